#include "studies/analysis/suite_spectra.h"

#include <fmt/format.h>

#include <algorithm>

#include "engine/base/error.h"
#include "groundmotions/measures/combination.h"
#include "groundmotions/measures/response_spectrum.h"
#include "studies/analysis/configuration_view.h"
#include "studies/analysis/study_data.h"
#include "studies/plan/study_motions.h"

namespace gurney::study {
namespace {

using groundmotions::Combination;
using groundmotions::Direction;
using groundmotions::Record;

/// Combination of the study's measure where spectra and the records have it.
Combination combination_for(const Study& study, const Record& record) {
  const bool both = record[Direction::kH1] && record[Direction::kH2];
  if (!both) return record[Direction::kH1] ? Combination::kH1 : Combination::kH2;
  const bool stated = study.intensity.kind != IntensityPlan::Kind::kScales &&
                      study.intensity.combination != Combination::kResultant &&
                      study.intensity.combination != Combination::kVertical;
  return stated ? study.intensity.combination : Combination::kGeometricMean;
}

/// @param files  "SHA-256 name" of each, as /records has them
void require_same(const Record& record, const std::string& files, const std::string& results) {
  for (const auto& component : record.components)
    require(!component || component->sha256.empty() ||
                files.find(component->sha256) != std::string::npos,
            fmt::format("{}: the record '{}' is not as the study read it: {} has changed", results,
                        record.name, component ? component->file : ""));
}

/// A value of the study's measure, or a factor, and its name.
std::pair<double, std::string> level_of(const StudyData& data, std::optional<std::size_t> wanted) {
  const IntensityPlan& plan = data.study().intensity;
  if (plan.kind == IntensityPlan::Kind::kIda) {
    const RunMeasure measure = data.measure("");
    const ReportUnit unit = report_unit(data, measure);
    return {plan.first,
            fmt::format("{} = {:.4g} {}", measure.name, plan.first / unit.in_si, unit.name)};
  }
  const Levels levels(data);
  require(!levels.values().empty(), data.file().path() + ": has no runs");
  const std::size_t level = wanted.value_or(levels.values().size() - 1);
  require(level < levels.values().size(),
          fmt::format("{}: has no level {}; it has {}", data.file().path(), level + 1,
                      levels.values().size()));
  return {levels.values()[level], levels.name_of(level)};
}

}  // namespace

std::vector<SuiteSpectra> suite_spectra(const StudyData& data, const SuiteSpectraRequest& request) {
  const std::string path = data.file().path();
  const auto [value, name] = level_of(data, request.level);
  const StudyJob job(data.file().job_text(), place_of_job(request.job, path));
  const StudyMotions motions(job);
  const config::FileSnapshot::Scope scope(job.files());
  const bool factors = data.study().intensity.kind == IntensityPlan::Kind::kScales;
  const auto files = data.file().strings("records/files");
  std::vector<SuiteSpectra> all(motions.sets());
  for (std::size_t i = 0; i < data.configurations().size(); ++i) {
    if (!request.configurations.empty() &&
        std::ranges::find(request.configurations, i) == request.configurations.end())
      continue;
    SuiteSpectra& spectra = all[motions.index_of(i)];
    spectra.configurations.push_back(data.configurations()[i]);
    const std::vector<std::size_t> rows = record_rows({&data, i});
    if (!spectra.records.empty() || rows.empty()) continue;
    const MotionSet& set = motions.set_of(i);
    spectra.level = name;
    spectra.periods = groundmotions::logarithmic_periods(0.02, 10, request.periods);
    for (std::size_t record = 0; record < set.size(); ++record) {
      if (data.has_suites_by_level() && set.levels(record).front() != value) continue;
      const FloorRecords::Shared kept = set.ground_record(record);
      const Record& ground = *kept;
      if (ground.samples() == 0) continue;
      if (record < rows.size()) require_same(ground, files.at(rows[record]), path);
      spectra.combination = combination_for(data.study(), ground);
      SuiteSpectra::Record of{
          set.name(record),
          factors ? value : set.scale_for(record, value),
          groundmotions::combined_spectrum(spectra.combination, ground, spectra.periods),
          {}};
      if (set.has_building())
        of.floor = groundmotions::combined_spectrum(
            spectra.combination, *set.floor_record(record, of.factor), spectra.periods);
      spectra.records.push_back(std::move(of));
    }
  }
  std::erase_if(all, [](const SuiteSpectra& each) { return each.records.empty(); });
  require(!all.empty(), path + ": its floor is at rest, or all of its runs failed");
  return all;
}

std::optional<FloorSpectra> floor_spectra(const StoredHistories& histories) {
  constexpr const char* kName = "floor_acceleration";
  constexpr int kPeriods = 60;
  constexpr double kLongest = 10, kSteps = 10;
  const std::vector<std::string> names = histories.names();
  if (histories.runs().empty() || std::ranges::find(names, kName) == names.end()) return {};
  const StoredHistory floor = histories.history(kName, histories.runs().front());
  if (floor.time.size() < 3) return {};
  const double step = floor.time[1] - floor.time[0];
  // The last sample stands at the end of the run, wherever that is.
  const auto count = static_cast<Eigen::Index>(floor.time.size() - 1);
  if (!(step > 0) || kSteps * step >= kLongest) return {};
  FloorSpectra spectra{
      groundmotions::logarithmic_periods(std::max(0.02, kSteps * step), kLongest, kPeriods), {}};
  for (const StoredHistory::Series& series : floor.series) {
    const Eigen::Map<const Eigen::VectorXd> acceleration(series.values.data(), count);
    if (!acceleration.allFinite() || acceleration.isZero(0)) continue;
    spectra.of_axis.emplace_back(
        series.axis,
        groundmotions::response_spectrum(step, acceleration, spectra.periods).pseudo_acceleration);
  }
  if (spectra.of_axis.empty()) return {};
  return spectra;
}

}  // namespace gurney::study
