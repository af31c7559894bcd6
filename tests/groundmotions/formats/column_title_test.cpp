#include "groundmotions/formats/column_title.h"

#include <gmock/gmock.h>

#include "engine/base/units.h"
#include "groundmotions/assembly/place.h"
#include "tests/groundmotions/formats/text_file.h"
#include "tests/support/error_text.h"

namespace gurney::groundmotions {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;

const std::string kRows = "0 1 2\n10 3 4\n20 5 6\n";

std::string error(const std::string& title, const ReadOptions& options = {}) {
  return error_text([&] { read_text(title + "\n" + kRows, options); });
}

// A unit in a title that is not known must not give way to the user's.
TEST(ColumnTitle, UnitsAreUnderstoodOrQuoted) {
  const std::pair<const char*, double> units[] = {{"[mg]", kStandardGravity / 1000},
                                                  {"[%g]", kStandardGravity / 100},
                                                  {"(ft/s2)", 0.3048},
                                                  {"(cm/s\xc2\xb2)", 0.01},
                                                  {"(cm/s\xb2)", 0.01},
                                                  {"[CM/SEC**2]", 0.01}};
  for (const auto& [unit, to_si] : units) {
    const std::string title = std::string("t(ms) A1") + unit + " A2" + unit;
    EXPECT_DOUBLE_EQ(read_text(title + "\n" + kRows)[0].acceleration[1], 3 * to_si) << unit;
    EXPECT_THAT(error(title, {.unit = "m/s2"}), HasSubstr("but unit = \"m/s2\" was given")) << unit;
  }
  EXPECT_THAT(error("t(ms) A1[furlong/s2] A2[g]", {.unit = "g"}),
              HasSubstr("f:1:1: the column 'A1[furlong/s2]' states 'furlong/s2', which is not a "
                        "unit of acceleration: g, m/s2"));
  EXPECT_DOUBLE_EQ(read_text("time_ms;acc1_g;acc2_m_per_s2\n" + kRows)[0].acceleration[0],
                   kStandardGravity);
  EXPECT_THAT(error_text([] { read_text("Acc [xy]\n1\n2\n", {.unit = "g", .time_step = 0.01}); }),
              HasSubstr("f:1:1: the column 'Acc [xy]' states 'xy', which is not a unit"));
  EXPECT_EQ(read_one("Acc [mg]\n1000\n2\n", {.time_step = 0.01}).acceleration[0],
            1000 * (kStandardGravity / 1000));
}

// A capital behind a name is the channel's, and neither g nor metres.
TEST(ColumnTitle, ALetterBehindANameIsPartOfIt) {
  const auto components = read_text("t(ms);Ch G;Ch M\n" + kRows, {.unit = "g"});
  ASSERT_EQ(components.size(), 2u);
  EXPECT_EQ(components[0].name, "Ch G");
  EXPECT_EQ(components[1].name, "Ch M");
  EXPECT_DOUBLE_EQ(components[1].acceleration[1], 4 * kStandardGravity);
}

TEST(ColumnTitle, TimesHaveTheirUnit) {
  for (const char* title : {"Time[ms] a(g) b(g)", "T (msec)  a (g)  b (g)", "# time_ms;a1_g;a2_g",
                            "Time (ms) ground motions a and b in g"})
    EXPECT_DOUBLE_EQ(read_text(std::string(title) + "\n" + kRows, {.unit = "g"})[0].time_step, 0.01)
        << title;
  EXPECT_DOUBLE_EQ(read_text("Time(min) a(g)\n0 1\n0.01 2\n0.02 3\n")[0].time_step, 0.6);
  EXPECT_THAT(error("Time(frames) a(g) b(g)"),
              HasSubstr("f:1:1: the column 'Time(frames)' states 'frames', which is not a unit of "
                        "time: s, ms, us or min are allowed"));
  EXPECT_THAT(
      read_text("a(g) Time[ms] b(g)\n1 0 2\n3 20 4\n", {.columns = "h1,time,h2"})[0].time_step,
      testing::DoubleEq(0.02));
}

TEST(ColumnTitle, ColumnsOfTheUserKeepAxesAndSigns) {
  const ReadOptions options{.columns = "time,h1,vertical"};
  const auto components = read_text("Time(ms) NS(g) DOWN(g)\n" + kRows, options);
  EXPECT_EQ(components[0].direction, Direction::kH1);
  EXPECT_EQ(components[0].azimuth, 0);
  EXPECT_EQ(components[1].direction, Direction::kVertical);
  EXPECT_DOUBLE_EQ(components[1].acceleration[0], -2 * kStandardGravity);
  EXPECT_THAT(components[1].warnings, ElementsAre(HasSubstr("the component points down (DOWN)")));
  EXPECT_DOUBLE_EQ(read_text("t(ms)  Acc (DOWN) [g]  b (g)\n" + kRows)[0].acceleration[0],
                   -kStandardGravity);

  const auto swapped = read_text("Time(ms) DOWN(g) NS(g)\n" + kRows, options);
  EXPECT_DOUBLE_EQ(swapped[0].acceleration[0], kStandardGravity);
  EXPECT_THAT(swapped[0].warnings,
              Contains("the file calls this column 'DOWN(g)', `columns` makes it h1"));
  EXPECT_THAT(swapped[1].warnings,
              ElementsAre("the file calls this column 'NS(g)', `columns` makes it vertical"));
  EXPECT_FALSE(swapped[1].azimuth);
}

// North as h1 and east as h2 are a mirror image: h2 lies 90 degrees clockwise from h1.
TEST(ColumnTitle, MirrorImagesAreWarnedOf) {
  for (const auto& [title, columns, count] : {std::tuple{"Time(ms) NS(g) EW(g)", "time,h1,h2", 1},
                                              {"Time(ms) EW(g) NS(g)", "time,h1,h2", 0}}) {
    std::vector<UnplacedComponent> given;
    for (Component& component : read_text(std::string(title) + "\n" + kRows, {.columns = columns}))
      given.push_back({.component = std::move(component)});
    EXPECT_EQ(place(given).warnings.size(), count) << title;
  }
}

TEST(ColumnTitle, AVelocityIsNoVertical) {
  const auto names = [](const char* v) {
    return "the column '" + std::string(v) + "' is a velocity";
  };
  EXPECT_THAT(error("t v d", {.unit = "g"}), HasSubstr(names("v")));
  EXPECT_THAT(error("t(ms)  NS velocity  x", {.unit = "g"}), HasSubstr(names("NS velocity")));
  EXPECT_THAT(error_text([] { read_text("t v\n0 1\n0.1 2\n0.2 3\n", {.unit = "g"}); }),
              HasSubstr("f:1:1: the column 'v' may be a velocity, a displacement or the vertical; "
                        "say which by columns"));
  EXPECT_EQ(read_text("t v\n0 1\n0.1 2\n", {.unit = "g", .columns = "time,vertical"})[0].direction,
            Direction::kVertical);
  EXPECT_EQ(read_text("t(ms) NS(g) V(g)\n" + kRows)[1].direction, Direction::kVertical);
  EXPECT_EQ(read_text("t(ms) L V\n" + kRows, {.unit = "g"})[1].direction, Direction::kVertical);
}

}  // namespace
}  // namespace gurney::groundmotions
