#include "studies/figures/pulling_figures.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "engine/base/units.h"
#include "studies/calibration/trials/trial.h"

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
  for (double diameter = diameters.low; diameter <= diameters.high; diameter += 1)
    inverse.add(diameter, calibration::mean_resistance(*trials[0]->averages) * 2 *
                              kMillimetersPerMeter * trials[0]->trial.setup.wheel_radius /
                              diameter);
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

constexpr std::array kPhaseNames = {"I", "II", "III", "IV"};
constexpr std::array kPhaseColors = {"#dddddd", "#f6d9a8", "#bcd9ee", "#eeeeee"};

bool finite(const Range& range) { return std::isfinite(range.low) && std::isfinite(range.high); }

/// Rolling resistance of each caster on each floor over its load, with its pulls.
Panel load_panel(const std::vector<LoadLine>& lines) {
  Range load, resistance;
  for (const LoadLine& line : lines) {
    load = widened(load, line.load);
    resistance = widened(resistance, line.resistance);
  }
  const double highest = 1.1 * load.high;
  Panel panel{.title = "",
              .x_label = "Normal force on all wheels N (N)",
              .y_label = "Rolling resistance f_r (N)",
              .legend_columns = 1,
              .x_range = {0, highest},
              .y_range = {0, 1.25 * resistance.high}};
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const LoadLine& line = lines[i];
    for (const auto& [slopes, opacity] :
         {std::pair{line.prediction, 0.12}, std::pair{line.interval, 0.28}})
      if (finite(slopes))
        panel.areas.push_back({{0, highest},
                               {0, slopes.low * highest},
                               {0, slopes.high * highest},
                               palette(i),
                               opacity});
    panel.curves.push_back(
        {line.label, {0, highest}, {0, line.ratio * highest}, pen(i, 1.8), marker(i)});
    panel.marks.push_back({"", line.load, line.resistance, pen(i, 1.2), marker(i), 3.5});
  }
  return panel;
}

std::vector<LoadLine> load_lines(const calibration::Calibration& c) {
  std::vector<LoadLine> lines;
  for (const calibration::Constant& each : c.constants) {
    if (each.kind != calibration::ConstantKind::kRolling) continue;
    LoadLine line{fmt::format("{} on {}: Cr/R {:.4g}", each.caster, each.floor, each.value),
                  each.value,
                  {each.interval.low, each.interval.high},
                  {each.prediction.low, each.prediction.high},
                  {},
                  {}};
    for (const calibration::RollingTrial& trial : c.rolling) {
      const calibration::TrialSetup& setup = trial.averages.setup;
      if (setup.caster != each.caster || setup.floor != each.floor) continue;
      line.load.push_back(normal_force(setup));
      line.resistance.push_back(trial.resistance.mean);
    }
    lines.push_back(std::move(line));
  }
  return lines;
}

Panel signal_panel(const calibration::PhasedPull& pull, const std::string& title,
                   const std::string& x_label, const std::string& y_label,
                   const std::vector<double>& values, double unit) {
  const std::vector<double>& time = pull.trial.signals.time;
  Panel panel{.title = title,
              .x_label = x_label,
              .y_label = y_label,
              .curves = {curve_of("", time, values, pen(0, 1.4), unit)},
              .spans = phase_spans(pull.phases, time)};
  leave_room_for_names(panel);
  return panel;
}

