#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "engine/base/floor_motion.h"
#include "engine/scene/settings.h"
#include "engine/solver/stage_solver.h"

namespace gurney {

/// Advances a mechanism in time with the two-stage method of quadrature.h: second order, L-stable.
///
/// A step whose solve does not converge is halved, again and again down to `max_subdivisions`.
/// Events that change the equations (a drop weight reaching its floor) are located inside the step
/// and end it. While a body meets another one the steps are a fraction of the contact's duration.
class Stepper {
 public:
  Stepper(const Mechanism& mechanism, const FloorMotion& floor, const SimulationSettings& settings);

  /// What an accepted step did.
  struct Step {
    const State* from;
    const State* to;
    const StageSolver::Output* first;  ///< the first stage; its weight is 1 - gamma
    const StageSolver::Output* end;    ///< the second stage, at the end of the step; weight gamma
    Vector3 floor_acceleration;        ///< in that stage
    double duration;
  };
  using Observer = std::function<void(const Step&)>;

  /// Advances `state` to `time`, telling the observer every accepted step.
  /// @returns a cause when the run cannot go on.
  std::optional<std::string> advance(State& state, double time, const Observer& observer);

  /// The contacts of bodies from now on. A contact that persists (same body, nearly the same place)
  /// keeps what it remembers in `state`; the energy stored in contacts that end is lost.
  void set_contacts(const std::vector<BodyContact>& contacts, State& state);

  /// Loads change at the state's time: blocks let go, and the last acceleration predicts nothing.
  void change_loads(State& state);

  const EnergyAccount& account() const { return account_; }
  const Quality& quality() const { return quality_; }

 private:
  bool attempt(const State& from, double duration);
  void accept(State& state, double duration, const Observer& observer);
  std::optional<std::string> advance_smoothly(State& state, double time, int depth,
                                              const Observer& observer);
  std::optional<double> locate_landing(const State& from, double duration);
  double approach_speed(const BodyContact& contact, const State& state) const;
  double longest_step(const State& state, double remaining) const;

  const Mechanism& mechanism_;
  const FloorMotion& floor_;
  SimulationSettings settings_;
  StageSolver solver_;
  StageSolver::Output first_, second_;
  State between_;  // start of the second stage
  std::vector<BodyContact> contacts_;
  Vector3 floor_second_ = Vector3::Zero();
  Velocity acceleration_;
  bool acceleration_known_ = false;
  EnergyAccount account_;
  Quality quality_;
};

}  // namespace gurney
