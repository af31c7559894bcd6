#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "engine/base/units.h"
#include "studies/job/job.h"
#include "tests/studies/job/job_text.h"
#include "tests/support/error_text.h"

namespace gurney::study {
namespace {

using testing::HasSubstr;

/// Degrees that were radians meanwhile.
testing::Matcher<const std::vector<double>&> are(const std::vector<double>& degrees) {
  return testing::Pointwise(testing::DoubleNear(1e-12 * 360), degrees);
}

constexpr const char* kTwoRigid =
    "schema = \"gurney-job/1\"\n[item]\nequipment = \"ultrasound_two_rigid\"\n";

/// Four casters of R100: `rear left` is rigid and turned by 30 degrees, give or take 5 in a draw.
constexpr const char* kInline = R"(schema = "gurney-job/1"
[item.inline]
name = "cart"
chassis = { mass_kg = 30, center_of_mass_mm = [0, 0, 400], inertia_box_mm = [600, 400, 800] }
shape = [{ center_mm = [0, 0, 400], size_mm = [600, 400, 800] }]
[[item.inline.caster]]
name = "front left"
type = "R100"
position_mm = [250, 150, 0]
[[item.inline.caster]]
name = "front right"
type = "R100"
position_mm = [250, -150, 0]
heading_deg = 20
[[item.inline.caster]]
name = "rear left"
type = "R100"
position_mm = [-250, 150, 0]
swivels = false
heading_deg = { value = 30, distribution = { kind = "uniform", low = 25, high = 35, source = "s" } }
[[item.inline.caster]]
name = "rear right"
type = "R100"
position_mm = [-250, -150, 0]
[item]
)";

std::vector<double> headings_of(const Job& job) {
  std::vector<double> degrees;
  for (const Caster& caster : job.scene.items[0].model.casters)
    degrees.push_back(caster.heading / kRadiansPerDegree);
  return degrees;
}

TEST(CasterOptions, OneHeadingTurnsTheCastersThatSwivel) {
  EXPECT_THAT(headings_of(job_of_text(std::string(kTwoRigid) + "headings_deg = 90\n")),
              are({90, 90, 0, 0}));
  EXPECT_THAT(headings_of(job_of_text(std::string(kInline) + "headings_deg = 90\n")),
              are({90, 90, 30, 90}));
}

TEST(CasterOptions, ADistributionTurnsTheCastersThatSwivel) {
  const std::string drawn = R"([item.headings_deg]
value = 0
distribution = { kind = "uniform", low = -180, high = 180, assumption = "any" }
[uncertainty]
draw = 3
)";
  const Draw draw(1, 3);
  const auto heading = [&](int caster) {
    return -180 + 360 * draw.probability("item.headings_deg[" + std::to_string(caster) + "]");
  };
  const Job job = job_of_text(kTwoRigid + drawn);
  const std::vector<double> headings = headings_of(job);
  EXPECT_DOUBLE_EQ(headings[0], heading(0));
  EXPECT_DOUBLE_EQ(headings[1], heading(1));
  EXPECT_EQ(headings[2], 0);
  EXPECT_EQ(headings[3], 0);
  int drawn_headings = 0;
  for (const equipment::Assumption& each : job.assumptions)
    if (each.key.starts_with("item.headings_deg[") && !each.distribution.empty()) ++drawn_headings;
  EXPECT_EQ(drawn_headings, 2);

  const std::vector<double> mixed = headings_of(job_of_text(kInline + drawn));
  EXPECT_DOUBLE_EQ(mixed[3], heading(3));
  EXPECT_DOUBLE_EQ(mixed[2], 25 + 10 * draw.probability("item.inline.caster[2].heading_deg"));
}

TEST(CasterOptions, AnotherHeadingForARigidCasterIsAnError) {
  EXPECT_EQ(errors_of_text(std::string(kTwoRigid) + "headings_deg = [90, 90, 90, 180]\n"),
            "a.toml:4:25: item.headings_deg[2] = 90: caster 'rear left' of Ultrasound machine on "
            "two rigid wheels and two casters does not swivel: must be its heading there, 0\n"
            "a.toml:4:29: item.headings_deg[3] = 180: caster 'rear right' of Ultrasound machine on "
            "two rigid wheels and two casters does not swivel: must be its heading there, 0");
  EXPECT_THAT(errors_of_text(std::string(kInline) +
                             "headings_deg = { value = [0, 0, 0, 0], source = \"s\" }\n"),
              HasSubstr("item.headings_deg[2] = 0: caster 'rear left' of cart does not swivel: "
                        "must be its heading there, 30"));
}

