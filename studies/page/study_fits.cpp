#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/base/shell_word.h"
#include "studies/figures/fragility_figure.h"
#include "studies/figures/labels.h"
#include "studies/figures/sensitivity_figure.h"
#include "studies/page/drawing.h"
#include "studies/page/findings_html.h"
#include "studies/page/study_page.h"
#include "studies/page/table.h"
#include "studies/report/fragility_report.h"
#include "studies/study/analysis/performance.h"

namespace gurney::page {
namespace {

std::vector<Cell> row_of(const study::FragilityResult& of, const study::ReportUnit& unit,
                         bool rates) {
  const study::ReportUnit one{"1", 1};
  const std::string exceeded =
      fmt::format("{} of {} {}", of.audit.exceeded, of.audit.outcomes, of.audit.counted);
  std::vector<Cell> row{of.state, of.configuration.empty() ? "all runs" : of.configuration,
                        exceeded};
  if (const auto curve = of.curve()) {
    row.insert(row.end(), {Cell(curve->theta, unit), Cell(curve->beta, one, 2),
                           study::interval_text(of.band.theta, unit.in_si, 3, of.records),
                           study::interval_text(of.band.beta, 1, 2, of.records)});
  } else {
    row.insert(row.end(), {"\u2013", "\u2013", study::no_curve_text(of, unit), "\u2013"});
  }
  if (rates && of.rate) {
    row.insert(row.end(),
               {Cell(of.rate->rate, one), study::rate_interval_text(*of.rate, of.records),
                Cell(100 * statistics::probability_in(50, of.rate->rate), one, 2)});
  } else if (rates) {
    row.insert(row.end(), 3, Cell("\u2013"));
  }
  return row;
}

Html table_of(const StudyPage& page) {
  const auto& all = page.fragilities;
  const study::ReportUnit unit = study::report_unit(page.data, all.front().measure);
  const bool rates =
      std::ranges::any_of(all, [](const auto& each) { return each.rate.has_value(); });
  const std::string of_unit = unit.name == "1" ? "" : " (" + unit.name + ")";
  Table table{fmt::format("Lognormal fragility curves over {}", all.front().measure.name),
              {{"Limit state"},
               {"Configuration"},
               {"Exceeded"},
               {"\u03b8" + of_unit, true, "median"},
               {"\u03b2", true, "dispersion"},
               {"95 % of \u03b8"},
               {"95 % of \u03b2"}}};
  if (rates) {
    table.columns.push_back({"Rate (1/year)", true, "mean annual rate of exceedance"});
    table.columns.push_back({"95 % of the rate"});
    table.columns.push_back({"In 50 years (%)", true});
  }
  for (const study::FragilityResult& each : all) table.rows.push_back(row_of(each, unit, rates));
  return html(table);
}

Html figure_of(const StudyPage& page) {
  std::vector<study::FragilityResult> drawn;
  std::vector<std::string> configurations;
  for (const study::FragilityResult& each : page.fragilities) {
    if (std::ranges::find(configurations, each.configuration) == configurations.end())
      configurations.push_back(each.configuration);
    if (configurations.size() <= kMaxConfigurations) drawn.push_back(each);
  }
  Html figure = html(Drawing{
      "fragility", figures::fragility_figure(page.data, drawn, {.most_marks = kMaxMarks}),
      "Fragility curves with 95 % confidence bands, where there are enough records; a panel "
      "for each limit state.",
      "Probability of exceedance over intensity; the table has medians and dispersions."});
  if (configurations.size() > kMaxConfigurations)
    figure += paragraph(fmt::format(
        "The figure draws the first {} of {} configurations. Others: gurney fragility {} "
        "--configuration NAME --figure fragility.svg.",
        kMaxConfigurations, configurations.size(), shell_word(page.path)));
  return figure;
}

Html notes_of(const StudyPage& page) {
  if (page.fragilities.empty()) return {};
  const std::vector<std::string> all = report::notes_on_curves(
      page.fragilities, study::report_unit(page.data, page.fragilities.front().measure));
  if (all.empty()) return {};
  return element("h3", "Notes on the curves") +
         (all.size() > 12 ? folded(counted(all.size(), "note"), list(all)) : list(all));
}

Html performance_of(const StudyPage& page) {
  Html all;
  for (const study::PerformanceTable& of : study::performance_tables(page.data, page.fragilities)) {
    const auto& measure = page.fragilities.front().measure;
    const study::ReportUnit unit = study::report_unit(page.data, measure), percent{"%", 0.01};
    Table table{fmt::format("{}Probability (%) that each level is the worst that is reached",
                            of.configuration.empty() ? "" : of.configuration + ": "),
                {{figures::with_unit(measure.name, unit), true}, {"none", true}}};
    for (const std::string& level : of.levels) table.columns.push_back({level, true});
    for (std::size_t i = 0; i < of.im.size(); ++i) {
      std::vector<Cell> row{Cell(of.im[i], unit)};
      for (const double probability : of.at[i].of_level) row.emplace_back(probability, percent);
      table.rows.push_back(std::move(row));
    }
    all += html(table);
  }
  return all.empty() ? all : element("h3", "Performance levels") + all;
}

}  // namespace

Section study_fragility(const StudyPage& page) {
  if (page.fragilities.empty()) return {"fragility", "Fragility", {}};
  return {"fragility", "Fragility",
          paragraph("P(limit state | im) = \u03a6(ln(im / \u03b8) / \u03b2)") + table_of(page) +
              figure_of(page) + notes_of(page) + performance_of(page)};
}

Section study_sensitivity(const StudyPage& page) {
  Html content;
  for (std::size_t i = 0; i < page.sensitivities.size(); ++i) {
    const report::SensitivityReport& each = page.sensitivities[i];
    const study::StudySensitivity& found = each.found;
    if (page.sensitivities.size() > 1 && !each.configuration.empty())
      content += element("h3", each.configuration);
    if (!each.why_not.empty()) {
      content += paragraph("No sensitivity: " + each.why_not);
      continue;
    }
    content +=
        paragraph(report::sensitivity_title(each)) +
        html(Drawing{fmt::format("sensitivity-{}", i + 1), figures::sensitivity_figure(each),
                     "Sensitivity: indices with 95 % intervals, and tornado.",
                     "First-order indices of the inputs, and means of the demand where an input is "
                     "low or high; the table has the numbers."}) +
        html(report::sensitive_inputs(each)) + list(report::sensitivity_remarks(found));
  }
  return {"sensitivity", "Sensitivity", content};
}

}  // namespace gurney::page
