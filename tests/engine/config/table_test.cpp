#include "engine/config/table.h"

#include <gtest/gtest.h>

#include <limits>

#include "engine/config/nearest_name.h"
#include "tests/support/error_text.h"
#include "tests/support/temp_folder.h"

namespace gurney::config {
namespace {

/// What `finish` says after `read` has read a document of this text.
template <typename Read>
std::string errors(const std::string& text, Read read) {
  return error_text([&] {
    Document document(text, "a.toml");
    Table root = document.root();
    read(root);
    document.finish();
  });
}

TEST(Table, GivesWhatTheFileSays) {
  Document document(R"(
mass_kg = 3
ratio = 0.5
on = true
name = "cart"
point = [1, 2.5, -3]
corners = [[1, 2, 3], [4, 5, -6]]
flags = [true, false]
files = ["a", "b"]
file = "c"
solver = "b"
steps = 7
[sub]
x = 1
[[part]]
y = 1
[[part]]
y = 2
)",
                    "a.toml");
  Table root = document.root();
  EXPECT_EQ(root.number("mass_kg", Range::positive()), 3);
  EXPECT_EQ(root.number("ratio", Range::any()), 0.5);
  EXPECT_TRUE(root.boolean("on"));
  EXPECT_EQ(root.text("name"), "cart");
  EXPECT_EQ(root.vector("point", Range::any()), Vector3(1, 2.5, -3));
  EXPECT_EQ(root.vectors("corners", Range::any()), (std::vector<Vector3>{{1, 2, 3}, {4, 5, -6}}));
  EXPECT_EQ(root.booleans("flags", 2), (std::vector<bool>{true, false}));
  EXPECT_EQ(root.texts("files"), (std::vector<std::string>{"a", "b"}));
  EXPECT_EQ(root.texts("file"), std::vector<std::string>{"c"});
  EXPECT_EQ(root.texts("none"), std::vector<std::string>{});
  EXPECT_EQ(root.choice("solver", {"a", "b"}), 1u);
  EXPECT_EQ(root.integer("steps", 0, 10), 7);
  EXPECT_EQ(root.table("sub")->number("x", Range::any()), 1);
  auto parts = root.tables("part");
  ASSERT_EQ(parts.size(), 2u);
  EXPECT_EQ(parts[0].number("y", Range::any()), 1);
  EXPECT_EQ(parts[1].number("y", Range::any()), 2);
  EXPECT_EQ(parts[1].name_of("y"), "part[1].y");
  EXPECT_EQ(root.where("mass_kg"), "a.toml:2:11");
  document.finish();
}

TEST(Table, FallsBackOnlyWhereAKeyIsAbsent) {
  Document document("a = 1", "a.toml");
  Table root = document.root();
  EXPECT_EQ(root.number("a", Range::any(), 5.0), 1);
  EXPECT_EQ(root.number("b", Range::any(), 5.0), 5);
  EXPECT_EQ(root.integer("c", 0, 9, 4), 4);
  EXPECT_EQ(root.text("d", "x"), "x");
  EXPECT_TRUE(root.boolean("e", true));
  EXPECT_EQ(root.vector("f", Range::any(), Vector3(1, 2, 3)), Vector3(1, 2, 3));
  EXPECT_FALSE(root.table("g"));
  EXPECT_TRUE(root.tables("h").empty());
  document.finish();
}

TEST(Table, CollectsEveryErrorSortedByLine) {
  const std::string text = errors(R"(mass_kg = -3
radius = 0
name = 4
solver = "stra"
[part]
x = "one"
p = [1, 2]
colour = "red"
)",
                                  [](Table& root) {
                                    auto part = *root.table("part");
                                    part.numbers("p", Range::any(), 3);
                                    part.number("x", Range::any());
                                    part.text("color", "blue");
                                    part.number("y", Range::any());
                                    root.choice("solver", {"star", "general"});
                                    root.text("name");
                                    root.number("radius", Range::positive());
                                    root.number("mass_kg", Range::positive());
                                  });
  EXPECT_EQ(text,
            "a.toml:1:11: mass_kg = -3: must be a finite number > 0\n"
            "a.toml:2:10: radius = 0: must be a finite number > 0\n"
            "a.toml:3:8: name = 4: must be text in quotes\n"
            "a.toml:4:10: solver = \"stra\": must be one of star, general; did you mean 'star'?\n"
            "a.toml:5:1: part.y: missing; must be a finite number\n"
            "a.toml:6:5: part.x = \"one\": must be a finite number\n"
            "a.toml:7:5: part.p = [1, 2]: must be an array of 3 numbers\n"
            "a.toml:8:1: part.colour: unknown key; did you mean 'color'?");
}

