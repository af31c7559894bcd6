#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>

#include "engine/solver/chassis_points.h"
#include "engine/solver/floor_points.h"
#include "engine/solver/wheel_clearance.h"
#include "tests/engine/run/drawn_items.h"

/// What is left out because it cannot be near would not have been found: searches that remember how
/// far all was apart find what those find that look at everything.
namespace gurney::properties {
namespace {

constexpr double kWheelRange = 0.021;  // [m]

/// Three items among a wall, a leaning column and a ramp.
Scene crowded(drawn::Draw& d) {
  Scene scene = scene_of(drawn::item(d));
  for (int k = 1; k < 3; ++k) {
    scene.items.push_back(scene.items[0]);
    scene.items.back().model = drawn::item(d);
  }
  for (std::size_t k = 0; k < scene.items.size(); ++k) {
    scene.items[k].name = "item " + std::to_string(k);
    scene.items[k].initial.position = {1.1 * static_cast<double>(k), d.between(-0.5, 0.5), 0};
    scene.items[k].initial.yaw = d.between(-3, 3);
  }
  scene.room = {
      {"wall", "", {1, 1.2, 1}, rotated({0, 0, 0.3}, Quaternion::Identity()), RoomBox{{4, 0.2, 2}}},
      {"column",
       "",
       {-0.9, 0, 1},
       rotated({0.3, 0, 0}, Quaternion::Identity()),
       RoomColumn{0.2, 2}},
      {"ramp",
       "",
       {1, -1.4, 0},
       Quaternion::Identity(),
       RoomHull{{{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}, {0, -1, 0.5}}}}};
  return scene;
}

/// What of the items moves: each bound has to hold by itself.
struct Moving {
  bool centers, turns, swivels;
};

/// Anything from a creep to a jump, as of steps of a run.
void move(drawn::Draw& d, const Moving& moving, State& state) {
  const double size = d.log_between(1e-5, 0.1);
  const auto any = [&] { return Vector3(d.between(-1, 1), d.between(-1, 1), d.between(-1, 1)); };
  if (moving.centers) state.position += size * any();
  if (moving.turns) state.rotation = rotated(size * any(), state.rotation);
  if (!moving.swivels) return;
  for (CasterState& caster : state.casters) caster.swivel_angle += 10 * size * d.between(-1, 1);
}

bool same(const BodyContact& a, const BodyContact& b) {
  return a.side.item == b.side.item && a.other == b.other && a.side.caster == b.side.caster &&
         a.side.local == b.side.local && a.normal == b.normal && a.offset == b.offset &&
         a.other_side.item == b.other_side.item && a.other_side.local == b.other_side.local;
}

/// Everything that is searched for contacts with the floor, the room and other items.
struct Searches {
  Searches(const Scene& scene, const Assembly& assembly)
      : chassis(scene, assembly), wheels(scene, assembly) {
    for (std::size_t i = 0; i < scene.items.size(); ++i)
      floor.emplace_back(scene.items[i].model, assembly.items[i], i);
  }
  std::vector<BodyContact> contacts(const SceneState& state, const Travels& travels,
                                    double margin) {
    std::vector<BodyContact> found;
    for (std::size_t i = 0; i < floor.size(); ++i)
      floor[i].collect(state.items[i], travels.of(i), margin, found);
    chassis.collect(state, travels, 0.004, margin, found);
    return found;
  }
  ChassisPoints chassis;
  std::vector<FloorPoints> floor;
  WheelClearance wheels;
};

RC_GTEST_PROP(Clearance, LeavesOutNothingThatWouldBeFound, ()) {
  drawn::Draw d(*rc::gen::arbitrary<unsigned>());
  const Scene scene = crowded(d);
  const Assembly assembly(scene);
  SceneState state;
  for (std::size_t i = 0; i < scene.items.size(); ++i)
    state.items.push_back(assembly.items[i].placed(scene.items[i].initial));
  Travels travels(assembly, true), unknown(assembly, false);
  Searches remembering(scene, assembly);
  const Moving moving{d.happens(0.5), d.happens(0.5), d.happens(0.5)};
  for (int step = 0; step < 300; ++step) {
    for (State& item : state.items) move(d, moving, item);
    const double margin = 0.02 + d.log_between(1e-3, 0.1);
    travels.observe(state);
    Searches fresh(scene, assembly);
    const auto kept = remembering.contacts(state, travels, margin);
    const auto all = fresh.contacts(state, unknown, margin);
    RC_ASSERT(std::ranges::equal(kept, all, same));
    RC_ASSERT(remembering.wheels.any_near(state, travels, kWheelRange) ==
              fresh.wheels.any_near(state, unknown, kWheelRange));
  }
}

}  // namespace
}  // namespace gurney::properties
