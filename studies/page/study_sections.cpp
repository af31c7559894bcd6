#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "studies/page/findings_html.h"
#include "studies/page/study_page.h"
#include "studies/report/fragility_report.h"
#include "studies/report/overview_report.h"
#include "studies/report/study_report.h"

namespace gurney::page {
namespace {

std::string percent(std::size_t count, std::size_t of) {
  return of == 0 ? "\u2013" : fmt::format("{:.3g} %", 100.0 * double(count) / double(of));
}

Html tile(const std::string& value, const std::string& name) {
  return element("li", element("b", value) + element("span", name));
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
  findings::Section answers;
  answers.add(report::answers_of(overview, page.data, page.fragilities));
  answers.add(report::compared_answers(overview, page.data));
  return {"summary", "At a glance",
          html(answers) + figure_of_curves(page) +
              caution_box(report::cautions_of(overview, page.data, page.fragilities)) +
              element("ul", tiles, {{"class", "key"}}) + html(report::energy_findings(overview))};
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
  return {"zones", "Zones", html(report::zone_findings(page.data))};
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
