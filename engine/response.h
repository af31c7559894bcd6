#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "engine/base/vector.h"
#include "engine/demands.h"
#include "engine/events.h"
#include "engine/scene/equipment_model.h"

namespace gurney {

/// How a run ended. kUntrusted: it went on to its end, but its energy balance misses by more than
/// EnergyBalance::kTrusted.
enum class Outcome { kRested, kStillMoving, kStopped, kOverturned, kDiverged, kUntrusted };
const char* name_of(Outcome outcome);
/// Whether a run with this outcome has no demands: kDiverged and kUntrusted.
bool is_failure(Outcome outcome);
/// The same of an outcome by its name.
bool is_failure(std::string_view outcome);

/// What a wheel does.
enum class WheelMode { kSticks, kRolls, kSkids, kBraked, kLifted };
const char* name_of(WheelMode mode);

/// The energy account since the start [J]. In the floor's frame the floor's inertia does work and
/// gravity is constant. Every entry is computed from its own force and velocity; `closure()` is
/// what they miss.
struct EnergyAccount {
  double kinetic = 0;
  double gravitational = 0;  ///< relative to the start
  double elastic = 0;        ///< stored in treads, stuck bearings, guides, blocks, cables
  double weight_energy = 0;  ///< kinetic and gravitational energy of drop weights and pulleys

  double work_of_floor =
      0;  ///< of the floor's inertia forces and of gravity that its rotation tilts
  double work_of_forces = 0;    ///< of point forces and string potentiometers
  double work_of_fixtures = 0;  ///< of guides with prescribed motion and guides that hold
  /// Of contacts between items, at the later item's side: what it gives, the earlier one takes.
  double work_of_neighbours = 0;
  double rolling_loss = 0;     ///< rolling resistance, W_R
  double sliding_loss = 0;     ///< sliding and scrub of the patch
  double relaxation_loss = 0;  ///< deflection that rolls out of the patch
  double tread_loss = 0;       ///< damping of the treads, normal and tangential
  double axle_loss = 0;        ///< axle bearings and brakes
  double swivel_loss = 0;      ///< swivel bearings and locks
  double damper_loss = 0;      ///< dampers of guides, blocks and cables; weights that land
  double contact_loss = 0;     ///< bodies in contact with other things than wheels with the floor
  double numerical_loss = 0;   ///< dissipated by the integrator, from its own formula

  double stored() const { return kinetic + gravitational + elastic + weight_energy; }
  double work() const {
    return work_of_floor + work_of_forces + work_of_fixtures + work_of_neighbours;
  }
  double loss() const;
  /// stored now - stored at the start - work + loss: zero for a perfect account [J].
  double closure(double stored_at_start) const {
    return stored() - stored_at_start - work() + loss();
  }
};

/// One wheel at one time.
struct WheelSample {
  double swivel_angle = 0;  ///< heading relative to the item, not wrapped [rad]
  double swivel_rate = 0;   ///< [rad/s]
  double wheel_rate = 0;    ///< about the axle, relative to the fork; rolling forward > 0 [rad/s]
  double normal_force = 0;  ///< N >= 0, vertical [N]
  double longitudinal_force = 0;  ///< of the floor on the wheel, along its rolling direction [N]
  double lateral_force = 0;       ///< along the axle, to the left [N]
  double scrub_torque = 0;        ///< about the vertical [N m]
  double rolling_resistance = 0;  ///< signed torque over R [N]
  WheelMode mode = WheelMode::kSticks;
};

/// A marked point at one time.
struct PointSample {
  Vector3 displacement = Vector3::Zero();           ///< relative to the floor since the start [m]
  Vector3 velocity = Vector3::Zero();               ///< relative to the floor [m/s]
  Vector3 absolute_acceleration = Vector3::Zero();  ///< without gravity [m/s2]
};

/// The item at one time. `displacement` and `velocity` are those of the item's origin (on the floor
/// below its middle), relative to the floor.
struct Sample {
  double time = 0;
  Vector3 displacement = Vector3::Zero();
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
};

/// What the numbers of a run are worth.
struct Quality {
  double energy_closure =
      0;  ///< largest |closure| over the largest energy in play (stored, work or loss) [-]
  double numerical_loss = 0;    ///< numerical_loss over the same energy [-]
  double largest_residual = 0;  ///< worst accepted momentum residual, as a fraction of M g dt
  long steps = 0;
  long subdivided_steps = 0;   ///< steps that had to be cut because their solve did not converge
  long unconverged_steps = 0;  ///< accepted with a residual above the setting
  long event_steps = 0;        ///< extra steps that end at a located event or resolve an impact
  long newton_iterations = 0;
  long collision_passes = 0;  ///< of Bullet
};

/// What one item did.
struct ItemResponse {
  Demands demands;
  EnergyAccount energy;  ///< at the end
  double stored_energy_at_start = 0;
  std::vector<Sample> history;  ///< every `history_step`, the start and the end included
};

struct Response {
  Outcome outcome = Outcome::kDiverged;  ///< of the run: kOverturned when any item did
  std::string cause;                     ///< of a failed run; otherwise empty
  double end_time = 0;                   ///< [s]
  Quality quality;                       ///< of the whole scene
  std::vector<ItemResponse> items;       ///< as Scene::items
  std::vector<Impact> impacts;           ///< by time
  std::vector<ZoneOutcome> zones;        ///< as Scene::zones
  std::vector<TetherOutcome> tethers;    ///< as Scene::tethers
};

}  // namespace gurney
