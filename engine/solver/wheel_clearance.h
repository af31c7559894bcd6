#pragma once

#include <vector>

#include "engine/contact/body_form.h"
#include "engine/solver/travel.h"

namespace gurney {

/// Whether a wheel may be near a shape of the room or another item: only then Bullet searches.
class WheelClearance {
 public:
  WheelClearance(const Scene& scene, const Assembly& assembly);

  /// @returns false when none is nearer than `range` [m]
  bool any_near(const SceneState& state, const Travels& travels, double range);

 private:
  struct Ball {
    Vector3 center;
    double radius;
  };
  /// A wheel is inside a ball about its centre.
  std::vector<Ball> balls(std::size_t item, const State& state) const;
  double gap_to_room(const std::vector<Ball>& balls) const;
  double gap_to_shapes(const std::vector<Ball>& balls, std::size_t other, const State& at) const;
  double gap_between(std::size_t a, std::size_t b, const SceneState& state) const;

  const Assembly& assembly_;
  std::vector<std::vector<BodyForm>> shapes_;  // chassis axes, of each item
  std::vector<BodyForm> room_;
  std::vector<Clearance> from_room_;  // of each item
  std::vector<Clearance> between_;    // of each pair of items
};

}  // namespace gurney
