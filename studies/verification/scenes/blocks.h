#pragma once

#include "engine/scene/scene.h"
#include "engine/scene/settings.h"

/// Items without casters and things to hit.
namespace gurney::blocks {

/// A uniform box standing on the floor: width (x), depth (y), height (z).
inline Scene block(double mass, const Vector3& size, const ContactConstants& floor) {
  Scene scene = scene_of({});
  scene.items[0].model.name = "block";
  scene.items[0].model.chassis_mass = mass;
  scene.items[0].model.chassis_center_of_mass = {0, 0, 0.5 * size.z()};
  scene.items[0].model.chassis_inertia = solid_box_inertia(mass, size);
  scene.items[0].model.shape = {{{0, 0, 0.5 * size.z()}, size}};
  scene.items[0].model.material = "steel";
  scene.items[0].model.marked_points = {{"center", {0, 0, 0.5 * size.z()}},
                                        {"ahead", {1, 0, 0.5 * size.z()}}};
  scene.floor_material = "concrete";
  scene.pairs = {{"steel", "concrete", floor}};
  return scene;
}

/// A wall whose face is the plane x = `face`, 3 m wide and high, met by the item along +x.
inline void add_wall(Scene& scene, double face, const ContactConstants& constants) {
  scene.room.push_back(
      {"wall", "plaster", {face + 0.1, 0, 1.5}, Quaternion::Identity(), RoomBox{{0.2, 3, 3}}});
  scene.pairs.push_back({scene.items[0].model.material, "plaster", constants});
}

inline SimulationSettings run_for(double duration, double time_step, double history_step) {
  SimulationSettings settings;
  settings.duration = duration;
  settings.time_step = time_step;
  settings.history_step = history_step;
  return settings;
}

}  // namespace gurney::blocks
