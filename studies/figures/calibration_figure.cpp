#include "studies/figures/calibration_figure.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "engine/base/units.h"
#include "studies/figures/panel.h"

namespace gurney::figures {
namespace {

constexpr double kWidth = 1180, kTop = 100, kMaxRows = 40, kRow = 13;
constexpr Frame kLoads{80, kTop, 480, 380};
constexpr Frame kDisplacement{660, kTop, 470, 150};
constexpr Frame kForce{660, kTop + 230, 470, 150};
constexpr double kBarsTop = kTop + 380 + 90;
constexpr std::array kPhaseNames = {"I", "II", "III", "IV"};
constexpr std::array kPhaseColors = {"#dddddd", "#f6d9a8", "#bcd9ee", "#eeeeee"};

std::vector<const calibration::Constant*> rolling_constants(const calibration::Calibration& c) {
  std::vector<const calibration::Constant*> found;
  for (const calibration::Constant& each : c.constants)
    if (each.kind == calibration::ConstantKind::kRolling) found.push_back(&each);
  return found;
}

void add_lines(const calibration::Constant& constant, double highest, std::size_t color,
               Panel& panel) {
  const auto line = [&](double slope, const Pen& pen, const std::string& label) {
    panel.curves.push_back({label, {0, highest}, {0, slope * highest}, pen});
  };
  line(constant.value, {.stroke = palette(color), .width = 1.8},
       fmt::format("{} on {}: Cr/R {:.4g}", constant.caster, constant.floor, constant.value));
  if (!std::isfinite(constant.interval.high)) return;
  for (const double slope : {constant.interval.low, constant.interval.high})
    line(slope, {.stroke = palette(color), .width = 1}, "");
  for (const double slope : {constant.prediction.low, constant.prediction.high})
    line(slope, {.stroke = palette(color), .width = 0.8, .dash = "4 3"}, "");
}

void draw_loads(Svg& svg, const calibration::Calibration& c) {
  const std::vector<const calibration::Constant*> constants = rolling_constants(c);
  double highest = 0, strongest = 0;
  for (const calibration::RollingTrial& trial : c.rolling) {
    highest = std::max(highest, 1.1 * normal_force(trial.averages.setup));
    strongest = std::max(strongest, 1.25 * trial.resistance.mean);
  }
  Panel panel{.title = "",
              .x_label = "Normal force on all wheels N (N)",
              .y_label = "Rolling resistance f_r (N)",
              .legend_columns = 1,
              .x_range = {0, highest},
              .y_range = {0, strongest}};
  for (std::size_t i = 0; i < constants.size(); ++i) add_lines(*constants[i], highest, i, panel);
  const Scaling scaling = draw(svg, kLoads, panel);
  for (const calibration::RollingTrial& trial : c.rolling) {
    const calibration::TrialSetup& setup = trial.averages.setup;
    const auto mine = std::ranges::find_if(constants, [&](const calibration::Constant* each) {
      return each->caster == setup.caster && each->floor == setup.floor;
    });
    svg.circle(scaling.x(normal_force(setup)), scaling.y(trial.resistance.mean), 3,
               {.stroke = "#ffffff",
                .width = 0.6,
                .fill = palette(static_cast<std::size_t>(mine - constants.begin()))});
  }
  svg.text(
      kLoads.x, kLoads.y + kLoads.height + 52,
      "Thin: 95 % confidence interval; dashed: 95 % prediction interval. Each point is a pull.",
      {.size = 10, .color = "#555555"});
}

std::array<double, 5> borders(const calibration::PhasedPull& pull) {
  const std::vector<double>& t = pull.trial.signals.time;
  return {t.front(), pull.phases.start, pull.phases.release, pull.phases.stop, t.back()};
}

void draw_phases(Svg& svg, const Frame& frame, const Scaling& scaling,
                 const calibration::PhasedPull& pull) {
  const std::array<double, 5> at = borders(pull);
  for (std::size_t i = 0; i < kPhaseNames.size(); ++i) {
    const double from = scaling.x(at[i]), to = scaling.x(at[i + 1]);
    if (to - from < 1) continue;
    svg.rectangle(from, frame.y, to - from, frame.height,
                  {.stroke = "", .fill = kPhaseColors[i], .opacity = 0.55});
  }
}

/// Axes, phases behind, curve on top, with room for the names of the phases.
void draw_signal(Svg& svg, const Frame& frame, Panel panel, const calibration::PhasedPull& pull) {
  const auto [low, high] = std::ranges::minmax(panel.curves[0].y);
  panel.y_range = {low - 0.08 * (high - low), high + 0.25 * (high - low)};
  const Scaling scaling = draw(svg, frame, panel);
  draw_phases(svg, frame, scaling, pull);
  draw(svg, frame, panel);
  const std::array<double, 5> at = borders(pull);
  for (std::size_t i = 0; i < kPhaseNames.size(); ++i)
    if (scaling.x(at[i + 1]) - scaling.x(at[i]) > 15)
      svg.text(scaling.x((at[i] + at[i + 1]) / 2), frame.y + 13, kPhaseNames[i],
               {.size = 11, .anchor = Anchor::kMiddle, .bold = true});
}

void draw_pull(Svg& svg, const calibration::PhasedPull& pull) {
  const calibration::TrialSignals& s = pull.trial.signals;
  const bool displacement = !s.displacement.empty();
  std::vector<double> mm;
  for (const double x : s.displacement) mm.push_back(x * kMillimetersPerMeter);
  const Pen pen{.stroke = palette(0), .width = 1.4};
  draw_signal(svg, kDisplacement,
              {.title = "Phases of " + pull.trial.name,
               .x_label = "",
               .y_label = displacement ? "Displacement (mm)" : "Acceleration (m/s2)",
               .curves = {{"", s.time, displacement ? mm : s.acceleration, pen}}},
              pull);
  draw_signal(svg, kForce,
              {.title = fmt::format("f_r = {:.3g} N pulled, {:.3g} N coasting",
                                    calibration::average_method(pull.averages).pulled,
                                    calibration::average_method(pull.averages).coasting),
               .x_label = "Time (s)",
               .y_label = "Cable force (N)",
               .curves = {{"", s.time, s.force, pen}}},
              pull);
}

void draw_bars(Svg& svg, const calibration::Calibration& c) {
  if (c.pulls.empty()) return;
  const auto rows = std::min(c.pulls.size(), static_cast<std::size_t>(kMaxRows));
  double first = c.pulls[0].trial.signals.time.front(), last = first;
  for (std::size_t i = 0; i < rows; ++i) {
    first = std::min(first, c.pulls[i].trial.signals.time.front());
    last = std::max(last, c.pulls[i].trial.signals.time.back());
  }
  const Frame frame{240, kBarsTop, 890, kRow * static_cast<double>(rows)};
  const Scaling scaling =
      draw(svg, frame,
           {.title = rows < c.pulls.size()
                         ? fmt::format("Phases found, first {} of {} pulls", rows, c.pulls.size())
                         : "Phases found: I held, II pulled, III coasting, IV "
                           "stopped or end of floor",
            .x_label = "Time (s)",
            .y_label = "",
            .x_range = {first, last},
            .y_range = {0, 1}});
  svg.rectangle(frame.x - 44, frame.y - 6, 43, frame.height + 12,
                {.stroke = "", .fill = "#ffffff"});
  for (std::size_t row = 0; row < rows; ++row) {
    const double y = frame.y + kRow * static_cast<double>(row);
    const std::array<double, 5> at = borders(c.pulls[row]);
    for (std::size_t i = 0; i < kPhaseNames.size(); ++i)
      svg.rectangle(scaling.x(at[i]), y + 1.5,
                    std::max(scaling.x(at[i + 1]) - scaling.x(at[i]), 0.0), kRow - 3,
                    {.stroke = "#888888", .width = 0.4, .fill = kPhaseColors[i]});
    svg.text(frame.x - 8, y + kRow - 3.5, c.pulls[row].trial.name,
             {.size = 10, .anchor = Anchor::kEnd});
  }
}

}  // namespace

std::string calibration_figure(const calibration::Calibration& c) {
  const double rows = std::min(static_cast<double>(c.pulls.size()), kMaxRows);
  Svg svg(kWidth, c.pulls.empty() ? kBarsTop : kBarsTop + kRow * rows + 60);
  svg.text(24, 34, "Calibration from " + c.source, {.size = 16, .bold = true});
  svg.text(24, 55,
           fmt::format("{} trials, {} excluded{}", c.read, c.left_out.size(),
                       c.simulated > 0 ? fmt::format("; {} SIMULATED", c.simulated) : ""),
           {.size = 12, .color = c.simulated > 0 ? "#b00000" : "#555555"});
  if (c.rolling.empty())
    svg.text(kLoads.x, kLoads.y, "No pulls with use = calibration.", {.size = 12});
  else
    draw_loads(svg, c);
  if (!c.pulls.empty()) draw_pull(svg, c.pulls.front());
  draw_bars(svg, c);
  return svg.str();
}

}  // namespace gurney::figures
