#pragma once

#include <array>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "engine/response/response.h"
#include "engine/scene/scene.h"
#include "engine/solver/stepper.h"

namespace gurney {

/// Turns the contact forces of accepted steps into one event for each impact.
///
/// An impact of a pair (the chassis or a wheel, with the floor, a room shape or another item)
/// begins when a point of the pair that was apart touches with an approach speed above
/// `kSlowestImpact`. Points that touch while it lasts belong to it, so a face that lands corner by
/// corner is one impact. It ends when no point of the pair carries force, or when the force has
/// become quasi-static: every touching point slower than half that speed for `kQuietTime`; its end
/// is then where that began. Bodies that rest, slide or roll on each other make no event.
class ImpactLog {
 public:
  static constexpr double kSlowestImpact = 0.05;  ///< [m/s]: a fall of 0.13 mm
  static constexpr double kQuietTime = 0.02;      ///< [s]

  ImpactLog(const Scene& scene, const Assembly& assembly);

  void observe(const Stepper::Step& step);

  /// Kinds of impact an item is in after the last step.
  struct Kinds {
    bool restitution = false, compliant = false;
  };
  Kinds impacts_of(std::size_t item) const;

  /// Impacts by their beginning; those that last are cut off at `time`.
  std::vector<Impact> finish(double time) const;

 private:
  struct Pair {
    bool touches = false;
    bool in_impact = false;
    double quiet_since = 0;
    std::size_t impact = 0;
  };
  /// Forces and times of the contacts of one pair in one step.
  struct PairStep {
    double first_force = 0, force = 0;  // of all points, in the two stages
    double fastest = 0;                 // of touching points
    double approach = 0;                // of points that came to touch
    double begins = std::numeric_limits<double>::infinity(), ends = 0;
    Vector3 point = Vector3::Zero();  // that touched first
    const BodyContact* contact = nullptr;
  };

  void begin(Pair& pair, const BodyContact& contact, const PairStep& now);

  using Key = std::array<int, 5>;  // item, caster, other, other item, its caster
  static Key key_of(const BodyContact& contact);
  bool in_island(const Key& key, const Island& island) const;
  /// Memory of a pair that touches, made when first asked for.
  Pair& pair_of(const Key& key);
  /// Entry of a pair in this step, made when first asked for.
  PairStep& step_of(const Key& key);

  const Assembly& assembly_;
  std::vector<std::vector<std::string>> wheels_;  // of each item
  std::vector<std::string> others_, items_;
  std::vector<std::pair<Key, Pair>> pairs_;      // that touch, by their keys
  std::vector<std::pair<Key, PairStep>> steps_;  // of the step that is observed
  std::vector<Impact> impacts_;
};

}  // namespace gurney
