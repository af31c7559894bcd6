#include "studies/plan/assessment_files.h"

#include <fmt/format.h>

#include <cmath>
#include <filesystem>
#include <limits>
#include <sstream>

#include "engine/base/csv_row.h"
#include "engine/base/error.h"
#include "engine/base/input_file.h"
#include "engine/base/number_text.h"
#include "engine/base/unit_table.h"
#include "engine/config/document.h"
#include "engine/config/table.h"
#include "equipment/catalogue/check_file.h"
#include "studies/job/scale_reader.h"
#include "studies/limit_states/limit_state_reader.h"
#include "studies/plan/study.h"

namespace gurney::study {
namespace {

config::Table root_of(config::Document& document, const std::string& schema) {
  equipment::refuse_other_kind(document, schema);
  config::Table root = document.root();
  root.choice("schema", {schema});
  root.text("title", "");
  return root;
}

/// The curve of a file of OpenQuake, which states measure and unit, but not the component.
SiteHazard read_openquake(config::Table& root) {
  config::Document& document = root.document();
  for (const char* key : {"measure", "unit", "im", "rate_per_year", "k0", "k"})
    if (root.has(key)) root.note(key, ": the file of OpenQuake states it");
  const std::filesystem::path folder = std::filesystem::path(document.path()).parent_path();
  const std::string file = (folder / root.text("openquake")).lexically_normal().string();
  std::optional<int> site;
  if (root.has("site")) site = root.integer("site", 1, std::numeric_limits<int>::max());
  OpenQuakeHazard found;
  try {
    found = read_openquake_hazard(file, site);
  } catch (const Error& error) {
    document.note(error);
  }
  const groundmotions::Measure measure =
      groundmotions::parse_measure(found.measure.empty() ? "PGA" : found.measure);
  const groundmotions::Combination component = read_combination(root, measure);
  document.finish();
  return {statistics::HazardCurve::table(found.im, found.rate),
          name_of(measure) + " " + name_of(component), root.where("openquake")};
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
    std::istringstream text(read_input_file(path));
    std::string line;
    for (std::size_t number = 1; std::getline(text, line); ++number)
      if (!trimmed(line).empty()) rows_.push_back({number, csv_row(line)});
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

struct Measure {
  std::string name, unit;
};

Measure measure_of(const std::string& imt) {
  if (imt == "PGA") return {"PGA", "g"};
  if (imt == "PGV") return {"PGV", "cm/s"};
  if (imt.starts_with("SA(")) return {"Sa(" + imt.substr(3), "g"};
  return {};
}

}  // namespace

LimitStatesFile read_limit_states_file(const std::string& path,
                                       const std::vector<LimitState>& of_job) {
  config::Document document(path);
  config::Table root = root_of(document, "gurney-limit-states/1");
  LimitStatesFile file{of_job, {}, {}};
  if (root.has("limit_state")) {
    file.states = read_limit_states(root);
    for (const config::Node& each : document.tree().find("limit_state")->elements)
      file.where.push_back(document.where(each.place));
  } else if (!root.has("performance")) {
    root.note("limit_state", ": must be given, tables [[limit_state]], or performance, or both");
  }
  file.performance = read_performance(root, file.states);
  document.finish();
  return file;
}

SiteHazard read_hazard_file(const std::string& path) {
  require(!path.ends_with(".csv"),
          path +
              ": a table does not state the component of its measure; name it in a file of its "
              "own: schema = \"gurney-hazard/1\", openquake = \"FILE.csv\", component = "
              "\"RotD50\"");
  config::Document document(path);
  return read_site_hazard(document);
}

SiteHazard read_site_hazard(config::Document& document) {
  config::Table root = root_of(document, "gurney-hazard/1");
  if (root.has("openquake")) return read_openquake(root);
  const ScalingTarget target = read_scaling_target(root);
  IntensityPlan intensity;
  intensity.kind = IntensityPlan::Kind::kStripes;
  intensity.unit_in_si = target.unit_in_si;
  const std::optional<statistics::HazardCurve> curve = read_hazard(root, intensity);
  document.finish();
  return {*curve, name_of(target.measure) + " " + name_of(target.combination),
          root.where("measure")};
}

OpenQuakeHazard read_openquake_hazard(const std::string& path, std::optional<int> site) {
  const Rows rows(path);
  require(rows.size() >= 3 && rows.at(0).cells.front().text.starts_with('#'),
          path +
              ": is no hazard curve of OpenQuake: a line of comment, a line of titles, and a line "
              "for each site");
  std::string header;
  for (const CsvCell& cell : rows.at(0).cells) header += cell.text + ",";
  const std::string imt = stated(header, "imt");
  const Measure measure = measure_of(imt);
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

  OpenQuakeHazard hazard{measure.name, {}, {}};
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
    const double rate = -std::log1p(-*poe) / *years;
    if (!hazard.rate.empty() && !(rate < hazard.rate.back())) {
      hazard.im.pop_back();
      hazard.rate.pop_back();
    }
    hazard.im.push_back(*level * unit);
    hazard.rate.push_back(rate);
  }
  if (hazard.im.size() < 2)
    rows.fail(row, 1, "fewer than two levels have a probability between 0 and 1");
  return hazard;
}

}  // namespace gurney::study
