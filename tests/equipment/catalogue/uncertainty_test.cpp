#include "equipment/catalogue/uncertainty.h"

#include <gtest/gtest.h>

#include <cmath>

#include "equipment/catalogue/quantity.h"
#include "tests/support/error_text.h"

namespace gurney::equipment {
namespace {

/// Parts that are all drawn.
std::vector<bool> all(std::size_t parts) { return std::vector<bool>(parts, true); }

using config::Document;
using config::Range;

/// What is reported of `x_mm = { value = 30, distribution = { ... } }`, without the place.
std::string error(const std::string& distribution, const Range& range = Range::positive(),
                  const std::string& value = "30") {
  const std::string text = error_text([&] {
    Document document("x_mm = { value = " + value + ", distribution = { " + distribution + " } }",
                      "a.toml");
    Quantities(document.root()).number("x_mm", range);
    document.finish();
  });
  return text.substr(std::min(text.size(), text.find(": ") + 2));
}

TEST(Uncertainty, SaysWhatIsWrong) {
  const std::string s = ", source = 's'";
  EXPECT_EQ(error("kind = 'normal', mean = 30, sd = 2, low = 25, high = 35" + s), "no error)");
  EXPECT_EQ(error("kind = 'lognormal', median = 30, beta = 0.1"),
            "x_mm.distribution: must have a source, an assumption, or both");
  EXPECT_EQ(error("kind = 'lognorml', median = 30, beta = 0.1" + s),
            "x_mm.distribution.kind = \"lognorml\": must be one of normal, lognormal, uniform, "
            "discrete, table; did you mean 'lognormal'?");
  EXPECT_EQ(error("median = 30, beta = 0.1" + s),
            "x_mm.distribution.kind: missing; must be one of normal, lognormal, uniform, discrete, "
            "table");
  EXPECT_EQ(error("kind = 'normal', mean = 30, sd = 2" + s),
            "x_mm.distribution: normal, mean 30, sd 2 gives numbers from -inf to inf: each must be "
            "a finite number > 0");
  EXPECT_EQ(error("kind = 'normal', mean = 30, sd = 2, cov = 0.1" + s, Range::any()),
            "x_mm.distribution.sd: must be given, or cov (sd over |mean|), not both");
  EXPECT_EQ(error("kind = 'normal', mean = 30, sd = 2, low = 40, high = 35" + s),
            "x_mm.distribution: low = 40 must be below high = 35");
  EXPECT_EQ(error("kind = 'lognormal', mean = 30, beta = 0.1" + s),
            "x_mm.distribution.median: missing; must be a finite number > 0\n"
            "a.toml:1:59: x_mm.distribution.mean: unknown key; did you mean 'median'?");
  EXPECT_EQ(error("kind = 'uniform', low = 31, high = 35" + s),
            "x_mm: the value 30 must be one that its distribution can give (uniform, 31 to 35)");
  EXPECT_EQ(error("kind = 'discrete', values = [29, 31], probabilities = [0.5, 0.5]" + s),
            "x_mm: the value 30 must be one that its distribution can give (discrete, 29 (0.5), "
            "31 (0.5))");
  EXPECT_EQ(error("kind = 'discrete', values = [0, 30], probabilities = [0.5, 0.5]" + s),
            "x_mm.distribution: discrete, 0 (0.5), 30 (0.5) gives numbers from 0 to 30: each must "
            "be a finite number > 0");
  EXPECT_EQ(error("kind = 'discrete', values = [20, 30], probabilities = [0.5, 0.4]" + s),
            "x_mm.distribution: the probabilities sum to 0.9: must be 1");
  EXPECT_EQ(error("kind = 'table', samples = [20, 30], values = [1]" + s),
            "x_mm.distribution.values: must be given with cumulative, or samples, not both");
  EXPECT_EQ(error("kind = 'table', values = [20, 40], cumulative = [0, 0.9]" + s),
            "x_mm.distribution: the cumulative probabilities must increase from 0 to 1");
  EXPECT_EQ(error("kind = 'uniform', low = 20, high = 35, correlation = 0.5" + s),
            "x_mm.distribution.correlation: needs the group it is with");
  EXPECT_EQ(error("kind = 'uniform', low = 20, high = 35, group = ''" + s),
            "x_mm.distribution.group: must have a name");
  EXPECT_EQ(error("kind = 'uniform', low = 20, high = 35, group = 'g', correlation = 2" + s),
            "x_mm.distribution.correlation = 2: must be a finite number >= -1 and <= 1");
}

constexpr const char* kPart = R"(
a_mm = { value = 30, source = "s", distribution = { kind = "uniform", low = 20, high = 40, source = "t" } }
b_kg = { value = 30, assumption = "v", range = [1, 99], distribution = { kind = "uniform", low = 20, high = 40, assumption = "d" } }
c = { value = 30, distribution = { kind = "uniform", low = 20, high = 40, assumption = "both", group = "g" } }
d = { value = 30, distribution = { kind = "normal", mean = 30, cov = 0.1, source = "t", group = "g" } }
[v_mm]
value = [1, 2, 3]
source = "s"
distribution = { y = { kind = "uniform", low = 0, high = 4, assumption = "tilt" } }
)";

struct Read {
  double a = 0, b = 0, c = 0, d = 0;
  Vector3 v = Vector3::Zero();
  std::vector<Assumption> assumptions;
};

Uncertain<Read> part_of(const std::string& text = kPart) {
  Document document(text, "a.toml");
  Uncertain<Read> part;
  Quantities in(document.root());
  part.set(&Read::a, in.length_mm("a_mm", Range::positive()));
  part.set(&Read::b, in.number("b_kg", Range::positive()));
  part.set(&Read::c, in.number("c", Range::positive()));
  part.set(&Read::d, in.number("d", Range::any()));
  part.set(&Read::v, in.vector_mm("v_mm", Range::any()));
  document.finish();
  return part;
}

Read read_part(const std::optional<Draw>& draw, const std::string& text = kPart) {
  return sample(part_of(text), draw);
}

TEST(Uncertainty, WithoutADrawValuesAreAsTheyAre) {
  const Read read = read_part({});
  EXPECT_EQ(read.a, 0.03);
  EXPECT_EQ(read.b, 30);
  EXPECT_EQ(read.v, Vector3(0.001, 0.002, 0.003));
  ASSERT_EQ(read.assumptions.size(), 2u);
  EXPECT_EQ(read.assumptions[0].key, "b_kg");
  EXPECT_EQ(read.assumptions[0].reason, "v");
  EXPECT_EQ(read.assumptions[0].high, 99);
  EXPECT_EQ(read.assumptions[1].key, "c");  // its value rests on the distribution
  EXPECT_EQ(read.assumptions[1].reason, "both");
  EXPECT_EQ(read.assumptions[1].low, 20);
  for (const Assumption& each : read.assumptions) EXPECT_EQ(each.distribution, "");
}

TEST(Uncertainty, AModelIsReadOnceAndSampledInAnyOrder) {
  const Uncertain<Read> part = part_of();
  EXPECT_EQ(sample(part, {}).assumptions.size(), part.stated().assumptions.size());
  std::vector<double> forwards, backwards;
  for (int run = 0; run < 8; ++run) forwards.push_back(sample(part, Draw(7, run)).b);
  for (int run = 7; run >= 0; --run) backwards.push_back(sample(part, Draw(7, run)).b);
  EXPECT_EQ(forwards, std::vector<double>(backwards.rbegin(), backwards.rend()));
  EXPECT_EQ(part.stated().b, 30);
}

TEST(Uncertainty, NumbersOfADrawnElementAreKnownWithoutItsIndex) {
  Document document(R"(
item = [{ x = 1 }, { x = 1, sub = { x = 1 } }]
)",
                    "a.toml");
  const Distribution law = Distribution::uniform(0, 2);
  const auto drawn = [&](config::Table table) {
    StatedQuantity x = Quantities(table).number("x", Range::any());
    const Uncertainty uniform{.distribution = law, .group = CorrelationGroup(), .reason = {}};
    x.uncertainty = uniform;
    std::vector<Assumption> list;
    SampleErrors errors;
    Sampler(list, errors, Draw(1, 2)).of_element("item[1]", "bed")(x);
    return list.at(0).key;
  };
  std::vector<config::Table> items = document.root().tables("item");
  EXPECT_EQ(drawn(items[1]), "bed/item.x");
  EXPECT_EQ(drawn(*items[1].table("sub")), "bed/item.sub.x");
  EXPECT_EQ(drawn(items[0]), "bed/item[0].x") << "another element";
}

