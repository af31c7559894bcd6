#include "studies/figures/study_figures.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/base/error.h"
#include "engine/base/random/normal_draw.h"
#include "studies/analysis/study_data.h"
#include "studies/figures/labels.h"

namespace gurney::figures {
namespace {

Panel panel_of(const std::string& title, const study::RunMeasure& measure,
               const study::ReportUnit& unit) {
  return {.title = title,
          .x_label = with_unit(label_of(measure.name), unit),
          .y_label = "Probability of exceedance",
          .zero_line = false,
          .log_x = true,
          .legend_columns = 3,
          .y_range = {0, 1}};
}

void add_band(Panel& panel, const std::vector<double>& im, const statistics::FragilityBand& band,
              double unit, std::size_t color) {
  Area area{.x = {}, .low = {}, .high = {}, .color = palette(color)};
  for (std::size_t i = 0; i < im.size(); ++i)
    area.add(im[i] / unit, band.of_curve[i].low, band.of_curve[i].high);
  panel.areas.push_back(std::move(area));
}

void add_curve(Panel& panel, const std::string& label, const std::vector<double>& im,
               const study::FittedCurve& fitted, double unit, std::size_t color) {
  const auto curve = fitted.curve();
  panel.curves.push_back(curve_over(
      label, im, pen(color, 1.8), [&](double each) { return each / unit; },
      [&](double each) { return curve ? curve->probability(each) : std::nan(""); }));
  panel.curves.back().known = {fitted.audit.lowest / unit, fitted.audit.highest / unit};
}

/// The fraction that exceeded at each im with so many runs.
void add_fractions(Panel& panel, const std::vector<statistics::Stripe>& stripes, double fewest,
                   double unit, std::size_t color) {
  Marks marks{"", {}, {}, pen(color), marker(color), 3.5};
  if (!panel.curves.empty()) marks.name = panel.curves.back().label;
  for (const statistics::Stripe& stripe : stripes) {
    if (stripe.runs <= 0 || stripe.runs < fewest) continue;
    marks.add(stripe.im / unit, stripe.fraction());
  }
  panel.marks.push_back(std::move(marks));
}

/// Least runs of a mark in a figure of one study: marks of fewer runs would be 0 or 1 by chance.
double fewest_of(const std::vector<statistics::Stripe>& stripes) {
  constexpr double kFewest = 3;
  double most = 0;
  for (const statistics::Stripe& stripe : stripes) most = std::max(most, stripe.runs);
  return std::min(kFewest, most);
}

/// Where a bracket stands in the empirical distribution: in its middle, in ln im.
double place_of(const statistics::Capacity& capacity) {
  return capacity.low > 0 ? std::sqrt(capacity.low * capacity.high) : capacity.high;
}

/// Steps of the empirical distribution; records that never exceed count, but have no step.
Curve capacities_of(const study::FittedCurve& fitted, const std::vector<double>& im, double unit,
                    std::size_t color) {
  std::vector<std::pair<double, double>> places;  // and their weights
  double n = 0;
  for (const statistics::Capacity& each : fitted.brackets) {
    if (std::isfinite(each.high)) places.emplace_back(place_of(each), each.weight);
    n += each.weight;
  }
  std::ranges::sort(places);
  Curve steps{"", {}, {}, pen(color, 1)};
  const auto add = [&](double at, double count) { steps.add(at / unit, count / n); };
  add(im.front(), 0);
  double below = 0;
  for (const auto& [place, weight] : places) {
    add(place, below);
    below += weight;
    add(place, below);
  }
  add(im.back(), below);
  return steps;
}

std::string label_of_curve(const study::FragilityResult& result) {
  const std::string name = result.configuration.empty() ? "all runs" : result.configuration;
  if (!result.curve()) return name + " (no curve)";
  if (!result.band.too_few) return name;
  return fmt::format("{} (no band: {} records)", name, result.records);
}

Panel state_panel(const std::vector<const study::FragilityResult*>& results,
                  const study::ReportUnit& unit) {
  const study::FragilityResult& first = *results.front();
  Panel panel =
      panel_of(first.state == first.words ? first.state : first.state + ": " + first.words,
               first.measure, unit);
  Range im{first.im.front(), first.im.back()};
  for (std::size_t i = 0; i < results.size(); ++i) {
    const study::FragilityResult& result = *results[i];
    im = widened(im, result.im);
    add_curve(panel, label_of_curve(result), result.im, result, unit.in_si, i);
    if (!result.by_capacities()) panel.curves.back().key = marker(i);
    if (result.curve() && !result.band.too_few)
      add_band(panel, result.im, result.band, unit.in_si, i);
    if (!result.by_capacities())
      add_fractions(panel, result.stripes, fewest_of(result.stripes), unit.in_si, i);
  }
  for (std::size_t i = 0; i < results.size(); ++i)
    if (results[i]->by_capacities())
      panel.curves.push_back(capacities_of(*results[i], results[i]->im, unit.in_si, i));
  panel.x_range = {std::log10(im.low / unit.in_si), std::log10(im.high / unit.in_si)};
  return panel;
}

/// Curve, band and fractions, or capacities, of one side of a comparison.
void add_side(Panel& panel, const std::string& name, std::size_t side,
              const study::FittedCurve& fitted, const Range& extent, double confidence,
              double unit) {
  constexpr int kPoints = 60;
  std::vector<double> im;
  for (int i = 0; i < kPoints; ++i)
    im.push_back(extent.low * std::pow(extent.high / extent.low, i / (kPoints - 1.0)));
  const statistics::FragilityBand band = study::band_of_curve(fitted, im, confidence);
  add_curve(panel, name, im, fitted, unit, side);
  if (!fitted.capacities) panel.curves.back().key = marker(side);
  if (fitted.curve() && !band.too_few) add_band(panel, im, band, unit, side);
  if (fitted.capacities)
    panel.curves.push_back(capacities_of(fitted, im, unit, side));
  else
    add_fractions(panel, statistics::StripeTable(fitted.observations).stripes(), 2, unit, side);
}

/// Runs in the plane of two measures, both in logarithms.
Panel plane_panel(const study::VectorResult& result, const study::ReportUnit& x_unit,
                  const study::ReportUnit& y_unit) {
  Panel panel{.title = result.configuration.empty() ? result.state
                                                    : result.state + ", " + result.configuration,
              .x_label = with_unit(result.measures[0].name, x_unit),
              .y_label = with_unit(result.measures[1].name, y_unit),
              .zero_line = false,
              .log_x = true,
              .legend_columns = 2,
              .log_y = true};
  panel.marks = {{"run that does not exceed", {}, {}, pen(0, 1.2), Marker::kCircle, 4},
                 {"run that exceeds",
                  {},
                  {},
                  {.stroke = palette(1), .width = 1.2, .fill = palette(1)},
                  Marker::kCircle,
                  2}};  // one is seen within the other
  Range x{INFINITY, -INFINITY}, y = x;
  for (const statistics::VectorObservation& each : result.runs) {
    Marks& marks = panel.marks[each.exceeded ? 1 : 0];
    marks.add(each.first / x_unit.in_si, each.second / y_unit.in_si);
    x = widened(x, {std::log10(marks.x.back())});
    y = widened(y, {std::log10(marks.y.back())});
  }
  for (Range* range : {&x, &y}) {
    const double air = 0.05 * range->span() + 0.02;
    *range = {range->low - air, range->high + air};
  }
  panel.x_range = x;
  panel.y_range = y;
  const Pen line{.stroke = "#222222", .width = 2}, dashes{.stroke = "#222222", .dash = "5 3"};
  if (result.fit.status != statistics::VectorStatus::kFitted) {
    panel.curves = {{"no fit", {}, {}, {.stroke = ""}}};
    return panel;
  }
  // plane[0] ln x + plane[1] ln y + plane[2] = the normal quantile of P, x and y in SI.
  const Eigen::Vector3d& plane = result.fit.plane;
  const auto add = [&](Curve& curve, double probability) {
    const double level = (normal_quantile(probability) - plane[2] -
                          plane[0] * std::log(x_unit.in_si) - plane[1] * std::log(y_unit.in_si)) /
                         std::log(10.0);
    for (const double end : {0.0, 1.0, std::nan("")}) {
      const bool steep = std::abs(plane[0]) > std::abs(plane[1]);
      const Range& along = steep ? y : x;
      const double at = along.low + end * along.span();
      const double other =
          steep ? (level - plane[1] * at) / plane[0] : (level - plane[0] * at) / plane[1];
      curve.add(std::pow(10, steep ? other : at), std::pow(10, steep ? at : other));
    }
  };
  panel.curves = {{"50 % of the fit", {}, {}, line}, {"16 and 84 %", {}, {}, dashes}};
  add(panel.curves[0], 0.5);
  for (const double p : {0.16, 0.84}) add(panel.curves[1], p);
  return panel;
}

constexpr std::size_t kMaxRows = 20, kLow = 0, kHigh = 1, kFirst = 5, kTotal = 4;  // of the palette
constexpr double kRow = 26, kBar = 12;                                             // [px]

using Inputs = std::vector<study::SensitiveInput>;

bool has_bar(const study::SensitiveInput& input) {
  return input.drawn && !std::isnan(input.bar.swing());
}

Inputs longest(const study::StudySensitivity& found) {
  Inputs inputs;
  std::ranges::copy_if(found.inputs, std::back_inserter(inputs), has_bar);
  std::ranges::stable_sort(inputs, std::greater(), [](const study::SensitiveInput& each) {
    return std::abs(each.bar.swing());
  });
  if (inputs.size() > kMaxRows) inputs.resize(kMaxRows);
  return inputs;
}

/// "ICU ventilator: peak_displacement" as "ICU ventilator: Peak displacement".
std::string words_of(const std::string& output) {
  const std::size_t at = output.rfind(": ");
  if (at != std::string::npos) return output.substr(0, at + 2) + label_of(output.substr(at + 2));
  return label_of(output);
}

Marks key(const std::string& label, const Pen& pen) {
  return {label, {}, {}, pen, Marker::kSquare, 4};
}

/// Low above, high below, each from the mean: both are seen where they go the same way.
Panel tornado_panel(const study::StudySensitivity& found, const Inputs& inputs, double unit) {
  const double mean = found.mean / unit;
  const Pen low{.stroke = palette(kLow), .width = 0.8, .fill = palette(kLow)},
      high{.stroke = palette(kHigh), .width = 0.8, .fill = "#ffffff"};
  Panel panel{.title = "",
              .x_label = "",
              .y_label = "",
              .legend_columns = 2,
              .rows = std::vector<std::string>(inputs.size()),
              .guides = {{mean}}};
  panel.marks = {key(fmt::format("lowest {:g} % of the input", 100 * found.share), low),
                 key("highest", high)};
  Range range{mean, mean};
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    if (!has_bar(inputs[i])) continue;
    const double middle = static_cast<double>(i) + 0.5, half = kBar / 4 / kRow;
    const statistics::TornadoBar& bar = inputs[i].bar;
    panel.bars.push_back({middle - half, half, {mean, bar.low / unit}, low});
    panel.bars.push_back({middle + half, half, {mean, bar.high / unit}, high});
    range = widened(range, {bar.low / unit, bar.high / unit});
  }
  const double air = range.span() > 0 ? 0.06 * range.span() : 1;
  panel.x_range = {range.low - air, range.high + air};
  return panel;
}

std::vector<std::string> names_of(const Inputs& inputs) {
  std::vector<std::string> names;
  for (const study::SensitiveInput& each : inputs) names.push_back(input_label(each.names));
  return names;
}

/// One index below the other, as bars with their intervals.
Panel index_panel(const study::StudySensitivity& found, const Inputs& inputs) {
  Panel panel{.title = "",
              .x_label = "Share of the variance, 95 % intervals",
              .y_label = "",
              .legend_columns = 2,
              .x_range = {0, 1},
              .rows = names_of(inputs)};
  const auto add = [&](const statistics::VarianceIndex& index, double middle, double half,
                       std::size_t color) {
    panel.bars.push_back({middle,
                          half,
                          {0, std::clamp(index.estimate, 0.0, 1.0)},
                          {.stroke = "", .fill = palette(color)}});
    const Range& interval = {index.interval.low, index.interval.high};
    panel.bars.push_back({middle, 0, interval, {.width = 1.4}});
    for (const double end : {interval.low, interval.high})
      panel.bars.push_back({middle, half / 2, {end, end}, {.width = 1.4}});
  };
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    const double middle = static_cast<double>(i) + 0.5, half = kBar / 2 / kRow;
    const auto &index = inputs[i].index, &total = inputs[i].total;
    if (index && !total) add(*index, middle, half, kFirst);
    if (!index || !total) continue;
    add(*index, middle - 0.7 * half, 0.7 * half, kFirst);
    add(*total, middle + 0.7 * half, 0.7 * half, kTotal);
  }
  const auto pen_of = [](std::size_t color) {
    return Pen{.stroke = palette(color), .fill = palette(color)};
  };
  panel.marks = {key("First-order index", pen_of(kFirst))};
  if (found.designed) panel.marks.push_back(key("total index", pen_of(kTotal)));
  return panel;
}

