#include "engine/config/overlay.h"

#include <gtest/gtest.h>

#include <cmath>

#include "engine/config/table.h"
#include "tests/support/error_text.h"

namespace gurney::config {
namespace {

TEST(Overlay, MergesTablesAndReplacesTheRest) {
  Document base(R"(
a = 1
list = [1, 2]
quantity = { value = 3, source = "s" }
[deep.table]
x = 1
y = 2
[[part]]
name = "one"
n = 1
[[part]]
name = "two"
n = 2
)",
                "a.toml");
  const Document patch(R"(
list = [3]
quantity = { value = 4 }
new = true
deep.table.y = 5
part.two.n = 7
part."*" = { m = 8, n = 6 }
)",
                       "a.toml");
  Node tree = base.tree();
  overlay(tree, patch.tree(), "patch", base);
  EXPECT_TRUE(base.clean());
  Document merged(tree, base);
  EXPECT_EQ(merged.path(), "a.toml");
  Table root = merged.root();
  EXPECT_EQ(root.number("a", Range::any()), 1);
  EXPECT_EQ(root.numbers("list", Range::any()), std::vector<double>{3});
  EXPECT_EQ(root.table("quantity")->keys(), std::vector<std::string>{"value"});
  EXPECT_TRUE(root.boolean("new"));
  EXPECT_EQ(root.table("deep")->table("table")->number("x", Range::any()), 1);
  EXPECT_EQ(root.table("deep")->table("table")->number("y", Range::any()), 5);
  std::vector<Table> parts = root.tables("part");
  EXPECT_EQ(parts[0].number("n", Range::any()), 6);
  EXPECT_EQ(parts[1].number("n", Range::any()), 7);
  EXPECT_EQ(parts[0].number("m", Range::any()), 8);
  EXPECT_EQ(parts[1].number("m", Range::any()), 8);
  EXPECT_EQ(parts[1].where("n"), "a.toml:6:14");  // the place in the patch
}

TEST(Overlay, RefusesToReplaceANumberByASwitch) {
  Document base("brakes = 0\nangle = 1\nspin = true\n", "a.toml");
  const Document patch("brakes = true\nangle = 1.5\nspin = 2\n", "a.toml");
  Node tree = base.tree();
  overlay(tree, patch.tree(), "patch", base);
  Table root = base.root();
  for (const char* key : {"brakes", "angle", "spin"}) root.set_aside(key);
  EXPECT_EQ(error_text([&] { base.finish(); }),
            "a.toml:1:10: brakes = 0: must be true or false, as what replaces it\n"
            "a.toml:3:8: spin = true: must be a number, as what replaces it");
}

TEST(Overlay, NotesNamesThatNoTableHas) {
  Document base("[[part]]\nname = 'one'\n", "a.toml");
  const Document patch("part.on.n = 1\npart.one = 2\n", "a.toml");
  Node tree = base.tree();
  overlay(tree, patch.tree(), "patch", base);
  base.root().tables("part")[0].text("name");
  EXPECT_EQ(error_text([&] { base.finish(); }),
            "a.toml:1:6: patch.part.on: no [[part]] has this name; did you mean 'one'?\n"
            "a.toml:2:12: patch.part.one = 2: must be a table");
}

TEST(Document, TakesAnElementOutOfItsRoot) {
  Document document("a = 1\nb = 2\n", "a.toml");
  EXPECT_EQ(document.take("a")->integer, 1);
  EXPECT_FALSE(document.take("a"));
  document.root().number("b", Range::any());
  document.finish();  // does not miss a
}

TEST(Range, ContainsWhatLiesBetween) {
  EXPECT_TRUE(Range::positive().contains_between(0, INFINITY));
  EXPECT_FALSE(Range::positive().contains_between(-1e-9, 1));
  EXPECT_FALSE(Range::within(0, 1).contains_between(0, 1.1));
  EXPECT_TRUE(Range::within(0, 1).open_above().contains_between(0, 1));
  EXPECT_FALSE(Range::any().contains_between(NAN, 1));
}

}  // namespace
}  // namespace gurney::config
