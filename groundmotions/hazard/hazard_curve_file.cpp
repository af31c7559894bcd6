#include "groundmotions/hazard/hazard_curve_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/base/csv_row.h"
#include "engine/base/error.h"
#include "engine/base/number_text.h"
#include "engine/base/unit_table.h"
#include "groundmotions/formats/source_file.h"
#include "groundmotions/hazard/published_measure.h"
#include "groundmotions/hazard/usgs_answer.h"

namespace gurney::groundmotions {
namespace {

/// A level that is exceeded as often as the one before it takes its place.
void add_point(PublishedHazard& hazard, double im, double rate) {
  if (!hazard.rate.empty() && !(rate < hazard.rate.back())) {
    hazard.im.pop_back();
    hazard.rate.pop_back();
  }
  hazard.im.push_back(im);
  hazard.rate.push_back(rate);
}

constexpr std::string_view kLevel =
    "poe-";  // of a column: the probability to exceed the level behind it

struct Row {
  std::size_t line = 0;
  std::vector<CsvCell> cells;
};

/// The file as rows; errors have its path and their place.
class Rows {
 public:
  explicit Rows(const std::string& path) : path_(path) {
    const SourceFile file(path);
    std::size_t number = file.blank_lines();
    for (const std::string_view line : file.lines()) {
      ++number;
      if (!trimmed(line).empty()) rows_.push_back({number, csv_row(line)});
    }
  }

  std::size_t size() const { return rows_.size(); }
  const Row& at(std::size_t i) const { return rows_.at(i); }

  [[noreturn]] void fail(const Row& row, std::size_t column, const std::string& message) const {
    throw Error(fmt::format("{}:{}:{}: {}", path_, row.line, column, message));
  }

 private:
  std::string path_;
  std::vector<Row> rows_;
};

/// PGA of `imt='PGA'`, 50.0 of `investigation_time=50.0` in the first line; empty if it is not there.
std::string stated(const std::string& header, const std::string& key) {
  std::size_t from = header.find(key + "=");
  if (from == std::string::npos) return {};
  from += key.size() + 1;
  from += header.substr(from, 1) == "'" ? 1 : 0;
  return header.substr(from, header.find_first_of("',", from) - from);
}

/// The points of a curve of the USGS, whose arrays have the same length.
PublishedHazard points(const UsgsAnswer& answer, const UsgsCurve& curve) {
  PublishedHazard hazard{curve.measure.name, {}, {}};
  const double unit = in_si(curve.measure.unit);
  double level_before = 0, rate_before = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < curve.levels->elements.size(); ++i) {
    const config::Node &level = curve.levels->elements[i], &rate = curve.rates->elements[i];
    if (!level.is_number() || !(level.number > level_before))
      answer.fail(level, describe(level) + ": levels must be > 0 and increase");
    if (!rate.is_number() || !(rate.number >= 0 && rate.number <= rate_before))
      answer.fail(rate, describe(rate) + ": must be a rate >= 0, and not above the one before it");
    level_before = level.number;
    rate_before = rate.number;
    if (rate.number > 0) add_point(hazard, level.number * unit, rate.number);
  }
  if (hazard.im.size() < 2)
    answer.fail(*curve.rates, "fewer than two levels have different rates > 0");
  return hazard;
}

}  // namespace

PublishedHazard read_openquake_hazard(const std::string& path, std::optional<int> site) {
  const Rows rows(path);
  require(rows.size() >= 3 && rows.at(0).cells.front().text.starts_with('#'),
          path +
              ": is no hazard curve of OpenQuake: a line of comment, a line of titles, and a line "
              "for each site");
  std::string header;
  for (const CsvCell& cell : rows.at(0).cells) header += cell.text + ",";
  const std::string imt = stated(header, "imt");
  const PublishedMeasure measure = published_measure(imt);
  if (measure.name.empty())
    rows.fail(rows.at(0), 1, fmt::format("imt = '{}': must be PGA, PGV or SA(period)", imt));
  const std::optional<double> years = number(stated(header, "investigation_time"));
  if (!years || !(*years > 0))
    rows.fail(rows.at(0), 1, "investigation_time: must be stated, a number > 0 of years");

  const std::size_t sites = rows.size() - 2;
  if (!site && sites > 1)
    throw Error(fmt::format("{}: has {} sites: site must be given, 1 to {}", path, sites, sites));
  const auto row_of_site = static_cast<std::size_t>(site.value_or(1));
  if (row_of_site < 1 || row_of_site > sites)
    throw Error(fmt::format("{}: site = {}: must be 1 to {}", path, row_of_site, sites));
  const Row &titles = rows.at(1), &row = rows.at(1 + row_of_site);
  if (row.cells.size() != titles.cells.size())
    rows.fail(row, 1,
              fmt::format("has {} values for {} columns", row.cells.size(), titles.cells.size()));

  PublishedHazard hazard{measure.name, {}, {}};
  const double unit = in_si(measure.unit);
  double before = 1;
  for (std::size_t i = 0; i < titles.cells.size(); ++i) {
    const CsvCell &title = titles.cells[i], &cell = row.cells[i];
    if (!title.text.starts_with(kLevel)) continue;
    const std::optional<double> level = number(std::string_view(title.text).substr(kLevel.size()));
    if (!level || !(*level > 0) || (!hazard.im.empty() && !(*level * unit > hazard.im.back())))
      rows.fail(titles, title.column,
                fmt::format("'{}': levels must be > 0 and increase", title.text));
    const std::optional<double> poe = number(cell.text);
    if (!poe || !(*poe >= 0 && *poe <= before))
      rows.fail(
          row, cell.column,
          fmt::format("'{}': must be a probability, and not above the one before it", cell.text));
    before = *poe;
    if (*poe == 1 || *poe == 0) continue;
    add_point(hazard, *level * unit, -std::log1p(-*poe) / *years);
  }
  if (hazard.im.size() < 2)
    rows.fail(row, 1, "fewer than two levels have a probability between 0 and 1");
  return hazard;
}

PublishedHazard read_usgs_hazard(const std::string& path, const std::string& measure) {
  const UsgsAnswer answer(path);
  const std::vector<UsgsCurve> curves = answer.curves();
  std::vector<std::string> names;
  for (const UsgsCurve& each : curves) names.push_back(each.measure.name);
  const auto chosen = std::ranges::find(names, measure);
  const std::string listed = fmt::format("{}", fmt::join(names, ", "));
  if (measure.empty() && names.size() > 1)
    throw Error(fmt::format("{}: has {}: measure must be given", path, listed));
  if (!measure.empty() && chosen == names.end())
    throw Error(fmt::format("{}: measure = {}: the file has {}", path, measure, listed));
  return points(answer,
                curves[measure.empty() ? 0 : static_cast<std::size_t>(chosen - names.begin())]);
}

}  // namespace gurney::groundmotions
