#include "studies/render/render.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace gurney::render {
namespace {

using findings::Section;
using findings::Table;

Table table() {
  Table table{"items",
              "",
              {{"key", "item"},
               {"name", ""},
               {"height_m", "height", {".0f", "mm", 1e-3}},
               {"", "Cr / R", {".3g"}},
               {"at.casters", "casters"}}};
  table.add({"cart", "a | b", 1.2344, 0.0123456, 4});
  table.add({"chair", "", std::nan(""), 2.0, std::size_t{0}});
  return table;
}

TEST(Render, WritesTheSameRowsForPeopleAndPrograms) {
  EXPECT_EQ(text(table()),
            "item   height [mm]  Cr / R  casters\n"
            "cart          1234  0.0123        4\n"
            "chair            -       2        0\n");
  EXPECT_EQ(markdown(table()),
            "| item | height [mm] | Cr / R | casters |\n| --- | --- | --- | --- |\n"
            "| cart | 1234 | 0.0123 | 4 |\n| chair | - | 2 | 0 |\n");
  const std::string expected = R"({
  "items": [
    {
      "key": "cart",
      "name": "a | b",
      "height_m": 1.2344,
      "at": {
        "casters": 4
      }
    },
    {
      "key": "chair",
      "name": "",
      "height_m": null,
      "at": {
        "casters": 0
      }
    }
  ]
}
)";
  EXPECT_EQ(json(Section{}.add(table())), expected);
}

/// Words of a cell go to the next line; columns that still do not fit come again below, with the first.
TEST(Render, FitsTablesIntoTheTerminal) {
  Table of{"", "", {{"", "state"}, {"", "why"}, {"", "theta"}, {"", "beta"}, {"", "least"}}};
  of.add(
      {"hit", "only one intensity has both outcomes, so neither can be estimated", 0.25, 0.5, 1});
  setenv("COLUMNS", "40", 1);
  const std::string fitted = text(of);
  unsetenv("COLUMNS");
  EXPECT_EQ(fitted,
            "state  why                     theta\n"
            "hit    only one intensity has   0.25\n"
            "       both outcomes, so\n"
            "       neither can be\n"
            "       estimated\n"
            "\n"
            "state  beta  least\n"
            "hit     0.5      1\n");
  EXPECT_EQ(text(of).find('\n'), text(of).rfind("hit ") - 1) << "a file has whole rows";
}

TEST(Render, EscapesNamesThatAreNotUtf8InJson) {
  findings::Section all;
  all.json("file", "bed \xff\xc3\xa9").json("files", findings::Texts{"\xc3\xa9", "\xc3"});
  EXPECT_NE(json(all).find("bed \\\\xff\xc3\xa9"), std::string::npos) << json(all);
  EXPECT_NE(json(all).find("[\n    \"\xc3\xa9\",\n    \"\\\\xc3\"\n  ]"), std::string::npos)
      << json(all);
}

TEST(Render, EscapesWhatWouldEndACellOfMarkdown) {
  Table of{"", "", {{"", "what"}, {"", "error", {".1e"}}}};
  of.add({"|x|", 0.00123});
  EXPECT_EQ(markdown(of), "| what | error |\n| --- | --- |\n| \\|x\\| | 1.2e-03 |\n");
}

/// Every kind of part, shown to both or to one of them; what is missing has a key and no line.
Section every_kind() {
  Section all{"", "Title"};
  all.fact("speed", "peak speed", -1.5, {".2f", "km/h", 1 / 3.6, 10}, "before the wall");
  all.fact("worst", "worst of all", std::numeric_limits<double>::infinity());
  all.fact("braked", "braked", true).json("hidden", findings::Numbers{1, std::nan("")});
  all.text("variants", findings::Texts{"a", "b"}).say("A sentence.").say("");
  Section inner{"parts[]", "first"};
  inner.fact("size_m", "size", findings::Numbers{0.5, -1e-9}, {".0f", "mm", 1e-3});
  all.add(inner).add(Section{"parts[]", "second, without facts for people"}.json("a", 1));
  Table named{"measures{}", "", {{"", "measure"}, {"unit", ""}, {"values.h1", "h1"}}};
  named.add({"PGA", "m/s2", 3.0});
  all.add(named).list("warnings", "warnings", {"one", "two\nlines"}).list("none", "none", {});
  return all.add(Section{"", "nothing to show"});
}

TEST(Render, ShowsPartsInTheirOrder) {
  EXPECT_EQ(text(every_kind()),
            "Title\n"
            "peak speed  -5.40 km/h, before the wall\n"
            "braked      yes\n"
            "variants    a, b\n"
            "\n"
            "A sentence.\n"
            "\n"
            "first\n"
            "  size  500, 0 mm\n"
            "\n"
            "measure  h1\n"
            "PGA       3\n"
            "\n"
            "warnings\n"
            "  one\n"
            "  two\n"
            "    lines\n");
}

TEST(Render, NestsSectionsByTheirKeys) {
  EXPECT_EQ(json(every_kind()), R"({
  "speed": -0.15,
  "worst": null,
  "braked": true,
  "hidden": [
    1.0,
    null
  ],
  "parts": [
    {
      "size_m": [
        0.5,
        -1e-09
      ]
    },
    {
      "a": 1
    }
  ],
  "measures": {
    "PGA": {
      "unit": "m/s2",
      "values": {
        "h1": 3.0
      }
    }
  },
  "warnings": [
    "one",
    "two\nlines"
  ],
  "none": []
}
)");
  EXPECT_EQ(json(std::vector<Section>{}), "[]\n");
  EXPECT_EQ(json(std::vector{Section{}.json("a", 1)}), "[\n  {\n    \"a\": 1\n  }\n]\n");
}

}  // namespace
}  // namespace gurney::render
