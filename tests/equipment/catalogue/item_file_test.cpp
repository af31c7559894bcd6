#include "equipment/catalogue/item_file.h"

#include <gtest/gtest.h>

#include "engine/base/random/distribution.h"
#include "equipment/catalogue/catalogue.h"
#include "equipment/catalogue/load_item.h"
#include "tests/support/error_text.h"
#include "tests/support/temp_folder.h"

namespace gurney::equipment {
namespace {

constexpr const char* kCart = R"(schema = "gurney-item/1"
name = "cart"
[chassis]
mass_kg = { value = 50, assumption = "a guess", range = [40, 60] }
center_of_mass_mm = [0, 0, 400]
inertia_box_mm = [600, 500, 800]
[[shape]]
center_mm = [0, 0, 400]
size_mm = [600, 500, 800]
[[caster]]
name = "left"
type = "R100"
position_mm = [250, 200, 0]
[[caster]]
name = "right"
type = "R100"
position_mm = [250, -200, 0]
[[caster]]
name = "rear"
type = "R100"
position_mm = [-250, 0, 0]
[[payload]]
name = "drawer"
mass_kg = 8
size_mm = [400, 400, 100]
position_mm = [0, 0, 100]
)";

constexpr const char* kVariants = R"(
[variant."drawers full"]
payload.drawer.count = 5
[variant."brakes on"]
caster."*".brake = true
caster.left.swivel_lock = true
[variant.heavy]
name = "heavy cart"
chassis.mass_kg = 80
shape = [{ center_mm = [0, 0, 500], size_mm = [600, 500, 1000] }]
)";

class ItemFile : public testing::Test {
 protected:
  ItemDescription load(const std::vector<std::string>& variants, const std::string& more = "") {
    return load_item_description(folder_.write("cart.toml", kCart + (kVariants + more)), variants)
        .stated();
  }

  /// What is reported of these variants, without the file.
  std::string error(const std::string& variants) {
    const std::string file = folder_.write("cart.toml", kCart + variants);
    std::string text = error_text([&] { load_item_description(file); });
    for (std::size_t at; (at = text.find(file + ":")) != std::string::npos;)
      text.erase(at, file.size() + 1);
    return text;
  }

  TempFolder folder_;
};

TEST_F(ItemFile, AVariantChangesTheKeysItNames) {
  const ItemDescription plain = load({});
  EXPECT_EQ(plain.chassis_mass, 50);
  EXPECT_EQ(plain.payloads.at(0).count, 0);
  EXPECT_EQ(plain.assumptions.size(), 1u);
  EXPECT_EQ(plain.variants, (std::vector<std::string>{"brakes on", "drawers full", "heavy"}));

  EXPECT_EQ(load({"drawers full"}).payloads.at(0).count, 5);
  EXPECT_EQ(load({"drawers full"}).payloads.at(0).mass, 8);
  const ItemDescription braked = load({"brakes on"});
  for (const CasterPlace& place : braked.casters) {
    EXPECT_TRUE(place.brake_on) << place.name;
    EXPECT_EQ(place.swivel_locked, place.name == "left") << place.name;
  }
  const ItemDescription heavy = load({"heavy"});
  EXPECT_EQ(heavy.name, "heavy cart");
  EXPECT_EQ(heavy.chassis_mass, 80);
  EXPECT_EQ(heavy.chassis_center_of_mass.z(), 0.4);
  EXPECT_TRUE(heavy.assumptions.empty());  // the guess went with its value
  ASSERT_EQ(heavy.shape.size(), 1u);
  EXPECT_EQ(heavy.shape[0].size.z(), 1);
}

TEST_F(ItemFile, VariantsAddUpInTheirOrder) {
  const std::string lighter = "[variant.lighter]\nchassis.mass_kg = 45\n";
  const ItemDescription both = load({"heavy", "drawers full", "lighter"}, lighter);
  EXPECT_EQ(both.name, "heavy cart");
  EXPECT_EQ(both.chassis_mass, 45);
  EXPECT_EQ(both.payloads.at(0).count, 5);
  EXPECT_EQ(load({"lighter", "heavy"}, lighter).chassis_mass, 80);
}

TEST_F(ItemFile, AVariantChangesWhatTheOneItExtendsAdds) {
  const std::string more =
      "[[variant.\"a monitor\".marked_point]]\nname = \"monitor\"\nposition_mm = [0, 0, 1100]\n"
      "[variant.turned]\nextends = \"a monitor\"\n"
      "marked_point.monitor.position_mm = [100, 0, 1100]\n"
      "[variant.last]\nextends = [\"turned\", \"heavy\"]\n";
  const auto x = [](const ItemDescription& item) { return item.marked_points.back().position.x(); };
  EXPECT_EQ(x(load({"a monitor"}, more)), 0);
  EXPECT_EQ(x(load({"turned"}, more)), 0.1);
  EXPECT_EQ(x(load({"turned", "a monitor"}, more)), 0.1);  // each once, the base first
  EXPECT_EQ(x(load({"last"}, more)), 0.1);
  EXPECT_EQ(load({"last"}, more).chassis_mass, load({"heavy"}, more).chassis_mass);
  EXPECT_EQ(error("[variant.a]\nextends = \"b\"\n[variant.c]\nextends = 3\n"),
            "27:10: variant.a.extends: the item has no variant 'b'; known: a, c\n"
            "30:11: variant.c.extends = 3: must be the name of a variant, or an array of names");
  EXPECT_THAT(error("[variant.a]\nextends = \"b\"\n[variant.b]\nextends = \"a\"\n"),
              testing::HasSubstr("variant.a.extends = \"b\": must not extend itself"));
}

