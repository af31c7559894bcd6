#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "engine/base/shell_word.h"
#include "studies/figures/fragility_figures.h"
#include "studies/figures/labels.h"
#include "studies/figures/sensitivity_figures.h"
#include "studies/page/drawing.h"
#include "studies/page/findings_html.h"
#include "studies/page/study_page.h"
#include "studies/report/fragility_report.h"

namespace gurney::page {
namespace {

Html table_of(const StudyPage& page) {
  const auto& all = page.fragilities;
  findings::Table table = report::fragility_table(
      all, study::report_unit(page.data, all.front().measure),
      std::ranges::any_of(all, [](const auto& each) { return each.rate.has_value(); }));
  table.title = fmt::format("Lognormal fragility curves over {}", all.front().measure.name);
  return html(table);
}

}  // namespace

Html figure_of_curves(const StudyPage& page) {
  std::vector<study::FragilityResult> drawn;
  std::vector<std::string> configurations;
  std::set<std::string> with_curve;
  for (const study::FragilityResult& each : page.fragilities)
    if (each.curve()) with_curve.insert(each.state);
  for (const study::FragilityResult& each : page.fragilities) {
    if (!with_curve.contains(each.state)) continue;
    if (std::ranges::find(configurations, each.configuration) == configurations.end())
      configurations.push_back(each.configuration);
    if (configurations.size() <= kMaxConfigurations) drawn.push_back(each);
  }
  if (drawn.empty()) return {};
  const figures::PlotPage paper{.width = kNarrow, .most_marks = kMaxMarks, .apart = true};
  Html figure = side_by_side(html(
      Drawing{"fragility", figures::fragility_figure(page.data, drawn, paper),
              "Fragility curves with 95 % confidence bands, where there are enough records.",
              "Probability of exceedance over intensity; the table has medians and dispersions."}));
  if (configurations.size() > kMaxConfigurations)
    figure += paragraph(fmt::format(
        "The figure draws the first {} of {} configurations. Others: gurney fragility {} "
        "--configuration NAME --figure fragility.svg.",
        kMaxConfigurations, configurations.size(), shell_word(page.path)));
  return figure;
}

namespace {

Html notes_of(const StudyPage& page) {
  if (page.fragilities.empty()) return {};
  const std::vector<std::string> all = report::notes_on_curves(
      page.fragilities, study::report_unit(page.data, page.fragilities.front().measure));
  if (all.empty()) return {};
  return element("h3", "Notes on the curves") +
         (all.size() > 3 ? folded(counted(all.size(), "note"), list(all)) : list(all));
}

Html performance_of(const StudyPage& page) {
  Html all;
  for (const findings::Table& of : report::worst_level_tables(page.data, page.fragilities))
    all += html(of);
  return all.empty() ? all : element("h3", "Performance levels") + all;
}

}  // namespace

Section study_fragility(const StudyPage& page) {
  if (page.fragilities.empty()) return {"fragility", "Fragility", {}};
  return {"fragility", "Fragility",
          paragraph("P(limit state | im) = \u03a6(ln(im / \u03b8) / \u03b2)") + table_of(page) +
              notes_of(page) + performance_of(page)};
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
