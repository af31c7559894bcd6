#include "studies/analysis/stored_histories.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>

#include "engine/base/error.h"
#include "engine/config/nearest_name.h"
#include "studies/results/hdf5_reader.h"

namespace gurney::study {
namespace {

const std::string kGroup = "/histories/";

/// Columns that index, name or code others.
bool is_quantity(const Hdf5Dataset& dataset) {
  static const std::vector<std::string> others{"time",  "run",   "row",  "offset",
                                               "count", "start", "mode", "orientation"};
  return dataset.path.starts_with(kGroup) && dataset.type == "float64" &&
         std::ranges::find(others, dataset.path.substr(kGroup.size())) == others.end();
}

/// "displacement" and "x" of "displacement_x".
std::pair<std::string, std::string> split_axis(const std::string& column) {
  for (const char* axis : {"x", "y", "z"})
    if (column.ends_with(std::string("_") + axis))
      return {column.substr(0, column.size() - 2), axis};
  return {column, ""};
}

}  // namespace

/// A study has a column for each axis and a row for each item and time; a run has arrays.
struct StoredHistories::Layout {
  explicit Layout(const std::string& path) : file(path) {
    const auto attributes = file.attributes();
    const bool known = std::ranges::find(attributes, "filetype") != attributes.end();
    const std::string type = known ? file.text_attribute("filetype") : "";
    require(type == "gurney-study" || type == "gurney-results",
            path + ": not a results file of gurney");
    of_study = type == "gurney-study";
    for (const Hdf5Dataset& each : file.datasets()) {
      if (!is_quantity(each)) continue;
      const std::string column = each.path.substr(kGroup.size());
      const auto [name, axis] = of_study ? split_axis(column) : std::pair(column, std::string());
      if (!datasets.contains(name)) names.push_back(name);
      datasets[name].push_back(each);
    }
  }

  std::vector<double> numbers(const std::string& column) const {
    return file.numbers(kGroup + column);
  }

  StoredHistory of_rows(const std::string& name, std::size_t run) const;
  StoredHistory of_arrays(const std::string& name) const;

  /// Rows of a study: read once for all of its runs.
  struct Rows {
    std::vector<double> time;
    std::vector<std::string> item;
    std::map<std::size_t, std::vector<std::size_t>> of_run;
  };
  const Rows& rows() const;
  /// Columns of a study's history, of which those asked for last are kept.
  const std::vector<std::vector<double>>& columns(const std::string& name) const;

  Hdf5Reader file;
  bool of_study = false;
  std::vector<std::string> names;
  std::map<std::string, std::vector<Hdf5Dataset>> datasets;  ///< of each name: one, or its axes

