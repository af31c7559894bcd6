#include "studies/figures/ranking_figure.h"

#include <fmt/format.h>

#include <algorithm>

#include "studies/figures/labels.h"
#include "studies/figures/plan_figures.h"

namespace gurney::figures {
namespace {

using study::RankedRecord;
using study::RecordRanking;

constexpr std::size_t kNamed = 12;  // records that a legend holds

Pen pen_of_place(std::size_t place, const RecordRanking& ranking) {
  return {.stroke = ramp(place, ranking.records.size()), .width = place == 0 ? 2.0 : 1.2};
}

Panel spectra_panel(const PlotPage& page, const RecordRanking& ranking,
                    const study::SuiteSpectra& spectra) {
  const study::ReportUnit unit = page.units.of("m/s2");
  const bool floor = !spectra.records.empty() && spectra.records.front().floor.size() > 0;
  Panel panel{.title = floor ? "Floor" : "Scaled records",
              .x_label = "Period (s)",
              .y_label = with_unit(std::string("Sa ") + name_of(spectra.combination), unit),
              .zero_line = false,
              .log_x = true,
              .legend_columns = 2,
              .log_y = true};
  for (std::size_t place = 0; place < ranking.records.size(); ++place)
    for (const study::SuiteSpectra::Record& record : spectra.records)
      if (record.name == ranking.records[place].name) {
        const Eigen::VectorXd shown = floor ? record.floor : record.factor * record.ground;
        panel.curves.push_back(curve_of(place < kNamed ? record.name : "", spectra.periods, shown,
                                        pen_of_place(place, ranking), unit.in_si));
        break;
      }
  return panel;
}

Panel paths_panel(const PlotPage& page, const RecordRanking& ranking,
                  const study::StoredHistories& histories) {
  Panel panel{.title = "Paths from the start, marked at the end",
              .x_label = "x",
              .y_label = "y",
              .zero_line = false,
              .equal_scales = true};
  const std::vector<std::size_t> kept = histories.runs();
  for (std::size_t place = 0; place < ranking.records.size(); ++place)
    for (const std::size_t run : ranking.records[place].runs) {
      if (std::ranges::find(kept, run) == kept.end()) continue;
      const study::StoredHistory history = histories.history("displacement", run);
      for (std::size_t i = 0; i + 1 < history.series.size(); ++i) {
        const auto &x = history.series[i], &y = history.series[i + 1];
        if (x.axis != "x" || y.axis != "y" || x.values.empty() ||
            !(x.part.empty() || x.part == ranking.item))
          continue;
        const Pen pen = pen_of_place(place, ranking);
        panel.curves.push_back({"", x.values, y.values, pen});
        panel.marks.push_back(
            {"", {x.values.back()}, {y.values.back()}, {.stroke = pen.stroke}, marker(0), 2.5});
      }
    }
  set_unit(panel, page.units);
  return panel;
}

}  // namespace

std::string ranking_figure(const PlotPage& page, const RecordRanking& ranking,
                           const study::SuiteSpectra& spectra,
                           const study::StoredHistories& histories) {
  Chart chart{fmt::format("{} of {} at {}", ranking.demand, ranking.item, ranking.level),
              "pseudo-acceleration, 5 % damping; the darker, the larger the demand",
              {{.panel = spectra_panel(page, ranking, spectra), .aspect = 0.75}}};
  if (Panel paths = paths_panel(page, ranking, histories); !paths.curves.empty())
    chart.panels.push_back({.panel = std::move(paths), .aspect = 0.75});
  else
    chart.footnotes.push_back("no paths: the study keeps no histories of these runs (study.keep)");
  chart.columns = chart.panels.size();
  return chart.svg(page);
}

}  // namespace gurney::figures
