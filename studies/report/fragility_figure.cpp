#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "studies/report/fragility_report.h"
#include "studies/report/panel.h"

namespace gurney::report {
namespace {

constexpr double kWidth = 700, kLeft = 70, kTop = 60, kPanelWidth = 590, kPanelHeight = 260,
                 kRow = 340;

/// The band as an area.
void draw_band(Svg& svg, const Scaling& scaling, const study::FragilityResult& result, double unit,
               std::size_t color) {
  Svg::Points outline;
  const auto add = [&](std::size_t i, double value) {
    outline.emplace_back(scaling.x(std::log10(result.im[i] / unit)), scaling.y(value));
  };
  for (std::size_t i = 0; i < result.im.size(); ++i) add(i, result.band.of_curve[i].low);
  for (std::size_t i = result.im.size(); i-- > 0;) add(i, result.band.of_curve[i].high);
  svg.polyline(outline, {.stroke = "", .fill = palette(color), .opacity = 0.15}, true);
}

void draw_fractions(Svg& svg, const Scaling& scaling, const study::FragilityResult& result,
                    double unit, std::size_t color) {
  for (const statistics::Stripe& stripe : result.stripes)
    if (stripe.runs > 0)
      svg.circle(scaling.x(std::log10(stripe.im / unit)), scaling.y(stripe.fraction()), 3.5,
                 {.stroke = palette(color), .width = 1.3, .fill = "#ffffff"});
}

/// Where a bracket stands in the empirical distribution: in its middle, in ln im.
double place_of(const statistics::Capacity& capacity) {
  return capacity.low > 0 ? std::sqrt(capacity.low * capacity.high) : capacity.high;
}

/// Steps of the empirical distribution; records that never exceed count, but have no step.
void draw_capacities(Svg& svg, const Scaling& scaling, const study::FragilityResult& result,
                     double unit, std::size_t color) {
  std::vector<std::pair<double, double>> places;  // and their weights
  double n = 0;
  for (const statistics::Capacity& each : result.brackets) {
    if (std::isfinite(each.high)) places.emplace_back(place_of(each), each.weight);
    n += each.weight;
  }
  std::ranges::sort(places);
  Svg::Points steps;
  const auto add = [&](double im, double count) {
    steps.emplace_back(scaling.x(std::log10(im / unit)), scaling.y(count / n));
  };
  add(result.im.front(), 0);
  double below = 0;
  for (const auto& [place, weight] : places) {
    add(place, below);
    below += weight;
    add(place, below);
  }
  add(result.im.back(), below);
  svg.polyline(steps, {.stroke = palette(color), .width = 1});
}

void draw_state(Svg& svg, const Frame& frame,
                const std::vector<const study::FragilityResult*>& results,
                const study::ReportUnit& unit) {
  const study::FragilityResult& first = *results.front();
  Panel panel{.title = first.state == first.words ? first.state : first.state + ": " + first.words,
              .x_label = fmt::format("{} ({})", first.measure.name, unit.name),
              .y_label = "Probability of exceedance",
              .curves = {},
              .log_x = true,
              .legend_columns = 3,
              .y_range = {0, 1}};
  for (std::size_t i = 0; i < results.size(); ++i) {
    const study::FragilityResult& result = *results[i];
    const auto of = result.curve();
    Curve curve{result.configuration.empty() ? "all runs" : result.configuration,
                {},
                {},
                {.stroke = palette(i), .width = 1.8}};
    if (!of) curve.label += " (no curve)";
    for (const double im : result.im) {
      curve.x.push_back(im / unit.in_si);
      curve.y.push_back(of ? of->probability(im) : std::nan(""));
    }
    panel.curves.push_back(curve);
  }
  const Scaling scaling = draw(svg, frame, panel);
  for (std::size_t i = 0; i < results.size(); ++i) {
    draw_band(svg, scaling, *results[i], unit.in_si, i);
    if (!results[i]->brackets.empty())
      draw_capacities(svg, scaling, *results[i], unit.in_si, i);
    else
      draw_fractions(svg, scaling, *results[i], unit.in_si, i);
  }
}

}  // namespace

std::string fragility_figure(const study::StudyData& data,
                             const std::vector<study::FragilityResult>& results) {
  std::vector<std::string> states;
  for (const study::FragilityResult& each : results)
    if (std::ranges::find(states, each.state) == states.end()) states.push_back(each.state);
  Svg svg(kWidth, kTop + kRow * static_cast<double>(states.size()));
  svg.text(kLeft, 26, data.file().text_attribute("title"), {.size = 15, .bold = true});
  const bool ida = std::ranges::any_of(
      results, [](const study::FragilityResult& each) { return each.capacities.has_value(); });
  svg.text(kLeft, 44,
           ida ? "line: fitted curve; area: 95 % confidence band; steps: empirical distribution of "
                 "the records' capacities; circles: fractions of runs"
               : "line: fitted curve; area: 95 % confidence band over records; circles: fractions "
                 "of runs",
           {.size = 11, .color = "#555555"});
  for (std::size_t i = 0; i < states.size(); ++i) {
    std::vector<const study::FragilityResult*> of_state;
    for (const study::FragilityResult& each : results)
      if (each.state == states[i]) of_state.push_back(&each);
    draw_state(svg, {kLeft, kTop + 40 + kRow * static_cast<double>(i), kPanelWidth, kPanelHeight},
               of_state, study::report_unit(data, of_state.front()->measure));
  }
  return svg.str();
}

}  // namespace gurney::report
