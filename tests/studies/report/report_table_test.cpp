#include "studies/report/report_table.h"

#include <gtest/gtest.h>

namespace gurney::report {
namespace {

ReportTable table() {
  ReportTable table({{"item", "<6", "", "key"},
                     {"", "", "", "name"},
                     {"height [mm]", ">11", ".0f", "height_m", 1000},
                     {"Cr / R", ">7", ".3g"},
                     {"casters", ">7", "", "casters"}});
  table.add({"cart", "a | b", 1.2344, 0.0123456, std::size_t{4}});
  return table;
}

TEST(ReportTable, WritesTheSameRowsForPeopleAndPrograms) {
  EXPECT_EQ(table().text(),
            "item   height [mm]  Cr / R casters\n"
            "cart          1234  0.0123       4\n");
  EXPECT_EQ(table().json().dump(),
            R"([{"key":"cart","name":"a | b","height_m":1.2344,"casters":4}])");
}

TEST(ReportTable, EscapesWhatWouldEndACellOfMarkdown) {
  ReportTable table({{"what"}, {"error", "", ".1e"}});
  table.add({"|x|", 0.00123});
  EXPECT_EQ(table.markdown(), "| what | error |\n| --- | --- |\n| \\|x\\| | 1.2e-03 |\n");
  EXPECT_EQ(ReportTable(std::vector<ReportColumn>{{"what"}}).json().dump(), "[]");
}

}  // namespace
}  // namespace gurney::report
