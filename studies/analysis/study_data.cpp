#include "studies/analysis/study_data.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iterator>
#include <sstream>

#include "engine/base/error.h"
#include "engine/base/number_text.h"
#include "engine/base/printable.h"
#include "engine/config/document.h"
#include "engine/config/nearest_name.h"
#include "engine/config/table.h"
#include "engine/response/response.h"
#include "studies/job/old_names.h"
#include "studies/plan/study.h"

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

/// The table [study] of the job that the file holds; the job's other files are not needed.
Study study_of(const StudyReader& file) {
  config::Document document(file.job_text(), file.path() + " (its job)");
  rename_old_keys(document);
  config::Table root = document.root();
  auto table = root.table("study");
  require(table.has_value(), file.path() + ": its job has no table [study]");
  return read_study(*table, *document.tree().find("study"));
}

/// The checksums in lines of checksums and names of files.
std::string sums_of(const std::string& files) {
  std::istringstream lines(files);
  std::string sums;
  for (std::string sum, name; lines >> sum && std::getline(lines, name);) sums += sum + '\n';
  return sums;
}

/// For each record of a file: is it wanted? Empty where none is named.
std::vector<bool> named_records(const StudyReader& file, const std::vector<std::string>& wanted) {
  if (wanted.empty()) return {};
  const std::vector<std::string> names = file.strings("records/name");
  for (const std::string& name : wanted)
    require(
        std::ranges::find(names, name) != names.end(),
        fmt::format("{}: no record '{}'{}", file.path(), name, config::suggestion(name, names)));
  std::vector<bool> named;
  for (const std::string& name : names)
    named.push_back(std::ranges::find(wanted, name) != wanted.end());
  return named;
}

/// Whether the file has the columns that a limit state asks for.
bool has_all(const StudyReader& file, const std::vector<LimitState>& states, std::size_t state) {
  const LimitState& of = states.at(state);
  if (of.is_simple()) return file.has_column(table_of(of.quantity.of) + "/" + of.quantity.column);
  return std::ranges::all_of(of.parts,
                             [&](std::size_t part) { return has_all(file, states, part); });
}

constexpr double kRounding = 1e-9;  // of a measure, relative

bool is_number(const std::vector<double>& values) {
  return std::ranges::any_of(values, [](double value) { return !std::isnan(value); });
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
    const bool has_items = quantity.of == Quantity::Of::kItem || !quantity.item.empty();
    if (has_items && !counts_of(quantity, strings(place.table + "/item")[row])) continue;
    if (!place.part.empty() && strings(place.table + "/" + place.part)[row] != quantity.part)
      continue;
    values.push_back(column[row]);
  }
  return values;
}

StudyData::StudyData(const std::string& path, const AssessmentRequest& request,
                     const std::vector<std::string>& records, const UnitSystem& units)
    : file_(std::make_unique<StudyReader>(path)),
      values_(*file_),
      study_(study_of(*file_)),
      units_(units),
      assessment_(assessment_of(*file_, study_, request)) {
  configurations_ = file_->strings("configurations/name");
  runs_.resize(configurations_.size());
  failed_.resize(configurations_.size());
  const std::vector<double> configuration = file_->numbers("runs/configuration");
  const std::vector<double> record = file_->numbers("runs/record");
  const std::vector<std::string> outcome = file_->strings("runs/outcome");
  const std::vector<bool> counts = named_records(*file_, records);
  for (std::size_t run = 0; run < configuration.size(); ++run) {
    const auto of = static_cast<std::size_t>(configuration[run]);
    record_.push_back(static_cast<std::size_t>(record[run]));
    if (!counts.empty() && !counts.at(record_.back())) continue;
    if (is_failure(outcome[run]))
      ++failed_.at(of);
    else
      runs_.at(of).push_back(run);
  }
  row_ = record_;
  if (file_->has("motions")) {
    const auto sets = file_->strings("records/set");
    std::vector<std::size_t> first;  // row of each set; rows of a set follow each other
    for (std::size_t row = 0; row < sets.size(); ++row)
      if (row == 0 || sets[row] != sets[row - 1]) first.push_back(row);
    const auto motion = file_->numbers("runs/motion"), set = file_->numbers("motions/set");
    for (std::size_t run = 0; run < row_.size(); ++run)
      row_[run] +=
          first.at(static_cast<std::size_t>(set.at(static_cast<std::size_t>(motion[run]))));
  }
  suites_by_level_ = each_record_has_one_of_several_levels();
  group_ = record_;
  if (suites_by_level_ && file_->has("motions")) join_same_files();
}

bool StudyData::each_record_has_one_of_several_levels() const {
  if (study_.intensity.kind != IntensityPlan::Kind::kStripes) return false;
  const std::vector<double> intensities = file_->numbers("runs/intensity");
  if (std::ranges::all_of(intensities, [&](double each) { return each == intensities[0]; }))
    return false;
  std::map<std::size_t, double> of_row;
  for (std::size_t run = 0; run < row_.size(); ++run)
    if (of_row.emplace(row_[run], intensities[run]).first->second != intensities[run]) return false;
  return true;
}

