#include "engine/bullet/contact_search.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "studies/verification/scenes/small_scenes.h"

// Contacts by a search of a state, with no step around it.
namespace gurney {
namespace {

const Tread kTread = small::bare_tread(3e5, 1e5);

/// A trolley whose wheels of radius 50 mm stand 10 mm before a kerb, with the rest of the kerb far
/// from its chassis.
Scene before_a_kerb() {
  Scene scene = scene_of(small::trolley({0, 0, 0, 0}, kTread));
  double front = -1;
  for (const Caster& caster : scene.items[0].model.casters)
    front = std::max(front, caster.mount.x() - caster.trail + caster.wheel_radius);
  scene.room.push_back(
      {"kerb", "", {front + 0.01 + 0.1, 0, 0.03}, Quaternion::Identity(), RoomBox{{0.2, 4, 0.06}}});
  return scene;
}

struct Search {
  explicit Search(const Scene& of) : scene(of), search(scene, assembly, true) {
    for (std::size_t i = 0; i < scene.items.size(); ++i)
      state.items.push_back(assembly.items[i].placed(scene.items[i].initial));
  }
  Scene scene;
  Assembly assembly{scene};
  SceneState state;
  ContactSearch search;
};

TEST(ContactSearch, AsksBulletForWheelsBeforeAKerb) {
  Search s(before_a_kerb());
  const std::vector<BodyContact> found = s.search.find(s.state, 0);
  EXPECT_EQ(s.search.collision_passes(), 1);
  ASSERT_EQ(found.size(), 2u) << "both front wheels";
  for (const BodyContact& contact : found) {
    EXPECT_GE(contact.side.caster, 0);
    EXPECT_EQ(contact.other, 1);
    // The face of the kerb is higher than the wheel's centre: its normal is exact.
    EXPECT_NEAR((contact.normal + Vector3::UnitX()).norm(), 0, 1e-12);
    EXPECT_NEAR(s.assembly.gap(contact, s.state), 0.01, 1e-12);
  }
}

// A wheel beside a wall meets it with the edge of its tread on that side: the other is a tread's width farther away.
TEST(ContactSearch, FindsTheSideOfAWheelThatIsNearTheWall) {
  for (const double side : {1.0, -1.0}) {
    Scene scene = scene_of(small::trolley({0, 0, 0, 0}, kTread));
    scene.items[0].model.shape.clear();
    double outermost = 0;
    for (Caster& caster : scene.items[0].model.casters) {
      caster.wheel_width = 0.03;
      outermost = std::max(outermost, std::abs(caster.mount.y()) + caster.wheel_width / 2);
    }
    scene.room.push_back({"wall",
                          "",
                          {0, side * (outermost + 0.01 + 0.1), 0.5},
                          Quaternion::Identity(),
                          RoomBox{{4, 0.2, 1}}});
    Search s(scene);
    std::set<int> wheels;
    for (const BodyContact& contact : s.search.find(s.state, 0)) {
      ASSERT_GE(contact.side.caster, 0);
      wheels.insert(contact.side.caster);
      EXPECT_NEAR((contact.normal + side * Vector3::UnitY()).norm(), 0, 1e-12);
      EXPECT_NEAR(s.assembly.gap(contact, s.state), 0.01, 1e-12);
    }
    EXPECT_EQ(wheels.size(), 2u) << "both wheels of this side";
  }
}

// A search leaves the state alone and remembers nothing that a second one would see.
TEST(ContactSearch, FindsTheSameAgain) {
  Search s(before_a_kerb());
  const std::vector<BodyContact> first = s.search.find(s.state, 0.004);
  const std::vector<BodyContact>& again = s.search.find(s.state, 0.004);
  ASSERT_EQ(first.size(), again.size());
  for (std::size_t i = 0; i < first.size(); ++i) {
    EXPECT_EQ(first[i].normal, again[i].normal);
    EXPECT_EQ(first[i].offset, again[i].offset);
    EXPECT_EQ(first[i].side.local, again[i].side.local);
  }
}

TEST(ContactSearch, AsksBulletForNothingWhileNoWheelIsNear) {
  Scene scene = before_a_kerb();
  scene.room[0].position.x() += 0.02;  // 30 mm away: out of range
  Search s(scene);
  EXPECT_TRUE(s.search.find(s.state, 0).empty());
  EXPECT_EQ(s.search.collision_passes(), 0);
}

// Wheels and chassis of one item overlap in space and are no contact; wheels of two items are.
TEST(ContactSearch, FindsWheelsOfTwoItemsButNotThoseOfOne) {
  Scene scene = scene_of(small::trolley({0, 0, 0, 0}, kTread));
  scene.items[0].name = "first";
  scene.items[0].model.shape = {{{0, 0, 0.1}, {1, 0.5, 0.1}}};  // about the wheels' centres
  Search alone(scene);
  EXPECT_TRUE(std::ranges::none_of(alone.search.find(alone.state, 0),
                                   [](const BodyContact& c) { return c.between_items(); }));
  scene.items[0].model.shape.clear();
  scene.items.push_back(scene.items[0]);
  scene.items[1].name = "second";
  // Mounts are 0.8 m apart along x: 10 mm are left between the wheels that face each other.
  scene.items[1].initial.position = {0.8 + 0.11, 0, 0};
  Search two(scene);
  const std::vector<BodyContact>& found = two.search.find(two.state, 0);
  ASSERT_FALSE(found.empty());
  for (const BodyContact& contact : found) {
    EXPECT_TRUE(contact.between_items());
    EXPECT_EQ(contact.side.item, 0u);
    EXPECT_EQ(contact.other_side.item, 1u);
    EXPECT_GE(contact.side.caster, 0);
    EXPECT_GE(contact.other_side.caster, 0);
    EXPECT_NEAR(two.assembly.gap(contact, two.state), 0.01, 1e-3) << "smooth bodies: Bullet's";
  }
}

// What moves fast is searched several times in a step.
TEST(ContactSearch, LetsNothingTravelPastTheMargin) {
  Search s(before_a_kerb());
  EXPECT_EQ(s.search.next(s.state, 1, 1.01), 1.01);
  s.state.items[0].velocity.chassis[0] = 9;
  EXPECT_NEAR(s.search.next(s.state, 1, 1.01), 1.002, 1e-12);
}

}  // namespace
}  // namespace gurney
