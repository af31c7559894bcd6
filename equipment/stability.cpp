#include "equipment/stability.h"

#include <fmt/format.h>

#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "engine/base/units.h"

namespace gurney {
namespace {

constexpr double kTransportTilt = 10 * kRadiansPerDegree;  // IEC 60601-1, transport position
constexpr double kAngleTolerance = 1e-9;                   // [rad]

/// A wheel somewhere on a circle round `center`.
struct Support {
  Vector2 center;
  double radius;
};

Vector2 contact_of(const Caster& caster) {
  const Vector2 forward(std::cos(caster.heading), std::sin(caster.heading));
  return caster.mount.head<2>() - caster.trail * forward;
}

struct Margin {
  double base;
  double direction;
};

/// Smallest over directions of max_i(center_i . n - radius_i) - point . n. Between its kinks, where
/// two supports tie, each branch is a sinusoid; so the smallest value is at a kink or at the bottom
/// of a branch.
Margin smallest_margin(const std::vector<Support>& supports, const Vector2& point) {
  std::vector<double> candidates = {0};
  for (std::size_t i = 0; i < supports.size(); ++i) {
    const Vector2 away = point - supports[i].center;
    candidates.push_back(std::atan2(away.y(), away.x()));
    for (std::size_t j = 0; j < i; ++j) {
      const Vector2 d = supports[i].center - supports[j].center;
      const double cosine = (supports[i].radius - supports[j].radius) / d.norm();
      if (!(std::abs(cosine) <= 1)) continue;
      const double middle = std::atan2(d.y(), d.x()), half = std::acos(cosine);
      candidates.push_back(middle + half);
      candidates.push_back(middle - half);
    }
  }
  Margin smallest{std::numeric_limits<double>::infinity(), 0};
  for (const double angle : candidates) {
    const Vector2 n(std::cos(angle), std::sin(angle));
    double reach = -std::numeric_limits<double>::infinity();
    for (const Support& support : supports)
      reach = std::max(reach, support.center.dot(n) - support.radius);
    const double base = reach - point.dot(n);
    if (base < smallest.base) smallest = {base, std::remainder(angle, 2 * std::numbers::pi)};
  }
  return smallest;
}

/// N_i = k_i s_i with the sink s_i = a + b x_i + c y_i of a rigid base; wheels that would pull are
/// left out, worst first. Fewer than three wheels share by the least-norm sink.
std::vector<double> wheel_loads_of(const EquipmentModel& item, const MassProperties& whole) {
  const double weight = whole.mass * kStandardGravity;
  std::vector<bool> carries(item.casters.size(), true);
  while (true) {
    Matrix3 stiffness = Matrix3::Zero();
    for (std::size_t i = 0; i < item.casters.size(); ++i) {
      const Vector3 at(1, contact_of(item.casters[i]).x(), contact_of(item.casters[i]).y());
      if (carries[i]) stiffness += item.casters[i].tread.normal_stiffness * at * at.transpose();
    }
    const Vector3 load = weight * Vector3(1, whole.center_of_mass.x(), whole.center_of_mass.y());
    const Vector3 sink = stiffness.completeOrthogonalDecomposition().solve(load);
    std::vector<double> loads(item.casters.size(), 0);
    std::size_t worst = loads.size();
    for (std::size_t i = 0; i < loads.size(); ++i) {
      if (!carries[i]) continue;
      const Vector2 at = contact_of(item.casters[i]);
      loads[i] = item.casters[i].tread.normal_stiffness * sink.dot(Vector3(1, at.x(), at.y()));
      if (loads[i] < 0 && (worst == loads.size() || loads[i] < loads[worst])) worst = i;
    }
    if (worst == loads.size()) return loads;
    carries[worst] = false;
  }
}

double tilt_of(double base, double height) { return std::atan2(base, height); }

}  // namespace

Stability stability_of(const EquipmentModel& item) {
  std::vector<Support> any_swivel, as_placed;
  for (const Caster& caster : item.casters) {
    const Support placed{contact_of(caster), 0};
    const bool turns = caster.swivels && caster.swivel_lock_torque == 0;
    any_swivel.push_back(turns ? Support{caster.mount.head<2>(), caster.trail} : placed);
    as_placed.push_back(placed);
  }
  const MassProperties whole = whole_item(item);
  const Vector2 center = whole.center_of_mass.head<2>();
  const Margin worst = smallest_margin(any_swivel, center);

  Stability result;
  result.base = worst.base;
  result.height = whole.center_of_mass.z();
  result.tilt = tilt_of(result.base, result.height);
  result.direction = worst.direction;
  result.tilt_as_placed = tilt_of(smallest_margin(as_placed, center).base, result.height);
  result.wheel_loads = wheel_loads_of(item, whole);
  const double direction = worst.direction / kRadiansPerDegree;
  if (!(result.base > 0))
    result.warnings.push_back(fmt::format(
        "{}: the centre of mass can leave the support of the wheels: with the casters turned the "
        "worst way it is {:.0f} mm outside, towards {:.0f} degrees; the item can fall by itself",
        item.name, -result.base * kMillimetersPerMeter, direction));
  else if (result.tilt < kTransportTilt - kAngleTolerance)
    result.warnings.push_back(fmt::format(
        "{}: with the casters turned the worst way a tilt of {:.1f} degrees towards {:.0f} degrees "
        "overturns it; IEC 60601-1 asks 10 degrees of mobile equipment in its transport position",
        item.name, result.tilt / kRadiansPerDegree, direction));
  return result;
}

}  // namespace gurney
