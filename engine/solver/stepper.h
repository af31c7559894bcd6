#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "engine/base/floor_motion.h"
#include "engine/response/quality.h"
#include "engine/scene/settings.h"
#include "engine/solver/contact_memory.h"
#include "engine/solver/slip_reversal.h"
#include "engine/solver/stage_solver.h"
#include "engine/solver/step_control.h"
#include "engine/solver/tread_crossing.h"

namespace gurney {

/// Advances the items of a scene in time with the two-stage method of quadrature.h: second order,
/// L-stable. Items that may touch take their steps together, all others apart.
///
/// Given a tolerance it takes several steps of its own choice where one would be too inaccurate
/// (StepControl); a rejected one changes nothing but the choice of the next.
/// A step whose solve does not converge is halved, again and again down to `max_subdivisions`.
/// Events that change the equations (a drop weight reaching its floor, a latch that lets go) are
/// located inside the step and end it; at those that bend a force (slip that reverses, a wheel that
/// leaves the floor or lands) a step ends where they are foreseen. While a body meets another one
/// the steps are a fraction of the contact's duration.
class Stepper {
 public:
  Stepper(const Assembly& assembly, const FloorMotion& floor, const SimulationSettings& settings);

  /// Effect of an accepted step on the items and contacts of one island.
  struct Step {
    const Island* island;
    double time, duration;  ///< at its start
    const SceneState* from;
    const SceneState* to;
    const StageSolver::Output* first;  ///< the first stage; its weight is 1 - gamma
    const StageSolver::Output* end;    ///< the second stage, at the end of the step; weight gamma
    FloorStage floor;                  ///< in that stage
  };
  using Observer = std::function<void(const Step&)>;

  /// Advances `state` to `time`, showing the observer every accepted step.
  /// @returns a cause when the run cannot go on.
  std::optional<std::string> advance(SceneState& state, double time, const Observer& observer);

  /// The contacts of bodies from now on. A contact that persists (same pair of bodies, the nearest
  /// place) keeps what it remembers in `state`; the energy stored in contacts that end is lost.
  ///
  /// No contact is made deeper by being found: where a new place, or a normal that has turned,
  /// would overlap by more than the contact was compressed, the rest is its slack and pushes
  /// nothing. Otherwise the search for contacts would do work on the item.
  void set_contacts(const std::vector<BodyContact>& contacts, SceneState& state);

  /// Loads change at the state's time: blocks let go, and the last acceleration predicts nothing.
  void change_loads(SceneState& state);

  /// Lets bodies that are held firmly ride on what carries them, before the next search for contacts.
  void board(SceneState& state) { riders_.board(state, accounts_); }
  const Riders& riders() const { return riders_; }

  /// Accounts in the order of Scene::items.
  const std::vector<EnergyAccount>& accounts() const { return accounts_; }
  const Quality& quality() const { return quality_; }

 private:
  bool attempt(const Island& island, const SceneState& from, double duration);
  void extrapolate(const Island& island, const SceneState& from, double duration);
  void accept(const Island& island, SceneState& state, double duration, const Observer& observer);
  std::optional<std::string> advance_island(const Island& island, SceneState& state, double time,
                                            const Observer& observer);
  /// One step and what events make of it; none where the step is rejected.
  std::optional<std::string> advance_smoothly(const Island& island, SceneState& state, double time,
                                              int depth, const Observer& observer);
  /// Distance of the state beyond the first event that changes the equations; > 0: that lies inside the
  /// step [m].
  double past_event(const Island& island, const SceneState& state) const;
  std::optional<double> locate_event(const Island& island, const SceneState& from, double duration);
  /// Frees the bodies that are not held firmly enough for what the last attempt asks of them.
  /// @returns whether there were any: the step is to be attempted again
  bool free_riders(const Island& island, SceneState& state);
  double approach_speed(const BodyContact& contact, const SceneState& state) const;
  /// Effective mass of the chassis alone for a normal impulse at the contact, and of what rides that of its carrier:
  /// less than all of it [kg].
  double effective_mass(const BodyContact& contact, const SceneState& state) const;
  double predicted_acceleration(const BodyContact& contact, const SceneState& state) const;
  /// How fast each contact of the island closes, and how fast those apart come near.
  void observe_approach(const Island& island, SceneState& state);
  double longest_step(const Island& island, const SceneState& state, double remaining);
  double longest_step_at_stops(const Island& island, const SceneState& state,
                               double remaining) const;

  /// Time at which the next step ends: `latest`, or earlier where slip reverses or a wheel
  /// crosses the floor.
  double end_of_step(const Island& island, const SceneState& state, double latest);

  const Assembly& assembly_;
  const FloorMotion& floor_;
  SimulationSettings settings_;
  StageSolver solver_;
  StageSolver::Input input_;
  StageSolver::Output first_, second_;
  SceneState between_;  // start of the second stage
  Islands islands_;
  ContactMemory memory_;
  std::vector<BodyContact> contacts_;  // sorted by island
  std::vector<BodyContactState> returned_;
  std::vector<double> rates_;        // of the gaps of the island's contacts [m/s]
  std::vector<double> contacts_of_;  // number of each item's
  FloorStage floor_second_;
  Riders riders_;
  std::vector<SlipReversals::Course> predictions_;
  SlipReversals reversals_;
  TreadCrossings crossings_;
  StepControl control_;
  std::vector<EnergyAccount> accounts_;
  Quality quality_;
};

}  // namespace gurney
