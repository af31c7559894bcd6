#include "studies/figures/record_figures.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "engine/base/error.h"
#include "engine/base/units.h"
#include "groundmotions/measures/combination.h"
#include "groundmotions/measures/peaks.h"
#include "groundmotions/measures/response_spectrum.h"
#include "studies/figures/chart.h"
#include "studies/figures/labels.h"
#include "studies/statistics/quantiles.h"

namespace gurney::figures {
namespace {

using groundmotions::Direction;

/// Smallest and largest value of each bin of samples, which is all that can be seen.
Curve thinned(double time_step, const Eigen::VectorXd& values, double unit, std::size_t color) {
  constexpr Eigen::Index kBins = 640;  // two for each px
  Curve curve{"", {}, {}, pen(color, 0.9)};
  const auto add = [&](Eigen::Index i) {
    curve.add(static_cast<double>(i) * time_step, values[i] / unit);
  };
  const Eigen::Index bin = std::max<Eigen::Index>(1, values.size() / kBins);
  for (Eigen::Index first = 0; first < values.size(); first += bin) {
    const Eigen::Index count = std::min(bin, values.size() - first);
    Eigen::Index low = 0, high = 0;
    values.segment(first, count).minCoeff(&low);
    values.segment(first, count).maxCoeff(&high);
    add(first + std::min(low, high));
    if (low != high) add(first + std::max(low, high));
  }
  return curve;
}

/// Acceleration, velocity and displacement, one below the other.
std::vector<Panel> component_panels(const groundmotions::Component& component,
                                    Direction direction) {
  const double step = component.time_step;
  const Eigen::VectorXd& acceleration = component.acceleration;
  const groundmotions::IntegratedMotion motion = groundmotions::integrated(step, acceleration);
  const auto panel = [&](const std::string& title, const char* label, const Eigen::VectorXd& values,
                         double unit) {
    return Panel{.title = title,
                 .x_label = "Time (s)",
                 .y_label = label,
                 .curves = {thinned(step, values, unit, static_cast<std::size_t>(direction))},
                 .x_range = {0, step * static_cast<double>(values.size() - 1)}};
  };
  const auto peak = [](const Eigen::VectorXd& values) { return values.cwiseAbs().maxCoeff(); };
  const auto last = [](const Eigen::VectorXd& values) { return values[values.size() - 1]; };
  return {panel(fmt::format("{}{}: PGA {:.3g} g", name_of(direction),
                            component.name.empty() ? "" : " (" + component.name + ")",
                            peak(acceleration) / kStandardGravity),
                "Acceleration (g)", acceleration, kStandardGravity),
          panel(fmt::format("PGV {:.3g} m/s, {:.2g} m/s at the end", peak(motion.velocity),
                            last(motion.velocity)),
                "Velocity (m/s)", motion.velocity, 1),
          panel(fmt::format("PGD {:.3g} m, {:.2g} m at the end", peak(motion.displacement),
                            last(motion.displacement)),
                "Displacement (m)", motion.displacement, 1)};
}

Panel spectra_panel(const groundmotions::Record& record) {
  const Eigen::VectorXd periods = groundmotions::logarithmic_periods(kShortestPeriod, 10, 150);
  Panel panel{.title = "Pseudo-acceleration, 5 % damping",
              .x_label = "Period (s)",
              .y_label = "PSA (g)",
              .log_x = true,
              .legend_columns = 4};
  for (const Direction direction : groundmotions::kDirections) {
    if (!record[direction]) continue;
    const groundmotions::Component& component = *record[direction];
    panel.curves.push_back(curve_of(
        name_of(direction), periods,
        groundmotions::response_spectrum(component.time_step, component.acceleration, periods)
            .pseudo_acceleration,
        pen(static_cast<std::size_t>(direction), 1.2), kStandardGravity));
  }
  if (record[Direction::kH1] && record[Direction::kH2])
    panel.curves.push_back(curve_of(
        "RotD50", periods,
        groundmotions::combined_spectrum(groundmotions::Combination::kRotD50, record, periods),
        {.stroke = "#000000", .width = 1.8}, kStandardGravity));
  return panel;
}

using Suite = study::SuiteSpectra;

struct View {
  const char* name;
  std::string (*title)(const Suite&);
  Eigen::VectorXd (*spectrum)(const Suite::Record&);
};

std::string factors_of(const Suite& suite) {
  const auto [low, high] = std::ranges::minmax(suite.records, {}, &Suite::Record::factor);
  return low.factor == high.factor
             ? fmt::format("factor {:.3g}", low.factor)
             : fmt::format("factors {:.3g} to {:.3g}", low.factor, high.factor);
}

std::string title_of_scaled(const Suite& suite) {
  return fmt::format("Scaled to {}, {}", suite.level, factors_of(suite));
}

const View kViews[] = {
    {"records", [](const Suite&) -> std::string { return "Records as read and processed"; },
     [](const Suite::Record& record) { return record.ground; }},
    {"scaled", title_of_scaled,
     [](const Suite::Record& record) -> Eigen::VectorXd { return record.factor * record.ground; }},
    {"floor", [](const Suite& suite) { return "Floor, records scaled to " + suite.level; },
     [](const Suite::Record& record) { return record.floor; }}};

bool has(const Suite& suite, const View& view) {
  return view.spectrum(suite.records.front()).size() > 0;
}

bool changes(const Suite& suite) {
  return std::ranges::any_of(suite.records, [](const auto& each) { return each.factor != 1; });
}

std::vector<View> views_of(const std::vector<Suite>& suites, const std::vector<std::string>& what) {
  std::vector<View> views;
  for (const std::string& each : what)
    require(std::ranges::find(kViews, each, &View::name) != std::end(kViews),
            fmt::format("no spectra of '{}'; there are records, scaled, floor", each));
  for (const View& view : kViews) {
    const std::string name = view.name;
    const bool wanted = std::ranges::find(what, name) != what.end();
    const bool there = std::ranges::any_of(suites, [&](const Suite& each) {
      return has(each, view) && (wanted || name != "scaled" || changes(each));
    });
    require(there || !wanted, "no spectra of the floor: the study has no building");
    if (there && (wanted || what.empty())) views.push_back(view);
  }
  return views;
}

/// Fractiles at each period, as one curve with a gap: it is drawn whole or not at all.
Curve fractiles(const std::vector<Eigen::VectorXd>& spectra, const Eigen::VectorXd& periods,
                const std::vector<double>& fractions, const std::string& label, const Pen& pen,
                double unit) {
  constexpr double kNoPoint = std::numeric_limits<double>::quiet_NaN();
  Curve curve{label, {}, {}, pen};
  for (const double fraction : fractions) {
    if (!curve.x.empty()) curve.add(kNoPoint, kNoPoint);
    for (Eigen::Index i = 0; i < periods.size(); ++i) {
      std::vector<double> values;
      for (const Eigen::VectorXd& each : spectra) values.push_back(each[i] / unit);
      curve.add(periods[i], statistics::quantile_of(values, fraction));
    }
  }
  return curve;
}

Panel spectra_panel(const std::string& title, const std::string& quantity,
                    const study::ReportUnit& unit) {
  return {.title = title,
          .x_label = "Period (s)",
          .y_label = with_unit(quantity, unit),
          .zero_line = false,
          .log_x = true,
          .legend_columns = 3,
          .log_y = true};
}

PlotPanel panel_of(const Suite& suite, const View& view, bool named,
                   const study::ReportUnit& unit) {
  std::string which = suite.configurations.front();
  if (suite.configurations.size() > 1)
    which += fmt::format(" and {} more", suite.configurations.size() - 1);
  Panel panel = spectra_panel(view.title(suite) + (named && !which.empty() ? ", " + which : ""),
                              std::string("Sa ") + name_of(suite.combination), unit);
  std::vector<Eigen::VectorXd> spectra;
  for (const Suite::Record& record : suite.records) {
    spectra.push_back(view.spectrum(record));
    const bool alone = suite.records.size() == 1;
    panel.curves.push_back(curve_of(alone                 ? record.name
                                    : spectra.size() == 1 ? "records"
                                                          : "",
                                    suite.periods, spectra.back(),
                                    alone ? pen(0, 1.8) : Pen{.stroke = "#999999", .width = 0.7},
                                    unit.in_si));
  }
  if (suite.records.size() < 2) return {.panel = panel, .aspect = 0.6};
  panel.curves.push_back(fractiles(spectra, suite.periods, {0.5}, "median",
                                   {.stroke = palette(0), .width = 2}, unit.in_si));
  panel.curves.push_back(fractiles(spectra, suite.periods, {0.16, 0.84}, "16 and 84 % fractiles",
                                   {.stroke = palette(1), .width = 1.5, .dash = "6 3"},
                                   unit.in_si));
  return {.panel = panel, .aspect = 0.6};
}

PlotPanel panel_of(const study::StoredHistory& history, const study::UnitSystem& units) {
  constexpr std::size_t kTogether = 3;
  const study::ReportUnit unit = units.of(history.units);
  PlotPanel result{.panel = {.title = label_of(history.name),
                             .x_label = "Time (s)",
                             .y_label = with_unit(label_of(history.name), unit),
                             .legend_columns = 4,
                             .least_span = least_span(history.units) / unit.in_si},
                   .aspect = 0.4};
  for (const study::StoredHistory::Series& series : history.series) {
    const std::string space = series.part.empty() || series.axis.empty() ? "" : ", ";
    result.panel.curves.push_back(curve_of(series.part + space + series.axis, history.time,
                                           series.values, pen(result.panel.curves.size(), 1.2),
                                           unit.in_si));
  }
  // A vertical component of several g would hide the horizontal ones.
  const bool of_floor = history.name.starts_with("floor_") && result.panel.curves.size() > 1;
  result.panel.own_ranges = of_floor;
  result.panel.lanes = of_floor || (history.of != "axis" && result.panel.curves.size() > kTogether);
  return result;
}

}  // namespace

std::string record_figure(const groundmotions::Record& record) {
  std::vector<std::vector<Panel>> components;
  for (const Direction direction : groundmotions::kDirections)
    if (record[direction]) components.push_back(component_panels(*record[direction], direction));
  Chart chart{
      .title = record.name,
      .note = fmt::format("{} samples, {:g} s apart; velocity and displacement from rest, {}",
                          record.samples(), record.time_step(),
                          record.processing.empty()
                              ? "nothing done to the samples"
                              : fmt::format("after {} processing steps", record.processing.size())),
      .columns = components.size()};
  for (std::size_t row = 0; row < 3; ++row)
    for (const std::vector<Panel>& each : components)
      chart.panels.push_back({.panel = each[row], .height = 130});
  chart.panels.push_back(
      {.panel = spectra_panel(record), .height = 240, .across = components.size()});
  return chart.svg({.width = 420 * std::max(2.0, static_cast<double>(components.size()))});
}

std::string suite_figure(const groundmotions::TargetSpectrum& target,
                         const Eigen::VectorXd& periods, const Eigen::MatrixXd& spectra,
                         const groundmotions::SuiteScaling& scaling) {
  Panel panel{
      .title = fmt::format("Mean at least {:.0f} % of the target; misfit of the mean {:.3f}",
                           100 * scaling.smallest_ratio, scaling.suite_misfit),
      .x_label = "Period (s)",
      .y_label = "Sa (g)",
      .log_x = true,
      .legend_columns = 3};
  const auto add = [&](const char* label, const Eigen::VectorXd& values, const Pen& pen) {
    panel.curves.push_back(curve_of(label, periods, values, pen, kStandardGravity));
  };
  for (Eigen::Index i = 0; i < spectra.rows(); ++i)
    add(i == 0 ? "records" : "", scaling.factors[i] * spectra.row(i).transpose(),
        {.stroke = "#999999", .width = 0.8});
  add("mean", scaling.mean, pen(0, 2));
  add("target", periods.unaryExpr([&](double period) { return target.at(period); }),
      pen(1, 2, "6 3"));
  return Chart{fmt::format("{} record{} scaled to {}, {:g} % damping", spectra.rows(),
                           spectra.rows() == 1 ? "" : "s", target.name, 100 * target.damping),
               "",
               {{.panel = std::move(panel), .height = 320}}}
      .svg({.width = 900});
}

std::string selection_figure(const groundmotions::SelectionTarget& target,
                             const groundmotions::Selection& selection) {
  const groundmotions::SpectrumDistribution& spectrum = target.spectrum;
  const Eigen::Index count = selection.ln_spectra.rows();
  Panel spectra{.title = fmt::format("Spectra, {:g} % damping", 100 * target.damping),
                .x_label = "Period (s)",
                .y_label = "Sa (g)",
                .log_x = true,
                .legend_columns = 4,
                .log_y = true};
  const auto add = [&](Panel& panel, const char* label, const Eigen::VectorXd& values,
                       const Pen& pen, double unit) {
    panel.curves.push_back(curve_of(label, spectrum.periods, values, pen, unit));
  };
  const auto fractile = [&](const char* label, double probability, const Pen& pen) {
    add(spectra, label, spectrum.quantile(probability), pen, kStandardGravity);
  };
  for (Eigen::Index i = 0; i < count; ++i)
    add(spectra, i == 0 ? "selected" : "", selection.ln_spectra.row(i).array().exp().transpose(),
        {.stroke = "#999999", .width = 0.8}, kStandardGravity);
  add(spectra, "their median", (spectrum.mean + selection.errors.mean).array().exp(), pen(0, 2),
      kStandardGravity);
  fractile("target", 0.5, pen(1, 2, "6 3"));
  fractile("2.5, 97.5 %", 0.025, pen(1, 1.2, "2 3"));
  fractile("", 0.975, pen(1, 1.2, "2 3"));
  Panel sigma{.title = "Standard deviation of ln Sa",
              .x_label = "Period (s)",
              .y_label = "Sigma",
              .log_x = true,
              .legend_columns = 2};
  add(sigma, "selected", spectrum.sigma() + selection.errors.sigma, pen(0, 2), 1);
  add(sigma, "target", spectrum.sigma(), pen(1, 2, "6 3"), 1);
  return Chart{
      fmt::format("{} records selected to {}", count, target.name),
      "",
      {{.panel = std::move(spectra), .height = 320}, {.panel = std::move(sigma), .height = 180}}}
      .svg({.width = 900});
}

std::string spectra_figure(const PlotPage& page, const std::string& title,
                           const std::vector<Suite>& suites, const std::vector<std::string>& what) {
  std::vector<PlotPanel> panels;
  std::size_t records = 0;
  const std::vector<View> views = views_of(suites, what);
  for (const Suite& suite : suites) {
    records += suite.records.size();
    for (const View& view : views)
      if (has(suite, view))
        panels.push_back(panel_of(suite, view, suites.size() > 1, page.units.of("m/s2")));
  }
  return Chart{title,
               fmt::format("pseudo-acceleration, 5 % damping; {} record{}", records,
                           records == 1 ? "" : "s"),
               panels}
      .svg(page);
}

std::string floor_spectra_figure(const PlotPage& page, const std::string& title,
                                 const study::FloorSpectra& spectra) {
  const study::ReportUnit unit = page.units.of("m/s2");
  Panel panel = spectra_panel("Floor", "Sa", unit);
  const char* const dashes[] = {"", "6 3", "2 2"};
  for (const auto& [axis, values] : spectra.of_axis) {
    const std::size_t index = panel.curves.size();
    panel.curves.push_back(
        curve_of(axis, spectra.periods, values, pen(index, 1.6, dashes[index % 3]), unit.in_si));
  }
  return Chart{
      title, "pseudo-acceleration, 5 % damping; floor axes", {{.panel = panel, .aspect = 0.55}}}
      .svg(page);
}

std::string history_figure(const PlotPage& page, const std::string& title, const std::string& note,
                           const std::vector<study::StoredHistory>& histories) {
  std::vector<PlotPanel> panels;
  for (const study::StoredHistory& each : histories) panels.push_back(panel_of(each, page.units));
  return Chart{title, note, panels}.svg(page);
}

}  // namespace gurney::figures
