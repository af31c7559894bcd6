#include "engine/base/toml_string.h"

#include <gtest/gtest.h>

namespace gurney {
namespace {

TEST(TomlString, EscapesWhatWouldEndItOrIsNotAllowed) {
  EXPECT_EQ(toml_string("bed é"), "\"bed é\"");
  EXPECT_EQ(toml_string("a\"b\\c"), R"("a\"b\\c")");
  EXPECT_EQ(toml_string("\t\n\x1f\x7f"), R"("\u0009\u000a\u001f\u007f")");
  EXPECT_EQ(toml_string(""), "\"\"");
}

}  // namespace
}  // namespace gurney
