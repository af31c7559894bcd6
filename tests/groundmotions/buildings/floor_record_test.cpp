#include "groundmotions/buildings/floor_record.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/base/units.h"
#include "groundmotions/buildings/modal_building.h"
#include "groundmotions/record/record_motion.h"
#include "groundmotions/synthetic/clough_penzien.h"
#include "tests/support/expect_error.h"

namespace gurney::groundmotions {
namespace {

using std::numbers::pi;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

const Record& ground() {
  static const Record kRecord = synthetic_record(shipped_synthetic_motion());
  return kRecord;
}

Building two_storeys() {
  ModalAxis axis = modes_of(Eigen::Vector2d(1, 1), shear_stiffness(Eigen::Vector2d(1, 1)));
  scale_to_period(axis, 0.5);
  set_damping(axis, 0.05);
  const ModalAxis slab = vertical_modes(2, {.floor_omega = 2 * pi * 10,
                                            .column_omega = std::numeric_limits<double>::infinity(),
                                            .damping = 0.03,
                                            .mass_share = 0.6});
  return {"House", 2, {axis, axis, slab}, {}, {}};
}

Building isolated(Isolation isolation) {
  Building building = two_storeys();
  building.isolation = isolation;
  building.isolation->base_mass_ratio = 0.3;
  return building;
}

const Eigen::VectorXd& samples(const Record& record, Direction direction) {
  return record[direction]->acceleration;
}

TEST(FloorRecord, GroundFloorIsTheGround) {
  const Record floor = floor_record(ground(), two_storeys(), 0);
  for (const Direction direction : kDirections)
    EXPECT_EQ(samples(floor, direction), samples(ground(), direction));
  EXPECT_EQ(floor.name, "synthetic 1, floor 0 of House");
  EXPECT_THAT(floor.processing,
              ElementsAre("floor 0 of building 'House' (2 storeys, fixed base; first periods of "
                          "the building above: h1 0.5 s, h2 0.5 s, vertical 0.1 s)"));
}

TEST(FloorRecord, ARigidBuildingMovesAsTheGround) {
  const Building rigid{"Block", 3, {}, {}, {}};
  const Record floor = floor_record(ground(), rigid, 3);
  for (const Direction direction : kDirections)
    EXPECT_EQ(samples(floor, direction).head(ground().samples()), samples(ground(), direction));
}

// A step of 1 m/s2 over the last 101 samples of 5 ms: the ground stops with 0.5 m/s, and the floor
// goes on with them while the building vibrates.
TEST(FloorRecord, ReportsHowFarAResidualVelocityOfTheGroundCarriesTheFloor) {
  EXPECT_THAT(floor_record(ground(), two_storeys(), 2).warnings, IsEmpty());
  Record moving = ground();
  auto& h2 = moving.components[1];
  h2->acceleration.tail(101).setOnes();
  const auto warnings = floor_record(moving, two_storeys(), 2).warnings;
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_THAT(warnings[0], HasSubstr("h2: the ground still moves at 0.5"));
  EXPECT_THAT(warnings[0], HasSubstr("with the step \"baseline kind=end_at_rest\""));
}

// 0.5 s at 8 m/s2 upwards and 0.5 s downwards, which leaves no velocity: a floor of 10 Hz overshoots,
// by its own share, at each step.
TEST(FloorRecord, SaysHowMuchTheFloorAmplifiesTheVertical) {
  Record strong = ground();
  auto& vertical = strong.components[2]->acceleration;
  vertical.setZero();
  vertical.segment(100, 100).setConstant(8);
  vertical.segment(200, 100).setConstant(-8);
  const BuildingResponse response = building_response(strong, two_storeys(), 2);
  const double peak = samples(response.floor, Direction::kVertical).cwiseAbs().maxCoeff();
  ASSERT_FALSE(response.findings.empty());
  EXPECT_EQ(response.findings[0],
            fmt::format("vertical amplified {:.2g} times, to {:.3g} g, by the building's own "
                        "frequency (10 Hz, 3 % damping, assumptions of its file)",
                        peak / 8, peak / kStandardGravity));
  EXPECT_GT(peak, kStandardGravity);
  ASSERT_EQ(response.floor.warnings.size(), 1u);
  EXPECT_EQ(response.floor.warnings[0],
            response.findings[0] + ": above 1 g what stands on the floor leaves it");
  vertical /= 8;
  EXPECT_THAT(floor_record(strong, two_storeys(), 2).warnings, IsEmpty());
}

// On one mode the drift of a storey is the difference of the shape at its floors times the mode's
// displacement; the ratio is that over the storey's height, 10 m.
TEST(FloorRecord, SaysTheLargestStoreyDriftRatio) {
  Building building = two_storeys();
  for (ModalAxis& axis : building.axes) axis.resize(1);
  EXPECT_FALSE(building_response(ground(), building, 2).storey_drift_ratio);
  building.height = 20;
  building.axes[1].clear();
  building.axes[2].clear();
  const Mode& mode = building.axes[0][0];
  const BuildingResponse response = building_response(ground(), building, 1);
  const double step = response.floor.time_step();
  Oscillator oscillator(mode.omega, mode.damping, step);
  const Eigen::VectorXd& input = samples(ground(), Direction::kH1);
  const auto refinement = static_cast<Eigen::Index>(std::lround(ground().time_step() / step));
  double largest = 0;
  for (Eigen::Index i = 0; i + 1 < input.size(); ++i)
    for (Eigen::Index k = 0; k < refinement; ++k) {
      const auto at = [&](Eigen::Index m) {
        return input[i] + (input[i + 1] - input[i]) * static_cast<double>(m) / refinement;
      };
      oscillator.step(-at(k), -at(k + 1));
      largest = std::max(largest, std::abs(oscillator.displacement()));
    }
  const Eigen::VectorXd& shape = mode.effective_shape;
  const double share = std::max(shape[1], shape[2] - shape[1]);
  ASSERT_TRUE(response.storey_drift_ratio);
  EXPECT_NEAR(*response.storey_drift_ratio, share * largest / 10, 1e-9 * largest);
  EXPECT_THAT(response.floor.warnings, IsEmpty());

  building.height = 20 * *response.storey_drift_ratio / 0.02;  // 2 %
  const BuildingResponse low = building_response(ground(), building, 1);
  EXPECT_NEAR(*low.storey_drift_ratio, 0.02, 1e-12);
  ASSERT_EQ(low.floor.warnings.size(), 1u);
  EXPECT_EQ(low.floor.warnings[0],
            "peak storey drift ratio 2 %: the model is elastic; above 1 % a building yields, and "
            "its floors accelerate less");
}

// The building above the isolators, alike: no storey drifts more than the fixed one would, whose
// motion the isolators keep away.
TEST(FloorRecord, AnIsolatedBuildingDriftsLess) {
  Building fixed = two_storeys();
  fixed.height = 6;
  Building above = isolated(linear_isolation(3, 0.1));
  above.height = 6;
  const auto ratio = [](const Building& building) {
    return *building_response(ground(), building, 2).storey_drift_ratio;
  };
  EXPECT_GT(ratio(above), 0);
  EXPECT_LT(ratio(above), 0.8 * ratio(fixed));
}

/// The building of two_storeys() with storeys that yield at this drift.
Building yielding(double drift) {
  Building building = two_storeys();
  building.height = 6;
  YieldingStoreys storeys;
  storeys.mass = Eigen::Vector2d::Ones();
  const double omega = modes_of(storeys.mass, shear_stiffness(storeys.mass)).front().omega;
  storeys.stiffness.fill(Eigen::Vector2d::Constant(std::pow(4 * pi / omega, 2)));
  storeys.damping.fill(Eigen::Vector2d::Constant(0.05));
  storeys.yield_drift = Eigen::Vector2d::Constant(drift);
  storeys.hardening = 0.05;
  building.yielding = storeys;
  return building;
}

// Both are within 0.1 % of the peak: the modes are exact for a ground that is linear between samples,
// and halving the step of the storeys changes their motion by no more.
TEST(FloorRecord, StoreysThatDoNotYieldAreModes) {
  Building modal = two_storeys();
  modal.height = 6;
  const BuildingResponse elastic = building_response(ground(), modal, 2),
                         storeys = building_response(ground(), yielding(1), 2);
  for (const Direction direction : kDirections) {
    const Eigen::VectorXd &a = samples(elastic.floor, direction),
                          &b = samples(storeys.floor, direction);
    const Eigen::Index n = std::min(a.size(), b.size());
    EXPECT_LT((a.head(n) - b.head(n)).cwiseAbs().maxCoeff(), 2e-3 * a.cwiseAbs().maxCoeff());
  }
  ASSERT_TRUE(storeys.storeys);
  EXPECT_LT(storeys.storeys->ductility.maxCoeff(), 0.1);
  EXPECT_LT(*storeys.residual_drift_ratio, 1e-3 * *storeys.storey_drift_ratio);
}

// The roof takes no more than the upper storey's shear over its mass, 1 kg, and its damping force.
TEST(FloorRecord, YieldLimitsTheFloorsAcceleration) {
  Record strong = ground();
  for (auto& component : strong.components)
    if (component) component->acceleration *= 2;
  const Building building = yielding(0.01);
  const YieldingStoreys& storeys = *building.yielding;
  const BuildingResponse found = building_response(strong, building, 2);
  ASSERT_TRUE(found.storeys);
  const double ductility = found.storeys->ductility[1];
  EXPECT_GT(found.storeys->ductility[0], 2);
  const double shear =
      storeys.stiffness[0][1] * 0.01 * (storeys.hardening * ductility + 1 - storeys.hardening);
  const Eigen::VectorXd &h1 = samples(found.floor, Direction::kH1),
                        &h2 = samples(found.floor, Direction::kH2);
  const double peak = (h1.cwiseAbs2() + h2.cwiseAbs2()).cwiseSqrt().maxCoeff();
  EXPECT_LT(peak, 1.25 * shear) << "damping of 5 % takes a tenth of the elastic force, or less";
  const Building modal = two_storeys();
  const double elastic =
      samples(floor_record(strong, modal, 2), Direction::kH1).cwiseAbs().maxCoeff();
  EXPECT_LT(h1.cwiseAbs().maxCoeff(), 0.7 * elastic);
  EXPECT_LT(found.storeys->energy_error, 1e-9);
  EXPECT_LE(found.storeys->change, 1e-3);
  EXPECT_THAT(found.findings.back(), HasSubstr("ductility"));
  EXPECT_THAT(found.floor.processing[0], HasSubstr("storeys yield"));
  ASSERT_TRUE(found.storey_drift_ratio);
  EXPECT_EQ(std::ranges::count_if(found.floor.warnings,
                                  [](const std::string& warning) {
                                    return warning.find("lose them") != std::string::npos;
                                  }),
            *found.storey_drift_ratio > 0.04 ? 1 : 0);
}

// A lead core that yields at 1e-14 m is a spring of 0.06 g / 1e-14 m: steps of some 1e-8 s.
TEST(FloorRecord, RefusesIsolatorsThatNeedTooManySteps) {
  EXPECT_ERROR(building_response(ground(), isolated(lead_rubber(2.5, 0.06, 1e-14, 0.03)), 2),
               "its isolators and shortest period need time steps of");
}

// Each axis alone by ModalResponse, at the finer samples the vertical mode of 0.1 s asks for:
// 0.1 / 20 = 0.005 s is the ground's own step.
TEST(FloorRecord, EachAxisIsItsModalResponse) {
  const Building building = two_storeys();
  const Record floor = floor_record(ground(), building, 2);
  EXPECT_EQ(floor.time_step(), ground().time_step());
  for (const Direction direction : kDirections) {
    ModalResponse response(building[direction], 2, floor.time_step());
    const Eigen::VectorXd& input = samples(ground(), direction);
    for (Eigen::Index i = 0; i + 1 < input.size(); ++i)
      ASSERT_EQ(samples(floor, direction)[i + 1], response.step(input[i], input[i + 1]));
  }
}

TEST(FloorRecord, SamplesAreFineEnoughForTheShortestPeriod) {
  Building building = two_storeys();
  building.axes[2][0].omega = 2 * pi * 25;  // 0.04 s / 20 = 0.002 s: a third of 0.005 s
  const Record floor = floor_record(ground(), building, 1);
  EXPECT_NEAR(floor.time_step(), 0.005 / 3, 1e-15);
  building.axes[2][0].omega = 2 * pi * 1000;  // counts as 1/33 s: 0.0015 s, a quarter
  EXPECT_NEAR(floor_record(ground(), building, 1).time_step(), 0.005 / 4, 1e-15);
}

// The tail: quiet for one period of 1 s at least, and louder than 1 % before that.
TEST(FloorRecord, VibratesOnUntilItIsQuiet) {
  Building building = two_storeys();
  building.axes[2].clear();
  set_damping(building.axes[0], 0.01);
  const Record floor = floor_record(ground(), building, 2);
  ASSERT_GT(floor.samples(), ground().samples() + 200);
  const Eigen::VectorXd& roof = samples(floor, Direction::kH1);
  const double quiet = 0.01 * roof.cwiseAbs().maxCoeff();
  EXPECT_LE(roof.tail(200).cwiseAbs().maxCoeff(), quiet);
  EXPECT_GT(roof.tail(203).cwiseAbs().maxCoeff(), quiet);
  EXPECT_THAT(floor.warnings, IsEmpty());
  EXPECT_EQ(
      floor.processing.back(),
      fmt::format("{:.4g} s of vibration after the ground's last sample; samples every 0.005 s",
                  0.005 * static_cast<double>(floor.samples() - ground().samples())));
}

// Isolators of 3 s: quiet for a period of theirs, 600 samples of 0.005 s, and louder before that.
TEST(FloorRecord, AnIsolatedOneIsQuietForAPeriodOfItsIsolators) {
  Building building = isolated(linear_isolation(3, 0.1));
  building.axes[2].clear();
  Record one = ground();
  one.components[1].reset();
  const Eigen::VectorXd roof = samples(floor_record(one, building, 2), Direction::kH1);
  const double quiet = 0.01 * roof.cwiseAbs().maxCoeff();
  EXPECT_LE(roof.tail(600).cwiseAbs().maxCoeff(), quiet);
  EXPECT_GT(roof.tail(603).cwiseAbs().maxCoeff(), quiet);
}

TEST(FloorRecord, MotionThatNeverEndsIsCut) {
  Building building = two_storeys();
  set_damping(building.axes[0], 0);
  const Record floor = floor_record(ground(), building, 2);
  EXPECT_NEAR(static_cast<double>(floor.samples() - ground().samples()) * 0.005, 120, 0.01);
  EXPECT_THAT(floor.warnings,
              ElementsAre("the floor still moves 120 s after the ground stopped; cut there"));
}

TEST(FloorRecord, ComponentsStayWhatTheyAre) {
  Record one = ground();
  one.components[1].reset();
  one.components[2].reset();
  one.components[0]->azimuth = 1.25;
  const Record floor = floor_record(one, two_storeys(), 1);
  EXPECT_FALSE(floor[Direction::kH2].has_value());
  EXPECT_FALSE(floor[Direction::kVertical].has_value());
  EXPECT_EQ(floor[Direction::kH1]->azimuth, 1.25);
}

TEST(FloorRecord, IsolationIsSolvedToItsAccuracyAndSaysSo) {
  Isolation bearing = lead_rubber(2.5, 0.06, 0.01, 0.03);
  bearing.capacity = 0.1;
  const BuildingResponse response = building_response(ground(), isolated(bearing), 2);
  ASSERT_TRUE(response.isolators.has_value());
  const IsolatorResponse& isolators = *response.isolators;
  EXPECT_LE(isolators.change, 1e-3);
  EXPECT_LT(isolators.energy_error, 1e-9);
  EXPECT_GT(isolators.peak, 0.1);
  EXPECT_EQ(isolators.displacement.cols(), response.floor.samples());
  EXPECT_EQ(isolators.peak, isolators.displacement.colwise().norm().maxCoeff());
  ASSERT_EQ(response.floor.processing.size(), 4U);
  EXPECT_THAT(response.floor.processing[0], HasSubstr("lead rubber isolation"));
  EXPECT_THAT(response.floor.processing[1], HasSubstr("isolators: peak displacement 0."));
  EXPECT_THAT(response.floor.warnings,
              ElementsAre(testing::MatchesRegex(
                  "isolators: peak displacement 0\\..* m exceeds the capacity of 0.1 m; the "
                  "building would strike the moat wall, which is not modelled")));

  // At any order >= 1 the last change bounds what is lacking; steps 16 times as fine lack nothing.
  const Building building = isolated(bearing);
  IsolatedMotion fine(*building.isolation, {building.axes[0], building.axes[1]},
                      isolators.time_step / 16);
  const double h = ground().time_step();
  const auto substeps = static_cast<int>(std::lround(16 * h / isolators.time_step));
  const auto finer = std::lround(h / response.floor.time_step());
  EXPECT_EQ(finer, 4);  // 1 / 33 s / 20 = 1.5 ms
  const auto level = [](const Record& record, Eigen::Index i) {
    return Vector3(samples(record, Direction::kH1)[i], samples(record, Direction::kH2)[i], 0);
  };
  double worst = 0, peak = 0;
  for (Eigen::Index i = 0; i + 1 < ground().samples(); ++i) {
    const Vector3 a = level(ground(), i), b = level(ground(), i + 1);
    for (int j = 0; j < substeps; ++j)
      fine.step(a + (b - a) * j / substeps, a + (b - a) * (j + 1) / substeps);
    const Vector2 exact = fine.floor_acceleration(2);
    worst = std::max(worst, (level(response.floor, finer * (i + 1)).head<2>() - exact).norm());
    peak = std::max(peak, exact.norm());
  }
  EXPECT_LT(worst, isolators.change * peak);
}

// The base floor's acceleration, integrated twice, is where ground and isolators have taken it. The
// straight lines between samples lose h^2 / 12 of the jumps of its rate where the base slips and
// sticks: q v / (u_y base_mass_ratio) = 0.6 x 0.3 / (1e-3 x 0.3) = 600 m/s3 gives 1e-4 m/s at
// h = 1.25 ms; a hundred of either sign in 30 s move the end by some mm. 2 % of the peak is 4 mm.
TEST(FloorRecord, IntegratedBaseMotionIsGroundAndIsolators) {
  for (const Isolation& isolation :
       {lead_rubber(2.5, 0.06, 0.01, 0.03), friction_pendulum(2, 0.03, 0.06, 50, 1e-3)}) {
    const BuildingResponse response = building_response(ground(), isolated(isolation), 0);
    const FloorMotion floor = floor_motion(response.floor);
    const Vector2 end = response.isolators->residual;
    EXPECT_GT(end.norm(), 0.05 * response.isolators->peak) << isolation.name;
    EXPECT_LT((floor.residual_displacement().head<2>() - end).norm(),
              0.02 * response.isolators->peak);
    EXPECT_LT(floor.residual_velocity().head<2>().norm(), 0.01);
  }
}

TEST(FloorRecord, UnloadedPendulumsWarn) {
  Record strong = ground();
  strong.components[2]->acceleration *= 8;
  const Record floor =
      floor_record(strong, isolated(friction_pendulum(2, 0.03, 0.06, 50, 1e-3)), 0);
  EXPECT_THAT(floor.warnings, testing::Contains(HasSubstr("takes all load off (below -1 g)")));
}

/// A modal building of one mode along h1 whose only floor moves as the mode and dips 0.1 rad/m.
Building one_mode() {
  Mode mode;
  mode.omega = 2 * pi / 0.5;
  mode.damping = 0.05;
  mode.effective_shape = Eigen::Vector2d(0, 1);
  mode.effective_rotation = Eigen::Vector2d(0, 0.1);
  mode.effective_mass = 0.9;
  return {"Pole", 1, {ModalAxis{mode}, {}, {}}, {}, {}};
}

// The floor's acceleration without the ground's is u'', the rotation 0.1 u about h2 (a floor that
// dips towards +h1 turns from the vertical towards h1). Of the equation of the mode,
// u'' + 2 zeta w u' + w^2 u = -a, u' is the integral of u'' (its samples by the trapezoidal rule).
TEST(FloorRecord, RotatesWithTheModes) {
  const Record floor = floor_record(ground(), one_mode(), 1);
  ASSERT_TRUE(floor.rotation.has_value());
  EXPECT_EQ(floor.rotation->angle.row(0).cwiseAbs().maxCoeff(), 0);
  const auto acceleration = floor.rotation->acceleration.row(1);
  const Eigen::VectorXd& above = samples(floor, Direction::kH1);
  const Eigen::VectorXd& below = samples(ground(), Direction::kH1);
  const double peak = above.cwiseAbs().maxCoeff(), w = 2 * pi / 0.5;
  ASSERT_EQ(floor.time_step(), ground().time_step());
  double velocity = 0;
  for (Eigen::Index i = 0; i < below.size(); ++i) {
    EXPECT_NEAR(10 * acceleration[i], above[i] - below[i], 1e-12 * peak) << i;
    if (i > 0) velocity += floor.time_step() / 2 * 10 * (acceleration[i - 1] + acceleration[i]);
    const double u = 10 * floor.rotation->angle(1, i);
    // Error of the rule, (w dt)^2 / 12 = 3e-4 of a velocity of the peak over w, at 5 ms.
    EXPECT_NEAR(w * w * u, -above[i] - 2 * 0.05 * w * velocity, 1e-3 * peak) << i;
  }
  EXPECT_THAT(floor.processing.back(), HasSubstr("the floor rotates: peak 0 rad about h1, "));
}

TEST(FloorRecord, RotationIsTurnedWithTheRecord) {
  const Record floor = floor_record(ground(), one_mode(), 1);
  const FloorRotation half = floor_motion(floor, 2, pi / 6).rotation();
  // h2 lies 30 deg beyond the y axis: (-1/2, sqrt(3)/2), times the scale of 2.
  const auto about_h2 = floor.rotation->angle.row(1);
  EXPECT_LT((half.angle.row(0) + about_h2).norm(), 1e-12);
  EXPECT_LT((half.angle.row(1) - std::sqrt(3) * about_h2).norm(), 1e-12);
}

// On stiff isolators the building above moves as on the ground: the layer gives way by
// (w_b / w_i)^2 = 1e-4 of the building's own displacement, which changes its period by as much.
TEST(FloorRecord, FloorsOfIsolatedBuildingsRotate) {
  Building building = one_mode();
  const Record fixed = floor_record(ground(), building, 1);
  building.isolation = linear_isolation(0.005, 0.05);
  building.isolation->base_mass_ratio = 0.3;
  const Record stiff = floor_record(ground(), building, 1);
  ASSERT_TRUE(stiff.rotation.has_value());
  const double peak = fixed.rotation->angle.cwiseAbs().maxCoeff();
  EXPECT_NEAR(stiff.rotation->angle.row(1).cwiseAbs().maxCoeff() / peak, 1, 0.01);
}

TEST(FloorRecord, ALevelBuildingHasNoRotation) {
  EXPECT_FALSE(floor_record(ground(), two_storeys(), 2).rotation.has_value());
  EXPECT_FALSE(floor_record(ground(), one_mode(), 0).rotation.has_value());
  EXPECT_FALSE(floor_motion(floor_record(ground(), two_storeys(), 2)).rotates());
}

TEST(FloorRecord, WarnsOfRotationsThatAreNotSmall) {
  Building building = one_mode();
  building.axes[0][0].effective_rotation *= 100;
  EXPECT_THAT(floor_record(ground(), building, 1).warnings,
              testing::Contains(HasSubstr("the engine takes rotations as small, up to 0.05 rad")));
}

TEST(FloorRecord, RefusesAFloorThatIsNotThere) {
  EXPECT_ERROR(floor_record(ground(), two_storeys(), 3),
               "building 'House' has no floor 3; floors are 0 (the base) to 2 (the roof)");
  EXPECT_ERROR(floor_record(ground(), two_storeys(), -1), "has no floor -1");
  EXPECT_ERROR(floor_record(Record{"empty", {}, {}, {}, {}}, two_storeys(), 1),
               "record 'empty' has no component");
}

}  // namespace
}  // namespace gurney::groundmotions