/// "30 runs: the lowest and the highest 10 % of an input have 3 runs each, and a mean needs 10".
std::string why_no_bar(const study::StudySensitivity& found) {
  const auto drawn = std::ranges::find_if(found.inputs, &study::SensitiveInput::drawn);
  if (drawn == found.inputs.end()) return "no input is a drawn number";
  return fmt::format(
      "{} runs: the lowest and the highest {:g} % of an input have {} runs each, "
      "and a mean needs {}",
      found.runs, 100 * found.share, drawn->bar.low_runs, study::kFewestOfMean);
}

std::size_t fewest_of(const Inputs& inputs) {
  std::size_t fewest = inputs.front().bar.low_runs;
  for (const study::SensitiveInput& each : inputs)
    fewest = std::min({fewest, each.bar.low_runs, each.bar.high_runs});
  return fewest;
}

}  // namespace

std::string fragility_figure(const study::StudyData& data,
                             const std::vector<study::FragilityResult>& results,
                             const PlotPage& page) {
  const bool ida = std::ranges::any_of(
      results, [](const study::FragilityResult& each) { return each.by_capacities(); });
  Chart chart{
      data.file().text_attribute("title"),
      ida ? "line: fitted curve, dotted beyond the intensities of the runs; area: 95 % confidence "
            "band; steps: empirical distribution of the records' capacities; marks: fractions of 3 "
            "or more runs"
          : "line: fitted curve, dotted beyond the intensities of the runs; area: 95 % confidence "
            "band over records; marks: fractions of runs"};
  std::vector<std::string> states;
  for (const study::FragilityResult& each : results) {
    if (std::ranges::find(states, each.state) != states.end()) continue;
    states.push_back(each.state);
    std::vector<const study::FragilityResult*> of_state;
    for (const study::FragilityResult& other : results)
      if (other.state == each.state && !other.im.empty()) of_state.push_back(&other);
    require(!of_state.empty(),
            fmt::format("{}: no run of {} has results", data.file().path(),
                        each.configuration.empty() ? "the study" : each.configuration));
    chart.panels.push_back(
        {.panel = state_panel(of_state, study::report_unit(data, each.measure)), .aspect = 0.44});
  }
  return chart.svg(page);
}

