#pragma once

#include <variant>
#include <vector>

#include "engine/contact/column_points.h"
#include "engine/contact/convex_shape.h"
#include "engine/solver/assembly.h"

namespace gurney {

/// Where the boxes of the chassis may touch the shapes of the room and each other: analytic, like
/// the corners on the floor, and known before they touch.
///
/// Bullet reports one edge point of two boxes until they overlap by 0.1 mm, so a face that lands
/// flat would touch with one point and turn.
class ChassisPoints {
 public:
  ChassisPoints(const Scene& scene, const Assembly& assembly);

  /// Appends the contacts with a gap of at most `margin` [m].
  /// @param step  until this is asked again [s]
  void collect(const SceneState& state, double step, double margin,
               std::vector<BodyContact>& contacts) const;

 private:
  struct Obstacle {
    int other;                                  // BodyContact::other
    std::variant<ConvexShape, Cylinder> shape;  // floor axes
    Vector3 center;
    double reach;  // of any of its points from there [m]
  };
  struct PlacedBox {
    ConvexShape shape;  // floor axes
    Vector3 center, velocity;
    double reach;
  };
  std::vector<PlacedBox> placed(std::size_t item, const State& state) const;
  void against_room(std::size_t item, const State& state, const std::vector<PlacedBox>& boxes,
                    double step, double margin, std::vector<BodyContact>& contacts) const;
  void between(std::size_t a, const std::vector<PlacedBox>& boxes_a, std::size_t b,
               const std::vector<PlacedBox>& boxes_b, const SceneState& state, double step,
               double margin, std::vector<BodyContact>& contacts) const;

  std::vector<std::vector<ConvexShape>> boxes_;  // chassis axes, of each item
  std::vector<double> reach_;                    // of each chassis
  std::vector<Obstacle> obstacles_;
};

}  // namespace gurney
