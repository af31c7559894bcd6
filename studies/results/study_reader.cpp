#include "studies/results/study_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "engine/base/error.h"
#include "engine/response/response.h"
#include "studies/results/columns.h"

namespace gurney::study {

namespace {

constexpr double kMaxDraws = 2147483648.0;

/// "items" of "/items/peak_displacement"
std::string table_of(const std::string& path) { return path.substr(1, path.rfind('/') - 1); }

}  // namespace

StudyReader::StudyReader(const std::string& path) : path_(path), file_(path) {
  const std::string type = text_attribute("filetype");
  require(type == "gurney-study",
          path + ": is not a results file of a study" +
              (type.empty() ? "" : " but '" + type + "', the file of a single run"));
  const std::int64_t version = file_.whole_attribute("format_version");
  require(version >= 1 && version <= kStudyFormatVersion,
          fmt::format("{}: is a study file of format_version {}, made by gurney {} ({}); this "
                      "program reads versions 1 to {}: run the study again, or use that program",
                      path, version, text_attribute("program_version"),
                      text_attribute("git_commit"), kStudyFormatVersion));
  check_tables();
  runs_ = numbers("runs/run").size();
  check_indices();
}

void StudyReader::check_tables() {
  const std::vector<Hdf5Dataset> datasets = file_.datasets();
  for (const Hdf5Dataset& each : datasets)
    if (each.path.ends_with("/row") && each.shape.size() == 1)
      rows_[table_of(each.path)] = each.shape[0];
  for (const Hdf5Dataset& each : datasets) {
    columns_.insert(each.path.substr(1));
    const auto table = rows_.find(table_of(each.path));
    require(table != rows_.end() && each.shape.size() == 1 && each.shape[0] == table->second,
            fmt::format("{}: dataset {} must be a column as long as its table", path_, each.path));
  }
}

void StudyReader::check_indices() const {
  const auto check = [&](const std::string& column, double low, double end) {
    if (!columns_.contains(column)) return;
    const std::vector<double> values = numbers(column);
    const auto wrong = std::ranges::find_if_not(values, [&](double value) {
      return value >= low && value < end && value == std::floor(value);
    });
    if (wrong != values.end())
      throw Error(fmt::format("{}: /{}[{}] = {}: must be a whole number >= {} and < {}", path_,
                              column, wrong - values.begin(), *wrong, low, end));
  };
  const auto rows = [&](const std::string& table) {  // nobody can look up one that is absent
    const auto found = rows_.find(table);
    return found == rows_.end() ? kMaxDraws : static_cast<double>(found->second);
  };
  for (const auto& [table, length] : rows_) {
    check(table + "/run", 0, rows("runs"));
    check_order(table);
  }
  for (const char* table : {"runs", "drawn"}) {
    check(table + std::string("/configuration"), 0, rows("configurations"));
    check(table + std::string("/draw"), -1, kMaxDraws);
  }
  check("runs/motion", 0, rows("motions"));
  for (const char* table : {"runs", "motions"})
    check(table + std::string("/record"), 0, rows("records"));
  check("motions/set", 0, kMaxDraws);
  for (const char* column : {"runs/scale", "runs/intensity", "runs/angle"}) {
    if (!columns_.contains(column)) continue;
    const auto is_finite = [](double value) { return std::isfinite(value); };
    require(std::ranges::all_of(numbers(column), is_finite),
            fmt::format("{}: /{} must be finite", path_, column));
  }
  check_record_sets();
  check_items();
}

/// rows_of_runs() needs the rows of a run to follow each other.
void StudyReader::check_order(const std::string& table) const {
  const std::string column = table + "/run";
  if (!columns_.contains(column)) return;
  const std::vector<double> run = numbers(column);
  const auto fall = std::ranges::adjacent_find(run, std::greater<>());
  require(fall == run.end(),
          fmt::format("{}: /{}[{}] = {}: must be at least that of the row before, {}", path_,
                      column, fall - run.begin() + 1, fall == run.end() ? 0 : fall[1],
                      fall == run.end() ? 0 : *fall));
}

/// A run that did not fail has a row for each item, as all others of its configuration.
void StudyReader::check_items() const {
  for (const char* column : {"items/run", "runs/configuration", "runs/outcome"})
    if (!columns_.contains(column)) return;
  const std::vector<double> configuration = numbers("runs/configuration");
  const std::vector<std::string> outcome = strings("runs/outcome");
  const auto rows = rows_of_runs("items");
  std::map<double, std::size_t> first;  // run of a configuration
  for (std::size_t run = 0; run < runs_; ++run) {
    const auto count = [&](std::size_t of) { return rows[of].second - rows[of].first; };
    if (is_failure(outcome[run])) {
      require(count(run) == 0,
              fmt::format("{}: run {} failed and has {} rows in /items", path_, run, count(run)));
      continue;
    }
    const std::size_t other = first.try_emplace(configuration[run], run).first->second;
    require(count(run) == count(other) && count(run) > 0,
            fmt::format("{}: run {} has {} rows in /items, run {} of the same configuration {}",
                        path_, run, count(run), other, count(other)));
  }
}

void StudyReader::check_record_sets() const {
  const std::vector<std::string> needed{"records/set", "motions/set", "runs/motion", "runs/record"};
  for (const std::string& column : needed)
    if (!columns_.contains(column)) return;
  std::map<std::string, std::size_t> records;
  for (const std::string& set : strings("records/set")) ++records[set];
  const std::vector<double> set = numbers("motions/set"), motion = numbers("runs/motion"),
                            record = numbers("runs/record");
  for (std::size_t run = 0; run < runs_; ++run) {
    const double of = set[static_cast<std::size_t>(motion[run])];
    const auto found = records.find(fmt::format("{:.0f}", of));
    require(found != records.end() && record[run] < static_cast<double>(found->second),
            fmt::format("{}: run {} has record {} of set {}, which is not in /records", path_, run,
                        record[run], of));
  }
}

bool StudyReader::has(const std::string& table) const { return rows_.contains(table); }

std::vector<std::string> StudyReader::columns_of(const std::string& table) const {
  std::vector<std::string> names;
  for (const std::string& column : columns_)
    if (column.starts_with(table + "/")) names.push_back(column.substr(table.size() + 1));
  return names;
}

std::vector<double> StudyReader::numbers(const std::string& column) const {
  if (column == "runs/analysis_case" && !has_column(column)) return numbers("runs/unit");
  require_column(column);
  std::vector<double> values = file_.numbers("/" + column);
  check_demand(column, values);
  return values;
}

/// A demand that every item has is a number; without, no limit would count as exceeded.
void StudyReader::check_demand(const std::string& column, const std::vector<double>& values) const {
  const auto known = std::ranges::find_if(demand_columns(), [&](const auto& each) {
    return column == std::string("items/") + each.name && !std::isnan(each.missing);
  });
  if (known == demand_columns().end()) return;
  const auto row = std::ranges::find_if(values, [](double value) { return std::isnan(value); });
  require(row == values.end(),
          fmt::format("{}: /{}[{}] = nan: must be a number", path_, column, row - values.begin()));
}

std::vector<std::string> StudyReader::strings(const std::string& column) const {
  if (column.starts_with("data_files/") && !has("data_files")) return {};  // version 1
  require_column(column);
  return file_.strings("/" + column);
}

void StudyReader::require_column(const std::string& column) const {
  if (columns_.contains(column)) return;
  throw Error(
      fmt::format("{}: has no column {}: it was written by gurney {} ({}); run the study "
                  "again for it",
                  path_, column, text_attribute("program_version"), text_attribute("git_commit")));
}

std::vector<std::string> StudyReader::missing_demands() const {
  std::vector<std::string> missing;
  if (has("items"))
    for (const TableColumn<Demands>& column : demand_columns())
      if (!has_column(std::string("items/") + column.name)) missing.emplace_back(column.name);
  if (has("points"))
    for (const TableColumn<PointDemands>& column : point_demand_columns())
      if (!has_column(std::string("points/") + column.name))
        missing.push_back(std::string("point: ") + column.name);
  return missing;
}

std::vector<std::pair<std::size_t, std::size_t>> StudyReader::rows_of_runs(
    const std::string& table) const {
  std::vector<std::pair<std::size_t, std::size_t>> rows(runs_, {0, 0});
  const std::vector<double> run = numbers(table + "/run");
  for (std::size_t row = 0; row < run.size(); ++row) {
    auto& [first, last] = rows[static_cast<std::size_t>(run[row])];
    if (last == 0) first = row;
    last = row + 1;
  }
  return rows;
}

}  // namespace gurney::study