std::string comparison_figure(const report::ComparisonReport& report) {
  const study::ReportUnit unit =
      study::report_unit(*report.a.data, {report.found.measure, report.found.units, {}});
  Chart chart{
      report.name_a + " against " + report.name_b,
      fmt::format(
          "line: fitted curve, dotted beyond the intensities of the runs; area: {:g} % confidence "
          "band; marks: fractions of runs; steps: capacities of an IDA",
          100 * report.confidence)};
  for (const study::ComparedCurves& each : report.found.curves) {
    if (each.a.fit.exceeded + each.b.fit.exceeded == 0) continue;
    Panel panel = panel_of(each.name, {report.found.measure, report.found.units, {}}, unit);
    const double first = each.a.observations.front().im;
    Range extent{first, first};
    for (const study::FittedCurve* side : {&each.a, &each.b})
      for (const statistics::Observation& seen : side->observations)
        extent = widened(extent, {seen.im / 1.2, seen.im * 1.2});
    panel.x_range = {std::log10(extent.low / unit.in_si), std::log10(extent.high / unit.in_si)};
    add_side(panel, report.name_a, 0, each.a, extent, report.confidence, unit.in_si);
    add_side(panel, report.name_b, 1, each.b, extent, report.confidence, unit.in_si);
    chart.panels.push_back({.panel = std::move(panel), .height = 220});
  }
  if (chart.panels.empty())
    chart.note = "no limit state is exceeded at several levels of a measure in common";
  chart.columns = std::clamp<std::size_t>(chart.panels.size(), 1, 2);
  return chart.svg({.width = 480 * static_cast<double>(chart.columns)});
}

