#include "studies/limit_states/limit_state_reader.h"

#include <gmock/gmock.h>

#include "engine/base/units.h"
#include "engine/config/document.h"
#include "tests/support/error_text.h"

namespace gurney::study {
namespace {

std::vector<LimitState> read(const std::string& text) {
  config::Document document(text, "a.toml");
  config::Table root = document.root();
  auto states = read_limit_states(root);
  document.finish();
  return states;
}

std::string errors(const std::string& text) {
  try {
    read(text);
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

/// Of one item: displacement and time of overturning.
Values values(double displacement, double overturned) {
  return [=](const Quantity& quantity) -> std::vector<double> {
    return {quantity.column == "time_of_overturning" ? overturned : displacement};
  };
}

TEST(LimitStates, LimitsAreInTheUnitStated) {
  const auto states = read(
      "[[limit_state]]\nname = \"tilts\"\ndemand = \"peak_tilt\"\nabove = 10\nunit = \"deg\"\n"
      "[[limit_state]]\nname = \"way\"\nzone = \"door\"\ndemand = \"least_free_width\"\n"
      "below = 90\nunit = \"cm\"\n"
      "[[limit_state]]\nname = \"screen\"\npoint = \"screen\"\nitem = \"cart\"\n"
      "demand = \"peak_absolute_acceleration\"\nabove = 1\nunit = \"g\"\n");
  EXPECT_DOUBLE_EQ(states[0].limit, 10 * kRadiansPerDegree);
  EXPECT_EQ(states[0].words, "peak_tilt > 10 deg");
  EXPECT_EQ(states[1].kind, LimitState::Kind::kBelow);
  EXPECT_DOUBLE_EQ(states[1].limit, 0.9);
  EXPECT_EQ(states[1].words, "door: least_free_width < 90 cm");
  EXPECT_DOUBLE_EQ(states[2].limit, kStandardGravity);
  EXPECT_EQ(states[2].words, "cart/screen: peak_absolute_acceleration > 1 g");
}

TEST(LimitStates, CombineThoseBeforeThem) {
  const auto states = read(
      "[[limit_state]]\nname = \"far\"\ndemand = \"peak_displacement\"\nabove = 1\nunit = \"m\"\n"
      "[[limit_state]]\nname = \"fell\"\nevent = \"overturned\"\n"
      "[[limit_state]]\nname = \"any\"\nany_of = [\"far\", \"fell\"]\n"
      "[[limit_state]]\nname = \"all\"\nall_of = [\"far\", \"fell\"]\n");
  EXPECT_EQ(states[2].words, "far or fell");
  for (const double far : {0.5, 1.5})
    for (const double fell : {-1.0, 0.0}) {
      EXPECT_EQ(exceeded(states, 0, values(far, fell)), far > 1);
      EXPECT_EQ(exceeded(states, 1, values(far, fell)), fell >= 0);
      EXPECT_EQ(exceeded(states, 2, values(far, fell)), far > 1 || fell >= 0);
      EXPECT_EQ(exceeded(states, 3, values(far, fell)), far > 1 && fell >= 0);
    }
}

TEST(LimitStates, CountItemsAndParts) {
  const auto states = read(
      "[[limit_state]]\nname = \"a\"\ndemand = \"peak_displacement\"\nabove = 1\nunit = \"m\"\n"
      "at_least = 2\n"
      "[[limit_state]]\nname = \"b\"\nevent = \"overturned\"\n"
      "[[limit_state]]\nname = \"c\"\nevent = \"impact\"\n"
      "[[limit_state]]\nname = \"d\"\nany_of = [\"a\", \"b\", \"c\"]\nat_least = 2\n");
  EXPECT_EQ(states[0].words, "at least 2 items: peak_displacement > 1 m");
  EXPECT_EQ(states[3].words, "at least 2 of: a or b or c");
  const auto holds = [&](std::vector<double> displacements, double fell, double impacts) {
    const Values values = [=](const Quantity& quantity) -> std::vector<double> {
      if (quantity.column == "peak_displacement") return displacements;
      return {quantity.column == "impacts" ? impacts : fell};
    };
    return std::pair(exceeded(states, 0, values), exceeded(states, 3, values));
  };
  EXPECT_EQ(holds({2, 0.5, 0.5}, -1, 0), std::pair(false, false));
  EXPECT_EQ(holds({2, 0.5, 3}, -1, 0), std::pair(true, false));
  EXPECT_EQ(holds({2, 0.5, 3}, -1, 1), std::pair(true, true));
  EXPECT_EQ(holds({2, 0.5, 0.5}, 0, 1), std::pair(false, true));
}

TEST(LimitStates, DefaultsSayWhereTheyComeFrom) {
  const auto states = read("");
  ASSERT_EQ(states.size(), 4);
  EXPECT_EQ(states[3].name, "overturned");
  for (std::size_t i = 0; i < 3; ++i) EXPECT_FALSE(states[i].origin.empty()) << states[i].name;
}

TEST(LimitStates, ErrorsAreNamed) {
  EXPECT_EQ(errors("[[limit_state]]\nname = \"a\"\ndemand = \"peak_tilt\"\nabove = 1\n"
                   "unit = \"m\"\n"),
            "a.toml:5:8: limit_state[0].unit = \"m\": must be one of rad, deg");
  EXPECT_EQ(
      errors("[[limit_state]]\nname = \"a\"\nevent = \"slid\"\n"),
      "a.toml:3:9: limit_state[0].event = \"slid\": must be one of overturned, toppled, fell, "
      "released, impact, "
      "lifted");
  EXPECT_EQ(errors("[[limit_state]]\nname = \"a\"\nany_of = [\"b\", \"c\"]\n"),
            "a.toml:3:10: limit_state[0].any_of: no limit state 'b'\n"
            "a.toml:3:10: limit_state[0].any_of: no limit state 'c'");
  EXPECT_EQ(errors("[[limit_state]]\nname = \"a\"\ndemand = \"impacts\"\nabove = 1\nbelow = 2\n"),
            "a.toml:4:9: limit_state[0].above: must be given, or below, not both");
  EXPECT_EQ(errors("[[limit_state]]\nname = \"a\"\ndemand = \"peak_tilt\"\nunit = \"deg\"\n"),
            "a.toml:1:1: limit_state[0].above: must be given, or below, not both");
  EXPECT_EQ(errors("[[limit_state]]\nname = \"a\"\nevent = \"impact\"\nitem = \"bed\"\n"
                   "at_least = 2\n"),
            "a.toml:5:12: limit_state[0].at_least: must not go with a place; it counts the items "
            "of the scene");
  const std::string two =
      "[[limit_state]]\nname = \"a\"\nevent = \"impact\"\n"
      "[[limit_state]]\nname = \"b\"\nevent = \"lifted\"\n[[limit_state]]\nname = \"c\"\n";
  EXPECT_EQ(errors(two + "all_of = [\"a\", \"b\"]\nat_least = 1\n"),
            "a.toml:10:12: limit_state[2].at_least: must go with any_of, not with all_of");
  EXPECT_EQ(errors(two + "any_of = [\"a\", \"b\"]\nat_least = 3\n"),
            "a.toml:10:12: limit_state[2].at_least = 3: must be a whole number in 1..2");
}

}  // namespace
}  // namespace gurney::study
