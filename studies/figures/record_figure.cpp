#include "studies/figures/record_figure.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/base/units.h"
#include "groundmotions/measures/combined_spectrum.h"
#include "groundmotions/measures/integrate.h"
#include "groundmotions/measures/response_spectrum.h"
#include "studies/figures/panel.h"

namespace gurney::figures {
namespace {

constexpr double kWidth = 1240, kLeft = 70, kColumn = 395, kPanelWidth = 320, kPanelHeight = 130,
                 kTop = 100, kRow = 195, kSpectrumHeight = 240;
constexpr int kBins = 640;  ///< of a curve: two for each px

Frame frame_at(std::size_t column, int row) {
  return {kLeft + static_cast<double>(column) * kColumn, kTop + row * kRow, kPanelWidth,
          kPanelHeight};
}

/// Smallest and largest value of each bin of samples, which is all that can be seen.
Curve thinned(double time_step, const Eigen::VectorXd& values, double unit, std::size_t color) {
  Curve curve{"", {}, {}, {.stroke = palette(color), .width = 0.9}};
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

void draw_history(Svg& svg, const Frame& frame, const std::string& title, const std::string& label,
                  double time_step, const Eigen::VectorXd& values, double unit, std::size_t color) {
  draw(svg, frame,
       {.title = title,
        .x_label = "Time (s)",
        .y_label = label,
        .curves = {thinned(time_step, values, unit, color)},
        .x_range = {0, time_step * static_cast<double>(values.size() - 1)}});
}

void draw_component(Svg& svg, const groundmotions::Component& component,
                    groundmotions::Direction direction) {
  const auto column = static_cast<std::size_t>(direction);
  const double step = component.time_step;
  const Eigen::VectorXd& acceleration = component.acceleration;
  const groundmotions::IntegratedMotion motion = groundmotions::integrated(step, acceleration);
  const auto& velocity = motion.velocity;
  const auto& displacement = motion.displacement;
  const std::string name = fmt::format("{}{}", name_of(direction),
                                       component.name.empty() ? "" : " (" + component.name + ")");
  draw_history(
      svg, frame_at(column, 0),
      fmt::format("{}: PGA {:.3g} g", name, acceleration.cwiseAbs().maxCoeff() / kStandardGravity),
      "Acceleration (g)", step, acceleration, kStandardGravity, column);
  draw_history(svg, frame_at(column, 1),
               fmt::format("PGV {:.3g} m/s, {:.2g} m/s at the end", velocity.cwiseAbs().maxCoeff(),
                           velocity[velocity.size() - 1]),
               "Velocity (m/s)", step, velocity, 1, column);
  draw_history(svg, frame_at(column, 2),
               fmt::format("PGD {:.3g} m, {:.2g} m at the end", displacement.cwiseAbs().maxCoeff(),
                           displacement[displacement.size() - 1]),
               "Displacement (m)", step, displacement, 1, column);
}

Curve spectrum_curve(const std::string& label, const Eigen::VectorXd& periods,
                     const Eigen::VectorXd& acceleration, const Pen& pen) {
  Curve curve{label, {periods.begin(), periods.end()}, {}, pen};
  for (const double value : acceleration) curve.y.push_back(value / kStandardGravity);
  return curve;
}

void draw_spectra(Svg& svg, const groundmotions::Record& record) {
  const Eigen::VectorXd periods = groundmotions::logarithmic_periods(0.02, 10, 150);
  Panel panel{.title = "Pseudo-acceleration, 5 % damping",
              .x_label = "Period (s)",
              .y_label = "PSA (g)",
              .curves = {},
              .log_x = true,
              .legend_columns = 4};
  for (const groundmotions::Direction direction : groundmotions::kDirections) {
    if (!record[direction]) continue;
    const groundmotions::Component& component = *record[direction];
    panel.curves.push_back(spectrum_curve(
        name_of(direction), periods,
        groundmotions::response_spectrum(component.time_step, component.acceleration, periods)
            .pseudo_acceleration,
        {.stroke = palette(static_cast<std::size_t>(direction)), .width = 1.2}));
  }
  if (record[groundmotions::Direction::kH1] && record[groundmotions::Direction::kH2])
    panel.curves.push_back(spectrum_curve(
        "RotD50", periods,
        groundmotions::combined_spectrum(groundmotions::Combination::kRotD50, record, periods),
        {.stroke = "#000000", .width = 1.8}));
  draw(svg, {kLeft, kTop + 3 * kRow, 2 * kColumn + kPanelWidth, kSpectrumHeight}, panel);
}

}  // namespace

std::string record_figure(const groundmotions::Record& record) {
  Svg svg(kWidth, kTop + 3 * kRow + kSpectrumHeight + 55);
  svg.text(kLeft, 34, record.name, {.size = 17, .bold = true});
  svg.text(kLeft, 55,
           fmt::format("{} samples, {:g} s apart; velocity and displacement from rest, {}",
                       record.samples(), record.time_step(),
                       record.processing.empty()
                           ? "nothing done to the samples"
                           : fmt::format("after {} processing steps", record.processing.size())),
           {.size = 12, .color = "#555555"});
  for (const groundmotions::Direction direction : groundmotions::kDirections)
    if (record[direction]) draw_component(svg, *record[direction], direction);
  draw_spectra(svg, record);
  return svg.str();
}

}  // namespace gurney::figures
