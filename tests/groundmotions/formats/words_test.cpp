#include "groundmotions/formats/words.h"

#include <gtest/gtest.h>

namespace gurney::groundmotions {
namespace {

TEST(Words, FindsNumbersBehindTheirKeys) {
  EXPECT_EQ(number_after("NO. OF POINTS =  120  LENGTH", "NO. OF POINTS"), 120);
  EXPECT_EQ(number_after("MAX  =  -.105 G", "MAX"), -0.105);
  EXPECT_FALSE(number_after("MAX  =  G", "MAX"));
  EXPECT_FALSE(number_after("MIN  =  1", "MAX"));
}

TEST(Words, PartsTextAtSeparators) {
  using List = std::vector<std::string_view>;
  EXPECT_EQ(words_of(" a, b;c", " ,;"), (List{"a", "b", "c"}));
  EXPECT_EQ(words_of(",,", ","), List());
  EXPECT_EQ(upper("Up 1"), "UP 1");
  EXPECT_EQ(lower("Up 1"), "up 1");
}

TEST(Words, FindsTextInBrackets) {
  EXPECT_EQ(in_brackets("Accel ( g ) (x)"), "g");
  EXPECT_EQ(in_brackets("Time[s]"), "s");
  EXPECT_EQ(in_brackets("Accel (g"), "g");
  EXPECT_EQ(in_brackets("Accel"), "");
}

}  // namespace
}  // namespace gurney::groundmotions
