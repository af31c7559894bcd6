#include "engine/run/rest.h"

#include "engine/run/start.h"
#include "engine/solver/equilibrium.h"

namespace gurney {

SceneState start_of(const Scene& scene, const Assembly& assembly) {
  SceneState state;
  for (std::size_t i = 0; i < scene.items.size(); ++i)
    state.items.push_back(assembly.items[i].placed(scene.items[i].initial));
  for (const JointLaw& joint : assembly.joints) state.joints.push_back(joint.initial_state());
  for (std::size_t i = 0; i < scene.items.size(); ++i) {
    if (!assembly.is_part(i)) settle(assembly, scene, i, state);
    assembly.items[i].set_in_motion(scene.items[i].initial, state.items[i]);
    if (!assembly.is_part(i)) continue;
    // As the whole item moves: InitialMotion states the velocity of its chassis.
    Vector6& v = state.items[i].velocity.chassis;
    const Vector3 turn = v.tail<3>();
    v.head<3>() += turn.cross(state.items[i].position - state.items[assembly.roots[i]].position);
  }
  return state;
}

std::vector<RestingBody> at_rest(const Scene& scene) {
  const Assembly assembly(scene);
  const SceneState state = start_of(scene, assembly);
  std::vector<RestingBody> bodies;
  for (std::size_t i = 0; i < state.items.size(); ++i) {
    const State& body = state.items[i];
    const Vector3& center = assembly.items[i].chassis.center_of_mass;
    bodies.push_back({body.position - body.rotation * center, body.rotation});
    if (joint_of(scene, i))
      bodies[i].coordinate = assembly.joint_motion(*joint_of(scene, i), state);
  }
  return bodies;
}

}  // namespace gurney