TEST_F(ItemFile, NamesTheNearestVariant) {
  const std::string file = folder_.write("cart.toml", std::string(kCart) + kVariants);
  EXPECT_EQ(variant_names(file), (std::vector<std::string>{"brakes on", "drawers full", "heavy"}));
  EXPECT_EQ(error_text([&] { load_item_description(file, {"drawer full"}); }),
            file + ": the item has no variant 'drawer full'; did you mean 'drawers full'?");
  EXPECT_EQ(unknown_variant({"a"}, {}), "the item has no variant 'a'");
}

TEST_F(ItemFile, EveryVariantIsCheckedAtItsOwnLine) {
  EXPECT_EQ(error("[variant.a]\nchassis.mas_kg = 3\n[variant.b]\nchassis.mass_kg = -3\n"),
            "28:9: chassis.mas_kg: unknown key; did you mean 'mass_kg'? (variant 'a')\n"
            "30:19: chassis.mass_kg = -3: must be a finite number > 0 (variant 'b')");
  EXPECT_EQ(error("[variant.a]\npayload.drawr.count = 3\ncaster.brake = true\n"),
            "28:9: variant.a.payload.drawr: no [[payload]] has this name; did you mean 'drawer'?\n"
            "29:8: variant.a.caster.brake: no [[caster]] has this name; known: left, right, rear");
  EXPECT_EQ(error("[variant.a]\ncaster.left = true\n"),
            "28:15: variant.a.caster.left = true: must be a table");
  EXPECT_EQ(error("[variant]\na = 3\n"), "28:5: variant.a = 3: must be a table [variant.a]");
  // An error of the item itself comes once, not again for each variant.
  const std::string wrong = error("count = -1\n[variant.a]\n[variant.b]\n");
  EXPECT_EQ(wrong, "27:9: payload[0].count = -1: must be a whole number in 0..100");
}

TEST_F(ItemFile, EachPlaceDrawsItsOwnWheel) {
  const std::string file = folder_.write("cart.toml", std::string(kCart) + kVariants);
  const Draw draw(1, 4);
  const ItemDescription item = sample(load_item_description(file), draw);
  const Distribution resistance = Distribution::lognormal(1, 0.3, 0.5, 1.5);
  for (const CasterPlace& place : item.casters) {
    const double p = draw.of_part(place.name)
                         .probability("tread.rolling_resistance_mm", {"rolling resistance", 0.8});
    EXPECT_EQ(place.type.properties.tread.rolling_friction_length, resistance.quantile(p) / 1000);
    EXPECT_EQ(place.type.properties.tread.static_friction,  // one floor for all wheels
              item.casters[0].type.properties.tread.static_friction);
  }
  EXPECT_NE(item.casters[0].type.properties.tread.rolling_friction_length,
            item.casters[1].type.properties.tread.rolling_friction_length);
  // A variant does not change what is drawn.
  const ItemDescription heavy = sample(load_item_description(file, {"heavy"}), draw);
  EXPECT_EQ(heavy.casters[2].type.properties.tread.rolling_friction_length,
            item.casters[2].type.properties.tread.rolling_friction_length);
}

/// What is reported of a caster like R100 with these distributions of its friction, without the
/// place.
std::string friction_error(const TempFolder& folder, const std::string& kinetic,
                           const std::string& fixed = "") {
  std::string text = contents_of(find_data(DataKind::kCaster, "R100", ""));
  const std::size_t first = text.find("[tread.static_friction]"), end = text.find("[axle");
  const std::string upper =
      "[tread.static_friction]\nvalue = 0.6\ndistribution = { kind = "
      "'uniform', low = 0.5, high = 0.7, group = 'f', source = 's' }\n";
  text.replace(
      first, end - first,
      (fixed.empty() ? upper : "[tread.static_friction]\nvalue = " + fixed + "\nsource = 's'\n") +
          "[tread.kinetic_friction]\nvalue = 0.5\ndistribution = { kind = 'uniform', " + kinetic +
          ", source = 's' }\n");
  const std::string file = folder.write("caster.toml", text);
  const std::string wrong = error_text([&] { load_caster_type(file); });
  return wrong.substr(std::min(wrong.size(), wrong.find(": ") + 2));
}

TEST_F(ItemFile, NoDrawMayPutKineticAboveStaticFriction) {
  const std::string could =
      "tread.kinetic_friction: a draw could make it larger than static_friction: the bounds must "
      "be apart, or both in one group and in order";
  EXPECT_EQ(friction_error(folder_, "low = 0.4, high = 0.6"), could);
  EXPECT_EQ(friction_error(folder_, "low = 0.4, high = 0.6, group = 'g'"), could);
  EXPECT_EQ(friction_error(folder_, "low = 0.4, high = 0.6, group = 'f', correlation = 0.9"),
            could);
  EXPECT_EQ(friction_error(folder_, "low = 0.4, high = 0.8, group = 'f'"), could);
  EXPECT_EQ(friction_error(folder_, "low = 0.4, high = 0.6, group = 'f'"), "no error)");
  EXPECT_EQ(friction_error(folder_, "low = 0.4, high = 0.5"), "no error)");
  EXPECT_EQ(friction_error(folder_, "low = 0.4, high = 0.6", "0.55"), could);
  EXPECT_EQ(friction_error(folder_, "low = 0.4, high = 0.6", "0.6"), "no error)");
}

// Every shipped item in some draws: all its distributions are read, and no draw is refused.
TEST(Catalogue, EveryItemCanBeDrawn) {
  for (const std::string& name : catalogue_names(DataKind::kItem)) {
    const auto item = load_item_description(find_data(DataKind::kItem, name, ""));
    for (std::uint64_t run = 0; run < 25; ++run)
      EXPECT_NO_THROW(assemble_item(sample(item, Draw(1, run)))) << name;
  }
}

}  // namespace
}  // namespace gurney::equipment
