#include "studies/figures/pulling_figures.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/base/units.h"
#include "studies/calibration/trials/instrument_noise.h"

namespace gurney::figures {
namespace {

using calibration::SimulatedTrial;
using Trials = std::vector<const SimulatedTrial*>;

constexpr double kWidth = 1000, kHeight = 190, kOfLoads = 330;  // [px]

Panel time_panel(const std::string& title, const std::string& y_label, const SimulatedTrial& trial,
                 std::vector<Curve> curves) {
  const std::vector<double>& time = trial.trial.signals.time;
  return {.title = title,
          .x_label = "Time (s)",
          .y_label = y_label,
          .curves = std::move(curves),
          .legend_columns = 3,
          .x_range = {time.front(), time.back()}};
}

/// The shown trial, and how its signals were made.
std::string subject_of(const report::PullingReport& report) {
  const SimulatedTrial& trial = report.trials.at(report.shown);
  return fmt::format("Run {}: {}{}", trial.run, trial.configuration,
                     report.noise ? "; " + report::noise_words(report) : "");
}

template <class Get>
Curve theory_curve(const SimulatedTrial& trial, Get get) {
  return curve_over(
      "closed form", trial.trial.signals.time, pen(1, 1.4, "6 4"), [](double time) { return time; },
      [&](double time) { return get(trial.theory, time); });
}

/// Times of a measured trial on the clock of the simulated one: both start at once.
std::vector<double> moved(const calibration::MeasuredTrial& measured, const SimulatedTrial& trial) {
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

/// That of the trolley's origin is what the displacement gives; an accelerometer on top measures
/// the pitch on the treads with it.
std::vector<Curve> accelerations(const SimulatedTrial& trial) {
  const calibration::TrialSignals& s = trial.trial.signals;
  if (trial.accelerometer_signal.empty())
    return {curve_of("", s.time, s.acceleration, pen(0, 1.2))};
  return {curve_of("accelerometer: " + trial.accelerometer, s.time, trial.accelerometer_signal,
                   pen(1, 1)),
          curve_of("at the floor", s.time, s.acceleration, pen(0, 1.2))};
}

std::string about(const report::PullingReport& report) {
  return std::string(
             "f_r by the paper's method from simulated signals, aligned trials. Cr and the "
             "floor factors are inputs of the simulation") +
         (report.measured.empty() ? "" : "; squares: trials that were given") +
         (report.noise ? "; " + report::noise_words(report) : "");
}

/// Aligned trials with averages.
Trials usable(const report::PullingReport& report) {
  Trials chosen;
  for (const SimulatedTrial& trial : report.trials)
    if (trial.alignment == calibration::Alignment::kAligned && trial.averages)
      chosen.push_back(&trial);
  return chosen;
}

const std::string& caster_of(const SimulatedTrial& trial) { return trial.trial.setup.caster; }
const std::string& floor_of(const SimulatedTrial& trial) { return trial.trial.setup.floor; }

template <class Get>
std::vector<std::string> names(const Trials& trials, Get get) {
  std::vector<std::string> all;
  for (const SimulatedTrial* trial : trials)
    if (std::ranges::find(all, get(*trial)) == all.end()) all.push_back(get(*trial));
  return all;
}

std::size_t index_in(const std::vector<std::string>& all, const std::string& name) {
  return static_cast<std::size_t>(std::ranges::find(all, name) - all.begin());
}

Range from_zero(double highest) { return {0, highest > 0 ? 1.15 * highest : 1}; }

double highest_resistance(const Trials& trials) {
  double highest = 0;
  for (const SimulatedTrial* trial : trials) {
    const calibration::Resistance found = calibration::average_method(*trial->averages);
    highest = std::max({highest, found.pulled, found.coasting});
  }
  return highest;
}

Panel resistance_panel(const std::string& title, const std::string& x_label, const Range& x,
                       double highest) {
  return {.title = title,
          .x_label = x_label,
          .y_label = "f_r (N)",
          .legend_columns = 3,
          .x_range = x,
          .y_range = from_zero(highest)};
}

/// A mark of one trial.
void add_dot(Panel& panel, double x, double y, std::size_t color, bool filled,
             Marker marker = Marker::kCircle) {
  Pen of_color = pen(color, 1.4);
  if (filled) of_color.fill = of_color.stroke;
  panel.marks.push_back({"", {x}, {y}, of_color, marker, 4});
}

Panel diameter_panel(const Trials& trials) {
  const auto floors = names(trials, floor_of);
  const Range diameters{80, 145};
  Panel panel =
      resistance_panel("No payload", "Wheel diameter (mm)", diameters, highest_resistance(trials));
  for (std::size_t i = 0; i < floors.size(); ++i)
    panel.curves.push_back({floors[i], {}, {}, pen(i, 1.5)});
  Curve inverse{"as 1/R", {}, {}, {.stroke = "#666666", .width = 1.3, .dash = "5 4"}};
  for (double diameter = diameters.low; diameter <= diameters.high; diameter += 1) {
    inverse.x.push_back(diameter);
    inverse.y.push_back(calibration::mean_resistance(*trials[0]->averages) * 2 *
                        kMillimetersPerMeter * trials[0]->trial.setup.wheel_radius / diameter);
  }
  panel.curves.push_back(inverse);
  // Trials of one diameter side by side: floors apart, and casters of other treads.
  for (const SimulatedTrial* trial : trials) {
    const std::size_t floor = index_in(floors, floor_of(*trial));
    const double diameter = 2 * kMillimetersPerMeter * trial->trial.setup.wheel_radius;
    add_dot(panel, diameter + (floor == 0 ? -0.8 : 0.8),
            calibration::mean_resistance(*trial->averages), floor, floor == 0);
  }
  return panel;
}

Panel speed_panel(const Trials& all) {
  const std::string caster = caster_of(*all.front());
  Trials trials;
  for (const SimulatedTrial* trial : all)
    if (caster_of(*trial) == caster) trials.push_back(trial);
  double fastest = 0, known = 0;
  for (const SimulatedTrial* trial : trials) {
    fastest = std::max({fastest, trial->averages->pull_speed, trial->averages->coast_speed});
    known = trial->theory.resistance;
  }
  const Range speeds = from_zero(fastest);
  Panel panel = resistance_panel(caster + ", no payload", "Mean speed (m/s)", speeds,
                                 highest_resistance(trials));
  panel.curves = {{"input", {speeds.low, speeds.high}, {known, known}, pen(6, 1.5)},
                  {"phase II", {}, {}, pen(0, 1.5)},
                  {"phase III", {}, {}, pen(1, 1.5)}};
  for (const SimulatedTrial* trial : trials) {
    const calibration::Resistance found = calibration::average_method(*trial->averages);
    add_dot(panel, trial->averages->pull_speed, found.pulled, 0, true);
    add_dot(panel, trial->averages->coast_speed, found.coasting, 1, false);
  }
  return panel;
}

}  // namespace

std::string pulling_figure_4(const report::PullingReport& report) {
  const SimulatedTrial& trial = report.trials.at(report.shown);
  const calibration::TrialSignals& s = trial.trial.signals;
  const auto one = [&](const std::vector<double>& y) {
    return std::vector<Curve>{curve_of("", s.time, y, pen(0, 1.2))};
  };
  Chart chart{.title = "Pulling test: time histories (as Figure 4 of Xu, Ma & Kurata 2022)",
              .note = subject_of(report) +
                      "; simulated, sampled at 120 Hz; I held, II pulled, III coasting, IV stopped "
                      "or end of the flooring: as found from the signals",
              .columns = 2};
  for (Panel panel :
       {time_panel("Displacement", "Displacement (m)", trial, one(s.displacement)),
        time_panel("Velocity", "Velocity (m/s)", trial, one(trial.velocity)),
        time_panel("Acceleration", "Acceleration (m/s\u00b2)", trial, accelerations(trial)),
        time_panel("Cable force", "Force (N)", trial, one(s.force))}) {
    if (trial.phases) panel.spans = phase_spans(*trial.phases, s.time);
    leave_room_for_names(panel);
    chart.panels.push_back({.panel = std::move(panel), .height = kHeight});
  }
  return chart.svg({.width = kWidth});
}

std::string pulling_figure_6(const report::PullingReport& report) {
  const Trials trials = usable(report);
  const auto casters = names(trials, caster_of);
  double heaviest = 0, highest = highest_resistance(trials);
  for (const SimulatedTrial* trial : trials)
    heaviest = std::max(heaviest, trial->theory.normal_force);
  for (const calibration::MeasuredTrial& each : report.measured) {
    if (!each.fault.empty()) continue;
    heaviest = std::max(heaviest, calibration::normal_force(each.trial.setup));
    highest = std::max(highest, calibration::mean_resistance(*each.averages));
  }
  const Range loads = from_zero(heaviest);
  Panel panel = resistance_panel("", "Normal force on all wheels (N)", loads, highest);
  panel.legend_columns = 1;
  for (const calibration::CasterFit& fit : calibration::fits_by_caster(report.trials))
    panel.curves.push_back(
        {fmt::format("{}: Cr/R = {:.4f} ({:.4f} input)", fit.caster, fit.found, fit.known),
         {loads.low, loads.high},
         {0, fit.found * loads.high},
         pen(index_in(casters, fit.caster), 1.5, panel.curves.empty() ? "" : "7 4")});
  // Casters that roll alike would hide each other.
  for (const SimulatedTrial* trial : trials) {
    const std::size_t caster = index_in(casters, caster_of(*trial));
    const double aside = 0.008 * loads.span() * (static_cast<double>(caster) - 1);
    add_dot(panel, trial->theory.normal_force + aside,
            calibration::mean_resistance(*trial->averages), caster, caster == 0);
  }
  for (const calibration::MeasuredTrial& each : report.measured)
    if (each.fault.empty() &&
        calibration::alignment_of(each.trial.setup.headings) == calibration::Alignment::kAligned)
      add_dot(panel, calibration::normal_force(each.trial.setup),
              calibration::mean_resistance(*each.averages),
              index_in(casters, each.trial.setup.caster), false, Marker::kSquare);
  return Chart{"Rolling resistance against load (as Figure 6 of Xu, Ma & Kurata 2022)",
               about(report),
               {{.panel = std::move(panel), .height = kOfLoads}}}
      .svg({.width = 735});
}

std::string pulling_figure_7(const report::PullingReport& report) {
  Trials trials = usable(report);  // of the empty item
  std::erase_if(trials, [](const auto* trial) { return trial->trial.setup.payload != 0; });
  Chart chart{.title = "Wheel diameter, floor and speed (as Figure 7 of Xu, Ma & Kurata 2022)",
              .note = about(report),
              .columns = 2};
  if (!trials.empty())
    chart.panels = of_height({diameter_panel(trials), speed_panel(trials)}, kOfLoads);
  return chart.svg({.width = kWidth});
}

std::string pulling_figure_11(const report::PullingReport& report) {
  const SimulatedTrial& trial = report.trials.at(report.shown);
  const calibration::TrialSignals& s = trial.trial.signals;
  const calibration::MeasuredTrial* const measured =
      calibration::find_matching(trial, report.measured);
  const bool overlaid = measured != nullptr && !measured->trial.signals.displacement.empty();
  Panel displacement = time_panel(
      "Displacement", "Displacement (m)", trial,
      {curve_of("simulated", s.time, s.displacement, pen(0, 1.4)),
       theory_curve(trial, [](const auto& of, double time) { return of.displacement_at(time); })});
  Panel velocity = time_panel(
      "Velocity", "Velocity (m/s)", trial,
      {curve_of("simulated", s.time, trial.velocity, pen(0, 1.4)),
       theory_curve(trial, [](const auto& of, double time) { return of.velocity_at(time); })});
  if (overlaid) {
    const std::vector<double>& path = measured->trial.signals.displacement;
    const std::vector<double> time = moved(*measured, trial);
    const Pen theirs = pen(2, 1.2, "2 2");
    displacement.curves.push_back(curve_of(origin_of(*measured), time, path, theirs));
    velocity.curves.push_back(
        curve_of(origin_of(*measured), time, calibration::rate(time, path), theirs));
  }
  Panel energy = time_panel("Energy", "Energy (J)", trial, {});
  if (!trial.kinetic.empty())
    energy.curves = {curve_of("W_F: weight and strings", s.time, trial.work, pen(0, 1.4)),
                     curve_of("W_R: rolling", s.time, trial.rolling_loss, pen(1, 1.4), -1),
                     curve_of("E_KT: kinetic", s.time, trial.kinetic, pen(2, 1.4))};
  Chart chart{.title = "Pulling test against its reference (as Figure 11 of Xu, Ma & Kurata 2022)",
              .note = subject_of(report) +
                      "; reference: closed-form mechanics of casters in line; " +
                      (overlaid ? origin_of(*measured) + ": " + measured->trial.name
                                : "no measured trial is given"),
              .panels = of_height({displacement, velocity, energy}, kHeight),
              .columns = 2};
  chart.panels.back().across = 2;
  return chart.svg({.width = kWidth});
}

}  // namespace gurney::figures
