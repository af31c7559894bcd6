#include "studies/analysis/file_values.h"

#include "engine/base/error.h"

namespace gurney::study {
namespace {

struct Place {
  std::string table, part;  ///< the column that names the part; empty: there is none
};

Place place_of(Quantity::Of of) {
  switch (of) {
    case Quantity::Of::kItem:
      return {"items", ""};
    case Quantity::Of::kPoint:
      return {"points", "point"};
    case Quantity::Of::kZone:
      return {"zones", "zone"};
    case Quantity::Of::kTether:
      return {"tethers", "tether"};
  }
  return {};
}

}  // namespace

std::string table_of(Quantity::Of of) { return place_of(of).table; }

const FileValues::Rows& FileValues::rows(const std::string& table) {
  const auto known = rows_.find(table);
  if (known != rows_.end()) return known->second;
  require(file_.has(table),
          file_.path() + ": the study did not keep /" + table + "; ask for it in [study.keep]");
  return rows_[table] = file_.rows_of_runs(table);
}

const std::vector<double>& FileValues::numbers(const std::string& column) {
  const auto known = numbers_.find(column);
  return known != numbers_.end() ? known->second : numbers_[column] = file_.numbers(column);
}

const std::vector<std::string>& FileValues::strings(const std::string& column) {
  const auto known = strings_.find(column);
  return known != strings_.end() ? known->second : strings_[column] = file_.strings(column);
}

std::vector<double> FileValues::operator()(std::size_t run, const Quantity& quantity) {
  const Place place = place_of(quantity.of);
  const auto [first, last] = rows(place.table).at(run);
  const std::vector<double>& column = numbers(place.table + "/" + quantity.column);
  std::vector<double> values;
  for (std::size_t row = first; row < last; ++row) {
    if (!quantity.item.empty() && strings(place.table + "/item")[row] != quantity.item) continue;
    if (!place.part.empty() && strings(place.table + "/" + place.part)[row] != quantity.part)
      continue;
    values.push_back(column[row]);
  }
  return values;
}

}  // namespace gurney::study