TEST(CasterOptions, ItsOwnHeadingForARigidCasterIsNone) {
  EXPECT_THAT(
      headings_of(job_of_text(std::string(kTwoRigid) + "headings_deg = [90, -90, 0, 360]\n")),
      are({90, -90, 0, 0}));
  const std::string own = std::string(kInline) + "headings_deg = [1, 2, 30, 4]\n";
  EXPECT_THAT(headings_of(job_of_text(own)), are({1, 2, 30, 4}));
  // In a draw the item's own heading is drawn, and what the job repeats is its value.
  EXPECT_DOUBLE_EQ(headings_of(job_of_text(own + "[uncertainty]\ndraw = 3\n"))[2],
                   25 + 10 * Draw(1, 3).probability("item.inline.caster[2].heading_deg"));
}

TEST(CasterOptions, ALockedSwivelTurnsAsItWasLeftBeforeItWasLocked) {
  const Job job = job_of_text(
      "schema = \"gurney-job/1\"\n[item]\nequipment = \"icu_ventilator\"\nheadings_deg = 90\n"
      "swivel_locks = true\n");
  EXPECT_THAT(headings_of(job), are({90, 90, 90, 90}));
  for (const Caster& caster : job.scene.items[0].model.casters)
    EXPECT_GT(caster.swivel_lock_torque, 0);
}

TEST(CasterOptions, OneLockIsForTheCastersThatSwivel) {
  const Job job = job_of_text(std::string(kTwoRigid) + "swivel_locks = true\n");
  const std::vector<Caster>& casters = job.scene.items[0].model.casters;
  EXPECT_GT(casters[0].swivel_lock_torque, 0);
  EXPECT_EQ(casters[2].swivel_lock_torque, 0);
  EXPECT_TRUE(job.warnings.empty());
  EXPECT_THAT(errors_of_text(std::string(kTwoRigid) + "swivel_locks = [true, true, true, false]\n"),
              HasSubstr("a.toml:4:29: item.swivel_locks[2] = true: caster 'rear left' of "
                        "Ultrasound machine on two rigid wheels and two casters does not swivel, "
                        "or has no lock"));
}

/// A cart whose casters have neither brake nor lock.
std::string plain_cart(bool first_has_brake, bool swivels) {
  std::string text = R"(schema = "gurney-job/1"
[item.inline]
name = "cart"
chassis = { mass_kg = 30, center_of_mass_mm = [0, 0, 400], inertia_box_mm = [600, 400, 800] }
shape = [{ center_mm = [0, 0, 400], size_mm = [600, 400, 800] }]
)";
  const char* const places[] = {"[250, 150, 0]", "[250, -150, 0]", "[-250, 150, 0]",
                                "[-250, -150, 0]"};
  for (int i = 0; i < 4; ++i) {
    text += std::string("[[item.inline.caster]]\nposition_mm = ") + places[i] +
            "\nswivels = " + (swivels ? "true" : "false") + "\n[item.inline.caster.inline]\n" +
            (i == 0 && first_has_brake ? "brake_torque_n_m = 5\n" : "") + R"(name = "plain"
height_mm = 130
wheel_diameter_mm = 100
wheel_width_mm = 30
trail_mm = 30
wheel_mass_kg = 0.3
wheel_inertia_ratio = 0.5
fork_mass_kg = 0.3
fork_center_of_mass_mm = [0, 0, -30]
fork_box_mm = [50, 50, 80]
axle = { coulomb_n_m = 0, viscous_n_m_s_per_rad = 0 }
swivel = { coulomb_n_m = 0, viscous_n_m_s_per_rad = 0 }
[item.inline.caster.inline.tread]
normal_stiffness_n_per_m = 3e5
normal_damping_n_s_per_m = 500
tangential_stiffness_n_per_m = 1e5
tangential_damping_n_s_per_m = 150
relaxation_length_mm = 10
patch_width_mm = 8
rolling_resistance_mm = 1
static_friction = 0.6
kinetic_friction = 0.6
)";
  }
  return text + "[item]\n";
}

