#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <functional>
#include <map>

#include "studies/results/growing_table.h"
#include "studies/results/results_file.h"
#include "studies/results/study_reader.h"
#include "tests/support/error_text.h"
#include "tests/support/temp_folder.h"

/// A study file whose tables do not belong together is refused before a row is looked up.
namespace gurney::study {
namespace {

using Columns = std::map<std::string, std::vector<double>>;

struct Tables {
  std::size_t configurations = 2, records = 3;
  Columns motions{{"set", {0, 0}}, {"record", {0, 2}}, {"scale", {1, 1}}};
  Columns runs{{"run", {0, 1, 2}},       {"configuration", {0, 1, 1}}, {"motion", {0, 1, 1}},
               {"record", {0, 2, 2}},    {"draw", {-1, -1, -1}},       {"scale", {1, 1, 1}},
               {"intensity", {0, 0, 0}}, {"angle", {0, 0, 0}}};
  Columns items{{"run", {0, 1, 2}}, {"peak", {1, 2, 3}}};
};

void add_rows(Hdf5Writer& file, const std::string& name, std::size_t rows) {
  GrowingTable table(file, name);
  for (std::size_t i = 0; i < rows; ++i) table.end_row();
  table.finish();
}

void add(Hdf5Writer& file, const std::string& name, const Columns& columns) {
  GrowingTable table(file, name);
  for (const auto& [column, values] : columns) table.add_number(column, "1", "a column");
  for (std::size_t i = 0; i < columns.begin()->second.size(); ++i) {
    for (const auto& [column, values] : columns) table.put(values[i]);
    table.end_row();
  }
  table.finish();
}

/// The error of reading these tables, without the folder.
std::string error_of(const std::function<void(Tables&)>& change,
                     const std::function<void(Hdf5Writer&)>& add_more = {}) {
  const TempFolder folder;
  Tables tables;
  change(tables);
  Hdf5Writer file;
  add_program(file, "gurney-study", kStudyFormatVersion);
  add_rows(file, "configurations", tables.configurations);
  add_rows(file, "records", tables.records);
  add(file, "motions", tables.motions);
  add(file, "runs", tables.runs);
  add(file, "items", tables.items);
  if (add_more) add_more(file);
  std::ofstream(folder.file("a.h5"), std::ios::binary) << file.image();
  const std::string text = error_text([&] { StudyReader(folder.file("a.h5")); });
  return text.starts_with(folder.file("")) ? text.substr(folder.file("").size()) : text;
}

TEST(HostileStudy, TheTablesAsTheyAreAreRead) {
  EXPECT_EQ(error_of([](Tables&) {}), "(no error)");
}

TEST(HostileStudy, IndicesLeadToRowsThatExist) {
  EXPECT_EQ(error_of([](Tables& t) { t.runs["configuration"][2] = 2; }),
            "a.h5: /runs/configuration[2] = 2: must be a whole number >= 0 and < 2");
  EXPECT_EQ(error_of([](Tables& t) { t.runs["motion"][0] = -1; }),
            "a.h5: /runs/motion[0] = -1: must be a whole number >= 0 and < 2");
  EXPECT_EQ(error_of([](Tables& t) { t.items["run"][1] = 1e18; }),
            "a.h5: /items/run[1] = 1e+18: must be a whole number >= 0 and < 3");
  EXPECT_EQ(error_of([](Tables& t) { t.motions["record"][1] = 0.5; }),
            "a.h5: /motions/record[1] = 0.5: must be a whole number >= 0 and < 3");
  EXPECT_EQ(error_of([](Tables& t) { t.runs["draw"][0] = NAN; }),
            "a.h5: /runs/draw[0] = nan: must be a whole number >= -1 and < 2147483648");
  EXPECT_EQ(error_of([](Tables& t) { t.runs["scale"][0] = INFINITY; }),
            "a.h5: /runs/scale must be finite");
}

TEST(HostileStudy, ColumnsAreAsLongAsTheirTable) {
  const auto nothing = [](Tables&) {};
  EXPECT_EQ(error_of(nothing,
                     [](Hdf5Writer& file) {
                       file.add_scale({"/runs/short", "1", "a column", {}}, std::vector<double>{1});
                     }),
            "a.h5: dataset /runs/short must be a column as long as its table");
  EXPECT_EQ(
      error_of(
          nothing,
          [](Hdf5Writer& file) {
            file.add_scale({"/runs/a", "1", "a", {}}, std::vector<double>{1, 2, 3});
            file.add_scale({"/runs/b", "1", "b", {}}, std::vector<double>{1});
            file.add({"/runs/c", "1", "c", {"/runs/a", "/runs/b"}}, std::vector<double>{1, 2, 3});
          }),
      "a.h5: dataset /runs/b must be a column as long as its table");
}

// A row that stands under another run: one has none then, another two.
TEST(HostileStudy, EachRunHasTheRowsOfItsItems) {
  const auto with_outcomes = [](const char* third) {
    return [=](Hdf5Writer& file) {
      file.add_growing({"/runs/outcome", "1", "outcome", {"/runs/row"}}, Hdf5Type::kText, 8);
      file.append("/runs/outcome", std::vector<std::string>{"rested", "rested", third});
    };
  };
  const auto nothing = [](Tables&) {};
  EXPECT_EQ(error_of(nothing, with_outcomes("rested")), "(no error)");
  EXPECT_EQ(error_of([](Tables& t) { t.items["run"][2] = 1; }, with_outcomes("rested")),
            "a.h5: run 2 has 0 rows in /items, run 1 of the same configuration 2");
  EXPECT_EQ(error_of(nothing, with_outcomes("diverged")),
            "a.h5: run 2 failed and has 1 rows in /items");
  EXPECT_EQ(error_of([](Tables& t) {
              t.items["run"] = {0, 2, 1};
            }),
            "a.h5: /items/run[2] = 1: must be at least that of the row before, 2");
}

}  // namespace
}  // namespace gurney::study
