#include "studies/report/study_report.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "engine/base/error.h"
#include "studies/analysis/study_comparison.h"
#include "studies/analysis/zone_occupancy.h"
#include "studies/report/formats.h"

namespace gurney::report {
namespace {

std::string counted_words(std::size_t count, const std::string& what) {
  return fmt::format("{} {}{}", count, what, count == 1 ? "" : "s");
}

/// "brakes on" of a study with one factor, else the configuration.
std::string subject_of(const study::StudyOverview& overview, const std::string& configuration) {
  return overview.factors.size() == 1 ? overview.factors.front().name + " " + configuration
                                      : configuration;
}

/// "brakes on, overturned".
std::string subject_of(const study::StudyOverview& overview, const study::FragilityResult& of) {
  return (of.configuration.empty() ? "" : subject_of(overview, of.configuration) + ", ") + of.state;
}

/// `PGV (larger)` of `PGV larger`.
std::string measure_words(const std::string& measure) {
  const auto at = measure.rfind(' ');
  return at == std::string::npos ? measure
                                 : measure.substr(0, at) + " (" + measure.substr(at + 1) + ")";
}

/// "brakes on, overturned: median PGV (larger) of 0.97 m/s (95 % interval 0.72 to 1.6), dispersion 0.85."
std::string headline(const study::StudyOverview& overview, const study::FragilityResult& of,
                     const study::ReportUnit& unit) {
  const std::string subject = subject_of(overview, of) + ": ";
  return fmt::format("{}median {} of {:.3g}{} (95 % interval {}), dispersion {:.2f}.", subject,
                     measure_words(of.measure.name), of.curve()->theta / unit.in_si,
                     unit.name == "1" ? "" : " " + unit.name,
                     study::interval_text(of.band.theta, unit.in_si, 3, of.records),
                     of.curve()->beta);
}

}  // namespace

std::string building_caution(const study::StudyOverview& overview) {
  if (overview.warned == 0) return {};
  return fmt::format("in {} the building warned, such as: {}",
                     counted_words(overview.warned, "run"), overview.first_warning);
}

findings::Texts cautions_of(const study::StudyOverview& overview, const study::StudyData& data,
                            const std::vector<study::FragilityResult>& fragilities) {
  findings::Texts all;
  if (overview.failed > 0)
    all.push_back(fmt::format("{} of {}: excluded from every statistic",
                              failed_runs(overview.failed, overview.untrusted),
                              counted_words(overview.runs, "run")));
  if (overview.factors_on_records.above() + overview.factors_on_records.below() > 0)
    all.push_back("scale factors " + overview.factors_on_records.text());
  if (const std::string building = building_caution(overview); !building.empty())
    all.push_back(building);
  if (overview.step_check)
    for (const study::StateChange& each : overview.step_check->states)
      all.push_back(fmt::format("with half the time step the outcome at {} differs in {} of {}",
                                each.state, each.runs.size(),
                                counted_words(overview.step_check->runs, "run")));
  if (overview.undrawn && overview.undrawn->parameters() > 0)
    all.push_back(
        fmt::format("{} with a range kept {}, so that this uncertainty is in no number of "
                    "this page: see Assumptions",
                    counted_words(overview.undrawn->parameters(), "parameter"),
                    overview.undrawn->parameters() == 1 ? "its value" : "their values"));
  for (const study::ZoneOccupancy& each : study::zone_occupancy(data))
    if (each.from_start > 0)
      all.push_back(fmt::format(
          "{}zone {}: an item stands in it from the start in {} of {}, which count as entries",
          each.configuration.empty() ? "" : each.configuration + ", ", each.zone, each.from_start,
          counted_words(each.runs, "run")));
  if (!overview.missing_demands.empty())
    all.push_back(fmt::format("this file was written by gurney {} and does not have: {}",
                              overview.file.program_version,
                              fmt::join(overview.missing_demands, ", ")));
  for (const study::FragilityResult& each : fragilities) {
    const study::ReportUnit unit = study::report_unit(data, each.measure);
    study::CurveAudit audit = each.audit;
    audit.factors = {};  // stated once, of all runs
    for (const std::string& caution : study::cautions(audit, unit))
      all.push_back((each.configuration.empty() ? "" : each.configuration + ", ") + each.state +
                    ": " + caution);
  }
  return all;
}

findings::List answers_of(const study::StudyOverview& overview, const study::StudyData& data,
                          const std::vector<study::FragilityResult>& fragilities) {
  findings::List answers{"", "Intensity at which a limit state is exceeded", {}};
  std::vector<std::pair<std::string, findings::Texts>> without;  // a reason, and what it is of
  for (const study::FragilityResult& each : fragilities) {
    const study::ReportUnit unit = study::report_unit(data, each.measure);
    if (each.curve()) {
      answers.lines.push_back(headline(overview, each, unit));
      continue;
    }
    const std::string reason = study::no_curve_text(each, unit);
    auto same = std::ranges::find(without, reason, &std::pair<std::string, findings::Texts>::first);
    if (same == without.end()) same = without.insert(same, {reason, {}});
    same->second.push_back(subject_of(overview, each));
  }
  for (const auto& [reason, subjects] : without)
    answers.lines.push_back(fmt::format("{}: {}.", fmt::join(subjects, "; "), reason));
  return answers;
}

findings::List compared_answers(const study::StudyOverview& overview,
                                const study::StudyData& data) {
  findings::List answers{"", "", {}};
  if (overview.configurations.size() != 2) return answers;
  study::StudyComparison found;
  try {
    found = study::compare_studies({&data, 0}, {&data, 1},
                                   {.demands = {"peak_displacement"}, .resamples = 1});
  } catch (const Error&) {
    return answers;
  }
  if (found.pairs.group == study::RunPairs::Group::kNone) return answers;
  answers.title =
      fmt::format("{} instead of {}, over all intensities",
                  subject_of(overview, overview.configurations[1]), overview.configurations[0]);
  for (const study::ComparedQuantity& each : found.quantities) {
    if (each.kind != study::ComparedQuantity::Kind::kShare) continue;
    const bool shown = each.p_holm < 0.05;
    answers.lines.push_back(fmt::format(
        "{}: {:.3g} % of the runs instead of {:.3g} %, {} (95 % interval of the difference {:.3g} "
        "to {:.3g} points, by {} {}, p = {:.2g}).",
        each.name, 100 * each.b, 100 * each.a,
        !shown                ? "which shows no difference"
        : each.difference < 0 ? "less often"
                              : "more often",
        100 * each.interval.low, 100 * each.interval.high, each.groups,
        found.pairs.group == study::RunPairs::Group::kRecord ? "records" : "draws", each.p_holm));
  }
  return answers;
}

findings::Table zone_findings(const study::StudyData& data) {
  const findings::Format width = format_of(data.units().of("m"), 1, ".3g"), share{".3g", "%", 0.01};
  findings::Table table{
      "",
      "Zones of the room, over the runs that did not fail",
      {{"", "zone"},
       {"", "configuration"},
       {"", "runs"},
       {"", "entered", share, "share of the runs in which an item entered the zone"},
       {"", "occupied at the end", share, "share of the runs"},
       {"", "mean time occupied", {".3g", "s"}},
       {"", "median least free width", width, "of the widest free path along the zone"},
       {"", "smallest free width", width, "over all runs"}}};
  for (const study::ZoneOccupancy& each : study::zone_occupancy(data)) {
    const auto share_of = [&](std::size_t count) {
      return static_cast<double>(count) / static_cast<double>(each.runs);
    };
    table.add({each.zone, each.configuration.empty() ? "all runs" : each.configuration, each.runs,
               share_of(each.entered), share_of(each.occupied_at_end), each.occupied_time,
               each.least_free_width, each.smallest_free_width});
  }
  return table;
}

std::string failed_runs(std::size_t failed, std::size_t untrusted) {
  return fmt::format("{} failed", failed) +
         (untrusted > 0 ? fmt::format(" ({} untrusted)", untrusted) : "");
}

}  // namespace gurney::report
