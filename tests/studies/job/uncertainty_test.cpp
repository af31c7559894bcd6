#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <optional>
#include <set>
#include <thread>

#include "engine/base/random/distribution.h"
#include "engine/base/units.h"
#include "equipment/catalogue/catalogue.h"
#include "studies/job/job.h"
#include "studies/prepare/run_job.h"
#include "tests/studies/job/job_text.h"
#include "tests/support/error_text.h"
#include "tests/support/temp_folder.h"

namespace gurney::study {
namespace {

constexpr const char* kHead = "schema = \"gurney-job/1\"\n[item]\nequipment = \"icu_ventilator\"\n";

constexpr const char* kUncertain = R"(
[item.position_m]
value = [0, 0]
source = "plan"
distribution = { y = { kind = "uniform", low = -1, high = 1, assumption = "in the room" } }
[item.yaw_deg]
value = 0
distribution = { kind = "uniform", low = 0, high = 360, assumption = "any" }
[item.headings_deg]
value = 0
distribution = { kind = "uniform", low = 0, high = 360, assumption = "any" }
[item.brakes]
value = false
distribution = { kind = "discrete", values = [0, 1], probabilities = [0.5, 0.5], source = "count" }
)";

Job job_of(const std::string& text) { return job_of_text(kHead + text); }

std::string errors(const std::string& text) {
  return error_text([&] { job_of(text); });
}

std::vector<equipment::Assumption> drawn_in(const Job& job) {
  std::vector<equipment::Assumption> drawn;
  std::copy_if(job.assumptions.begin(), job.assumptions.end(), std::back_inserter(drawn),
               [](const equipment::Assumption& each) { return !each.distribution.empty(); });
  return drawn;
}

double drawn_value(const Job& job, const std::string& key) {
  for (const equipment::Assumption& each : drawn_in(job))
    if (each.key == key) return each.value;
  ADD_FAILURE() << key << " was not drawn";
  return 0;
}

std::size_t braked(const Job& job) {
  const auto& casters = job.scene.items[0].model.casters;
  return static_cast<std::size_t>(std::count_if(
      casters.begin(), casters.end(), [](const Caster& each) { return each.brake_torque > 0; }));
}

TEST(JobDraw, WithoutItEveryNumberHasItsValue) {
  const Job job = job_of(kUncertain);
  EXPECT_FALSE(job.draw);
  EXPECT_TRUE(drawn_in(job).empty());
  EXPECT_EQ(job.scene.items[0].model.chassis_mass, 30);
  EXPECT_EQ(job.scene.items[0].initial.position, Vector3(0, 0, 0));
  EXPECT_EQ(job.scene.items[0].initial.yaw, 0);
  for (const Caster& caster : job.scene.items[0].model.casters) {
    EXPECT_EQ(caster.heading, 0);
    EXPECT_EQ(caster.brake_torque, 0);
    EXPECT_DOUBLE_EQ(caster.tread.rolling_friction_length, 0.001);
  }
}

TEST(JobDraw, ReachesTheItemItsCastersItsFloorAndItsPlace) {
  const Job job =
      job_of(std::string(kUncertain) + "[uncertainty]\nseed = 5\ndraw = 2\n[floor.slope]\n" +
             "value = 0\ndistribution = { kind = 'uniform', low = -0.01, high = 0.01, source = "
             "'survey' }\n");
  const Draw draw(5, 2);
  EXPECT_EQ(
      job.scene.items[0].model.chassis_mass,
      Distribution::lognormal(30, 0.15, 27, 45).quantile(draw.probability("chassis.mass_kg")));
  EXPECT_EQ(job.scene.items[0].initial.position,
            Vector3(0, -1 + 2 * draw.probability("item.position_m.y"), 0));
  EXPECT_EQ(job.scene.items[0].initial.yaw,
            360 * draw.probability("item.yaw_deg") * kRadiansPerDegree);
  EXPECT_EQ(job.scene.slope, -0.01 + 0.02 * draw.probability("floor.slope"));
  const EquipmentModel& item = job.scene.items[0].model;
  for (std::size_t i = 0; i < item.casters.size(); ++i) {
    const std::string index = "[" + std::to_string(i) + "]", name = item.casters[i].name;
    EXPECT_EQ(item.casters[i].heading,
              360 * draw.probability("item.headings_deg" + index) * kRadiansPerDegree);
    EXPECT_EQ(item.casters[i].brake_torque > 0, draw.probability("item.brakes" + index) > 0.5);
    EXPECT_EQ(item.casters[i].tread.patch_width,
              drawn_value(job, name + "/tread.patch_width_mm") / kMillimetersPerMeter);
    EXPECT_EQ(item.casters[i].tread.static_friction,
              drawn_value(job, "front left/tread.static_friction"));
  }
  // mass, three of the centre of mass; y, yaw, slope; for each caster heading, brake, its torque, on
  // or off, and nine.
  EXPECT_EQ(job.scene.cross_slope, 0);
  EXPECT_EQ(drawn_in(job).size(), 4u + 3 + 4 * 12);
}

TEST(JobDraw, AModelIsSampledWithoutItsFiles) {
  namespace fs = std::filesystem;
  const std::string draw = "[uncertainty]\nseed = 5\ndraw = 7\n";
  const Job expected = job_of(std::string(kUncertain) + draw);
  const TempFolder folder;
  fs::copy(equipment::data_folder() + "/equipment", folder.path() + "/equipment",
           fs::copy_options::recursive);
  setenv("GURNEY_DATA", folder.path().c_str(), 1);
  std::optional<JobModel> model;
  {
    config::Document document(std::string(kHead) + kUncertain, "a.toml");
    model.emplace(document);
  }
  fs::remove_all(folder.path() + "/equipment");
  const Job other = sample(*model, Draw(5, 8)), drawn = sample(*model, Draw(5, 7));
  unsetenv("GURNEY_DATA");
  EXPECT_NE(other.scene.items[0].model.chassis_mass, expected.scene.items[0].model.chassis_mass);
  ASSERT_EQ(drawn.assumptions.size(), expected.assumptions.size());
  for (std::size_t i = 0; i < drawn.assumptions.size(); ++i) {
    EXPECT_EQ(drawn.assumptions[i].key, expected.assumptions[i].key);
    EXPECT_EQ(drawn.assumptions[i].streams, expected.assumptions[i].streams);
    if (drawn.assumptions[i].choice.empty()) {
      EXPECT_EQ(drawn.assumptions[i].value, expected.assumptions[i].value);
    }
  }
}

TEST(JobDraw, TakesTheFloorOutOfLevelUnlessTheJobStatesASlope) {
  const std::string draw = "[uncertainty]\nseed = 5\ndraw = 2\n";
  const Distribution slope = Distribution::normal(0, 0.0017, -0.005, 0.005);
  const Job drawn = job_of(draw);
  EXPECT_EQ(drawn.scene.slope, slope.quantile(Draw(5, 2).probability("floor/slope")));
  EXPECT_EQ(drawn.scene.cross_slope, slope.quantile(Draw(5, 2).probability("floor/cross_slope")));
  for (const char* stated : {"[floor]\nslope = 0\n", "[floor]\ncross_slope = 0\n"}) {
    EXPECT_EQ(job_of(draw + stated).scene.slope, 0);
    EXPECT_EQ(job_of(draw + stated).scene.cross_slope, 0);
  }
  const Job level = job_of("");
  EXPECT_EQ(level.scene.slope, 0);
  EXPECT_EQ(level.scene.cross_slope, 0);
}

TEST(JobDraw, BrakesOfAnItemAreAlikeAndNotTheSame) {
  const Job job = job_of("brakes = true\n[uncertainty]\ndraw = 2\n");
  const auto& casters = job.scene.items[0].model.casters;
  const Distribution torque = Distribution::lognormal(10, 0.6, 2.5, 30);
  for (const Caster& caster : casters)
    EXPECT_EQ(caster.brake_torque, torque.quantile(Draw(1, 2).probability(
                                       caster.name + "/brake_torque_n_m", {"brake torque", 0.8})));
  EXPECT_NE(casters[0].brake_torque, casters[1].brake_torque);
}

// A study stores the numbers of a draw by their places in this list.
TEST(JobDraw, HasTheSameNumbersInEveryDrawWhateverIsSwitchedOn) {
  const auto draw = [](int number) {
    return job_of(kUncertain + fmt::format("[uncertainty]\ndraw = {}\n", number));
  };
  const auto names = [](const Job& job) {
    std::vector<std::string> all;
    for (const equipment::Assumption& each : drawn_in(job)) all.push_back(each.key);
    return all;
  };
  const std::vector<std::string> first = names(draw(0));
  std::set<std::size_t> numbers_of_brakes;
  for (int number = 0; number < 8; ++number) {
    const Job job = draw(number);
    EXPECT_EQ(names(job), first) << number;
    numbers_of_brakes.insert(braked(job));
    std::size_t in_use = 0;
    for (const equipment::Assumption& each : drawn_in(job))
      in_use += each.in_use && each.key.ends_with("/brake_torque_n_m");
    EXPECT_EQ(in_use, braked(job)) << number;
  }
  EXPECT_GT(numbers_of_brakes.size(), 1u);
}

TEST(JobDraw, StreamsAreThoseOfWhatIsUsed) {
  const auto uses = [](const std::string& text, const std::string& stream) {
    for (const equipment::Assumption& each : job_of(text + "[uncertainty]\ndraw = 2\n").assumptions)
      if (each.streams.contains(stream)) return true;
    return false;
  };
  EXPECT_TRUE(uses("brakes = true\n", "group brake torque"));
  EXPECT_TRUE(uses("brakes = true\n", "variable rear left/brake_torque_n_m"));
  EXPECT_FALSE(uses("brakes = false\n", "group brake torque"));
  EXPECT_TRUE(uses("brakes = false\n", "variable floor/cross_slope"));
}

TEST(JobDraw, ReplacedCastersAreDrawnForEachPlace) {
  const Job job = job_of("casters = \"R125\"\n[uncertainty]\ndraw = 1\n");
  const std::vector<Caster>& casters = job.scene.items[0].model.casters;
  EXPECT_EQ(casters[0].wheel_radius, 0.0625);
  EXPECT_NE(casters[0].tread.rolling_friction_length, casters[1].tread.rolling_friction_length);
  EXPECT_EQ(casters[3].tread.rolling_friction_length,
            drawn_value(job, "rear right/tread.rolling_resistance_mm") / kMillimetersPerMeter);
}

TEST(JobDraw, ReachesTheFloorCovering) {
  const TempFolder folder;
  folder.write("soft.toml", R"(schema = "gurney-floor/1"
name = "soft"
rolling_resistance_factor = { value = 1, distribution = { kind = "uniform", low = 1, high = 3, source = "s" } }
friction_factor = 1
)");
  const auto resistance_in = [&](const std::string& covering) {
    return read_job(folder.write("job.toml",
                                 std::string(kHead) + "[uncertainty]\ndraw = 2\n" + covering))
        .scene.items[0]
        .model.casters[0]
        .tread.rolling_friction_length;
  };
  const double factor = 1 + 2 * Draw(1, 2).probability("floor/rolling_resistance_factor");
  EXPECT_EQ(resistance_in("[floor]\ncovering = \"soft.toml\"\n"), resistance_in("") * factor);
}

TEST(JobDraw, IsTheSameOnEveryThread) {
  const std::string text = std::string(kUncertain) + "[uncertainty]\ndraw = ";
  std::vector<std::vector<double>> first(6), second(6);
  const auto values = [&](int draw) {
    std::vector<double> list;
    for (const equipment::Assumption& each : drawn_in(job_of(text + std::to_string(draw) + "\n")))
      list.push_back(each.value);
    return list;
  };
  std::thread upwards([&] {
    for (int draw = 0; draw < 6; ++draw) first[static_cast<std::size_t>(draw)] = values(draw);
  });
  for (int draw = 6; draw-- > 0;) second[static_cast<std::size_t>(draw)] = values(draw);
  upwards.join();
  EXPECT_EQ(first, second);
  EXPECT_NE(first[0], first[1]);
}

TEST(JobDraw, SaysWhatIsWrong) {
  EXPECT_EQ(errors("[uncertainty]\n"),
            "a.toml:4:1: uncertainty.draw: missing; must be a whole number in 0..2147483647");
  EXPECT_EQ(errors("[uncertainty]\ndraw = -1\nsede = 3\n"),
            "a.toml:5:8: uncertainty.draw = -1: must be a whole number in 0..2147483647\n"
            "a.toml:6:1: uncertainty.sede: unknown key; did you mean 'seed'?");
  EXPECT_EQ(errors("brakes = { value = [true], source = 's' }\n"),
            "a.toml:4:20: item.brakes.value = [true]: must be an array of 4 times true or false");
  EXPECT_EQ(errors("headings_deg = { value = 1 }\n"),
            "a.toml:4:16: item.headings_deg: must have a source, an assumption with its range, or "
            "both");
}

TEST(JobDraw, GoesIntoTheFactsOfTheRun) {
  const TempFolder folder;
  const PreparedRun run = prepare_run(
      folder.write("a.toml", std::string(kHead) + kUncertain + "[uncertainty]\ndraw = 3\n"));
  ASSERT_TRUE(run.facts.draw);
  EXPECT_EQ(run.facts.draw->text(), "draw 3 of seed 1");
  const auto fact = [&](const std::string& variable) {
    const auto& list = run.facts.drawn;
    return *std::find_if(list.begin(), list.end(),
                         [&](const DrawnFacts& each) { return each.variable == variable; });
  };
  EXPECT_EQ(fact("chassis.mass_kg").value, run.facts.scene.items[0].model.chassis_mass);
  EXPECT_EQ(fact("chassis.mass_kg").unit, "kg");
  EXPECT_EQ(fact("chassis.mass_kg").file, "icu_ventilator.toml");
  EXPECT_EQ(fact("item.yaw_deg").distribution, "uniform, 0 to 360");
  EXPECT_EQ(fact("rear left/tread.static_friction").unit, "1");
  // The brakes have a source, all else is assumed.
  for (const AssumptionFacts& each : run.facts.assumptions)
    EXPECT_FALSE(each.key.starts_with("item.brakes")) << each.key;
  EXPECT_TRUE(std::any_of(run.facts.assumptions.begin(), run.facts.assumptions.end(),
                          [](const AssumptionFacts& each) { return each.key == "item.yaw_deg"; }));
}

TEST(ShippedJob, DrawsTheVentilator) {
  const Job job = read_job(GURNEY_SOURCE_DIR "/studies/jobs/icu_ventilator_draw.toml");
  // mass, three of the centre of mass; yaw; two of the slope; for each caster heading, brake and
  // nine constants, and the torque of a brake that is on.
  EXPECT_EQ(drawn_in(job).size(), 4u + 1 + 2 + 4 * 11 + braked(job));
  for (const Caster& caster : job.scene.items[0].model.casters)
    EXPECT_EQ(caster.brake_torque > 0, job.scene.items[0].model.casters[0].brake_torque > 0);
}

TEST(JobVariant, ChangesTheItem) {
  EXPECT_EQ(job_of("").scene.items[0].model.casters[0].brake_torque, 0);
  for (const char* text : {"variant = \"brakes on\"\n", "variant = [\"brakes on\"]\n"}) {
    const Job job = job_of(text);
    for (const Caster& caster : job.scene.items[0].model.casters) EXPECT_GT(caster.brake_torque, 0);
  }
  EXPECT_EQ(job_of("variant = []\n").scene.items[0].model.casters[0].brake_torque, 0);  // as it is
  // What the job itself says comes after the variant.
  EXPECT_EQ(job_of("variant = \"brakes on\"\nbrakes = false\n")
                .scene.items[0]
                .model.casters[0]
                .brake_torque,
            0);
}

TEST(JobVariant, NamesTheNearest) {
  EXPECT_EQ(errors("variant = \"brake on\"\n"),
            "a.toml:4:11: item.variant: the item has no variant 'brake on'; did you mean 'brakes "
            "on'?");
  EXPECT_THAT(errors("variant = 3\n"),
              testing::HasSubstr("a.toml:4:11: item.variant = 3: must be a text or an array"));
  EXPECT_THAT(
      errors_of_text("schema = \"gurney-job/1\"\n[item]\nvariant = \"full\"\n[item.inline]\n"),
      testing::HasSubstr("a.toml:3:11: item.variant: only an item with a file of its own "
                         "has variants"));
}

}  // namespace
}  // namespace gurney::study
