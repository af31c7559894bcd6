#include <gmock/gmock.h>

#include <filesystem>
#include <fstream>

#include "tests/groundmotions/formats/text_file.h"

/// The examples on the pages of docs/formats are read as the pages say.
namespace gurney {
namespace {

/// The indented lines that follow the line `title`, up to the next line of text.
std::string example(const std::string& page, const std::string& title) {
  std::ifstream stream(std::filesystem::path(SOURCE_DIR) / "docs/formats" / page);
  std::string text, line;
  while (std::getline(stream, line) && line != title) {
  }
  while (std::getline(stream, line)) {
    if (line.starts_with("    "))
      text += line.substr(4) + "\n";
    else if (!text.empty())
      break;
  }
  return text;
}

void expect_read(const std::string& page, const std::string& title, const std::string& format,
                 std::size_t components, Eigen::Index samples, const ReadOptions& options = {}) {
  SCOPED_TRACE(page);
  const auto read = read_text(example(page, title), options);
  ASSERT_EQ(read.size(), components);
  EXPECT_EQ(read[0].format, format);
  EXPECT_EQ(read[0].acceleration.size(), samples);
}

TEST(Pages, HaveExamplesThatAreRead) {
  expect_read("record_knet.md", "## Example", "K-NET", 1, 10);
  expect_read("record_esm.md", "## Example", "ESM", 1, 4);
  expect_read("record_esm.md", "# SIMBAD files of ITACA records", "SIMBAD", 1, 7);
  expect_read("record_ucgmsim.md", "## Example", "EMOD3D", 1, 7, {.unit = "g"});
  expect_read("record_bbp.md", "## Example", "BBP", 3, 3);
  expect_read("record_plain.md", "## Example", "plain text", 1, 3);
  expect_read("record_at2.md", "## Example", "PEER AT2", 1, 5);
  expect_read("record_csv.md", "## CSV", "columns CSV", 3, 2);
}

}  // namespace
}  // namespace gurney