TEST(Uncertainty, ADrawnNumberBeyondAnotherIsAnErrorAtItsPlace) {
  Document document(
      "[sub]\nlow = 1\nhigh = { value = 3, source = 's', distribution = { kind = 'uniform', low = "
      "0, high = 4, source = 's' } }",
      "a.toml");
  Quantities in(*document.root().table("sub"));
  Uncertain<Read> part;
  part.add([high = in.number("high", Range::any()), low = in.number("low", Range::any())](
               Read&, Sampler& of) { of.check_drawn(high, Range::more_than(low.value)); });
  document.finish();
  for (int run = 0; run < 8; ++run) {
    const double high = 4 * Draw(1, run).probability("sub.high");
    const std::string message = error_text([&] { sample(part, Draw(1, run)); });
    if (high > 1)
      EXPECT_EQ(message, "(no error)");
    else
      EXPECT_TRUE(message.starts_with("a.toml:3:8: sub.high = 0.")) << message;
  }
}

TEST(Uncertainty, ADrawGivesTheQuantileAtItsProbability) {
  const Draw draw = Draw(7, 2).of_part("front left");
  const Read read = read_part(draw);
  EXPECT_EQ(read.a, (20 + draw.probability("a_mm") * 20) / 1000);
  EXPECT_EQ(read.b, 20 + draw.probability("b_kg") * 20);
  EXPECT_EQ(read.v, Vector3(0.001, draw.probability("v_mm.y") * 4 / 1000, 0.003));
  const double shared = Draw(7, 2).probability("", {"g", 1});
  EXPECT_EQ(read.c, 20 + shared * 20);
  EXPECT_EQ(read.d, Distribution::normal(30, 3).quantile(shared));
  ASSERT_EQ(read.assumptions.size(), 5u);
  EXPECT_EQ(read.assumptions[0].key, "front left/a_mm");
  EXPECT_EQ(read.assumptions[0].distribution, "uniform, 20 to 40");
  EXPECT_EQ(read.assumptions[0].reason, "");  // it has a source
  EXPECT_EQ(read.assumptions[1].value, read.b);
  EXPECT_EQ(read.assumptions[1].reason, "d");
  EXPECT_EQ(read.assumptions[1].high, 40);
  EXPECT_EQ(read.assumptions[4].key, "front left/v_mm.y");
}