 private:
  mutable std::optional<Rows> rows_;
  mutable std::string columns_of_;
  mutable std::vector<std::vector<double>> columns_;
};

const StoredHistories::Layout::Rows& StoredHistories::Layout::rows() const {
  if (rows_) return *rows_;
  const std::vector<double> run = numbers("run");
  file.require_length({kGroup + "time", kGroup + "item"}, run.size());
  rows_ = {numbers("time"), file.strings(kGroup + "item"), {}};
  for (std::size_t row = 0; row < run.size(); ++row)
    rows_->of_run[static_cast<std::size_t>(run[row])].push_back(row);
  return *rows_;
}

const std::vector<std::vector<double>>& StoredHistories::Layout::columns(
    const std::string& name) const {
  if (columns_of_ == name) return columns_;
  columns_.clear();
  columns_of_.clear();  // where reading ends in an error, none are kept
  for (const Hdf5Dataset& column : datasets.at(name)) {
    file.require_length({column.path}, rows().time.size());
    columns_.push_back(file.numbers(column.path));
  }
  columns_of_ = name;
  return columns_;
}

StoredHistory StoredHistories::Layout::of_rows(const std::string& name, std::size_t run) const {
  const std::vector<Hdf5Dataset>& axes = datasets.at(name);
  StoredHistory history{name, axes.front().units, "item", {}, {}};
  const std::vector<std::size_t>& of_run = rows().of_run.at(run);
  std::vector<std::string> items;
  for (const std::size_t row : of_run)
    if (std::ranges::find(items, rows().item[row]) == items.end())
      items.push_back(rows().item[row]);
  for (const std::string& each : items)
    for (std::size_t axis = 0; axis < axes.size(); ++axis) {
      const std::vector<double>& values = columns(name)[axis];
      StoredHistory::Series series{items.size() == 1 ? "" : each,
                                   split_axis(axes[axis].path.substr(kGroup.size())).second,
                                   {}};
      history.time.clear();
      for (const std::size_t row : of_run)
        if (rows().item[row] == each) {
          history.time.push_back(rows().time[row]);
          series.values.push_back(values[row]);
        }
      history.series.push_back(std::move(series));
    }
  return history;
}

StoredHistory StoredHistories::Layout::of_arrays(const std::string& name) const {
  const Hdf5Dataset& dataset = datasets.at(name).front();
  const auto& scales = dataset.scales;
  require(scales.size() == dataset.shape.size() && scales.size() >= 2 && scales[0] == "time",
          fmt::format("{}: {} is no history", file.path(), dataset.path));
  StoredHistory history{name, dataset.units, scales[1], numbers("time"), {}};
  const bool vector = scales.back() == "axis";
  std::vector<std::string> parts{""};
  if (scales[1] != "axis") parts = file.strings(kGroup + scales[1]);
  if (scales[1] == "item" && parts.size() == 1) parts = {""};
  const std::vector<std::string> axes =
      vector ? file.strings(kGroup + "axis") : std::vector<std::string>{""};
  const std::vector<double> values = file.numbers(dataset.path);
  const std::size_t width = parts.size() * axes.size();
  require(values.size() == history.time.size() * width,
          fmt::format("{}: {} is not as long as its scales", file.path(), dataset.path));
  for (std::size_t part = 0; part < parts.size(); ++part)
    for (std::size_t axis = 0; axis < axes.size(); ++axis) {
      StoredHistory::Series series{parts[part], axes[axis], {}};
      for (std::size_t i = 0; i < history.time.size(); ++i)
        series.values.push_back(values[i * width + part * axes.size() + axis]);
      history.series.push_back(std::move(series));
    }
  return history;
}

StoredHistories::StoredHistories(const std::string& path)
    : layout_(std::make_unique<Layout>(path)) {}
StoredHistories::~StoredHistories() = default;

std::vector<std::string> StoredHistories::names() const { return layout_->names; }
std::string StoredHistories::title() const { return layout_->file.text_attribute("title"); }
const std::string& StoredHistories::path() const { return layout_->file.path(); }

std::vector<std::size_t> StoredHistories::runs() const {
  std::vector<std::size_t> runs;
  if (layout_->names.empty()) return runs;
  if (layout_->of_study)
    for (const auto& [run, rows] : layout_->rows().of_run) runs.push_back(run);
  else
    for (const double run : layout_->numbers("run")) runs.push_back(static_cast<std::size_t>(run));
  return runs;
}

StoredHistory StoredHistories::history(const std::string& name, std::size_t run) const {
  const std::vector<std::string>& known = layout_->names;
  require(!known.empty(),
          path() +
              ": holds no histories; studies keep them with study.keep.histories, and gurney "
              "replay writes those of one run");
  require(std::ranges::find(known, name) != known.end(),
          fmt::format("{}: no history '{}'{}", path(), name, config::suggestion(name, known)));
  const std::vector<std::size_t> with = runs();
  if (std::ranges::find(with, run) == with.end()) {
    const std::size_t shown = std::min<std::size_t>(with.size(), 10);
    throw Error(fmt::format("{}: no histories of run {}; it has those of {} runs: {}{}", path(),
                            run, with.size(),
                            fmt::join(with.begin(), with.begin() + static_cast<long>(shown), ", "),
                            shown < with.size() ? ", ..." : ""));
  }
  return layout_->of_study ? layout_->of_rows(name, run) : layout_->of_arrays(name);
}

std::vector<StoredImpact> stored_impacts(const std::string& path) {
  const Hdf5Reader file(path);
  const auto datasets = file.datasets();
  require(std::ranges::find(datasets, "/events/run", &Hdf5Dataset::path) != datasets.end(),
          path + ": keeps no impacts (study.keep.events)");
  const auto run = file.numbers("/events/run"), x = file.numbers("/events/point_x"),
             y = file.numbers("/events/point_y"), speed = file.numbers("/events/approach_speed");
  const auto item = file.strings("/events/item"), other = file.strings("/events/other");
  file.require_length({"/events/point_x", "/events/point_y", "/events/approach_speed",
                       "/events/item", "/events/other"},
                      run.size());
  std::vector<StoredImpact> impacts;
  for (std::size_t i = 0; i < run.size(); ++i)
    impacts.push_back({static_cast<std::size_t>(run[i]), item[i], other[i], x[i], y[i], speed[i]});
  return impacts;
}

std::vector<StoredImpact> impacts_of_runs(const std::vector<StoredImpact>& impacts,
                                          const std::vector<std::size_t>& runs) {
  std::vector<StoredImpact> of_runs;
  std::ranges::copy_if(impacts, std::back_inserter(of_runs), [&](const StoredImpact& each) {
    return std::ranges::binary_search(runs, each.run);
  });
  return of_runs;
}

std::vector<std::string> hit_by_items(const std::vector<StoredImpact>& impacts) {
  std::vector<std::string> names;
  for (const StoredImpact& each : impacts)
    if (std::ranges::find(names, each.other) == names.end()) names.push_back(each.other);
  return names;
}

}  // namespace gurney::study
