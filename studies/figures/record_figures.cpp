#include "studies/figures/record_figures.h"

#include <fmt/format.h>

#include <algorithm>

#include "engine/base/units.h"
#include "groundmotions/measures/combination.h"
#include "groundmotions/measures/peaks.h"
#include "groundmotions/measures/response_spectrum.h"
#include "studies/figures/chart.h"

namespace gurney::figures {
namespace {

using groundmotions::Direction;

/// Smallest and largest value of each bin of samples, which is all that can be seen.
Curve thinned(double time_step, const Eigen::VectorXd& values, double unit, std::size_t color) {
  constexpr Eigen::Index kBins = 640;  // two for each px
  Curve curve{"", {}, {}, pen(color, 0.9)};
  const auto add = [&](Eigen::Index i) {
    curve.x.push_back(static_cast<double>(i) * time_step);
    curve.y.push_back(values[i] / unit);
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
  const Eigen::VectorXd periods = groundmotions::logarithmic_periods(0.02, 10, 150);
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

}  // namespace gurney::figures
