#pragma once

#include <vector>

#include "engine/response/response.h"
#include "engine/scene/scene.h"
#include "engine/solver/assembly.h"

namespace gurney {

/// Items in each zone of the room, and the free width that they leave.
class ZoneLog {
 public:
  ZoneLog(const Scene& scene, const Assembly& assembly);

  /// Takes in the scene at `time`, the end of a step of `duration`.
  void observe(double time, double duration, const SceneState& state);
  const std::vector<ZoneOutcome>& outcomes() const { return outcomes_; }

 private:
  struct Span {
    double low, high;  // across the zone [m]
  };
  double free_width(const Zone& zone, std::vector<Span> taken) const;

  std::vector<Zone> zones_;
  std::vector<std::vector<std::vector<Vector3>>> outlines_;  // of the shapes of each item
  std::vector<ZoneOutcome> outcomes_;
};

}  // namespace gurney
