#include "groundmotions/buildings/floor_findings.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/base/units.h"
#include "groundmotions/measures/integrate.h"
#include "groundmotions/measures/peaks.h"

namespace gurney::groundmotions {
namespace {

using std::numbers::pi;

constexpr double kVisibleDrift = 0.01;  ///< after the ground's end; an assumption [m]
constexpr double kShareOfPeak = 0.1;    ///< and of the peak displacement; an assumption
constexpr const char* kBaselineStep = "\"baseline kind=end_at_rest\"";
constexpr double kElasticDrift = 0.01;     ///< storey drift ratio; an assumption
constexpr double kSteadyDrift = 0.04;      ///< of storeys that yield; an assumption
constexpr double kLargestRotation = 0.05;  ///< sin and cos are 1 and 0 within 0.13 % [rad]

/// A finding, and with the words of what follows from it a warning where it is too large.
void report_finding(const std::string& finding, bool too_large, const std::string& therefore,
                    BuildingResponse& response) {
  response.findings.push_back(finding);
  response.floor.processing.push_back(finding);
  if (too_large) response.floor.warnings.push_back(finding + ": " + therefore);
}

}  // namespace

void report_rotation(Record& floor) {
  const Vector2 peak = floor.rotation->angle.cwiseAbs().rowwise().maxCoeff();
  floor.processing.push_back(fmt::format(
      "the floor rotates: peak {:.3g} rad about h1, {:.3g} rad about h2", peak.x(), peak.y()));
  if (peak.maxCoeff() > kLargestRotation)
    floor.warnings.push_back(
        fmt::format("the floor rotates by {:.3g} rad; the engine takes rotations as small, up to "
                    "{:g} rad, and a building would not stay linear",
                    peak.maxCoeff(), kLargestRotation));
}

void report_vertical(const Record& ground, const Building& building, BuildingResponse& response) {
  const ModalAxis& axis = building[Direction::kVertical];
  if (axis.empty() || !ground[Direction::kVertical]) return;
  const auto peak = [](const Component& component) {
    return peaks(component.time_step, component.acceleration).acceleration;
  };
  const double below = peak(*ground[Direction::kVertical]);
  const double above = peak(*response.floor[Direction::kVertical]);
  if (!(below > 0)) return;
  report_finding(
      fmt::format("vertical amplified {:.2g} times, to {:.3g} g, by the building's own frequency "
                  "({:.3g} Hz, {:.2g} % damping, assumptions of its file)",
                  above / below, above / kStandardGravity, axis.front().omega / (2 * pi),
                  100 * axis.front().damping),
      above > kStandardGravity, "above 1 g what stands on the floor leaves it", response);
}

void report_storey_drift(double largest, const Building& building, BuildingResponse& response) {
  if (!building.height) return;
  const double ratio = largest / (*building.height / building.storeys);
  response.storey_drift_ratio = ratio;
  if (!response.storeys)
    return report_finding(
        fmt::format("peak storey drift ratio {:.2g} %", 100 * ratio), ratio > kElasticDrift,
        fmt::format("the model is elastic; above {:g} % a building yields, and its floors "
                    "accelerate less",
                    100 * kElasticDrift),
        response);
  const StoreyResponse& storeys = *response.storeys;
  Eigen::Index storey = 0;
  const double ductility = storeys.ductility.maxCoeff(&storey);
  response.residual_drift_ratio =
      storeys.residual_drift.maxCoeff() / (*building.height / building.storeys);
  report_finding(
      fmt::format(
          "peak storey drift ratio {:.2g} %, residual {:.2g} %, ductility {:.2g} in storey {}",
          100 * ratio, 100 * *response.residual_drift_ratio, ductility, storey + 1),
      ratio > kSteadyDrift,
      fmt::format("the storeys of the model keep strength and stiffness; above {:g} % those of a "
                  "building lose them",
                  100 * kSteadyDrift),
      response);
}

void report_drift(const Record& ground, double tail, Record& floor) {
  for (const Direction direction : kDirections) {
    if (!ground[direction] || !floor[direction]) continue;
    const double step = ground.time_step();
    const double speed = std::abs(end_motion(step, ground[direction]->acceleration).velocity);
    const double below = peaks(step, ground[direction]->acceleration).displacement;
    if (speed * tail <= std::max(kVisibleDrift, kShareOfPeak * below)) continue;
    const auto& above = *floor[direction];
    floor.warnings.push_back(fmt::format(
        "{}: the ground still moves at {:.2g} m/s when its record ends; over the {:.3g} s that the "
        "building vibrates on this is {:.2g} m, and the peak displacement of {:.3g} m becomes "
        "{:.3g} m on the floor; correct the baseline of the record first, with the step {}",
        name_of(direction), speed, tail, speed * tail, below,
        peaks(above.time_step, above.acceleration).displacement, kBaselineStep));
  }
}

}  // namespace gurney::groundmotions
