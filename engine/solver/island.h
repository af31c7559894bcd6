#pragma once

#include <span>
#include <vector>

#include "engine/solver/riders.h"

namespace gurney {

/// Items that may touch each other in a step, hang on each other or ride on each other: they are
/// solved together, all others apart.
struct Island {
  std::vector<std::size_t> items;                  ///< indices in Scene::items, increasing
  std::size_t first_contact = 0, end_contact = 0;  ///< theirs, in SceneState::contacts
  std::vector<std::size_t> joints = {};            ///< theirs, in Assembly::joints
};

/// The islands of a scene, by their first items.
class Islands {
 public:
  /// Finds the islands of a scene; sorts `contacts` by island.
  void update(std::vector<BodyContact>& contacts, const Assembly& assembly, const Riders& riders);
  /// Makes room for so many more contacts behind those of an island.
  void widen(const Island& island, std::size_t contacts);

  std::span<const Island> all() const { return {islands_.data(), count_}; }

 private:
  /// The first item of an item's island.
  std::size_t first_of(std::size_t item);

  std::vector<Island> islands_;  // more than count_ once there were more: they keep their memory
  std::size_t count_ = 0;
  std::vector<std::size_t> parent_, island_of_;  // of each item; parent: towards the first
};

}  // namespace gurney
