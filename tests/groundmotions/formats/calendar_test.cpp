#include "groundmotions/formats/calendar.h"

#include <gtest/gtest.h>

namespace gurney::groundmotions {
namespace {

// `date -u -d "2018-01-24 19:51:43" +%s` prints 1516823503.
TEST(Calendar, ReadsDatesInEverySpelling) {
  for (const char* text : {"2018/01/24 19:51:43", "2018-1-24T19:51:43Z", "20180124_195143",
                           " 2018/01/24,19:51:43.000 ", "2018-01-24 195143"})
    EXPECT_EQ(utc_seconds(text), 1516823503) << text;
  EXPECT_EQ(utc_seconds("20180124_195143.250"), 1516823503.25);
  EXPECT_EQ(utc_seconds("1970/01/01 00:00:00"), 0);
  EXPECT_EQ(utc_seconds("2000/02/29 00:00:00"), 951782400);  // date -u -d "2000-02-29"
}

TEST(Calendar, RefusesWhatIsNoDate) {
  for (const char* text :
       {"", "2018/01/24", "2018/13/24 19:51:43", "2019/02/29 00:00:00", "2018/01/24 24:00:00",
        "2018/01/24 19:60:43", "2018/00/24 19:51:43", "18/01/24 19:51:43", "2018/01/24 19:51:xx",
        "2018/01/24 19:51:43 7", "2018/1.5/24 19:51:43", "99999999_999999"})
    EXPECT_FALSE(utc_seconds(text)) << text;
}

TEST(Calendar, TakesNumbers) {
  EXPECT_EQ(utc_seconds(1970, 1, 1, 0, 0, 0), 0);
  EXPECT_EQ(utc_seconds(2000, 3, 1, 12, 30, 1.5), 951913801.5);  // date -u -d ... +%s
  EXPECT_FALSE(utc_seconds(2001, 2, 29, 0, 0, 0));
  EXPECT_FALSE(utc_seconds(2001, 13, 1, 0, 0, 0));
  EXPECT_EQ(utc_seconds(2016, 12, 31, 23, 59, 60.5), 1483228800.5);  // a leap second
  EXPECT_FALSE(utc_seconds(2001, 0, 1, 0, 0, 0));
  EXPECT_FALSE(utc_seconds(1899, 1, 1, 0, 0, 0));
  EXPECT_FALSE(utc_seconds(-999, 1, 1, 0, 0, 0));
  EXPECT_FALSE(utc_seconds(2001, 1, 1, 24, 0, 0));
}

}  // namespace
}  // namespace gurney::groundmotions
