#include <gmock/gmock.h>

#include "tests/groundmotions/formats/page_example.h"
#include "tests/groundmotions/formats/text_file.h"

/// The examples of docs/formats/record_files.md are read as the page says.
namespace gurney::groundmotions {
namespace {

void expect_read(const std::string& title, const std::string& format, std::size_t components,
                 Eigen::Index samples, const ReadOptions& options = {}) {
  SCOPED_TRACE(title);
  const auto read = read_text(page_example(title), options);
  ASSERT_EQ(read.size(), components);
  EXPECT_EQ(read[0].format, format);
  EXPECT_EQ(read[0].acceleration.size(), samples);
}

TEST(RecordPage, HasExamplesThatAreRead) {
  expect_read("## K-NET and KiK-net", "K-NET", 1, 10);
  expect_read("## ESM, ITACA and AFAD", "ESM", 1, 4);
  expect_read("### SIMBAD", "SIMBAD", 1, 7);
  expect_read("## EMOD3D and ucgmsim", "EMOD3D", 1, 7, {.unit = "g"});
  expect_read("## CWB", "CWB", 3, 4);
  expect_read("## NSMN", "NSMN", 3, 3);
  expect_read("## CSMNC", "CSMNC", 1, 11);
  expect_read("## SCEC BBP", "BBP", 3, 3);
  expect_read("## Plain text", "plain text", 1, 3);
  expect_read("## PEER AT2", "PEER AT2", 1, 5);
  expect_read("## CSV", "columns CSV", 3, 2);
}

}  // namespace
}  // namespace gurney::groundmotions
