#pragma once

#include <variant>
#include <vector>

#include "engine/contact/column_points.h"
#include "engine/contact/convex_shape.h"
#include "engine/scene/scene.h"
#include "engine/solver/mechanism.h"

namespace gurney {

/// Where the boxes of a chassis may touch the shapes of the room: analytic, like the corners on the
/// floor, and known before they touch.
///
/// Bullet reports one edge point of two boxes until they overlap by 0.1 mm, so a face that lands
/// flat would touch with one point and turn.
class RoomPoints {
 public:
  RoomPoints(const Scene& scene, const Mechanism& mechanism);

  /// Appends the contacts with a gap of at most `margin` [m].
  /// @param step  until this is asked again [s]
  void collect(const State& state, double step, double margin,
               std::vector<BodyContact>& contacts) const;

 private:
  struct Obstacle {
    int other;                                // BodyContact::other
    std::variant<ConvexShape, Column> shape;  // floor axes
  };

  std::vector<ConvexShape> boxes_;  // chassis axes, relative to its centre
  std::vector<Obstacle> obstacles_;
};

}  // namespace gurney
