#include "studies/figures/fragility_figure.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "studies/figures/labels.h"

namespace gurney::figures {
namespace {

Area band_of(const study::FragilityResult& result, double unit, std::size_t color) {
  Area area{.x = {}, .low = {}, .high = {}, .color = palette(color)};
  for (std::size_t i = 0; i < result.im.size(); ++i) {
    area.x.push_back(result.im[i] / unit);
    area.low.push_back(result.band.of_curve[i].low);
    area.high.push_back(result.band.of_curve[i].high);
  }
  return area;
}

Marks fractions_of(const study::FragilityResult& result, double unit, std::size_t color) {
  Marks marks{"", {}, {}, {.stroke = palette(color), .width = 1.3}, marker(color), 3.5};
  constexpr double kFewest = 3;
  double most = 0;
  for (const statistics::Stripe& stripe : result.stripes) most = std::max(most, stripe.runs);
  for (const statistics::Stripe& stripe : result.stripes) {
    if (stripe.runs <= 0 || stripe.runs < std::min(kFewest, most)) continue;
    marks.x.push_back(stripe.im / unit);
    marks.y.push_back(stripe.fraction());
  }
  return marks;
}

/// Where a bracket stands in the empirical distribution: in its middle, in ln im.
double place_of(const statistics::Capacity& capacity) {
  return capacity.low > 0 ? std::sqrt(capacity.low * capacity.high) : capacity.high;
}

/// Steps of the empirical distribution; records that never exceed count, but have no step.
Curve capacities_of(const study::FragilityResult& result, double unit, std::size_t color) {
  std::vector<std::pair<double, double>> places;  // and their weights
  double n = 0;
  for (const statistics::Capacity& each : result.brackets) {
    if (std::isfinite(each.high)) places.emplace_back(place_of(each), each.weight);
    n += each.weight;
  }
  std::ranges::sort(places);
  Curve steps{"", {}, {}, {.stroke = palette(color), .width = 1}};
  const auto add = [&](double im, double count) {
    steps.x.push_back(im / unit);
    steps.y.push_back(count / n);
  };
  add(result.im.front(), 0);
  double below = 0;
  for (const auto& [place, weight] : places) {
    add(place, below);
    below += weight;
    add(place, below);
  }
  add(result.im.back(), below);
  return steps;
}

PlotPanel panel_of(const std::vector<const study::FragilityResult*>& results,
                   const study::ReportUnit& unit) {
  const study::FragilityResult& first = *results.front();
  Panel panel{.title = first.state == first.words ? first.state : first.state + ": " + first.words,
              .x_label = with_unit(label_of(first.measure.name), unit),
              .y_label = "Probability of exceedance",
              .curves = {},
              .log_x = true,
              .legend_columns = 3,
              .y_range = {0, 1}};
  double low = first.im.front(), high = first.im.back();
  for (const study::FragilityResult* each : results) {
    low = std::min(low, each->im.front());
    high = std::max(high, each->im.back());
  }
  panel.x_range = {std::log10(low / unit.in_si), std::log10(high / unit.in_si)};
  for (std::size_t i = 0; i < results.size(); ++i) {
    const study::FragilityResult& result = *results[i];
    const auto of = result.curve();
    Curve curve{result.configuration.empty() ? "all runs" : result.configuration,
                {},
                {},
                {.stroke = palette(i), .width = 1.8}};
    if (!result.by_capacities()) curve.key = marker(i);
    if (!of) curve.label += " (no curve)";
    if (of && result.band.too_few)
      curve.label += fmt::format(" (no band: {} records)", result.records);
    for (const double im : result.im) {
      curve.x.push_back(im / unit.in_si);
      curve.y.push_back(of ? of->probability(im) : std::nan(""));
    }
    panel.curves.push_back(curve);
  }
  for (std::size_t i = 0; i < results.size(); ++i) {
    if (results[i]->curve() && !results[i]->band.too_few)
      panel.areas.push_back(band_of(*results[i], unit.in_si, i));
    if (results[i]->by_capacities())
      panel.curves.push_back(capacities_of(*results[i], unit.in_si, i));
    else
      panel.marks.push_back(fractions_of(*results[i], unit.in_si, i));
  }
  return {.panel = panel, .aspect = 0.44};
}

}  // namespace

std::string fragility_figure(const study::StudyData& data,
                             const std::vector<study::FragilityResult>& results,
                             const PlotPage& page) {
  std::vector<std::string> states;
  for (const study::FragilityResult& each : results)
    if (std::ranges::find(states, each.state) == states.end()) states.push_back(each.state);
  const bool ida = std::ranges::any_of(
      results, [](const study::FragilityResult& each) { return each.by_capacities(); });
  std::vector<PlotPanel> panels;
  for (const std::string& state : states) {
    std::vector<const study::FragilityResult*> of_state;
    for (const study::FragilityResult& each : results)
      if (each.state == state) of_state.push_back(&each);
    panels.push_back(panel_of(of_state, study::report_unit(data, of_state.front()->measure)));
  }
  return plot_figure(
      page, data.file().text_attribute("title"),
      ida ? "line: fitted curve; area: 95 % confidence band; steps: empirical distribution of the "
            "records' capacities; marks: fractions of 3 or more runs"
          : "line: fitted curve; area: 95 % confidence band over records; marks: fractions of runs",
      panels);
}

}  // namespace gurney::figures
