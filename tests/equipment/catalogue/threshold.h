#pragma once

#include <algorithm>
#include <string>

#include "engine/base/units.h"
#include "engine/run/simulate.h"
#include "equipment/catalogue/catalogue.h"
#include "equipment/catalogue/load_item.h"
#include "tests/support/standing.h"

/// The threshold test of IEC 60601-1 (9.4.2.4.3, from memory) on the catalogue: docs/equipment.md.
namespace gurney::equipment::threshold {

/// An obstruction across the way and the speed at which the item meets it.
struct Threshold {
  double height;  ///< [m]
  double speed;   ///< [m/s]
};
inline constexpr Threshold kLow{0.010, 0.8};   ///< amendment 1
inline constexpr Threshold kHigh{0.020, 0.4};  ///< third edition

inline constexpr double kWidth = 0.08;  ///< of the obstruction along the way [m]
inline constexpr double kGap = 0.05;    ///< before the first wheel at the start [m]

/// An item that rolls forward against the obstruction, all brakes and locks released, casters
/// trailing, and is pushed meanwhile.
struct Trial {
  Scene scene = scene_of({});
  double end = 0;   ///< of the obstruction along x [m]
  double push = 0;  ///< the most that the push gives [N]
};

inline Trial trial(const std::string& name, const Threshold& threshold, bool pushed) {
  const ItemDescription item = load_item_description(find_data(DataKind::kItem, name, "")).stated();
  ItemOptions released;
  released.brakes.assign(item.casters.size(), false);
  released.swivel_locks.assign(item.casters.size(), false);
  Trial trial;
  trial.scene = standing(assemble_item(item, released));
  const EquipmentModel& model = trial.scene.items[0].model;
  double front = -1e9, rear = 1e9, back = 1e9, top = 0;
  for (const Caster& caster : model.casters) {
    const double center = caster.mount.x() - caster.trail * std::cos(caster.heading);
    front = std::max(front, center + caster.wheel_radius);
    rear = std::min(rear, center - caster.wheel_radius);
  }
  for (const BodyShape& box : model.shape) {
    back = std::min(back, box.center.x() - box.size.x() / 2);
    top = std::max(top, box.center.z() + box.size.z() / 2);
  }
  const double start = front + kGap;
  trial.end = start + kWidth;
  trial.scene.room = {{"threshold",
                       "",
                       {start + kWidth / 2, 0, threshold.height / 2},
                       Quaternion::Identity(),
                       RoomBox{{kWidth, 4, threshold.height}}}};
  trial.scene.items[0].initial.velocity = {threshold.speed, 0, 0};
  trial.push = std::min(0.25 * whole_item(model).mass * kStandardGravity, 220.0);
  const double until = (trial.end - rear) / threshold.speed + 1;
  if (pushed)
    trial.scene.items[0].loads = {PointForce{"push",
                                             {back, 0, std::min(top, 1.0)},
                                             Vector3::UnitX(),
                                             {0, until},
                                             {trial.push, trial.push},
                                             threshold.speed}};
  return trial;
}

enum class Verdict { kPasses, kStops, kFalls };

/// Passes: every wheel is beyond the obstruction and on the floor at the end.
inline Verdict verdict(const Trial& trial, const Response& response) {
  if (response.outcome == Outcome::kOverturned) return Verdict::kFalls;
  const Sample& last = response.items[0].history.back();
  const auto& casters = trial.scene.items[0].model.casters;
  for (std::size_t i = 0; i < casters.size(); ++i) {
    const double turned = last.wheels[i].swivel_angle;
    const Vector3 center =
        casters[i].mount + casters[i].trail * Vector3(-std::cos(turned), -std::sin(turned), 0);
    const double x = (last.displacement + last.orientation * center).x();
    if (x - casters[i].wheel_radius < trial.end || last.wheels[i].mode == WheelMode::kLifted)
      return Verdict::kStops;
  }
  return Verdict::kPasses;
}

}  // namespace gurney::equipment::threshold
