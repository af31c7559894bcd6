#include "equipment/catalogue/room_description.h"

#include <gtest/gtest.h>

#include "engine/base/units.h"
#include "equipment/catalogue/catalogue.h"
#include "equipment/catalogue/tether_type.h"
#include "tests/support/error_text.h"
#include "tests/support/key_table.h"

namespace gurney::equipment {
namespace {

RoomDescription room_of(const std::string& text) {
  config::Document document(text, "a.toml");
  RoomNames names;
  Uncertain<RoomDescription> room;
  read_room(document.root(), names, room);
  document.finish();
  return room.stated();
}

std::string errors(const std::string& text) {
  return error_text([&] { room_of(text); });
}

const Vector3& size_of(const RoomShape& shape) { return std::get<RoomBox>(shape.shape).size; }

constexpr const char* kWall =
    "[[wall]]\nfrom_m = [1, 0]\nto_m = [1, 4]\nthickness_m = 0.2\nheight_m = 3\n";

TEST(Room, AWallIsABoxAlongItsLine) {
  const RoomDescription room = room_of(kWall);
  ASSERT_EQ(room.shapes.size(), 1u);
  EXPECT_EQ(room.shapes[0].name, "wall 1");
  EXPECT_EQ(room.shapes[0].material, "plasterboard");
  EXPECT_LT((room.shapes[0].position - Vector3(1, 2, 1.5)).norm(), 1e-12);
  EXPECT_EQ(size_of(room.shapes[0]), Vector3(4, 0.2, 3));
  EXPECT_LT((room.shapes[0].rotation * Vector3::UnitX() - Vector3::UnitY()).norm(), 1e-12);
}

/// 4 m of wall with doors from 0.5 to 1.5 and, as high as the wall, from 3 to 4.
TEST(Room, DoorsLeaveThePiecesBesideAndAbove) {
  const RoomDescription room = room_of(std::string(kWall) + R"(name = "w"
door = [{ at_m = 3, width_m = 1, height_m = 3 }, { at_m = 0.5, width_m = 1, height_m = 2 }]
)");
  ASSERT_EQ(room.shapes.size(), 3u);
  EXPECT_EQ(room.shapes[0].name, "w 1");
  EXPECT_LT((room.shapes[0].position - Vector3(1, 0.25, 1.5)).norm(), 1e-12);
  EXPECT_LT((size_of(room.shapes[0]) - Vector3(0.5, 0.2, 3)).norm(), 1e-12);
  EXPECT_EQ(room.shapes[1].name, "w lintel 1");
  EXPECT_LT((room.shapes[1].position - Vector3(1, 1, 2.5)).norm(), 1e-12);
  EXPECT_LT((size_of(room.shapes[1]) - Vector3(1, 0.2, 1)).norm(), 1e-12);
  EXPECT_EQ(room.shapes[2].name, "w 2");
  EXPECT_LT((room.shapes[2].position - Vector3(1, 2.25, 1.5)).norm(), 1e-12);
  EXPECT_LT((size_of(room.shapes[2]) - Vector3(1.5, 0.2, 3)).norm(), 1e-12);
}

TEST(Room, ReadsEveryOtherKindOfShape) {
  const RoomDescription room = room_of(R"(
[[box]]
center_m = [1, 2, 0.5]
size_m = [2, 1, 1]
yaw_deg = 90
[[column]]
name = "pillar"
center_m = [3, 4]
radius_m = 0.2
height_m = 3
[[kerb]]
from_m = [0, 0]
to_m = [2, 0]
width_m = 0.3
height_m = 0.1
[[threshold]]
from_m = [0, 0]
to_m = [0, 1]
width_m = 0.05
height_m = 0.01
material = "wood"
[[zone]]
name = "way"
center_m = [1, 1]
length_m = 2
width_m = 1
yaw_deg = 90
[[point]]
name = "socket"
position_m = [0, 0, 1]
)");
  ASSERT_EQ(room.shapes.size(), 4u);
  EXPECT_EQ(room.shapes[0].position, Vector3(1, 2, 0.5));
  EXPECT_EQ(room.shapes[0].material, "wood");
  EXPECT_LT((room.shapes[0].rotation * Vector3::UnitX() - Vector3::UnitY()).norm(), 1e-12);
  EXPECT_EQ(room.shapes[1].name, "pillar");
  EXPECT_EQ(room.shapes[1].position, Vector3(3, 4, 1.5));
  EXPECT_EQ(std::get<RoomColumn>(room.shapes[1].shape).radius, 0.2);
  EXPECT_EQ(size_of(room.shapes[2]), Vector3(2, 0.3, 0.1));
  EXPECT_EQ(room.shapes[2].position, Vector3(1, 0, 0.05));
  EXPECT_EQ(room.shapes[3].name, "threshold 1");
  EXPECT_EQ(room.shapes[3].material, "wood");
  ASSERT_EQ(room.zones.size(), 1u);
  EXPECT_EQ(room.zones[0].name, "way");
  EXPECT_EQ(room.zones[0].length, 2);
  EXPECT_DOUBLE_EQ(room.zones[0].angle, 90 * kRadiansPerDegree);
  ASSERT_EQ(room.points.size(), 1u);
  EXPECT_EQ(room.points[0].position, Vector3(0, 0, 1));
}

TEST(BadRoom, DoorsMustFitTheirWall) {
  const auto door = [](const std::string& doors) {
    return errors(std::string(kWall) + "door = [" + doors + "]\n");
  };
  EXPECT_EQ(
      door("{ at_m = 0, width_m = 4.5, height_m = 2 }"),
      "a.toml:6:31: wall[0].door[0].width_m = 4.5: the door is wider than the wall, 4 m long");
  EXPECT_EQ(door("{ at_m = 3.5, width_m = 1, height_m = 2 }"),
            "a.toml:6:18: wall[0].door[0].at_m = 3.5: the door would end at 4.5 m, beyond the end "
            "of the wall at 4 m");
  EXPECT_EQ(door("{ at_m = 1, width_m = 1, height_m = 3.5 }"),
            "a.toml:6:45: wall[0].door[0].height_m = 3.5: must be at most the height of the wall, "
            "3");
  EXPECT_EQ(door("{ at_m = 1, width_m = 1, height_m = 2 }, { at_m = 1.5, width_m = 1, height_m = "
                 "2 }"),
            "a.toml:6:59: wall[0].door[1].at_m = 1.5: the door, to 2.5 m, overlaps the one from 1 "
            "to 2 m");
}

TEST(BadRoom, AllErrorsAtOnce) {
  EXPECT_EQ(errors(R"([[wall]]
name = "w"
from_m = [1, 1]
to_m = [1, 1]
thickness_m = 0
height_m = 3
material = "plasterbord"
[[box]]
name = "w"
center_m = [0, 0, 1]
size_m = [1, -1, 1]
[[box]]
name = "floor"
center_m = [0, 0, 1]
size_m = [1, 1, 1]
[[column]]
radius_m = nan
height_m = 1
[[zone]]
center_m = [0, 0]
length_m = 0
width_m = 1
[[zone]]
name = "zone 1"
center_m = [0, 0]
length_m = 1
width_m = 1
[[window]]
)"),
            "a.toml:4:8: wall[0].to_m: must differ from from_m\n"
            "a.toml:5:15: wall[0].thickness_m = 0: must be a finite number > 0\n"
            "a.toml:7:12: wall[0].material = \"plasterbord\": no contact names this material; did "
            "you mean 'plasterboard'?\n"
            "a.toml:9:8: box[0].name = \"w\": must differ from the name at a.toml:2:8\n"
            "a.toml:11:14: box[0].size_m[1] = -1: must be a finite number > 0\n"
            "a.toml:13:8: box[1].name = \"floor\": must not be empty or 'floor'\n"
            "a.toml:16:1: column[0].center_m: missing; must be an array of 2 numbers\n"
            "a.toml:17:12: column[0].radius_m = nan: must be a finite number > 0\n"
            "a.toml:21:12: zone[0].length_m = 0: must be a finite number > 0\n"
            "a.toml:24:8: zone[1].name = \"zone 1\": must differ from the name at a.toml:19:1\n"
            "a.toml:28:3: window: unknown key; known: box, column, contact, kerb, point, "
            "threshold, wall, zone");
}

TEST(Contacts, AreReadWithWhatTheyRestOn) {
  const RoomDescription room = room_of(R"(
[[contact]]
materials = ["equipment", "foam"]
stiffness_n_per_m = { value = 2e4, assumption = "soft", range = [1e4, 5e4] }
damping_n_s_per_m = 100
friction = 0.6
[[box]]
center_m = [0, 0, 1]
size_m = [1, 1, 1]
material = "foam"
)");
  const MaterialContact* foam = find_contact(room.contacts, "foam", "equipment");
  ASSERT_NE(foam, nullptr);
  EXPECT_EQ(foam->constants.kind, ContactConstants::Kind::kCompliant);
  EXPECT_EQ(foam->constants.stiffness, 2e4);
  EXPECT_EQ(foam->constants.damping, 100);
  EXPECT_EQ(foam->constants.friction, 0.6);
  ASSERT_EQ(foam->assumptions.size(), 1u);
  EXPECT_EQ(foam->assumptions[0].key, "equipment-foam/contact.stiffness_n_per_m");
  EXPECT_EQ(room.shapes[0].material, "foam");
}

TEST(Contacts, TheUsualOnesAreAssumptionsThroughout) {
  const std::vector<MaterialContact> usual = usual_contacts().stated();
  for (const char* other : {"floor", "equipment", "plasterboard", "concrete", "wood", "steel"}) {
    const MaterialContact* contact = find_contact(usual, "equipment", other);
    ASSERT_NE(contact, nullptr) << other;
    EXPECT_EQ(contact->assumptions.size(), 2u) << other;
  }
  // On the floor they are those the engine has where nobody names materials.
  const ContactConstants engine, floor = find_contact(usual, "equipment", "floor")->constants;
  EXPECT_EQ(floor.kind, engine.kind);
  EXPECT_EQ(floor.restitution, engine.restitution);
  EXPECT_EQ(floor.friction, engine.friction);
}

TEST(BadContacts, AreExplained) {
  EXPECT_EQ(errors(R"([[contact]]
materials = ["equipment"]
restitution = 0.3
stiffness_n_per_m = 1e5
damping_n_s_per_m = 10
friction = 0.3
[[contact]]
materials = ["a", "b"]
restitution = 0
stiffness_n_per_m = 0
friction = -1
[[contact]]
materials = ["b", "a"]
restitution = 0.5
friction = 0.5
)"),
            "a.toml:2:13: contact[0].materials: must be an array of 2 texts\n"
            "a.toml:3:15: contact[0].restitution: must be given, or damping_n_s_per_m, not both\n"
            "a.toml:9:15: contact[1].restitution = 0: must be a finite number >= 0.01 and <= 1\n"
            "a.toml:10:21: contact[1].stiffness_n_per_m = 0: must be a finite number > 0\n"
            "a.toml:11:12: contact[1].friction = -1: must be a finite number >= 0\n"
            "a.toml:13:13: contact[2].materials: the pair of 'b' and 'a' is there already");
}

TEST(ShippedRooms, Load) {
  const std::vector<std::string> shipped = catalogue_names(DataKind::kRoom);
  EXPECT_GE(shipped.size(), 3u);
  for (const std::string& name : shipped) {
    RoomNames names;
    Uncertain<RoomDescription> model;
    load_room(find_data(DataKind::kRoom, name, ""), names, model);
    const RoomDescription& room = model.stated();
    EXPECT_GE(room.shapes.size(), 4u) << name;
    EXPECT_FALSE(room.zones.empty()) << name;
    EXPECT_FALSE(room.assumptions.empty()) << name;
  }
}

TEST(ShippedTethers, Load) {
  for (const std::string& name : catalogue_names(DataKind::kTether)) {
    const TetherType type = load_tether_type(find_data(DataKind::kTether, name, "")).stated();
    // Stiffness, damping, strength, slack pull; a short strap hangs without a pull.
    EXPECT_EQ(type.assumptions.size(), name == "strap" ? 3u : 4u) << name;
    EXPECT_GT(type.strength, 0) << name;
  }
  // A line parts before a plug leaves its socket, and this before a gas probe its outlet.
  const auto strength = [](const char* name) {
    return load_tether_type(find_data(DataKind::kTether, name, "")).stated().strength;
  };
  EXPECT_LT(strength("iv_line"), strength("power_cord"));
  EXPECT_LT(strength("power_cord"), strength("gas_hose"));
  EXPECT_LT(strength("gas_hose"), strength("strap"));
}

TEST(RoomPage, HasEveryKeyTheReaderKnowsAndNoOther) {
  std::set<std::string> asked;
  for (const char* constants : {"restitution = 0.5", "damping_n_s_per_m = 1"}) {
    config::Document document(std::string("wall = [{ door = [{}] }]\nbox = [{}]\ncolumn = [{}]\n"
                                          "kerb = [{}]\nthreshold = [{}]\nzone = [{}]\npoint = "
                                          "[{}]\ncontact = [{ ") +
                                  constants + " }]\n",
                              "a.toml");
    RoomNames names;
    Uncertain<RoomDescription> room;
    read_room(document.root(), names, room);
    for (const std::string& key : without_provenance(document.asked_keys())) asked.insert(key);
  }
  for (const char* key : {"at_m", "width_m", "height_m"})  // read where the wall is right
    asked.insert(std::string("wall[].door[].") + key);
  for (const char* key : {"schema", "name", "description"}) asked.insert(key);
  EXPECT_EQ(asked, documented_keys(GURNEY_SOURCE_DIR "/docs/formats/room_file.md", ""));
}

}  // namespace
}  // namespace gurney::equipment
