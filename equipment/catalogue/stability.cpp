#include "equipment/catalogue/stability.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/base/linear_algebra.h"
#include "engine/base/units.h"
#include "equipment/catalogue/support.h"

namespace gurney::equipment {
namespace {

// IEC 60601-1: the transport position, and all others; what has no casters is not transported.
constexpr double kTransportTilt = 10 * kRadiansPerDegree, kOtherTilt = 5 * kRadiansPerDegree;
constexpr double kAngleTolerance = 1e-9;  // [rad]

/// N_i = k_i s_i with the sink s_i = a + b x_i + c y_i of a rigid base; wheels that would pull are
/// left out, worst first. Fewer than three wheels share by the least-norm sink.
std::vector<double> wheel_loads_of(const EquipmentModel& item, const MassProperties& whole) {
  const std::vector<Support> contacts = supports_of(item, Swivels::kAsPlaced);
  const double weight = whole.mass * kStandardGravity;
  std::vector<bool> carries(item.casters.size(), true);
  while (true) {
    Matrix3 stiffness = Matrix3::Zero();
    for (std::size_t i = 0; i < item.casters.size(); ++i) {
      const Vector3 at(1, contacts[i].center.x(), contacts[i].center.y());
      if (carries[i]) stiffness += item.casters[i].tread.normal_stiffness * at * at.transpose();
    }
    const Vector3 load = weight * Vector3(1, whole.center_of_mass.x(), whole.center_of_mass.y());
    const Vector3 sink = least_norm_solution(stiffness, load);
    std::vector<double> loads(item.casters.size(), 0);
    std::size_t worst = loads.size();
    for (std::size_t i = 0; i < loads.size(); ++i) {
      if (!carries[i]) continue;
      const Vector2 at = contacts[i].center;
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
  const MassProperties whole = whole_item(item);
  const Vector2 center = whole.center_of_mass.head<2>();
  const Margin worst = smallest_margin(supports_of(item, Swivels::kAnywhere), center);
  const Margin placed = smallest_margin(supports_of(item, Swivels::kAsPlaced), center);

  Stability result;
  result.base = worst.distance;
  result.height = whole.center_of_mass.z();
  result.tilt = tilt_of(result.base, result.height);
  result.direction = worst.direction;
  result.tilt_as_placed = tilt_of(placed.distance, result.height);
  result.wheel_loads = wheel_loads_of(item, whole);
  const double direction = worst.direction / kRadiansPerDegree;
  const bool rolls = !item.casters.empty();
  const double asked = rolls ? kTransportTilt : kOtherTilt;
  const char* const turned = rolls ? "with the casters turned the worst way " : "";
  if (!(result.base > 0))
    result.warnings.push_back(fmt::format(
        "{}: the centre of mass can leave the support{}: {}it is {:.0f} mm outside, towards {:.0f} "
        "degrees; the item is statically unstable",
        item.name, rolls ? " of the wheels" : "", turned, -result.base * kMillimetersPerMeter,
        direction));
  else if (result.tilt < asked - kAngleTolerance)
    result.warnings.push_back(fmt::format(
        "{}: {}a tilt of {:.1f} degrees towards {:.0f} degrees overturns it; IEC 60601-1 asks "
        "{:.0f} "
        "degrees of {}",
        item.name, turned, result.tilt / kRadiansPerDegree, direction, asked / kRadiansPerDegree,
        rolls ? "mobile equipment in its transport position" : "equipment that is not mobile"));
  return result;
}

}  // namespace gurney::equipment