std::string vector_figure(const study::StudyData& data,
                          const std::vector<study::VectorResult>& results) {
  Chart chart{data.file().text_attribute("title")};
  for (const study::VectorResult& each : results)
    if (!each.runs.empty())
      chart.panels.push_back({.panel = plane_panel(each, study::report_unit(data, each.measures[0]),
                                                   study::report_unit(data, each.measures[1])),
                              .height = 330});
  chart.columns = std::clamp<std::size_t>(chart.panels.size(), 1, 3);
  return chart.svg({.width = 430 * static_cast<double>(chart.columns)});
}

std::string sensitivity_figure(const report::SensitivityReport& report) {
  const study::StudySensitivity& found = report.found;
  const study::ReportUnit unit = report.units.of(found.units);
  Inputs inputs = found.inputs;
  if (inputs.size() > kMaxRows) inputs.resize(kMaxRows);
  std::string about = report.configuration;
  if (!found.level.empty()) about += (about.empty() ? "" : ", ") + found.level;
  Chart chart{.title = "Sensitivity of " + words_of(found.output),
              .note = fmt::format("{}{}{} runs{}", about, about.empty() ? "" : ", ", found.runs,
                                  found.inputs.size() > kMaxRows ? ", first 20 inputs" : ""),
              .panels = {{.panel = index_panel(found, inputs)}}};
  if (std::ranges::none_of(inputs, has_bar)) {
    chart.note += "; no tornado: " + why_no_bar(found);
    return chart.svg({.width = 700});
  }
  chart.note += "; dashed: mean of all runs";
  Panel tornado = tornado_panel(found, inputs, unit.in_si);
  tornado.x_label = fmt::format("Mean{}", unit.name == "1" ? "" : " (" + unit.name + ")");
  chart.panels.push_back({.panel = std::move(tornado)});
  chart.columns = 2;
  return chart.svg({.width = 1180});
}

