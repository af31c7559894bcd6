#include <gmock/gmock.h>

#include "engine/base/units.h"
#include "studies/limit_states/limit_state_reader.h"
#include "studies/results/columns.h"
#include "tests/support/error_text.h"
#include "tests/support/expect_error.h"

namespace gurney::study {
namespace {

const Places kPlaces{{"cart", "bed", "gate"}, {"door", "gate"}, {"cord"}, {{"cart", "screen"}}};

LimitState read(const std::string& line) { return read_limit_state_expression(line, kPlaces); }

TEST(LimitStateExpression, ReadsDemandsWithTheirUnits) {
  const LimitState above = read("peak_displacement > 20 cm");
  EXPECT_EQ(above.kind, LimitState::Kind::kAbove);
  EXPECT_DOUBLE_EQ(above.limit, 0.2);
  EXPECT_EQ(above.name, "peak_displacement > 20 cm");
  EXPECT_EQ(read("  peak_tilt>.5deg ").limit, 0.5 * kRadiansPerDegree);
  const LimitState count = read("impacts > 2");
  EXPECT_EQ(count.limit, 2);
  EXPECT_EQ(count.words, "impacts > 2");
  EXPECT_EQ(read("largest_impulse > 3 N s").limit, 3);
  EXPECT_EQ(read("peak_normal_force > 1e10 N").limit, 1e10);
}

template <class Columns>
void expect_units_of(const Columns& columns, const std::string& place) {
  for (const auto& column : columns) {
    const std::string unit =
        column.units == std::string("1") ? "" : std::string(" ") + column.units;
    const std::string line = place + column.name + " > 1" + unit;
    EXPECT_EQ(error_text([&] { read(line); }), "(no error)") << "kUnits of limit_state_reader.cpp";
  }
}

TEST(LimitStateExpression, TellsOverturningFromToppling) {
  Places places = kPlaces;
  places.on_items = {"bed"};
  const auto check = [&](const std::string& line) {
    return error_text([&] { check_names(read(line), places, "the job"); });
  };
  EXPECT_EQ(check("cart: overturned"), "(no error)");
  EXPECT_EQ(check("bed: toppled"), "(no error)");
  EXPECT_EQ(check("bed: peak_displacement > 1 m"), "(no error)");
  EXPECT_THAT(check("bed: overturned"),
              testing::HasSubstr("'bed' stands on another item, where it is not overturned but "
                                 "\"toppled\""));
}

TEST(LimitStateExpression, KnowsTheUnitOfEveryDemand) {
  expect_units_of(demand_columns(), "");
  expect_units_of(point_demand_columns(), "screen: ");
  expect_units_of(zone_columns(), "door: ");
  expect_units_of(tether_columns(), "cord: ");
}

TEST(LimitStateExpression, ReadsWhatReportsPrint) {
  for (const char* line :
       {"cart: peak_displacement > 0.2 m", "cart/screen: peak_absolute_acceleration > 1 g",
        "screen: peak_absolute_acceleration > 1 g", "door: least_free_width < 90 cm", "cord: taut",
        "overturned", "at least 2 items: peak_displacement > 1 m",
        "at least 3 items: overturned"}) {
    EXPECT_EQ(read(line).words, line);
    EXPECT_EQ(read(line).name, line);
  }
  const LimitState point = read("cart/screen: peak_absolute_acceleration > 1 g");
  EXPECT_EQ(point.quantity.item, "cart");
  EXPECT_EQ(point.quantity.part, "screen");
  EXPECT_EQ(read("at least 2 items: overturned").at_least, 2);
}

TEST(LimitStateExpression, TakesAName) {
  const LimitState named = read("far away = bed: peak_displacement > 0.2 m");
  EXPECT_EQ(named.name, "far away");
  EXPECT_EQ(named.words, "bed: peak_displacement > 0.2 m");
}

TEST(LimitStateExpression, NamesWhatIsWrong) {
  EXPECT_ERROR(
      read("peak_disp > 0.2 m"),
      "--limit-state \"peak_disp > 0.2 m\": demand = \"peak_disp\": must be a known name; ");
  EXPECT_ERROR(read("peak_disp > 0.2 m"), "did you mean 'peak_displacement'?");
  EXPECT_ERROR(read("peak_displacement > 0.2 g"), ": unit = \"g\": must be one of m, cm, mm");
  EXPECT_ERROR(read("peak_displacement > 0.2"), ": unit: missing; must be one of m, cm, mm");
  EXPECT_ERROR(read("peak_displacement > far"), ": a number must follow >, and its unit");
  EXPECT_ERROR(read("peak_displacement >= 1 m"),
               ": a limit is exceeded beyond its value: >, not >=");
  EXPECT_ERROR(
      read("overtuned"),
      ": event = \"overtuned\": must be one of overturned, toppled, fell, released, impact");
  EXPECT_ERROR(read("caart: overturned"),
               ": no item, marked point, zone or tether 'caart'; did you mean 'cart'?; "
               "a name of the limit state stands before =");
  EXPECT_ERROR(read("gate: entered"), ": 'gate' is the name of item and of zone");
  EXPECT_ERROR(read("at least two items: overturned"), ": must be as in: at least 3 items");
  EXPECT_ERROR(read("at least 2.5 items: overturned"), ": at_least = 2.5: must be");
  EXPECT_ERROR(read(" "), ": must be as in: peak_displacement > 0.2 m");
  EXPECT_ERROR(read("= overturned"), ": a name must stand before =");
}

}  // namespace
}  // namespace gurney::study
