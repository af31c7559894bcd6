#pragma once

#include <vector>

#include "engine/response/response.h"
#include "engine/scene/scene.h"
#include "engine/solver/assembly.h"

namespace gurney {

/// Items that stand on other items or on shapes of the room: how far each slides there and when it falls,
/// from its centre of mass in the axes of what it stands on, at the ends of steps.
class SupportLog {
 public:
  SupportLog(const Scene& scene, const Assembly& assembly, const SceneState& at_start);

  void observe(double time, const SceneState& state);

  /// Demands::peak_slide and time_of_fall of the items that it knows.
  void finish(std::vector<ItemResponse>& items) const;

 private:
  struct Supported {
    std::size_t item;
    Support support;
    double height;  ///< of the centre of mass above the surface at the start [m]
    Vector3 start;  ///< of the centre of mass, axes of the support [m]
    double slide = 0, fell_at = -1;
  };

  static Vector3 place_of(const Supported& each, const SceneState& state);

  std::vector<Supported> supported_;
};

}  // namespace gurney
