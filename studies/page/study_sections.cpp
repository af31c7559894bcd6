#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "studies/analysis/zone_occupancy.h"
#include "studies/figures/labels.h"
#include "studies/page/findings_html.h"
#include "studies/page/study_page.h"
#include "studies/page/table.h"
#include "studies/report/failed_runs.h"
#include "studies/report/fragility_report.h"
#include "studies/report/overview_report.h"

namespace gurney::page {
namespace {

std::string percent(std::size_t count, std::size_t of) {
  return of == 0 ? "\u2013" : fmt::format("{:.3g} %", 100.0 * double(count) / double(of));
}

Html tile(const std::string& value, const std::string& name) {
  return element("li", element("b", value) + element("span", name));
}

/// What a reader has to know before any number of the page is used.
std::vector<std::string> cautions_of(const StudyPage& page) {
  const study::StudyOverview& overview = page.overview;
  std::vector<std::string> all;
  if (overview.failed > 0)
    all.push_back(fmt::format("{} of {}: excluded from every statistic",
                              report::failed_runs(overview.failed, overview.untrusted),
                              counted(overview.runs, "run")));
  if (overview.factors_on_records.above() + overview.factors_on_records.below() > 0)
    all.push_back("scale factors " + overview.factors_on_records.text());
  if (overview.warned > 0)
    all.push_back(fmt::format("in {} the building warned, such as: {}",
                              counted(overview.warned, "run"), overview.first_warning));
  if (overview.step_check)
    for (const study::StateChange& each : overview.step_check->states)
      all.push_back(fmt::format("with half the time step the outcome at {} differs in {} of {}",
                                each.state, each.runs.size(),
                                counted(overview.step_check->runs, "run")));
  if (overview.undrawn && overview.undrawn->parameters() > 0)
    all.push_back(
        fmt::format("{} with a range kept {}, so that this uncertainty is in no number of "
                    "this page: see Assumptions",
                    counted(overview.undrawn->parameters(), "parameter"),
                    overview.undrawn->parameters() == 1 ? "its value" : "their values"));
  for (const study::ZoneOccupancy& each : study::zone_occupancy(page.data))
    if (each.from_start > 0)
      all.push_back(fmt::format(
          "{}zone {}: an item stands in it from the start in {} of {}, which count as entries",
          each.configuration.empty() ? "" : each.configuration + ", ", each.zone, each.from_start,
          counted(each.runs, "run")));
  if (!overview.missing_demands.empty())
    all.push_back(fmt::format("this file was written by gurney {} and does not have: {}",
                              overview.file.program_version,
                              fmt::join(overview.missing_demands, ", ")));
  for (const study::FragilityResult& each : page.fragilities) {
    const study::ReportUnit unit = study::report_unit(page.data, each.measure);
    study::CurveAudit audit = each.audit;
    audit.factors = {};  // stated once, of all runs
    for (const std::string& caution : study::cautions(audit, unit))
      all.push_back((each.configuration.empty() ? "" : each.configuration + ", ") + each.state +
                    ": " + caution);
  }
  return all;
}

/// Long lists are folded away after the first lines.
Html caution_box(const std::vector<std::string>& all) {
  constexpr std::size_t kShown = 8;
  if (all.empty()) return {};
  const auto end = all.begin() + static_cast<std::ptrdiff_t>(std::min(kShown, all.size()));
  Html box = element("h3", "Cautions") + list({all.begin(), end});
  if (end != all.end())
    box += folded(fmt::format("{} more", all.end() - end), list({end, all.end()}));
  return element("div", box, {{"class", "cautions"}});
}

}  // namespace

Section study_summary(const StudyPage& page) {
  const study::StudyOverview& overview = page.overview;
  Html tiles = tile(std::to_string(overview.runs), "runs") +
               tile(std::to_string(overview.overturned), "overturned") +
               tile(std::to_string(overview.failed), "failed") +
               tile(std::to_string(overview.configurations.size()), "configurations") +
               tile(std::to_string(overview.file.motions.size()), "records");
  for (std::size_t i = 0; i < overview.states.size(); ++i) {
    std::size_t exceeded = 0, runs = 0;
    for (const study::LevelCounts& each : overview.counts) {
      exceeded += each.exceeded[i];
      runs += each.counted();
    }
    tiles += tile(percent(exceeded, runs), "of runs: " + overview.states[i].name);
  }
  std::vector<std::pair<std::string, std::string>> named;
  if (!std::isnan(overview.file.energy_closure))
    named.emplace_back("Energy balance",
                       fmt::format("closes within {:.2g} of the energy in play (worst: run {})",
                                   overview.file.energy_closure, overview.energy_closure_run));
  return {"summary", "At a glance",
          element("ul", tiles, {{"class", "key"}}) + caution_box(cautions_of(page)) + facts(named)};
}

Section study_design(const StudyPage& page) {
  const study::StudyOverview& overview = page.overview;
  const std::string what =
      overview.configurations.size() > 1 ? "configuration " + overview.configurations.front() : "";
  return {"design", "What was run",
          html(report::design_findings(overview)) +
              (page.scene ? scene_drawings(*page.scene, what, overview.units)
                          : paragraph(page.no_scene))};
}

Section study_outcomes(const StudyPage& page) {
  return {"outcomes", "Outcomes", html(report::share_findings(page.overview))};
}

Section study_zones(const StudyPage& page) {
  const study::ReportUnit length = page.overview.units.of("m"), seconds{"s", 1};
  Table table{"Zones of the room, over the runs that did not fail",
              {{"Zone"},
               {"Configuration"},
               {"Runs", true},
               {"Entered", true, "share of the runs in which an item entered the zone"},
               {"Occupied at the end", true, "share of the runs"},
               {"Mean time occupied (s)", true},
               {figures::with_unit("Median least free width", length), true,
                "of the widest free path along the zone"},
               {figures::with_unit("Smallest free width", length), true, "over all runs"}}};
  for (const study::ZoneOccupancy& each : study::zone_occupancy(page.data)) {
    Cell entered(percent(each.entered, each.runs)),
        at_end(percent(each.occupied_at_end, each.runs));
    entered.number = double(each.entered) / double(each.runs);
    at_end.number = double(each.occupied_at_end) / double(each.runs);
    table.rows.push_back({each.zone, each.configuration.empty() ? "all runs" : each.configuration,
                          each.runs, entered, at_end, Cell(each.occupied_time, seconds),
                          Cell(each.least_free_width, length),
                          Cell(each.smallest_free_width, length)});
  }
  return {"zones", "Zones", html(table)};
}

Section study_failures(const StudyPage& page) {
  const findings::Table table = report::failure_findings(page.overview);
  return {"failures", "Failed runs",
          table.rows.empty() ? paragraph("No run failed.") : html(table)};
}

Section study_time_step(const StudyPage& page) {
  if (page.overview.step_check)
    return {"time-step", "Time-step check",
            html(report::step_check_findings(*page.overview.step_check))};
  return {"time-step", "Time-step check",
          paragraph("The study asked for none (study.step_check): how far the time step changes "
                    "these results is not known from this file.")};
}

}  // namespace gurney::page
