#include <gmock/gmock.h>

#include "tests/groundmotions/formats/page_example.h"
#include "tests/groundmotions/formats/text_file.h"

/// The examples on the pages of docs/formats are read as the pages say.
namespace gurney::groundmotions {
namespace {

void expect_read(const std::string& page, const std::string& title, const std::string& format,
                 std::size_t components, Eigen::Index samples, const ReadOptions& options = {}) {
  SCOPED_TRACE(page);
  const auto read = read_text(page_example(page, title), options);
  ASSERT_EQ(read.size(), components);
  EXPECT_EQ(read[0].format, format);
  EXPECT_EQ(read[0].acceleration.size(), samples);
}

TEST(Pages, HaveExamplesThatAreRead) {
  expect_read("record_knet.md", "## Example", "K-NET", 1, 10);
  expect_read("record_esm.md", "## Example", "ESM", 1, 4);
  expect_read("record_esm.md", "# SIMBAD files of ITACA records", "SIMBAD", 1, 7);
  expect_read("record_ucgmsim.md", "## Example", "EMOD3D", 1, 7, {.unit = "g"});
  expect_read("record_cwb.md", "## Example", "CWB", 3, 4);
  expect_read("record_nsmn.md", "## Example", "NSMN", 3, 3);
  expect_read("record_csmnc.md", "## Example", "CSMNC", 1, 11);
  expect_read("record_bbp.md", "## Example", "BBP", 3, 3);
  expect_read("record_plain.md", "## Example", "plain text", 1, 3);
  expect_read("record_at2.md", "## Example", "PEER AT2", 1, 5);
  expect_read("record_csv.md", "## CSV", "columns CSV", 3, 2);
}

}  // namespace
}  // namespace gurney::groundmotions
