#include "engine/base/utf8.h"

#include <gtest/gtest.h>

#include <string>

namespace gurney {
namespace {

// The ends of each length in the table of well-formed sequences (Unicode 15, table 3-7), and what is beside them.
TEST(Utf8Length, IsThatOfAWellFormedCharacter) {
  EXPECT_EQ(utf8_length("a"), 1u);
  EXPECT_EQ(utf8_length("\x7f"), 1u);
  EXPECT_EQ(utf8_length("\xc2\x80"), 2u);
  EXPECT_EQ(utf8_length("\xdf\xbf"), 2u);
  EXPECT_EQ(utf8_length("\xe0\xa0\x80"), 3u);
  EXPECT_EQ(utf8_length("\xed\x9f\xbf"), 3u);
  EXPECT_EQ(utf8_length("\xef\xbf\xbf"), 3u);
  EXPECT_EQ(utf8_length("\xf0\x90\x80\x80"), 4u);
  EXPECT_EQ(utf8_length("\xf4\x8f\xbf\xbf"), 4u);
  EXPECT_EQ(utf8_length("\xc3\xa9t\xe9"), 2u) << "of the first character";
}

TEST(Utf8Length, IsZeroOfAnythingElse) {
  for (const std::string text : {"\x80", "\xbf", "\xc0\x80", "\xc1\xbf", "\xc2",
                                 "\xc2"
                                 "a",
                                 "\xe0\x9f\xbf", "\xe1\x80", "\xed\xa0\x80", "\xf0\x8f\xbf\xbf",
                                 "\xf1\x80\x80", "\xf4\x90\x80\x80", "\xf5\x80\x80\x80", "\xff"})
    EXPECT_EQ(utf8_length(text), 0u) << testing::PrintToString(text);
}

}  // namespace
}  // namespace gurney
