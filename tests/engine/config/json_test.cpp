#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "engine/config/document.h"
#include "engine/config/json_reader.h"
#include "engine/config/table.h"
#include "tests/support/error_text.h"

namespace gurney::config {
namespace {

constexpr const char* kJson = R"({
  "mass_kg": 3, "name": "bed", "brake": true, "at": [1, 2.5],
  "wall": [{"x": 1}, {"x": -1e3}], "a/b~c": {"d": null}
})";
constexpr const char* kToml =
    "mass_kg = 3\nname = \"bed\"\nbrake = true\nat = [1, 2.5]\n"
    "wall = [{ x = 1 }, { x = -1e3 }]\n";

std::string errors(const std::string& json) {
  return error_text([&] {
    Document document(json, "a.json");
    Table root = document.root();
    root.number("mass_kg", Range::positive());
    root.text("name");
    for (Table& wall : root.tables("wall")) wall.number("x", Range::positive());
    document.finish();
  });
}

TEST(Json, GivesTheTreeOfTheSameToml) {
  Document json(kJson, "a.json"), toml(kToml, "a.toml");
  for (const char* key : {"mass_kg", "name", "brake", "at"})
    EXPECT_EQ(describe(*json.tree().find(key)), describe(*toml.tree().find(key))) << key;
  EXPECT_EQ(json.tree().find("mass_kg")->kind, Node::Kind::kInteger);
  EXPECT_EQ(json.root().numbers("at", Range::any()), (std::vector<double>{1, 2.5}));
  EXPECT_EQ(json.root().tables("wall")[1].number("x", Range::any()), -1000);
}

TEST(Json, IsKnownByItsBraceWithoutItsName) {
  Document document(kJson, "study.h5 (its job)");
  EXPECT_EQ(document.tree().find("name")->text, "bed");
}

TEST(Json, PlacesAreJsonPointers) {
  EXPECT_EQ(errors(kJson),
            "a.json:/brake: brake: unknown key; known: mass_kg, name, wall\n"
            "a.json:/at: at: unknown key; known: mass_kg, name, wall\n"
            "a.json:/wall/1/x: wall[1].x = -1000: must be a finite number > 0\n"
            "a.json:/a~1b~0c: a/b~c: unknown key; known: mass_kg, name, wall");
  EXPECT_EQ(errors("{\"name\": 3}"),
            "a.json:/: mass_kg: missing; must be a finite number > 0\n"
            "a.json:/name: name = 3: must be text in quotes");
  EXPECT_EQ(errors(R"({"mass_kg": 1, "name": null})"),
            "a.json:/name: name = null: must be text in quotes");
}

TEST(Json, TextThatIsNoneIsRefused) {
  EXPECT_THAT(errors("{\"mass_kg\": 1,\n  \"name\" \"a\"}"),
              testing::StartsWith("a.json: not valid JSON: parse error at line 2, column 12: "));
  EXPECT_EQ(errors("[1]"), "a.json: must be a JSON object");
  EXPECT_EQ(errors(R"({"wall": [{"x": 1, "x": 2}]})"),
            "a.json: the key \"x\" comes twice in one object");
  EXPECT_EQ(errors(R"({"mass_kg": 1, "name": "a", "wall": [{"x": 1}, {"x": 2}]})"), "(no error)");
}

}  // namespace
}  // namespace gurney::config
