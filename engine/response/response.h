#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/base/vector.h"
#include "engine/response/demands.h"
#include "engine/response/energy_account.h"
#include "engine/response/events.h"
#include "engine/response/predictability.h"
#include "engine/response/quality.h"
#include "engine/scene/equipment_model.h"

namespace gurney {

/// How a run ended. kUntrusted: it went on to its end, but its energy balance misses by more than
/// EnergyBalance::kTrusted.
enum class Outcome { kRested, kStillMoving, kStopped, kOverturned, kDiverged, kUntrusted };
const char* name_of(Outcome outcome);
/// Whether a run with this outcome has no demands: kDiverged and kUntrusted.
bool is_failure(Outcome outcome);
/// Whether the outcome with this name is a failure.
bool is_failure(std::string_view outcome);

/// Motion of a wheel on its contact.
enum class WheelMode { kSticks, kRolls, kSkids, kBraked, kLifted };
const char* name_of(WheelMode mode);

/// One wheel at one time.
struct WheelSample {
  double swivel_angle = 0;  ///< heading relative to the item, not wrapped [rad]
  double swivel_rate = 0;   ///< [rad/s]
  double wheel_rate = 0;    ///< about the axle, relative to the fork; rolling forward > 0 [rad/s]
  double normal_force = 0;  ///< N >= 0, vertical [N]
  double longitudinal_force = 0;  ///< of the floor on the wheel, along its rolling direction [N]
  double lateral_force = 0;       ///< along the axle, to the left [N]
  double scrub_torque = 0;        ///< about the vertical [N m]
  double rolling_resistance_force = 0;  ///< signed torque over R [N]
  WheelMode mode = WheelMode::kSticks;
};

/// A marked point at one time.
struct PointSample {
  Vector3 displacement = Vector3::Zero();           ///< relative to the floor since the start [m]
  Vector3 velocity = Vector3::Zero();               ///< relative to the floor [m/s]
  Vector3 absolute_acceleration = Vector3::Zero();  ///< without gravity [m/s2]
};

/// The item at one time. `displacement` and `velocity` are those of the item's origin (on the floor
/// below its middle), of a part those of its centre of mass, relative to the floor.
struct Sample {
  double time = 0;
  Vector3 displacement = Vector3::Zero();
  /// Way from there to where the displacement of a part's origin, since it was placed, ends [m].
  Vector3 to_origin = Vector3::Zero();
  Vector3 velocity = Vector3::Zero();
  Vector3 acceleration = Vector3::Zero();  ///< relative to the floor [m/s2]
  double yaw = 0;                          ///< since the start, not wrapped [rad]
  double tilt = 0;  ///< angle between the item's z axis and the floor normal [rad]
  Quaternion orientation = Quaternion::Identity();  ///< item axes in floor axes
  double cable_tension = 0;                         ///< sum over drop weights [N]
  double pull_force = 0;                            ///< sum of point forces (signed magnitudes) [N]
  std::array<WheelSample, EquipmentModel::kMaxCasters> wheels{};
  std::vector<PointSample> points;  ///< one for each marked point
  EnergyAccount energy;

  /// Displacement of the item's origin from where it was placed; what the whole item settles left out.
  Vector3 origin_displacement() const { return displacement + to_origin; }
};

/// Response of one item.
struct ItemResponse {
  Demands demands;
  EnergyAccount energy;  ///< at the end
  double stored_energy_at_start = 0;
  /// The point whose displacement its histories have, in item axes: zero, of a part its centre of mass.
  Vector3 tracked = Vector3::Zero();
  std::vector<Sample> history;  ///< every `history_step`, the start and the end included
  std::optional<Predictability> predictability;  ///< of single runs whose twin was run
};

struct Response {
  Outcome outcome = Outcome::kDiverged;  ///< of the run: kOverturned when any item did
  std::string cause;    ///< why it failed, or ends where its item overturned; otherwise empty
  double end_time = 0;  ///< [s]
  Quality quality;      ///< of the whole scene
  std::vector<ItemResponse> items;     ///< as Scene::items
  std::vector<Impact> impacts;         ///< by time
  std::vector<ZoneOutcome> zones;      ///< as Scene::zones
  std::vector<TetherOutcome> tethers;  ///< as Scene::tethers
};

}  // namespace gurney