std::string tornado_figure(const PlotPage& page, const std::string& title,
                           const std::vector<report::SensitivityReport>& reports) {
  Chart chart{title,
              "means over the runs in which an input is low or high; dashed: mean of all "
              "runs"};
  bool cut = false;
  std::string without;
  for (const report::SensitivityReport& each : reports) {
    const study::StudySensitivity& found = each.found;
    const study::ReportUnit unit = each.units.of(found.units);
    const Inputs inputs = longest(found);
    const std::string name =
        words_of(found.output) + (each.configuration.empty() ? "" : ", " + each.configuration);
    if (inputs.empty()) {
      without += "; no tornado of " + name + ": " + why_no_bar(found);
      continue;
    }
    Panel panel = tornado_panel(found, inputs, unit.in_si);
    panel.title = name;
    panel.x_label = with_unit(fmt::format("Mean over {} runs or more", fewest_of(inputs)), unit);
    panel.rows = names_of(inputs);
    chart.panels.push_back({.panel = std::move(panel)});
    cut = cut || std::ranges::count_if(found.inputs, &study::SensitiveInput::drawn) >
                     static_cast<std::ptrdiff_t>(kMaxRows);
  }
  require(!chart.panels.empty(), "nothing to draw" + without);
  if (cut) chart.note += "; the 20 longest bars";
  chart.note += without;
  return chart.svg(page);
}

}  // namespace gurney::figures
