#include "studies/results/growing_table.h"

#include <gtest/gtest.h>

#include <cmath>

#include "studies/results/hdf5_reader.h"
#include "tests/support/temp_folder.h"

namespace gurney::study {
namespace {

/// Writes `rows` rows of an Impact with a text and a whole number before it.
std::string written(const TempFolder& folder, int rows) {
  const std::string path = folder.file(std::to_string(rows) + ".h5");
  Hdf5Writer file(path);
  GrowingTable table(file, "events");
  table.add_whole("run", "index");
  table.add_text("name", "a name", 6);
  table.add(impact_columns());
  for (int i = 0; i < rows; ++i) {
    Impact impact;
    impact.time = 0.25 * i;
    impact.peak_force = i % 2 == 0 ? std::nan("") : i;
    table.put(double(i)).put(i % 3 == 0 ? "" : "n" + std::to_string(i));
    table.put(impact_columns(), impact).end_row();
  }
  EXPECT_EQ(table.rows(), rows);
  table.finish();
  file.finish();
  return path;
}

TEST(GrowingTable, HasEveryRowOfEveryBlock) {
  const TempFolder folder;
  for (const int rows : {1, 4095, 4096, 4097, 8192, 10001}) {
    const Hdf5Reader file(written(folder, rows));
    const std::vector<double> row = file.numbers("/events/row"), run = file.numbers("/events/run"),
                              time = file.numbers("/events/time"),
                              force = file.numbers("/events/peak_force");
    const std::vector<std::string> name = file.strings("/events/name");
    const auto size = static_cast<std::size_t>(rows);
    ASSERT_EQ(row.size(), size);
    ASSERT_EQ(run.size(), size);
    ASSERT_EQ(time.size(), size);
    ASSERT_EQ(force.size(), size);
    ASSERT_EQ(name.size(), size);
    for (std::size_t i = 0; i < size; ++i) {
      ASSERT_EQ(row[i], double(i));
      ASSERT_EQ(run[i], double(i));
      ASSERT_EQ(time[i], 0.25 * double(i));
      ASSERT_EQ(std::isnan(force[i]), i % 2 == 0);
      ASSERT_EQ(name[i], i % 3 == 0 ? "" : ("n" + std::to_string(i)).substr(0, 6));
    }
  }
}

TEST(GrowingTable, MayStayEmpty) {
  const TempFolder folder;
  const Hdf5Reader file(written(folder, 0));
  EXPECT_TRUE(file.numbers("/events/time").empty());
  EXPECT_TRUE(file.strings("/events/name").empty());
}

TEST(GrowingTable, DescribesItsColumns) {
  const TempFolder folder;
  const Hdf5Reader file(written(folder, 3));
  for (const Hdf5Dataset& each : file.datasets())
    if (each.path == "/events/approach_speed") {
      EXPECT_EQ(each.type, "float64");
      EXPECT_EQ(each.units, "m/s");
      EXPECT_EQ(each.scales, std::vector<std::string>{"row"});
      return;
    }
  FAIL() << "no /events/approach_speed";
}

TEST(GrowingTable, GivesTheSameBytesForTheSameRows) {
  const TempFolder folder;
  const std::string first = contents_of(written(folder, 5000));
  EXPECT_EQ(first, contents_of(written(folder, 5000)));
}

}  // namespace
}  // namespace gurney::study
