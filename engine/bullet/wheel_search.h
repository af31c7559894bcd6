#pragma once

#include <memory>
#include <vector>

#include "engine/scene/scene.h"
#include "engine/solver/assembly.h"

namespace gurney {

/// Finds the contacts of wheels with the room and with other items, by Bullet's broad and narrow
/// phase: kerbs, thresholds, columns, other wheels and chassis.
///
/// Wheels are cylinders, chassis compounds of boxes, cylinders, spheres and hulls, shapes of the room
/// convex hulls or cylinders.
/// Bullet's normal of a wheel before a polyhedron is where WheelObstacle starts from; that of other
/// pairs is the contact's. Bullet's world is built when it is first asked: most runs need none.
class WheelSearch {
 public:
  /// Contacts are found from this far, Bullet's gContactBreakingThreshold [m].
  static constexpr double kMargin = 0.02;

  /// Both must outlive it.
  WheelSearch(const Scene& scene, const Assembly& assembly);
  ~WheelSearch();

  /// Appends the contacts of `state`.
  /// @param step  that they are for [s]
  void collect(const SceneState& state, double step, std::vector<BodyContact>& contacts);

 private:
  class World;
  const Scene& scene_;
  const Assembly& assembly_;
  std::unique_ptr<World> world_;
};

}  // namespace gurney
