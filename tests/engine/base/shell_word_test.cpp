#include "engine/base/shell_word.h"

#include <gtest/gtest.h>

namespace gurney {
namespace {

TEST(ShellWord, IsQuotedWhereAShellWouldReadSomethingElse) {
  EXPECT_EQ(shell_word("out/a-1.h5"), "out/a-1.h5");
  EXPECT_EQ(shell_word(""), "''");
  EXPECT_EQ(shell_word("a b"), "'a b'");
  EXPECT_EQ(shell_word("$(rm x)"), "'$(rm x)'");
  EXPECT_EQ(shell_word("it's"), "'it'\\''s'");
}

// printf '%s' $'\x1b[31m it\'s \\' in a shell gives the text back.
TEST(ShellWord, ShowsControlCharacters) {
  EXPECT_EQ(shell_word("\x1b[31m it's \\"), "$'\\x1b[31m it\\'s \\\\'");
}

}  // namespace
}  // namespace gurney