void StudyData::join_same_files() {
  const auto sets = file_->strings("records/set");
  std::vector<std::string> sums;  // checksums of the files of each record
  for (const std::string& files : file_->strings("records/files")) sums.push_back(sums_of(files));
  std::vector<std::size_t> first_same;  // row of the same set, for each row
  for (std::size_t row = 0, begin = 0; row < sets.size(); ++row) {
    if (sets[row] != sets[begin]) begin = row;
    std::size_t same = sums[row].empty() ? row : begin;
    while (sums[same] != sums[row]) ++same;
    first_same.push_back(same);
  }
  for (std::size_t run = 0; run < group_.size(); ++run)
    group_[run] -= row_[run] - first_same.at(row_[run]);
}

std::vector<double> StudyData::factors_on_records() const {
  std::vector<double> factors = file_->numbers("runs/scale");
  if (!file_->has_column("records/scale")) return factors;
  const std::vector<std::string> stated = file_->strings("records/scale");
  for (std::size_t run = 0; run < factors.size(); ++run) {
    const std::string& text = stated.at(row_[run]);
    const std::optional<double> scale = number(text);
    require(scale && *scale > 0 && std::isfinite(*scale),
            fmt::format("{}: /records/scale[{}] = '{}': must be a number > 0", file_->path(),
                        row_[run], printable(text)));
    factors[run] *= *scale;
  }
  return factors;
}

std::vector<std::string> StudyData::measures() const {
  std::vector<std::string> names;
  const std::string own = file_->text_attribute("intensity_measure");
  if (!own.empty()) names.push_back(own);
  for (const KeptMeasure& kept : study_.measures) {
    const std::string name = name_of(kept.measure) + " " + name_of(kept.combination);
    if (std::ranges::find(names, name) == names.end()) names.push_back(name);
  }
  names.insert(names.end(), {"pfa", "pfv"});
  return names;
}

RunMeasure StudyData::measure(const std::string& name) const {
  const std::vector<std::string> names = measures();
  if (name.empty()) return measure(names.front());
  require(std::ranges::find(names, name) != names.end(),
          fmt::format("{}: no intensity measure '{}'{}", file_->path(), name,
                      config::suggestion(name, names)));
  if (name == "pfa") return {name, "m/s2", file_->numbers("runs/pfa")};
  if (name == "pfv") return {name, "m/s", file_->numbers("runs/pfv")};
  if (name == file_->text_attribute("intensity_measure"))
    return {name, file_->text_attribute("intensity_units"), file_->numbers("runs/intensity")};
  const std::vector<double> of_motion = file_->numbers("motions/" + name);
  RunMeasure measure{name, "", {}};
  for (const KeptMeasure& kept : study_.measures)
    if (name == name_of(kept.measure) + " " + name_of(kept.combination))
      measure.units = groundmotions::si_unit_of(kept.measure);
  for (const double motion : file_->numbers("runs/motion"))
    measure.values.push_back(of_motion.at(static_cast<std::size_t>(motion)));
  require(is_number(measure.values), file_->path() + ": no record has " + name);
  return measure;
}

bool StudyData::traces(std::size_t configuration, const RunMeasure& measure) const {
  if (!is_ida()) return false;
  const std::vector<double> own = file_->numbers("runs/intensity"),
                            cases = file_->numbers("runs/analysis_case");
  std::map<double, std::map<double, double>> of_case;  // measure by the study's own
  for (const std::size_t run : runs_.at(configuration))
    if (measure.values[run] > 0) of_case[cases[run]][own[run]] = measure.values[run];
  for (const auto& [number, values] : of_case)
    for (auto next = std::next(values.begin()); next != values.end(); ++next)
      if (!(next->second > std::prev(next)->second * (1 + kRounding))) return false;
  return true;
}

std::set<std::size_t> StudyData::ended_cases(std::size_t configuration) const {
  const IntensityPlan& plan = study_.intensity;
  const std::vector<double> cases = file_->numbers("runs/analysis_case");
  const bool known = has_all(*file_, study_.limit_states, plan.until);
  std::set<std::size_t> ended;
  for (const std::size_t run : runs_.at(configuration))
    if (!known || exceeded(study_.limit_states, plan.until, values_.of_run(run)))
      ended.insert(static_cast<std::size_t>(cases[run]));
  return ended;
}

const statistics::HazardCurve* StudyData::hazard_over(const RunMeasure& measure) const {
  if (!assessment_.hazard) return nullptr;
  const SiteHazard& hazard = *assessment_.hazard;
  if (hazard.measure == measure.name) return &hazard.curve;
  require(hazard.where.empty(),
          fmt::format("{}: the hazard is over {}, the curves are over {}; --measure NAME chooses "
                      "another, {} has {}",
                      hazard.where, hazard.measure, measure.name, file_->path(),
                      fmt::join(measures(), ", ")));
  return nullptr;
}