TEST(Uncertainty, OtherVariablesChangeNothing) {
  const Read read = read_part(Draw(7, 2));
  std::string fewer = kPart;
  fewer.replace(fewer.find("a_mm"), fewer.find("b_kg") - fewer.find("a_mm"), "a_mm = 30\n");
  EXPECT_EQ(read_part(Draw(7, 2), fewer).b, read.b);
  EXPECT_EQ(read_part(Draw(7, 2), fewer).v, read.v);
  EXPECT_NE(read_part(Draw(7, 3)).b, read.b);
  EXPECT_NE(read_part(Draw(8, 2)).b, read.b);
}

TEST(Uncertainty, AVectorNeedsProvenanceForEveryAxis) {
  const std::string text = error_text([] {
    Document document(
        "v = { value = [1, 2, 3], distribution = { y = { kind = 'uniform', low = 0, high = 4, "
        "source = 's' }, w = 1 } }",
        "a.toml");
    Quantities(document.root()).vector("v", Range::any());
    document.finish();
  });
  EXPECT_EQ(text,
            "a.toml:1:41: v.distribution.x: missing; the value needs a source or an assumption\n"
            "a.toml:1:41: v.distribution.z: missing; the value needs a source or an assumption\n"
            "a.toml:1:102: v.distribution.w: unknown key; known: x, y, z");
}

