#include <gmock/gmock.h>

#include "engine/base/units.h"
#include "groundmotions/formats/plain_rows.h"
#include "tests/groundmotions/formats/text_file.h"
#include "tests/support/error_text.h"

namespace gurney::groundmotions {
namespace {

using testing::Contains;
using testing::HasSubstr;

void expect_the_motion(const std::string& text, const ReadOptions& options = {.unit = "g"}) {
  SCOPED_TRACE(text);
  const Component component = read_one(text, options);
  const Eigen::Vector4d expected(0.5, -0.25, 0.125, 0);
  EXPECT_EQ(component.acceleration, expected * kStandardGravity);
  EXPECT_DOUBLE_EQ(component.time_step, 0.01);
}

TEST(PlainCells, QuotesAreNoPartOfNumbers) {
  expect_the_motion("\"0\",\"0.5\"\n\"0.01\",\"-0.25\"\n\"0.02\",\"0.125\"\n\"0.03\",\"0\"\n");
  expect_the_motion(
      "\"Time (s)\";\"Acc, NS (g)\"\n\"0\";\"0,5\"\n\"0,01\";\"-0,25\"\n"
      "\"0,02\";\"0,125\"\n\"0,03\";\"0\"\n",
      {});
  expect_the_motion("\"0\",\"0,5\"\n\"0,01\",\"-0,25\"\n\"0,02\",\"0,125\"\n\"0,03\",\"0\"\n");
}

TEST(PlainCells, DecimalCommasAreReadWhereSemicolonsTabsOrBlanksPartTheCells) {
  for (const char* mark : {";", "\t", "; ", "  "}) {
    const std::string m = mark;
    expect_the_motion("0" + m + "0,5\n0,01" + m + "-0,25\n0,02" + m + "1,25E-1\n0,03" + m + "0\n");
    expect_the_motion("t (s)" + (m == "  " ? "\t" : m) + "Acc (g)\n0,00" + m + "0,5\n0,01" + m +
                          "-0,25\n0,02" + m + "0,125\n0,03" + m + "0,0\n",
                      {});
  }
  EXPECT_EQ(error_text([] { read_text("0.01;0,5\n0.02;0,6\n0.03;0,7\n", {.unit = "g"}); }),
            "f:1:1: semicolons part the cells, but the numbers have commas and points: which is "
            "the decimal mark? Write points only");
  // Commas that part whole numbers stay what they are.
  EXPECT_EQ(read_one("1, -2\n3, 4\n", {.time_step = 0.01, .si_per_count = 1, .columns = "samples"})
                .acceleration,
            Eigen::Vector4d(1, -2, 3, 4));
}

TEST(PlainCells, DatesAndClockTimesAreTimes) {
  expect_the_motion(
      "2010-02-27 06:34:14.005 0.5\n2010-02-27 06:34:14.015 -0.25\n2010-02-27 06:34:14.025 0.125\n"
      "2010-02-27 06:34:14.035 0\n");
  expect_the_motion(
      "timestamp,acc (g)\n2010-02-27T06:34:14.99Z,0.5\n2010-02-27T06:34:15.00Z,-0.25\n"
      "2010-02-27T06:34:15.01Z,0.125\n2010-02-27T06:34:15.02Z,0\n",
      {});
  expect_the_motion("06:34:14.99;0.5\n06:34:15.00;-0.25\n06:34:15.01;0.125\n06:34:15.02;0\n");
  const std::string midnight =
      "27/02/2010 23:59:59.99\t0.5\n28/02/2010 00:00:00.00\t-0.25\n"
      "28/02/2010 00:00:00.01\t0.125\n28/02/2010 00:00:00.02\t0\n";
  expect_the_motion(midnight);
  EXPECT_THAT(read_one(midnight, {.unit = "g"}).warnings,
              Contains("the first row is of 27/02/2010 23:59:59.99; the motion starts there, at 0 "
                       "s of the run"));
}

TEST(PlainCells, HeadersMayBeginWithDigitsDatesAndRules) {
  const std::string rows = "0 0.5\n0.01 -0.25\n0.02 0.125\n0.03 0\n";
  for (const char* header :
       {"065JZC120103153901\n", "2010/02/27 06:34:14\n", "27.02.2010\n", "2nd\n", "2010-02-27\n",
        "Quake\n----****----\n", "****\nQuake\n*****\n", "**********************************\n",
        "Quake\n--+--|--+--\n"})
    expect_the_motion(header + rows);
  for (const std::string word : {"1.5x", "0.12.34", "****", "1.#QNAN", "0x1F", "12nan"})
    EXPECT_THAT(error_text([&] {
                  read_text("Quake\n" + word + "\n1\n2\n", {.unit = "g", .time_step = 0.01});
                }),
                testing::AllOf(HasSubstr("f:2:1: not a record in a known format"),
                               HasSubstr("; this is neither a number nor a word")))
        << word;
}

}  // namespace
}  // namespace gurney::groundmotions
