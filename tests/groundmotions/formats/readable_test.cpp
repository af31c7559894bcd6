#include <gtest/gtest.h>

#include "groundmotions/formats/format.h"
#include "tests/groundmotions/formats/text_file.h"

namespace gurney::groundmotions {
namespace {

TEST(Readable, KeepsUtf8) {
  for (const char* text : {"", "Roof, 90 deg", "Concepci\xc3\xb3n", "\xe4\xbb\x99\xe5\x8f\xb0",
                           "\xf0\x9f\x8c\x8d", "\xed\x9f\xbf", "\xf4\x8f\xbf\xbf"})
    EXPECT_EQ(readable(text), text);
}

TEST(Readable, TakesOtherBytesAsLatin1) {
  EXPECT_EQ(readable("Concepci\xf3n"), "Concepci\xc3\xb3n");
  EXPECT_EQ(readable("\xc3\xb3 and \xf3"), "\xc3\xb3 and \xc3\xb3");
  EXPECT_EQ(readable("caf\xe9"), "caf\xc3\xa9");
  // Overlong, a surrogate, above U+10FFFF, and a character without its end.
  EXPECT_EQ(readable("\xc1\xbf"), "\xc3\x81\xc2\xbf");
  EXPECT_EQ(readable("\xe0\x9f\xbf"), "\xc3\xa0 \xc2\xbf");
  EXPECT_EQ(readable("\xf0\x8f\xbf\xbf"), "\xc3\xb0 \xc2\xbf\xc2\xbf");
  EXPECT_EQ(readable("\xe0\xa0"), "\xc3\xa0\xc2\xa0");
  EXPECT_EQ(readable("\xed\xa0\xa1"), "\xc3\xad\xc2\xa0\xc2\xa1");
  EXPECT_EQ(readable("\xf4\xbf\xbf\xbf"), "\xc3\xb4\xc2\xbf\xc2\xbf\xc2\xbf");
  EXPECT_EQ(readable("\xf0\xaf"), "\xc3\xb0\xc2\xaf");
}

TEST(Readable, MakesBlanksOfControlCharacters) {
  EXPECT_EQ(readable(std::string_view("a\tb\x1b\x7f\0c\n", 8)), "a b   c ");
  EXPECT_EQ(readable("St. Mary\x92s"), "St. Mary s");  // of Windows: C1 in Latin-1
  EXPECT_EQ(readable("a\xc2\x85z"), "a z");            // C1 in UTF-8
}

TEST(Readable, IsWhatReadersTellOfAFile) {
  const auto components = read_text(
      "# Concepci\xf3n\tsouth\nTime[s];Se\xf1"
      "al[g]\n0;1\n1;2\n2;3\n");
  ASSERT_EQ(components.size(), 1u);
  EXPECT_EQ(components[0].name,
            "Se\xc3\xb1"
            "al");
  EXPECT_EQ(fact(components[0], "text 1"), "# Concepci\xc3\xb3n south");
  ASSERT_EQ(components[0].warnings.size(), 1u);
  EXPECT_EQ(components[0].warnings[0],
            "1 line of text before the numbers, skipped; the last is 'Time[s];Se\xc3\xb1"
            "al[g]'");
}

}  // namespace
}  // namespace gurney::groundmotions
