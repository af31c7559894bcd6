#pragma once

#include <gtest/gtest.h>

#include <fstream>
#include <map>
#include <regex>
#include <string>
#include <vector>

#include "studies/results/hdf5_reader.h"

namespace gurney {

/// The rows `| name | ... |` of a page whose first cell is a name in backquotes; `..._x`, `_y` has a
/// row for each, with its letter for the x of the meaning.
inline std::map<std::string, std::vector<std::string>> table_rows(const std::string& path) {
  std::ifstream page(path);
  std::map<std::string, std::vector<std::string>> rows;
  for (std::string line; std::getline(page, line);) {
    if (line.rfind("| `", 0) != 0) continue;
    std::vector<std::string> cells;
    std::string cell;
    for (const char c : line.substr(1)) {
      if (c == '|' && !(cell.size() > 0 && cell.back() == '\\')) {
        cells.push_back(std::regex_replace(cell, std::regex("^ +| +$|`"), ""));
        cell.clear();
      } else {
        if (c == '|')
          cell.back() = c;
        else
          cell += c;
      }
    }
    if (cells.size() > 2) {  // a dataset
      if (cells.size() == 3) cells.insert(cells.begin() + 1, "row");
      const bool has_unit = cells[2].find("int") == cells[2].npos && cells[2] != "string";
      cells.insert(cells.begin() + 1, has_unit ? "float64" : cells[2]);
      if (!has_unit) cells[3] = "1";
    }
    std::string name = cells[0].substr(0, cells[0].find(','));
    std::vector<std::string> values(cells.begin() + 1, cells.end());
    rows[name] = values;
    for (const char axis : {'y', 'z'}) {
      if (cells[0].find(std::string(", _") + axis) == std::string::npos) continue;
      name.back() = axis;
      ++values.back()[values.back().find(static_cast<char>(axis - 1))];
      rows[name] = values;
    }
  }
  return rows;
}

inline std::string joined(const std::vector<std::string>& names) {
  std::string result;
  for (const std::string& name : names) result += (result.empty() ? "" : " x ") + name;
  return result;
}

/// Compares the datasets and attributes of a file with the tables of its page, both ways. A table
/// that the page does not list is that of the page `shared`: `/half_step` has the columns of
/// `/items`, histories the terms of `/energy`, in dimensions of their own, and many those of `/TABLE`.
inline void expect_as_on_page(const study::Hdf5Reader& file, const std::string& page,
                              const std::string& shared = "") {
  auto rows = table_rows(page);
  const auto shared_rows = table_rows(shared);
  std::string should;
  for (const study::Hdf5Dataset& dataset : file.datasets()) {
    const std::vector<std::string> cells{dataset.type, joined(dataset.scales), dataset.units,
                                         dataset.long_name};
    std::string path = dataset.path;
    path = std::regex_replace(path, std::regex("^/half_step_points/"), "/points/");
    path = std::regex_replace(path, std::regex("^/half_step/"), "/items/");
    path = std::regex_replace(path, std::regex("^/histories/(energy|loss|work)_"), "/energy/$1_");
    auto other = shared_rows.find(path);
    if (other == shared_rows.end())
      other = shared_rows.find(std::regex_replace(path, std::regex("^/[^/]+/"), "/TABLE/"));
    const bool on_page = rows.contains(dataset.path) || other == shared_rows.end();
    std::vector<std::string> stated = on_page ? rows[dataset.path] : other->second;
    if (!on_page && path.starts_with("/energy/")) stated[1] = cells[1];
    EXPECT_EQ(stated, cells) << dataset.path;
    if (stated != cells)
      should += "| `" + dataset.path + "` | " + cells[1] + " | " +
                (cells[0] == "float64" ? cells[2] : cells[0]) + " | " +
                std::regex_replace(cells[3], std::regex("\\|"), "\\|") + " |\n";
    rows.erase(dataset.path);
  }
  for (const std::string& name : file.attributes()) {
    EXPECT_TRUE(rows.contains(name) || shared_rows.contains(name))
        << "attribute " << name << " is not on the page";
    rows.erase(name);
  }
  std::erase_if(rows, [](const auto& row) { return row.first.starts_with("/TABLE/"); });
  for (const auto& [name, cells] : rows) ADD_FAILURE() << "the file has no " << name;
  EXPECT_EQ(should, "") << "lines for the page:\n" << should;
}

}  // namespace gurney
