#include "studies/figures/comparison_figure.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "studies/analysis/report_unit.h"
#include "studies/figures/panel.h"

namespace gurney::figures {
namespace {

constexpr int kPoints = 60;
constexpr double kPanelWidth = 380, kPanelHeight = 220, kColumn = 460, kRow = 310, kLeft = 70,
                 kTop = 120;

/// How a side of the comparison is drawn.
struct SidePen {
  std::string label, color;
  Marker marker;
  double confidence, unit;  ///< unit: of im, in SI
};

struct Extent {
  double low, high;
};

Extent extent_of(const study::ComparedCurves& curves) {
  Extent extent{curves.of_a.front().im, curves.of_a.front().im};
  for (const auto* observations : {&curves.of_a, &curves.of_b})
    for (const statistics::Observation& each : *observations)
      extent = {std::min(extent.low, each.im), std::max(extent.high, each.im)};
  return {extent.low / 1.2, extent.high * 1.2};
}

/// Adds the curve and the band of one side to the panel.
void add_side(Panel& panel, const SidePen& side, const std::vector<statistics::Observation>& seen,
              const statistics::FragilityFit& fit, const Extent& extent) {
  std::vector<double> im;
  for (int i = 0; i < kPoints; ++i)
    im.push_back(extent.low * std::pow(extent.high / extent.low, i / (kPoints - 1.0)));
  const statistics::FragilityBand band =
      statistics::fragility_band(statistics::StripeTable(seen), im, side.confidence);
  std::vector<double> x = im;
  for (double& each : x) each /= side.unit;
  Curve line{side.label, x, {}, {.stroke = side.color, .width = 2}};
  line.key = side.marker;
  Area area{.x = x, .low = {}, .high = {}, .color = side.color};
  for (std::size_t i = 0; i < im.size(); ++i) {
    line.y.push_back(fit.curve ? fit.curve->probability(im[i]) : std::nan(""));
    if (band.too_few) continue;
    area.low.push_back(band.of_curve[i].low);
    area.high.push_back(band.of_curve[i].high);
  }
  panel.curves.push_back(line);
  if (fit.curve && !band.too_few) panel.areas.push_back(std::move(area));
}

/// A mark for the fraction that exceeded at each im with several runs.
void add_fractions(Panel& panel, const std::vector<statistics::Observation>& seen,
                   const SidePen& side) {
  const statistics::StripeTable table(seen);
  Marks marks{"", {}, {}, {.stroke = side.color, .width = 1.3}, side.marker, 3.5};
  for (const statistics::Stripe& stripe : table.stripes())
    if (stripe.runs > 1) {
      marks.x.push_back(stripe.im / side.unit);
      marks.y.push_back(stripe.fraction());
    }
  panel.marks.push_back(std::move(marks));
}

}  // namespace

std::string comparison_figure(const report::ComparisonReport& report) {
  std::vector<study::ComparedCurves> curves = report.found.curves;
  std::erase_if(curves, [](const auto& each) { return each.a.exceeded + each.b.exceeded == 0; });
  const std::size_t rows = (curves.size() + 1) / 2;
  const double columns = curves.size() < 2 ? 1 : 2;
  const std::string title = fmt::format("{}   against   {}", report.name_a, report.name_b);
  const double width = std::max(columns * kColumn + 20, kLeft + 20 + 1.08 * text_width(title, 16));
  Svg svg(width, kTop + static_cast<double>(std::max<std::size_t>(1, rows)) * kRow - 20);
  svg.text(kLeft, 34, title, {.size = 16, .bold = true});
  svg.text(kLeft, 55,
           curves.empty()
               ? std::string("no limit state is exceeded at several levels of a measure in common")
               : fmt::format(
                     "line: fitted curve; area: {:g} % confidence band; marks: fractions of runs",
                     100 * report.confidence),
           {.size = 12, .color = "#555555"});
  const study::ReportUnit unit =
      study::report_unit(*report.a.data, {report.found.measure, report.found.units, {}});
  const SidePen a{report.name_a, palette(0), marker(0), report.confidence, unit.in_si},
      b{report.name_b, palette(1), marker(1), report.confidence, unit.in_si};
  for (std::size_t i = 0; i < curves.size(); ++i) {
    const study::ComparedCurves& each = curves[i];
    Panel panel{.title = each.name,
                .x_label = fmt::format("{} ({})", report.found.measure, unit.name),
                .y_label = "Probability of exceedance",
                .curves = {},
                .zero_line = false,
                .log_x = true,
                .legend_columns = 2,
                .y_range = {0, 1}};
    const Extent extent = extent_of(each);
    panel.x_range = {std::log10(extent.low / unit.in_si), std::log10(extent.high / unit.in_si)};
    add_side(panel, a, each.of_a, each.a, extent);
    add_side(panel, b, each.of_b, each.b, extent);
    const std::size_t row = i / 2;
    const Frame frame{kLeft + static_cast<double>(i % 2) * kColumn,
                      kTop + static_cast<double>(row) * kRow, kPanelWidth, kPanelHeight};
    add_fractions(panel, each.of_a, a);
    add_fractions(panel, each.of_b, b);
    draw(svg, frame, panel);
  }
  return svg.str();
}

}  // namespace gurney::figures
