#include "engine/base/printable.h"

#include <gtest/gtest.h>

namespace gurney {
namespace {

TEST(Printable, KeepsTextAndNamesControlCharacters) {
  EXPECT_EQ(printable(" plain ~"), " plain ~");
  EXPECT_EQ(printable("\x1b"), "\\x1b") << "nothing but a control character";
  EXPECT_EQ(printable("\x01\x1f"), "\\x01\\x1f");
  EXPECT_EQ(printable("a\x7f"), "a\\x7f");
  EXPECT_EQ(printable("\xc3\xa9\xff"), "\xc3\xa9\\xff")
      << "UTF-8 stays, a byte that is none does not";
  EXPECT_EQ(printable(""), "");
}

}  // namespace
}  // namespace gurney
