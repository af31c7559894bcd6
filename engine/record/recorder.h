#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/record/energy_balance.h"
#include "engine/record/impact_log.h"
#include "engine/record/run_clock.h"
#include "engine/response/response.h"
#include "engine/scene/scene.h"
#include "engine/scene/settings.h"
#include "engine/solver/assembly.h"
#include "engine/solver/mechanical_energy.h"
#include "engine/solver/stepper.h"

namespace gurney {

/// Turns the accepted steps of one item into demands, histories and the energy balance.
class Recorder {
 public:
  Recorder(const Scene& scene, const Assembly& assembly, std::size_t item, const SceneState& start);

  /// Every accepted step of the item's group.
  /// @param impacts  the item is in after the step
  void observe(const Stepper::Step& step, const ImpactLog::Kinds& impacts);

  /// Notes which way the item fell and which wheels were in the air, at the last step.
  void overturned();

  /// Checks the energy balance at `state` and, when `keep`, appends a sample to the history.
  void sample(const SceneState& state, const EnergyAccount& account, bool keep);

  /// Checks it for the verdict on the run, which must not depend on the history's spacing.
  void check(const SceneState& state, const EnergyAccount& account);
  /// [-]
  double energy_error() const { return checked_.error(); }
  std::string energy_error_source() const { return checked_.source(); }

  /// At the last step. A part turns on its joint without overturning.
  RunClock::ItemMotion motion() const {
    return {speed_, body_speed_, assembly_.is_part(item_) ? 0 : current_.tilt, on_item_};
  }

  /// Moves the item to `response`, whose impacts are there, and its energy errors to the quality.
  void finish(const SceneState& state, const EnergyAccount& account, double overturned_at,
              Response& response);

 private:
  /// Angle of the heading in the plan; 0 of a sphere [rad].
  double yaw_of(const Matrix3& rotation) const;
  /// Tilt of the item; of one cylinder that of its axis from where it was, of a sphere none [rad].
  double lean_of(const Matrix3& rotation) const;
  EnergyAccount complete(const SceneState& state, const EnergyAccount& account) const;
  void observe_wheels(const Stepper::Step& step);
  void observe_lift(const Stepper::Step& step);
  void observe_points(const Stepper::Step& step, const Matrix3& rotation,
                      const ImpactLog::Kinds& impacts);

  const Assembly& assembly_;
  std::size_t item_;
  const Mechanism& mechanism_;
  MechanicalEnergies energies_;
  std::vector<Vector3> points_;  // marked points relative to the chassis' centre, chassis axes
  std::vector<Vector3> point_starts_;
  std::vector<double> trails_;
  std::optional<Vector3> roller_;  // axis of a body that rolls, zero of a sphere; chassis axes
  Vector3 heading_;                // chassis axes; of a sphere zero
  struct Gap {
    double height = 0;  // of the tread above the floor [m]
    double rate = 0;    // [m/s]
    bool lifted = false;
    double since = 0;  // when it was lifted [s]
  };
  std::vector<Gap> gaps_;
  // The item's origin relative to the chassis' centre, chassis axes; of a part its centre.
  Vector3 origin_;
  Vector3 origin_start_;
  // tracked_: centre of mass of a part, item axes. settled_: place of that point, or of the origin of what
  // stands on a part, once settled, from where the origin was placed and less what the whole item settles.
  Vector3 tracked_ = Vector3::Zero(), settled_ = Vector3::Zero();
  double yaw_start_, yaw_;
  bool on_item_ = false;      // it stands on another
  std::vector<int> carries_;  // the others that stand on it
  bool has_overturned_ = false;
  double gravitational_start_, stored_start_;
  EnergyBalance sampled_, checked_;
  double speed_ = 0, body_speed_ = 0;
  Sample current_;
  Demands demands_;
  std::vector<Sample> history_;
};

}  // namespace gurney
