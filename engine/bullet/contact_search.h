#pragma once

#include <vector>

#include "engine/bullet/wheel_search.h"
#include "engine/scene/scene.h"
#include "engine/solver/assembly.h"
#include "engine/solver/chassis_points.h"
#include "engine/solver/floor_points.h"
#include "engine/solver/wheel_clearance.h"

namespace gurney {

/// Finds the contacts of items with the floor, the room and each other; a wheel's tread on the floor
/// is no contact but part of its item.
///
/// Contacts with the flat floor (FloorPoints) and those of a chassis with the room and other items
/// (ChassisPoints) are analytic. Only wheels before the room or other items are left to Bullet
/// (WheelSearch), which is asked while one of them may be near (WheelClearance). Pairs that bounds
/// on their motion keep apart (Clearance) are left out; results are the same bits either way.
class ContactSearch {
 public:
  /// @param skip_clear_passes  false: everything is searched at every step
  ContactSearch(const Scene& scene, const Assembly& assembly, bool skip_clear_passes);

  /// When to search again at the latest: nothing may travel past the margin between two searches,
  /// or it would be found inside another body.
  /// @returns in (time, until]
  double next(const SceneState& state, double time, double until) const;

  /// The contacts that may push within the step that begins at `state`; valid until the next call.
  /// @param step  until the next search, >= 0 [s]
  /// @param riders  bodies that move together touch each other nowhere; none: none does
  const std::vector<BodyContact>& find(const SceneState& state, double step,
                                       const Riders* riders = nullptr);

  /// How often Bullet was asked.
  long collision_passes() const { return collision_passes_; }

 private:
  const Assembly& assembly_;
  Travels travels_;
  std::vector<FloorPoints> floor_points_;  // as Scene::items
  ChassisPoints chassis_points_;
  WheelClearance wheel_clearance_;
  WheelSearch wheels_;
  bool skip_clear_passes_, alone_;
  std::vector<BodyContact> contacts_;
  long collision_passes_ = 0;
};

}  // namespace gurney
