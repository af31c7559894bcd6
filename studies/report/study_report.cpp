#include "studies/report/study_report.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

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

/// "brakes on: overturned at a median PGV of 0.97 m/s (95 % of it 0.72 to 1.6)."
std::string headline(const study::StudyOverview& overview, const study::FragilityResult& of,
                     const study::ReportUnit& unit) {
  const std::string subject =
      (of.configuration.empty() ? std::string() : subject_of(overview, of.configuration) + ", ") +
      of.state + ": ";
  if (!of.curve()) return subject + study::no_curve_text(of, unit) + ".";
  return fmt::format(
      "{}median {} of {:.3g}{} (95 % interval {}), dispersion {:.2f}.", subject, of.measure.name,
      of.curve()->theta / unit.in_si, unit.name == "1" ? "" : " " + unit.name,
      study::interval_text(of.band.theta, unit.in_si, 3, of.records), of.curve()->beta);
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
  if (overview.warned > 0)
    all.push_back(fmt::format("in {} the building warned, such as: {}",
                              counted_words(overview.warned, "run"), overview.first_warning));
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

}  // namespace

findings::List answers_of(const study::StudyOverview& overview, const study::StudyData& data,
                          const std::vector<study::FragilityResult>& fragilities) {
  findings::List answers{"", "Intensity at which a limit state is exceeded", {}};
  for (const study::FragilityResult& each : fragilities)
    answers.lines.push_back(headline(overview, each, study::report_unit(data, each.measure)));
  return answers;
}

findings::Section study_findings(const study::StudyOverview& overview, const study::StudyData& data,
                                 const std::vector<study::FragilityResult>& fragilities) {
  findings::Section all;
  all.add(answers_of(overview, data, fragilities));
  return std::move(all.list("", findings::kCautions, cautions_of(overview, data, fragilities)));
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