TEST(CasterOptions, BrakesThatNoCasterHasAreAnError) {
  EXPECT_EQ(errors_of_text(plain_cart(false, true) + "brakes = false\n"), "(no error)");
  EXPECT_THAT(errors_of_text(plain_cart(false, true) + "brakes = true\n"),
              HasSubstr("item.brakes: has no effect: every caster of cart has no brake "
                        "(brake_torque_n_m of its caster)"));
  // Its value is false, a draw would have set them.
  EXPECT_THAT(
      errors_of_text(plain_cart(false, true) +
                     "brakes = { value = false, distribution = { kind = \"discrete\", values = "
                     "[0, 1], probabilities = [0.5, 0.5], source = \"s\" } }\n"),
      HasSubstr("item.brakes: has no effect"));
  EXPECT_THAT(errors_of_text(plain_cart(true, true) + "brakes = [true, false, true, false]\n"),
              HasSubstr("item.brakes[2] = true: caster 'caster 3' of cart has no brake"));
}

TEST(CasterOptions, BrakesThatSomeCastersHaveNotAreAWarning) {
  const Job job = job_of_text(plain_cart(true, true) + "brakes = true\n");
  EXPECT_GT(job.scene.items[0].model.casters[0].brake_torque, 0);
  EXPECT_EQ(job.scene.items[0].model.casters[1].brake_torque, 0);
  EXPECT_THAT(job.warnings,
              testing::Contains("item.brakes: no effect on caster 'caster 2', which has no brake "
                                "(brake_torque_n_m of its caster)"));
}

TEST(CasterOptions, HalfSetBrakesHoldAShareOfTheirTorque) {
  const std::string cart = plain_cart(true, true);
  const auto torque = [](const Job& job) {
    return job.scene.items[0].model.casters[0].brake_torque;
  };
  EXPECT_EQ(torque(job_of_text(cart + "brakes = true\n")), 5);
  EXPECT_EQ(torque(job_of_text(cart + "brakes = true\nbrake_share = 0.4\n")), 2);
  EXPECT_EQ(torque(job_of_text(cart + "brakes = true\nbrake_share = [0, 1, 1, 1]\n")), 0);
  EXPECT_THAT(errors_of_text(cart + "brakes = true\nbrake_share = 1.2\n"),
              HasSubstr("item.brake_share = 1.2: must be a finite number >= 0 and <= 1"));
  EXPECT_THAT(errors_of_text(cart + "brake_share = 0.5\n"),
              HasSubstr("item.brake_share: has no effect: no brake of cart is on"));
  // Each draw has its own share.
  const std::string drawn =
      cart +
      "brakes = true\nbrake_share = { value = 1, distribution = { kind = \"uniform\", low = "
      "0.3, high = 1, assumption = \"a\" } }\n[uncertainty]\nseed = 1\ndraw = ";
  const double first = torque(job_of_text(drawn + "1\n")),
               second = torque(job_of_text(drawn + "2\n"));
  EXPECT_NE(first, second);
  for (const double found : {first, second}) EXPECT_TRUE(found > 1.5 && found < 5) << found;
}

TEST(CasterOptions, LocksAndHeadingsWhereNothingSwivelsAreErrors) {
  const std::string rigid = plain_cart(false, false);
  EXPECT_THAT(errors_of_text(rigid + "swivel_locks = true\n"),
              HasSubstr("item.swivel_locks: has no effect: every caster of cart does not swivel"));
  EXPECT_THAT(errors_of_text(rigid + "headings_deg = 5\n"),
              HasSubstr("item.headings_deg: has no effect: no caster of cart swivels"));
  EXPECT_EQ(errors_of_text(rigid + "headings_deg = [0, 0, 0, 0]\n"), "(no error)");
}

TEST(CasterOptions, ALockOfARigidCasterInAnItemIsAnError) {
  std::string locked = kInline;
  locked.replace(locked.find("swivels = false"), 15, "swivels = false\nswivel_lock = true");
  EXPECT_EQ(errors_of_text(locked),
            "a.toml:20:15: item.inline.caster[2].swivel_lock: has no effect: the caster does not "
            "swivel (swivels = false)");
}

}  // namespace
}  // namespace gurney::study
