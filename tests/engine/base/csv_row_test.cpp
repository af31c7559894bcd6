#include "engine/base/csv_row.h"

#include <gmock/gmock.h>

namespace gurney {
namespace {

std::vector<std::string> texts(std::string_view line) {
  std::vector<std::string> result;
  for (const CsvCell& cell : csv_row(line)) result.push_back(cell.text);
  return result;
}

TEST(CsvRow, HasACellMoreThanCommas) {
  EXPECT_THAT(texts(""), testing::ElementsAre(""));
  EXPECT_THAT(texts("a"), testing::ElementsAre("a"));
  EXPECT_THAT(texts("a,b,"), testing::ElementsAre("a", "b", ""));
  EXPECT_EQ(csv_row("ab, cd")[1].column, 5u);
}

TEST(CsvRow, TakesQuotedCellsWithCommas) {
  EXPECT_THAT(texts(R"( 1, "A, ""B""" ,,x )"), testing::ElementsAre("1", "A, \"B\"", "", "x"));
}

}  // namespace
}  // namespace gurney