/// The phases of each pull as a row of bars.
Panel phases_panel(const std::vector<calibration::PhasedPull>& pulls) {
  constexpr std::size_t kMaxRows = 40;
  const auto count = std::min(pulls.size(), kMaxRows);
  Panel panel{.title = count < pulls.size()
                           ? fmt::format("Phases found, first {} of {} pulls", count, pulls.size())
                           : "Phases found: I held, II pulled, III coasting, IV stopped or end of "
                             "floor",
              .x_label = "Time (s)",
              .y_label = ""};
  Range whole{INFINITY, -INFINITY};
  for (std::size_t row = 0; row < count; ++row) {
    const std::vector<double>& time = pulls[row].trial.signals.time;
    whole = widened(whole, {time.front(), time.back()});
    panel.rows.push_back(pulls[row].trial.name);
    for (const Span& span : phase_spans(pulls[row].phases, time))
      panel.bars.push_back({static_cast<double>(row) + 0.5,
                            0.38,
                            {span.x.low, std::max(span.x.low, span.x.high)},
                            {.stroke = "#888888", .width = 0.4, .fill = span.fill}});
  }
  panel.x_range = whole;
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

std::vector<Span> phase_spans(const calibration::Phases& phases, const std::vector<double>& time) {
  const std::array<double, 5> at = {time.front(), phases.start, phases.release, phases.stop,
                                    time.back()};
  std::vector<Span> spans;
  for (std::size_t i = 0; i < kPhaseNames.size(); ++i)
    spans.push_back({{at[i], at[i + 1]}, kPhaseNames[i], kPhaseColors[i]});
  return spans;
}

void leave_room_for_names(Panel& panel) {
  Range range{INFINITY, -INFINITY};
  for (const Curve& each : panel.curves) range = widened(range, each.y);
  if (range.low <= range.high)
    panel.y_range = {range.low - 0.08 * range.span(), range.high + 0.25 * range.span()};
}

std::string calibration_figure(const calibration::Calibration& c) {
  Chart chart{
      .title = "Calibration from " + c.source,
      .note = fmt::format("{} trials, {} excluded{}", c.read, c.left_out.size(),
                          c.simulated > 0 ? fmt::format("; {} SIMULATED", c.simulated) : ""),
      .columns = 2};
  if (c.rolling.empty()) {
    chart.note += ". No pulls with use = calibration.";
  } else {
    chart.note +=
        ". Dark band: 95 % confidence interval; light band: 95 % prediction interval. "
        "Each point is a pull.";
    chart.panels.push_back(
        {.panel = load_panel(load_lines(c)), .height = 380, .down = c.pulls.empty() ? 1u : 2u});
  }
  if (!c.pulls.empty()) {
    const calibration::PhasedPull& pull = c.pulls.front();
    const calibration::TrialSignals& s = pull.trial.signals;
    const bool displacement = !s.displacement.empty();
    chart.panels.push_back(
        {.panel = signal_panel(pull, "Phases of " + pull.trial.name, "",
                               displacement ? "Displacement (mm)" : "Acceleration (m/s\u00b2)",
                               displacement ? s.displacement : s.acceleration,
                               displacement ? 1 / kMillimetersPerMeter : 1),
         .height = 150});
    const auto found = calibration::average_method(pull.averages);
    chart.panels.push_back({.panel = signal_panel(pull,
                                                  fmt::format("f_r = {:.3g} N pulled, {:.3g} N "
                                                              "coasting",
                                                              found.pulled, found.coasting),
                                                  "Time (s)", "Cable force (N)", s.force, 1),
                            .height = 150});
    const Panel phases = phases_panel(c.pulls);
    chart.panels.push_back(
        {.panel = phases, .height = 13 * static_cast<double>(phases.rows.size()), .across = 2});
  }
  return chart.svg({.width = 1180});
}

std::string load_figure(const PlotPage& page, const std::vector<LoadLine>& lines) {
  return Chart{"Rolling resistance against load",
               "each mark is a pull; dark band: 95 % confidence interval of Cr/R; light band: 95 % "
               "prediction interval of one more pull",
               {{.panel = load_panel(lines)}}}
      .svg(page);
}

std::string residual_figure(const PlotPage& page, const std::vector<ResidualRow>& rows) {
  Panel panel{.title = "",
              .x_label = "Value of the trial over the constant, less one (%)",
              .y_label = "",
              .legend_columns = 2,
              .guides = {{0}}};
  panel.marks = {{"calibration", {}, {}, {.stroke = palette(0), .width = 1.2, .fill = palette(0)}},
                 {"validation", {}, {}, pen(1, 1.2)}};
  double reach = 1;
  for (std::size_t row = 0; row < rows.size(); ++row) {
    const double middle = static_cast<double>(row) + 0.5;
    panel.rows.push_back(rows[row].label);
    for (const auto& [range, opacity] :
         {std::pair{rows[row].prediction, 0.12}, std::pair{rows[row].interval, 0.25}})
      if (finite(range))
        panel.bars.push_back({middle,
                              0.24,
                              {100 * (range.low - 1), 100 * (range.high - 1)},
                              {.stroke = "", .fill = palette(0), .opacity = opacity}});
    for (const ResidualRow::Trial& each : rows[row].trials) {
      const double x = 100 * (each.ratio - 1), half = 200 * each.error;
      Marks& marks = panel.marks[each.validation ? 1 : 0];
      marks.add(x, middle);
      panel.bars.push_back({middle, 0, {x - half, x + half}, {.stroke = marks.pen.stroke}});
      reach = std::max(reach, std::abs(x) + half);
    }
  }
  panel.x_range = {-1.15 * reach, 1.15 * reach};
  return Chart{"Residuals",
               "line through a mark: two standard errors of its measurement to either side; dark "
               "band: 95 % confidence interval of the constant; light band: 95 % prediction "
               "interval of one more trial",
               {{.panel = std::move(panel)}}}
      .svg(page);
}

}  // namespace gurney::figures