std::string StudyData::other_hazard(const RunMeasure& measure) const {
  const auto& hazard = assessment_.hazard;
  return hazard && hazard->measure != measure.name ? hazard->measure : "";
}

std::vector<bool> StudyData::exceedances(std::size_t state,
                                         const std::vector<std::size_t>& runs) const {
  std::vector<bool> result;
  for (const std::size_t run : runs)
    result.push_back(exceeded(limit_states(), state, values_.of_run(run)));
  return result;
}

std::vector<statistics::Observation> StudyData::observations(std::size_t state,
                                                             std::size_t configuration,
                                                             const RunMeasure& measure) const {
  const std::vector<std::size_t>& runs = runs_.at(configuration);
  const std::vector<bool> exceeds = exceedances(state, runs);
  std::map<std::size_t, bool> exceeded;
  for (std::size_t i = 0; i < runs.size(); ++i) exceeded.emplace(runs[i], exceeds[i]);
  return observations(exceeded, configuration, measure);
}

std::vector<statistics::Observation> StudyData::observations(
    const std::map<std::size_t, bool>& exceeded, std::size_t configuration,
    const RunMeasure& measure) const {
  require(exceeded.empty() || exceeded.rbegin()->first < record_.size(),
          fmt::format("{}: no run {}; it has {}", file_->path(),
                      exceeded.empty() ? 0 : exceeded.rbegin()->first, record_.size()));
  const std::vector<double> cases = file_->numbers("runs/analysis_case");
  std::vector<statistics::Observation> result;
  for (const std::size_t run : runs_.at(configuration)) {
    const auto outcome = exceeded.find(run);
    if (outcome != exceeded.end() && measure.values[run] > 0)
      result.push_back({measure.values[run], outcome->second, group_[run],
                        static_cast<std::size_t>(cases[run])});
  }
  return result;
}

std::size_t StudyData::overturned_short_of(std::size_t state, std::size_t configuration) const {
  const LimitState& limit = limit_states().at(state);
  if (limit.kind != LimitState::Kind::kAbove || units_of(limit.quantity) != "m") return 0;
  const Quantity overturned{Quantity::Of::kItem, "time_of_overturning", limit.quantity.item, ""};
  const std::vector<std::size_t>& runs = runs_.at(configuration);
  const std::vector<bool> exceeds = exceedances(state, runs);
  std::size_t count = 0;
  for (std::size_t i = 0; i < runs.size(); ++i)
    count += !exceeds[i] && std::ranges::any_of(values_(runs[i], overturned),
                                                [](double time) { return time >= 0; });
  return count;
}

std::vector<statistics::CloudPoint> StudyData::cloud(std::size_t state, std::size_t configuration,
                                                     const RunMeasure& measure,
                                                     double floor) const {
  const LimitState& limit = limit_states().at(state);
  const bool sized = limit.kind == LimitState::Kind::kAbove && limit.limit > 0;
  require(sized, fmt::format("limit state '{}' ({}): a cloud needs a demand above a limit",
                             limit.name, limit.words));
  std::vector<statistics::CloudPoint> points;
  const Quantity overturned{Quantity::Of::kItem, "time_of_overturning", limit.quantity.item, ""};
  for (const std::size_t run : runs_.at(configuration)) {
    double demand = 0;
    for (const double value : values_(run, limit.quantity))
      if (value > demand) demand = value;
    bool fell = false;
    for (const double time : values_(run, overturned)) fell = fell || time >= 0;
    statistics::CloudPoint point{measure.values[run], std::max(demand, floor),
                                 statistics::CloudPoint::Known::kExactly, group_[run]};
    if (fell) {
      point.known = statistics::CloudPoint::Known::kAtLeast;
      point.edp = std::max(demand, limit.limit);
    } else if (demand <= floor) {
      point.known = statistics::CloudPoint::Known::kAtMost;
    }
    if (point.im > 0) points.push_back(point);
  }
  return points;
}

ReportUnit report_unit(const StudyData& data, const RunMeasure& measure) {
  return data.units().chosen() ? data.units().of(measure.units) : unit_of_levels(data, measure);
}

ReportUnit unit_of_levels(const StudyData& data, const RunMeasure& measure) {
  const IntensityPlan& plan = data.study().intensity;
  const bool stated =
      plan.unit_in_si != 1 && measure.name == data.file().text_attribute("intensity_measure");
  return stated ? ReportUnit{plan.unit, plan.unit_in_si} : UnitSystem().of(measure.units);
}

std::string place_of_job(const std::string& job, const std::string& results) {
  if (!job.empty()) return job;
  return (std::filesystem::path(results).parent_path() / "the job of the results.toml").string();
}

}  // namespace gurney::study
