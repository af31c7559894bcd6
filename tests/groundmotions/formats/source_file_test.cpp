#include "groundmotions/formats/source_file.h"

#include <gmock/gmock.h>

#include <filesystem>

#include "tests/support/error_text.h"

namespace gurney::groundmotions {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

TEST(SourceFile, CutsAtEveryKindOfLineEnd) {
  EXPECT_THAT(SourceFile("f", "a\nb\r\nc\r\r\nd\re").lines(), ElementsAre("a", "b", "c", "d", "e"));
  EXPECT_THAT(SourceFile("f", "a\n\nb\r\n\r\n").lines(), ElementsAre("a", "", "b", ""));
  EXPECT_THAT(SourceFile("f", "\n \t\r\na\n\n").lines(), ElementsAre("a", ""));
  EXPECT_EQ(SourceFile("f", "\n \t\r\na\n\n").blank_lines(), 2u);
  EXPECT_THAT(SourceFile("f", "\n\n").lines(), ElementsAre("", ""));
}

TEST(SourceFile, DropsTheByteOrderMark) {
  EXPECT_THAT(SourceFile("f", "\xef\xbb\xbftime_s\n").lines(), ElementsAre("time_s"));
}

TEST(SourceFile, KnowsWhetherTheLastLineIsWhole) {
  EXPECT_TRUE(SourceFile("f", "a\n").ends_with_line_end());
  EXPECT_FALSE(SourceFile("f", "a\nb").ends_with_line_end());
}

// FIPS 180-4, the one-block example of NIST's "SHA-256" example file: "abc".
TEST(SourceFile, HashesItsBytes) {
  EXPECT_EQ(SourceFile("f", "abc").sha256(),
            "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
}

TEST(SourceFile, KnowsText) {
  EXPECT_TRUE(SourceFile("f", "a\t\x1a").is_text());
  const SourceFile binary("f", std::string("ab\0c", 4));
  EXPECT_FALSE(binary.is_text());
  EXPECT_EQ(binary.bytes(), std::string_view("ab\0c", 4));
  EXPECT_EQ(error_text([&] { binary.lines(); }), "f: not a text file (byte 3 is 0x00)");
  EXPECT_EQ(error_text([] { SourceFile("f", ""); }), "f: the file is empty");
}

// Recorders pad their last block with NULs, and programs put a line end behind them.
TEST(SourceFile, DropsNulsAtTheEnd) {
  const std::string nuls(80, '\0');
  for (const std::string& end : {nuls, nuls + "\r\n", nuls + "\n\x1a", nuls + " \n" + nuls}) {
    EXPECT_THAT(SourceFile("f", "a\nb\n" + end).lines(), ElementsAre("a", "b"));
    EXPECT_TRUE(SourceFile("f", "a\nb\n" + end).ends_with_line_end());
    EXPECT_FALSE(SourceFile("f", "a\nb" + end).ends_with_line_end());
  }
  EXPECT_FALSE(SourceFile("f", "a\n" + nuls + "\nb").is_text());
}

TEST(SourceFile, RefusesWhatCannotBeRead) {
  EXPECT_EQ(error_text([] { SourceFile(std::filesystem::path("no/such.AT2")); }),
            "no/such.AT2: no such file");
  EXPECT_THAT(error_text([] { SourceFile(std::filesystem::temp_directory_path()); }),
              HasSubstr(": is a folder, not a file"));
  EXPECT_THAT(error_text([] { SourceFile(std::filesystem::path("/dev/zero")); }),
              HasSubstr(": is a pipe or a device, not a regular file"));
}

}  // namespace
}  // namespace gurney::groundmotions
