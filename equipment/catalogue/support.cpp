#include "equipment/catalogue/support.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "engine/base/linear_algebra.h"
#include "engine/base/units.h"

namespace gurney::equipment {
namespace {

constexpr double kUpright = 1e-9;  // sine of the tilt of a cylinder

double reach(const std::vector<Support>& supports, const Vector2& n) {
  double largest = -std::numeric_limits<double>::infinity();
  for (const Support& support : supports)
    largest = std::max(largest, support.center.dot(n) - support.radius);
  return largest;
}

Vector2 unit(double angle) { return {std::cos(angle), std::sin(angle)}; }

/// Directions in which two supports reach equally far.
std::vector<double> ties(const std::vector<Support>& supports) {
  std::vector<double> angles;
  for (std::size_t i = 0; i < supports.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      const Vector2 d = supports[i].center - supports[j].center;
      const double cosine = (supports[i].radius - supports[j].radius) / d.norm();
      if (!(std::abs(cosine) <= 1)) continue;
      const double middle = std::atan2(d.y(), d.x()), half = std::acos(cosine);
      angles.push_back(middle + half);
      angles.push_back(middle - half);
    }
  return angles;
}

/// Points of a shape that may be its lowest: of what rolls, those it rolls on.
std::vector<Vector3> low_points(const BodyShape& shape) {
  const auto* cylinder = std::get_if<SolidCylinder>(&shape.solid);
  if (const auto* sphere = std::get_if<SolidSphere>(&shape.solid))
    return {shape.center - sphere->radius * Vector3::UnitZ()};
  if (cylinder == nullptr || cylinder->axis.head<2>().norm() < kUpright)
    return outline_points(shape);
  const Vector3 up = Vector3::UnitZ() - cylinder->axis.z() * cylinder->axis;
  const Vector3 side = shape.center - cylinder->radius * up.normalized();
  const Vector3 end = 0.5 * cylinder->length * cylinder->axis;
  return {side - end, side + end};
}

std::vector<Support> points_on_floor(const std::vector<BodyShape>& shape) {
  constexpr double kLevel = 1e-6;  // [m] sizes are stated in mm
  double lowest = std::numeric_limits<double>::infinity();
  for (const BodyShape& each : shape) lowest = std::min(lowest, each.bottom());
  std::vector<Support> corners;
  for (const BodyShape& each : shape) {
    if (!(each.bottom() <= lowest + kLevel)) continue;
    if (each.is_box()) {
      for (const double x : {-0.5, 0.5})
        for (const double y : {-0.5, 0.5})
          corners.push_back(
              {each.center.head<2>() + Vector2(x * each.size.x(), y * each.size.y()), 0});
      continue;
    }
    for (const Vector3& point : low_points(each))
      if (point.z() <= lowest + kLevel) corners.push_back({point.head<2>(), 0});
  }
  return corners;
}

}  // namespace

std::vector<Support> supports_of(const EquipmentModel& item, Swivels swivels) {
  if (item.casters.empty()) return points_on_floor(item.shape);
  std::vector<Support> supports;
  for (const Caster& caster : item.casters) {
    const bool turns = caster.swivels && caster.swivel_lock_torque == 0;
    if (turns && swivels == Swivels::kAnywhere)
      supports.push_back({caster.mount.head<2>(), caster.trail});
    else
      supports.push_back({caster.mount.head<2>() - caster.trail * unit(caster.heading), 0});
  }
  return supports;
}

Margin smallest_margin(const std::vector<Support>& supports, const Vector2& point) {
  std::vector<double> candidates = ties(supports);
  candidates.push_back(0);
  for (const Support& support : supports) {  // the bottom of its sinusoid
    const Vector2 away = point - support.center;
    candidates.push_back(std::atan2(away.y(), away.x()));
  }
  Margin smallest{std::numeric_limits<double>::infinity(), 0};
  for (const double angle : candidates) {
    const Vector2 n = unit(angle);
    const double distance = reach(supports, n) - point.dot(n);
    if (distance < smallest.distance)
      smallest = {distance, std::remainder(angle, 2 * std::numbers::pi)};
  }
  return smallest;
}

// With m at the angle phi from the direction and u = tan phi, margin / cos phi is the largest of
// A_i + B_i u - r_i sqrt(1 + u^2), each concave in u: it is smallest where two of them tie. Fewer
// than three wheels may have no such tie; then the direction itself shows where their ends are.
double reach_towards(const std::vector<Support>& supports, const Vector2& point, double direction) {
  constexpr double kSideways = 1e-9;  // edges along the direction never stop the point
  std::vector<double> candidates = ties(supports);
  candidates.push_back(direction);
  double smallest = std::numeric_limits<double>::infinity();
  for (const double angle : candidates) {
    const Vector2 m = unit(angle);
    const double cosine = m.dot(unit(direction));
    if (cosine > kSideways)
      smallest = std::min(smallest, (reach(supports, m) - point.dot(m)) / cosine);
  }
  return smallest;
}

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

/// A height in metres under a key that ends in _mm: the mass is at the floor, or at the underside of the base plate
/// from which the file measures. Empty: it is not.
std::string low_center(const EquipmentModel& item) {
  constexpr double kLow = 0.01;     // of the height; a plate of twice this would have all the mass
  constexpr double kMeters = 2e-3;  // 2 m under a key in mm [m]
  double height = 0;
  for (const BodyShape& shape : item.shape) height = std::max(height, shape.top());
  const double center = item.chassis_center_of_mass.z();
  const double above = item.casters.empty() ? 0 : center - item.casters.front().mount.z();
  if (above > 0 && above < kMeters)
    return fmt::format(
        "{}: the centre of mass of the chassis is {:.3g} mm above the underside of its base plate; "
        "center_of_mass_mm is in mm",
        item.name, above * kMillimetersPerMeter);
  if (center >= kLow * height) return {};
  return fmt::format(
      "{}: the centre of mass of the chassis is {:.3g} mm above the floor, under {:g} % of the "
      "height of {:.4g} mm; center_of_mass_mm is in mm",
      item.name, center * kMillimetersPerMeter, 100 * kLow, height * kMillimetersPerMeter);
}

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
  if (const std::string low = low_center(item); !low.empty()) result.warnings.push_back(low);
  return result;
}

}  // namespace gurney::equipment