TEST(Table, RefusesNumbersThatAreNone) {
  const auto read = [](Table& root) { root.number("x", Range::positive()); };
  EXPECT_EQ(errors("x = nan", read), "a.toml:1:5: x = nan: must be a finite number > 0");
  EXPECT_EQ(errors("x = inf", read), "a.toml:1:5: x = inf: must be a finite number > 0");
  EXPECT_EQ(errors("x = true", read), "a.toml:1:5: x = true: must be a finite number > 0");
  EXPECT_EQ(errors("x = 2024-01-01", read),
            "a.toml:1:5: x = 2024-01-01: must be a finite number > 0");
  EXPECT_EQ(errors("x = {}", read), "a.toml:1:5: x = a table: must be a finite number > 0");
}

TEST(Table, RefusesElementsAndCountsOutsideTheirRange) {
  EXPECT_EQ(errors("v = [1, nan, 3]", [](Table& t) { t.vector("v", Range::any()); }),
            "a.toml:1:9: v[1] = nan: must be a finite number");
  EXPECT_EQ(errors("n = 2.5", [](Table& t) { t.integer("n", 0, 9); }),
            "a.toml:1:5: n = 2.5: must be a whole number in 0..9");
  EXPECT_EQ(errors("b = [true, 1]", [](Table& t) { t.booleans("b", 2); }),
            "a.toml:1:5: b = [true, 1]: must be an array of 2 times true or false");
  for (const char* wrong : {"[\"a\", 1]", "[]", "1"})
    EXPECT_EQ(errors(std::string("f = ") + wrong, [](Table& t) { t.texts("f"); }),
              std::string("a.toml:1:5: f = ") + wrong + ": must be a text or an array of texts");
  EXPECT_EQ(errors("t = 1", [](Table& t) { t.table("t"); }),
            "a.toml:1:5: t = 1: must be a table [t]");
  EXPECT_EQ(errors("t = [1]", [](Table& t) { t.tables("t"); }),
            "a.toml:1:5: t = [1]: must be an array of tables [[t]]");
}

TEST(Table, FindsUnreadKeysAtEveryDepth) {
  const std::string text =
      errors("[[part]]\nx = 1\n[[part]]\nx = 2\nz = { w = 1 }\n[sub]\nq = 1", [](Table& root) {
        for (Table& part : root.tables("part")) part.number("x", Range::any());
      });
  EXPECT_EQ(text,
            "a.toml:5:1: part[1].z: unknown key; known: x\n"
            "a.toml:6:2: sub: unknown key; known: part");
}

TEST(Document, ReportsWhatKeysWereAskedFor) {
  Document document("[[part]]\nx = 1\n[sub]", "a.toml");
  Table root = document.root();
  for (Table& part : root.tables("part")) part.number("y", Range::any(), 1.0);
  root.table("sub")->has("z");
  EXPECT_EQ(document.asked_keys(), (std::vector<std::string>{"part", "part[].y", "sub", "sub.z"}));
}

TEST(Document, ExplainsFilesItCannotRead) {
  const TempFolder folder;
  const auto open = [](const std::string& path) {
    return error_text([&] { Document document(path); });
  };
  EXPECT_EQ(open(folder.path() + "/no.toml"), folder.path() + "/no.toml: no such file");
  EXPECT_EQ(open(folder.path()), folder.path() + ": is a folder, not a file");
  EXPECT_EQ(open(folder.write("empty.toml", "")), "(no error)");
  const std::string broken = folder.write("broken.toml", "a = 1\nb = = 2\n");
  EXPECT_EQ(open(broken).rfind(broken + ":2:5: not valid TOML: ", 0), 0u) << open(broken);
  // What is no value of TOML is stated with its place and what is allowed.
  const std::string word = folder.write("word.toml", "swivels = no\n");
  EXPECT_EQ(open(word), word +
                            ":1:11: not valid TOML: invalid value `no`; expected true, false, a "
                            "number, or text in quotes");
  const std::string list = folder.write("list.toml", "brakes = [true, Off]\n");
  EXPECT_EQ(open(list).rfind(list + ":1:17: not valid TOML: invalid value `Off`;", 0), 0u)
      << open(list);
  const std::string open_header = folder.write("header.toml", "a = 1\n[floor\nb = 2\n");
  EXPECT_EQ(open(open_header),
            open_header + ":2:7: not valid TOML: ']' is missing at the end of the name of a table");
  const std::string twice = folder.write("twice.toml", "a = 1\na = 2\n");
  EXPECT_EQ(open(twice).rfind(twice + ":2:", 0), 0u) << open(twice);
}

