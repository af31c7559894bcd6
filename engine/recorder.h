#pragma once

#include <vector>

#include "engine/impact_log.h"
#include "engine/response.h"
#include "engine/scene/scene.h"
#include "engine/scene/settings.h"
#include "engine/solver/mechanism.h"
#include "engine/solver/stepper.h"

namespace gurney {

/// Turns the accepted steps of a run into demands, histories and the energy account.
class Recorder {
 public:
  Recorder(const Scene& scene, const Mechanism& mechanism, const State& start);

  /// Every accepted step.
  void observe(const Stepper::Step& step);

  /// Checks the energy account at `state` and, when `keep`, appends a sample to the history.
  void sample(const State& state, const EnergyAccount& account, bool keep);

  /// Fastest motion of any part of the item at the last step [m/s].
  double speed() const { return speed_; }
  /// The same without the joints of casters: what an item that lies on the floor rests by [m/s].
  double body_speed() const { return body_speed_; }
  double tilt() const { return current_.tilt; }
  Demands& demands() { return demands_; }

  void finish(const State& state, const EnergyAccount& account, Response& response) const;

 private:
  EnergyAccount complete(const State& state, const EnergyAccount& account) const;
  void observe_wheels(const Stepper::Step& step);
  void observe_lift(const Stepper::Step& step);
  void observe_points(const Stepper::Step& step, const Matrix3& rotation);

  const Mechanism& mechanism_;
  std::vector<Vector3> points_;  // marked points relative to the chassis' centre, chassis axes
  std::vector<Vector3> point_starts_;
  std::vector<double> trails_;
  struct Gap {
    double height = 0;  // of the tread above the floor [m]
    double rate = 0;    // [m/s]
    bool lifted = false;
  };
  std::vector<Gap> gaps_;
  Vector3 origin_;  // the item's origin relative to the chassis' centre, chassis axes
  Vector3 origin_start_;
  double yaw_start_, yaw_;
  double gravitational_start_, stored_start_;
  double largest_energy_ = 0, largest_closure_ = 0;
  double speed_ = 0, body_speed_ = 0;
  Sample current_;
  Demands demands_;
  std::vector<Sample> history_;
  ImpactLog impacts_;
};

}  // namespace gurney
