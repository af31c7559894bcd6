#include "engine/base/input_file.h"

#include <gtest/gtest.h>

#include <fstream>

#include "tests/support/expect_error.h"
#include "tests/support/temp_folder.h"

namespace gurney {
namespace {

TEST(InputFile, IsReadByteForByte) {
  const TempFolder folder;
  for (const std::string& bytes : {std::string(), std::string("a\r\n\0b", 5)}) {
    std::ofstream(folder.file("f"), std::ios::binary) << bytes;
    EXPECT_EQ(read_input_file(folder.file("f")), bytes);
  }
}

TEST(InputFile, IsNoLargerThanAsked) {
  const TempFolder folder;
  std::ofstream(folder.file("f")) << "12345";
  EXPECT_EQ(read_input_file(folder.file("f"), 5), "12345");
  EXPECT_ERROR(read_input_file(folder.file("f"), 4), "has 5 bytes; must have at most 4");
  EXPECT_ERROR(read_input_file(folder.path()), "is a folder, not a file");
  EXPECT_ERROR(read_input_file(folder.file("none")), "none: ");
}

}  // namespace
}  // namespace gurney