TEST(Document, PutsErrorsOfOtherFilesAfterItsOwn) {
  Document document("x = 1", "a.toml");
  document.note(Error("b.toml:1:1: y: unknown key"));
  EXPECT_FALSE(document.clean());
  EXPECT_EQ(error_text([&] { document.finish(); }),
            "a.toml:1:1: x: unknown key\nb.toml:1:1: y: unknown key");
}

TEST(Range, ContainsWhatItsTextSays) {
  const double inf = std::numeric_limits<double>::infinity();
  EXPECT_EQ(Range::positive().with_infinity().text(), "a number > 0 or inf");
  EXPECT_TRUE(Range::positive().with_infinity().contains(inf));
  EXPECT_FALSE(Range::positive().with_infinity().contains(-inf));
  EXPECT_FALSE(Range::any().contains(inf));
  EXPECT_FALSE(Range::any().contains(std::nan("")));
  const Range range = Range::within(0, 0.02).open_below();
  EXPECT_EQ(range.text(), "a finite number > 0 and <= 0.02");
  EXPECT_FALSE(range.contains(0));
  EXPECT_TRUE(range.contains(0.02));
  EXPECT_FALSE(range.open_above().contains(0.02));
  EXPECT_EQ(range.open_above().text(), "a finite number > 0 and < 0.02");
}

TEST(NearestName, CountsEdits) {
  EXPECT_EQ(edit_distance("", "abc"), 3);
  EXPECT_EQ(edit_distance("mass_kg", "mass_kg"), 0);
  EXPECT_EQ(edit_distance("mass_gk", "mass_kg"), 1);  // one swap, not two substitutions
  EXPECT_EQ(edit_distance("kitten", "sitting"), 3);
  EXPECT_EQ(edit_distance("ca", "abc"), 3);  // optimal string alignment; unrestricted would be 2
}

TEST(NearestName, SuggestsANeighbourOrListsAll) {
  EXPECT_EQ(suggestion("trial", {"height", "trail"}), "; did you mean 'trail'?");
  EXPECT_EQ(suggestion("colour_of_it", {"height", "trail"}), "; known: height, trail");
  EXPECT_EQ(suggestion("timestep", {"time_step_s", "residual"}), "; did you mean 'time_step_s'?");
  EXPECT_EQ(suggestion("mass", {"mass_kg", "size_mm"}), "; did you mean 'mass_kg'?");
  EXPECT_EQ(suggestion("x", {}), "");
  EXPECT_EQ(suggestion("ventilator", {"icu_bed", "icu_ventilator"}),
            "; did you mean 'icu_ventilator'?");
  EXPECT_EQ(suggestion("frame_bed", {"icu_bed", "ward_bed"}), "; known: icu_bed, ward_bed");
  EXPECT_EQ(suggestion("cart", {"crash_cart", "linen_cart"}), "; known: crash_cart, linen_cart");
  EXPECT_EQ(suggestion("PGV", {"pfv", "PGA larger", "PGV geomean"}),
            "; did you mean 'PGV geomean'?");
  // To compare a key of megabytes would take gigabytes.
  EXPECT_EQ(suggestion(std::string(300, 'x'), {std::string(301, 'x'), "b"}).substr(0, 9),
            "; known: ");
  // One letter wrong wins over a longer name that begins so.
  EXPECT_EQ(suggestion("swivel", {"swivel_lock", "swivels"}), "; did you mean 'swivels'?");
  EXPECT_EQ(suggestion("swivel", {"swivel_lock", "brake"}), "; did you mean 'swivel_lock'?");
  // The same word spelt otherwise wins over a nearer one.
  EXPECT_EQ(suggestion("PU125", {"R125", "pu_125"}), "; did you mean 'pu_125'?");
  EXPECT_EQ(suggestion("Sheet Vinyl", {"sheet_metal", "sheet-vinyl"}),
            "; did you mean 'sheet-vinyl'?");
  // A letter wrong in the beginning of one name.
  EXPECT_EQ(suggestion("lead_ruber", {"concrete_hospital", "lead_rubber_hospital"}),
            "; did you mean 'lead_rubber_hospital'?");
  EXPECT_EQ(near_name("lead_ruber", {"lead_rubber_hospital", "lead_rubber_office"}), "");
  EXPECT_EQ(near_name("colour_of_it", {"height", "trail"}), "");
}

}  // namespace
}  // namespace gurney::config
