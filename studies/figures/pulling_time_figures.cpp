#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "studies/calibration/trials/instrument_noise.h"
#include "studies/figures/panel.h"
#include "studies/figures/pulling_figures.h"

namespace gurney::figures {
namespace {

constexpr double kWidth = 1000, kLeft = 75, kTop = 105, kPanelWidth = 390, kPanelHeight = 190,
                 kRow = 270, kColumn = 505;

Frame frame_at(int column, int row) {
  return {kLeft + column * kColumn, kTop + row * kRow, kPanelWidth, kPanelHeight};
}

Curve curve(const std::string& label, const std::vector<double>& x, const std::vector<double>& y,
            const Pen& pen) {
  return {label, x, y, pen};
}

Panel panel(const std::string& title, const std::string& y_label, const Range& time) {
  return {.title = title,
          .x_label = "Time (s)",
          .y_label = y_label,
          .curves = {},
          .legend_columns = 3,
          .x_range = time};
}

/// Lines between the phases, with their numbers.
void draw_phases(Svg& svg, const Frame& frame, const Scaling& scaling,
                 const calibration::Phases& phases, const Range& time) {
  const std::array<double, 5> ends = {time.low, phases.start, phases.release, phases.stop,
                                      time.high};
  static const char* const names[] = {"I", "II", "III", "IV"};
  for (std::size_t i = 0; i < 4; ++i) {
    const double from = scaling.x(ends[i]), to = scaling.x(ends[i + 1]);
    if (i > 0)
      svg.line(from, frame.y, from, frame.y + frame.height,
               {.stroke = "#888888", .width = 0.9, .dash = "3 3"});
    if (to - from > 12)
      svg.text((from + to) / 2, frame.y + frame.height - 6, names[i],
               {.size = 11, .anchor = Anchor::kMiddle, .bold = true, .color = "#666666"});
  }
}

void heading(Svg& svg, const std::string& title, const report::PullingReport& report,
             const std::string& note) {
  const calibration::SimulatedTrial& trial = report.trials.at(report.shown);
  const std::string noise = report.noise ? "; " + report::noise_words(report) : "";
  svg.text(kLeft, 28, title, {.size = 15, .bold = true});
  svg.text(kLeft, 48, fmt::format("Run {}: {}{}", trial.run, trial.configuration, noise),
           {.size = 12});
  svg.text(kLeft, 66, note, {.size = 11, .color = "#555555"});
}

Range whole(const calibration::SimulatedTrial& trial) {
  return {trial.trial.signals.time.front(), trial.trial.signals.time.back()};
}

template <class Get>
Curve theory_curve(const calibration::SimulatedTrial& trial, Get get) {
  Curve result{"closed form", {}, {}, {.stroke = palette(1), .width = 1.4, .dash = "6 4"}};
  for (const double time : trial.trial.signals.time) {
    result.x.push_back(time);
    result.y.push_back(get(trial.theory, time));
  }
  return result;
}

/// Times of a measured trial on the clock of the simulated one: both start at once.
std::vector<double> moved(const calibration::MeasuredTrial& measured,
                          const calibration::SimulatedTrial& trial) {
  std::vector<double> time = measured.trial.signals.time;
  const double shift = (trial.phases ? trial.phases->start : trial.theory.start) -
                       (measured.phases ? measured.phases->start : 0);
  for (double& t : time) t += shift;
  return time;
}

/// A trial that an engine simulated must not be called measured.
std::string origin_of(const calibration::MeasuredTrial& given) {
  return given.trial.setup.origin == calibration::TrialOrigin::kSimulated ? "synthetic"
                                                                          : "measured";
}

/// Lowest and highest of several series, without the NaN at the ends of a rate.
Range extent(const std::vector<Curve>& curves) {
  Range range{INFINITY, -INFINITY};
  for (const Curve& each : curves)
    for (const double y : each.y) {
      if (!std::isfinite(y)) continue;
      range = {std::min(range.low, y), std::max(range.high, y)};
    }
  return range;
}

/// That of the trolley's origin is what the displacement gives; an accelerometer on top measures
/// the pitch on the treads with it.
std::vector<Curve> accelerations(const calibration::SimulatedTrial& trial) {
  const calibration::TrialSignals& s = trial.trial.signals;
  const Pen ours{.stroke = palette(0), .width = 1.2};
  if (trial.accelerometer_signal.empty()) return {curve("", s.time, s.acceleration, ours)};
  return {curve("accelerometer: " + trial.accelerometer, s.time, trial.accelerometer_signal,
                {.stroke = palette(1), .width = 1}),
          curve("at the floor", s.time, s.acceleration, ours)};
}

std::vector<double> negative(std::vector<double> values) {
  for (double& value : values) value = -value;
  return values;
}

}  // namespace

std::string pulling_figure_4(const report::PullingReport& report) {
  const calibration::SimulatedTrial& trial = report.trials.at(report.shown);
  const calibration::TrialSignals& s = trial.trial.signals;
  Svg svg(kWidth, kTop + 2 * kRow);
  heading(svg, "Pulling test: time histories (as Figure 4 of Xu, Ma & Kurata 2022)", report,
          "simulated, sampled at 120 Hz; I held, II pulled, III coasting, IV stopped or end of the "
          "flooring: as found from the signals");
  struct Series {
    const char *title, *unit;
    std::vector<Curve> curves;
  };
  const Pen ours{.stroke = palette(0), .width = 1.2};
  const std::array<Series, 4> all = {
      {{"Displacement", "Displacement (m)", {curve("", s.time, s.displacement, ours)}},
       {"Velocity", "Velocity (m/s)", {curve("", s.time, trial.velocity, ours)}},
       {"Acceleration", "Acceleration (m/s\u00b2)", accelerations(trial)},
       {"Cable force", "Force (N)", {curve("", s.time, s.force, ours)}}}};
  for (int i = 0; i < 4; ++i) {
    const Series& each = all[static_cast<std::size_t>(i)];
    Panel next = panel(each.title, each.unit, whole(trial));
    // Room for the phases' numbers below the curve.
    const auto [low, high] = extent(each.curves);
    next.y_range = {low - 0.2 * (high - low), high + 0.06 * (high - low)};
    next.curves = each.curves;
    const Frame frame = frame_at(i % 2, i / 2);
    const Scaling scaling = draw(svg, frame, next);
    if (trial.phases) draw_phases(svg, frame, scaling, *trial.phases, whole(trial));
  }
  return svg.str();
}

std::string pulling_figure_11(const report::PullingReport& report) {
  const calibration::SimulatedTrial& trial = report.trials.at(report.shown);
  const calibration::TrialSignals& s = trial.trial.signals;
  const calibration::MeasuredTrial* const measured =
      calibration::find_matching(trial, report.measured);
  const bool overlaid = measured != nullptr && !measured->trial.signals.displacement.empty();
  Svg svg(kWidth, kTop + 2 * kRow);
  const std::string reference =
      overlaid ? fmt::format("reference: closed-form mechanics of casters in line; {}: {}",
                             origin_of(*measured), measured->trial.name)
               : "reference: closed-form mechanics of casters in line; no measured trial is given";
  heading(svg, "Pulling test against its reference (as Figure 11 of Xu, Ma & Kurata 2022)", report,
          reference);
  const Pen ours{.stroke = palette(0), .width = 1.4};
  const Pen theirs{.stroke = palette(2), .width = 1.2, .dash = "2 2"};
  Panel displacement = panel("Displacement", "Displacement (m)", whole(trial));
  displacement.curves = {curve("simulated", s.time, s.displacement, ours),
                         theory_curve(trial, [](const calibration::PullTheory& of, double time) {
                           return of.displacement_at(time);
                         })};
  Panel velocity = panel("Velocity", "Velocity (m/s)", whole(trial));
  velocity.curves = {curve("simulated", s.time, trial.velocity, ours),
                     theory_curve(trial, [](const calibration::PullTheory& of, double time) {
                       return of.velocity_at(time);
                     })};
  if (overlaid) {
    const calibration::TrialSignals& m = measured->trial.signals;
    const std::vector<double> time = moved(*measured, trial);
    displacement.curves.push_back(curve(origin_of(*measured), time, m.displacement, theirs));
    velocity.curves.push_back(
        curve(origin_of(*measured), time, calibration::rate(time, m.displacement), theirs));
  }
  draw(svg, frame_at(0, 0), displacement);
  draw(svg, frame_at(1, 0), velocity);
  Panel energy = panel("Energy", "Energy (J)", whole(trial));
  const auto add = [&](const char* label, const std::vector<double>& values, std::size_t color) {
    energy.curves.push_back(curve(label, s.time, values, {.stroke = palette(color), .width = 1.4}));
  };
  if (!trial.kinetic.empty()) {
    add("W_F: weight and strings", trial.work, 0);
    add("W_R: rolling", negative(trial.rolling_loss), 1);
    add("E_KT: kinetic", trial.kinetic, 2);
  }
  Frame wide = frame_at(0, 1);
  wide.width = kColumn + kPanelWidth;
  draw(svg, wide, energy);
  return svg.str();
}

}  // namespace gurney::figures
