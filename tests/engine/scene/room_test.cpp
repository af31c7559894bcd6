#include "engine/scene/room.h"

#include <gtest/gtest.h>

#include "engine/scene/validate_room.h"
#include "tests/support/error_text.h"

namespace gurney {
namespace {

Scene with(const RoomShape& shape) {
  Scene scene = scene_of({});
  scene.room = {shape};
  return scene;
}

std::string problems(const Scene& scene) {
  return error_text([&] { validate_room(scene); });
}

RoomShape box(const std::string& name, const Vector3& size) {
  return {name, "", Vector3::Zero(), Quaternion::Identity(), RoomBox{size}};
}

TEST(ValidateRoom, NamesEveryWrongValue) {
  EXPECT_EQ(problems(with(box("wall", {0.1, 3, 3}))), "(no error)");
  EXPECT_EQ(problems(with(box("wall", {0.1, -3, 0}))),
            "room shape 'wall': size = -3: must be > 0 and finite\n"
            "room shape 'wall': size = 0: must be > 0 and finite");
  EXPECT_EQ(problems(with(box("floor", {1, 1, 1}))),
            "room shape 'floor': the name must not be empty or 'floor'");
  RoomShape column{"c", "", Vector3::Zero(), Quaternion::Identity(), RoomColumn{0, 2}};
  EXPECT_EQ(problems(with(column)), "room shape 'c': radius = 0: must be > 0 and finite");
  column.shape = RoomHull{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}}};
  EXPECT_EQ(problems(with(column)),
            "room shape 'c': points: 4 or more that span a volume are needed");
}

TEST(ValidateRoom, NamesAreTakenOnceAndMaterialsHaveAPair) {
  Scene scene = with(box("wall", {0.1, 3, 3}));
  scene.room.push_back(scene.room[0]);
  EXPECT_EQ(problems(scene), "room shape 'wall': the name is taken twice");
  scene = with(box("wall", {0.1, 3, 3}));
  scene.room[0].material = "plaster";
  EXPECT_EQ(problems(scene),
            "no contact constants for the materials (none) of an item and 'plaster'");
  scene.pairs = {{"", "plaster", {.restitution = 0}}};
  EXPECT_EQ(problems(scene), "pair of '' and 'plaster': restitution = 0: must be in 0.01..1");
  scene.pairs[0].constants.restitution = 0.5;
  EXPECT_EQ(problems(scene), "(no error)");
}

}  // namespace
}  // namespace gurney
