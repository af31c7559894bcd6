#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "engine/base/units.h"
#include "studies/figures/pulling_figures.h"

namespace gurney::figures {
namespace {

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
      marks.x.push_back(x);
      marks.y.push_back(middle);
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