TEST(Uncertainty, PartsOfOneQuantityAreDrawnEachByItself) {
  Document document(R"(
heading_deg = { value = 0, distribution = { kind = "uniform", low = 0, high = 360, assumption = "any" } }
brakes = { value = [true, false, true], distribution = { kind = "discrete", values = [0, 1], probabilities = [0.5, 0.5], group = "brakes", assumption = "all or none" } }
locks = { value = true, distribution = { kind = "discrete", values = [0, 1], probabilities = [0.5, 0.5], assumption = "any" } }
lock = { value = false, distribution = { kind = "discrete", values = [0, 1], probabilities = [0.01, 0.99], source = "s" } }
)",
                    "a.toml");
  const Draw draw(1, 1);
  std::vector<Assumption> assumptions;
  Quantities in(document.root());
  SampleErrors errors;
  Sampler as_stated(assumptions, errors), drawn(assumptions, errors, draw);
  const auto numbers = [](Sampler& of, const QuantityList& list) { return of(list); };
  const auto flags = [](Sampler& of, const QuantityList& list) {
    const std::vector<double> values = of(list);
    return std::vector<bool>(values.begin(), values.end());
  };
  EXPECT_EQ(numbers(as_stated, in.numbers("heading_deg", Range::any(), all(2))),
            (std::vector<double>{0, 0}));
  EXPECT_EQ(flags(as_stated, in.flags("brakes", all(3))), (std::vector<bool>{true, false, true}));
  EXPECT_EQ(flags(as_stated, in.flag("lock", true)), std::vector<bool>{false});
  EXPECT_EQ(flags(as_stated, in.flag("absent", true)), std::vector<bool>{true});
  EXPECT_EQ(flags(as_stated, in.flags("absent", all(3))), std::vector<bool>{});
  ASSERT_EQ(assumptions.size(), 2u);
  EXPECT_EQ(assumptions[0].choice, "0, 0");
  EXPECT_EQ(assumptions[1].choice, "1, 0, 1");

  EXPECT_EQ(numbers(drawn, in.numbers("heading_deg", Range::any(), all(2))),
            (std::vector<double>{360 * draw.probability("heading_deg[0]"),
                                 360 * draw.probability("heading_deg[1]")}));
  EXPECT_EQ(numbers(drawn, in.numbers("heading_deg", Range::any(), {false, true})),
            (std::vector<double>{0, 360 * draw.probability("heading_deg[1]")}));
  const bool braked = draw.probability("", {"brakes", 1}) > 0.5;
  EXPECT_EQ(flags(drawn, in.flags("brakes", all(3))), std::vector<bool>(3, braked));
  std::vector<bool> locks;
  for (const char* lock : {"locks[0]", "locks[1]", "locks[2]", "locks[3]"})
    locks.push_back(draw.probability(lock) > 0.5);
  EXPECT_EQ(flags(drawn, in.flags("locks", all(4))), locks);
  EXPECT_EQ(flags(drawn, in.flag("lock", false)),
            std::vector<bool>{draw.probability("lock") > 0.01});
  document.finish();
}

TEST(Uncertainty, AFlagIsFalseOrTrue) {
  const std::string text = error_text([] {
    Document document(
        "on = { value = true, distribution = { kind = 'uniform', low = 0, high = 1, source = 's' } "
        "}",
        "a.toml");
    Quantities(document.root()).flag("on", false);
    document.finish();
  });
  EXPECT_EQ(text,
            "a.toml:1:37: on.distribution: must be discrete, with the values 0 (false) and 1 "
            "(true)");
}

TEST(Uncertainty, PartsOutsideTheirDistributionAreNotedOnce) {
  const std::string text = error_text([] {
    Document document(
        "yaw_deg = { value = 0, distribution = { kind = 'uniform', low = 1, high = 2, source = "
        "'s' } }",
        "a.toml");
    Quantities(document.root()).numbers("yaw_deg", Range::any(), all(4));
    document.finish();
  });
  EXPECT_EQ(text,
            "a.toml:1:11: yaw_deg: the value 0 must be one that its distribution can give "
            "(uniform, 1 to 2)");
}

TEST(Uncertainty, ATextCannotBeDrawn) {
  const std::string text = error_text([] {
    Document document("type = { value = 'R100', source = 's', distribution = {} }", "a.toml");
    Quantities(document.root()).text("type");
    document.finish();
  });
  EXPECT_EQ(text, "a.toml:1:55: type.distribution: a text cannot be drawn");
}

TEST(Uncertainty, UnitsAreThoseOfTheKey) {
  EXPECT_EQ(unit_of_key("chassis.mass_kg"), "kg");
  EXPECT_EQ(unit_of_key("chassis.center_of_mass_mm.x"), "mm");
  EXPECT_EQ(unit_of_key("item.headings_deg[3]"), "deg");
  EXPECT_EQ(unit_of_key("front left/axle.viscous_n_m_s_per_rad"), "N m s/rad");
  EXPECT_EQ(unit_of_key("tread.normal_damping_n_s_per_m"), "N s/m");
  EXPECT_EQ(unit_of_key("tread.normal_stiffness_n_per_m"), "N/m");
  EXPECT_EQ(unit_of_key("brake_torque_n_m"), "N m");
  EXPECT_EQ(unit_of_key("chassis.inertia_kg_m2.y"), "kg m2");
  EXPECT_EQ(unit_of_key("initial.velocity_m_per_s.x"), "m/s");
  EXPECT_EQ(unit_of_key("tread.static_friction"), "1");
}

}  // namespace
}  // namespace gurney::equipment
