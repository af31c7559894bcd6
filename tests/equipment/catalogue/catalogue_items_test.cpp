#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>

#include "engine/base/units.h"
#include "engine/config/document.h"
#include "engine/run/simulate.h"
#include "equipment/catalogue/catalogue.h"
#include "equipment/catalogue/load_item.h"
#include "equipment/catalogue/support.h"
#include "tests/support/standing.h"

// What every shipped item must be: found by a hospital's word for it, stable as IEC 60601-1 asks,
// at rest on the floor, and coming to rest after a push.
namespace gurney::equipment {
namespace {

constexpr double kG = kStandardGravity;

ItemDescription describe(const std::string& name) {
  return load_item_description(find_data(DataKind::kItem, name, "")).stated();
}

class EveryItem : public testing::TestWithParam<std::string> {};
INSTANTIATE_TEST_SUITE_P(Catalogue, EveryItem, testing::ValuesIn(catalogue_names(DataKind::kItem)),
                         [](const auto& test) { return test.param; });

TEST(CatalogueItems, HasWhatHospitalsAskFor) {
  const std::vector<std::string> names = catalogue_names(DataKind::kItem);
  for (const char* wanted : {"icu_ventilator",
                             "transport_incubator",
                             "neonatal_incubator",
                             "infant_warmer",
                             "anaesthesia_workstation",
                             "ultrasound_two_rigid",
                             "ultrasound_four_swivel",
                             "infusion_pole",
                             "patient_monitor_stand",
                             "icu_bed",
                             "hospital_bed",
                             "crash_cart",
                             "medication_cart",
                             "dialysis_machine",
                             "mobile_xray",
                             "instrument_trolley",
                             "dressing_trolley",
                             "defibrillator_cart",
                             "linen_cart",
                             "overbed_table",
                             "bookcase",
                             "filing_cabinet",
                             "storage_shelving",
                             "portable_monitor",
                             "infusion_pump"})
    EXPECT_TRUE(std::count(names.begin(), names.end(), wanted)) << wanted;
  EXPECT_GE(catalogue_names(DataKind::kCaster).size(), 8u);
  EXPECT_GE(catalogue_names(DataKind::kFloor).size(), 6u);
}

TEST(CatalogueItems, NamesAreUnique) {
  for (const DataKind kind :
       {DataKind::kItem, DataKind::kCaster, DataKind::kFloor, DataKind::kRoom, DataKind::kTether}) {
    std::set<std::string> seen;
    for (const std::string& file : catalogue_names(kind)) {
      const config::Document document(find_data(kind, file, ""));
      const std::string& name = document.tree().find("name")->text;
      EXPECT_TRUE(seen.insert(name).second) << file << ": '" << name << "' is taken";
    }
  }
}

TEST(CatalogueItems, ForksAndWheelsAreOfTheKindTheirItemsSay) {
  // Two rigid wheels, four swivels, five legs, rigid drive wheels that brake by themselves.
  const auto swivels = [](const std::string& name) {
    const std::vector<CasterPlace> casters = describe(name).casters;
    return std::count_if(casters.begin(), casters.end(),
                         [](const CasterPlace& caster) { return caster.swivels; });
  };
  EXPECT_EQ(swivels("ultrasound_two_rigid"), 2);
  EXPECT_EQ(swivels("ultrasound_four_swivel"), 4);
  EXPECT_EQ(swivels("infusion_pole"), 5);
  for (const CasterPlace& caster : describe("icu_bed").casters)
    EXPECT_TRUE(caster.brake_on && caster.swivel_locked) << caster.name;
  for (const CasterPlace& caster : describe("mobile_xray").casters)
    EXPECT_EQ(caster.brake_on, !caster.swivels) << caster.name;
}

// IEC 60601-1: a tilt of 10 degrees in the transport position with its payloads and without, with
// the casters turned the worst way; 5 degrees without casters. Swivels that a central lock holds
// are released for it.
TEST_P(EveryItem, StandsTheTiltOfItsStandard) {
  const ItemDescription item = describe(GetParam());
  ItemOptions released, empty;
  released.swivel_locks.assign(item.casters.size(), false);
  empty.swivel_locks = released.swivel_locks;
  for (const PayloadKind& payload : item.payloads) empty.payloads[payload.name] = 0;
  const double asked = (item.casters.empty() ? 5 : 10) * kRadiansPerDegree;
  for (const ItemOptions& options : {released, empty}) {
    const LoadedItem loaded = assemble_item(item, options);
    EXPECT_GE(stability_of(loaded.model).tilt, asked);
    EXPECT_EQ(loaded.warnings, std::vector<std::string>{});
  }
}

TEST_P(EveryItem, HasABaseThatIsBiggerThanItsTrailsAndLoadsEveryWheel) {
  const LoadedItem item = assemble_item(describe(GetParam()));
  const Stability stability = stability_of(item.model);
  EXPECT_GT(stability.base, 0);
  for (std::size_t i = 0; i < item.model.casters.size(); ++i) {
    EXPECT_GT(stability.base, item.model.casters[i].trail) << item.model.casters[i].name;
    EXPECT_GT(stability.wheel_loads[i], 0) << item.model.casters[i].name;
  }
}

TEST_P(EveryItem, KeepsItsMassInsideItsShape) {
  const LoadedItem item = assemble_item(describe(GetParam()));
  const Vector3 center = whole_item(item.model).center_of_mass;
  Vector3 low = item.model.shape[0].center, high = low;
  for (const BodyShape& box : item.model.shape) {
    low = low.cwiseMin(box.center - box.size / 2);
    high = high.cwiseMax(box.center + box.size / 2);
  }
  EXPECT_TRUE((low.array() < center.array()).all() && (center.array() < high.array()).all())
      << center.transpose();
  if (item.model.casters.empty())
    EXPECT_NEAR(low.z(), 0, 1e-12) << "it does not stand on the floor";
  else
    EXPECT_GT(low.z(), 0) << "the chassis is in the floor";
}

SimulationSettings settings(double duration) {
  SimulationSettings settings;
  settings.duration = duration;
  settings.history_step = 1;
  return settings;
}

/// On a floor of 0.5 %, which is below every Cr / R.
Scene on_slope(const std::string& name) {
  Scene scene = standing(assemble_item(describe(name)));
  scene.slope = 0.005;
  return scene;
}

// IEC 60601-1, in any position but transport: a slope of 5 degrees, uphill and across, brakes on.
TEST_P(EveryItem, StaysUprightOnASlopeOfFiveDegrees) {
  const ItemDescription description = describe(GetParam());
  ItemOptions options;
  for (const CasterPlace& place : description.casters) {
    options.brakes.push_back(place.type.brake_torque > 0);
    options.swivel_locks.push_back(place.type.swivel_lock_torque > 0);
  }
  for (const double yaw : {0.0, 90.0, 180.0, 270.0}) {
    Scene scene = standing(assemble_item(description, options));
    scene.slope = std::tan(5 * kRadiansPerDegree);
    scene.items[0].initial.yaw = yaw * kRadiansPerDegree;
    const Response response = simulate(scene, {}, settings(2));
    ASSERT_EQ(response.outcome, Outcome::kStopped) << yaw << ": " << response.cause;
    EXPECT_LT(response.items[0].demands.peak_tilt, 1 * kRadiansPerDegree) << yaw;
  }
}

// As parked, all casters along the slope: the start is the equilibrium, and the rolling resistance
// alone holds.
TEST_P(EveryItem, StaysWhereItIsParked) {
  const Response response = simulate(on_slope(GetParam()), {}, settings(2));
  ASSERT_EQ(response.outcome, Outcome::kStopped) << response.cause;
  EXPECT_LT(response.items[0].demands.peak_displacement, 1e-6);
  EXPECT_LT(std::abs(response.items[0].history.back().displacement.z()), 1e-6);
}

// With the casters as somebody left them the forks first turn by the wind-up of their scrub, which
// rolls the item some millimetres; then it holds.
TEST_P(EveryItem, HoldsWithItsCastersAnyhow) {
  Scene scene = on_slope(GetParam());
  const double headings[] = {0.3, 1.6, 2.8, 5.2, 4.0};
  for (std::size_t i = 0; i < scene.items[0].model.casters.size(); ++i)
    if (scene.items[0].model.casters[i].swivels)
      scene.items[0].model.casters[i].heading = headings[i];
  const Response response = simulate(scene, {}, settings(20));
  ASSERT_EQ(response.outcome, Outcome::kStopped) << response.cause;
  const Sample &middle = response.items[0].history[10], &end = response.items[0].history.back();
  EXPECT_LT(response.items[0].demands.peak_displacement, 0.01);
  EXPECT_LT((end.displacement - middle.displacement).norm(), 1e-6);
  EXPECT_LT(std::abs(end.yaw - middle.yaw), 1e-6);
}

// A push of 0.4 m/s. Every metre takes at least W min(Cr / R) of the M v^2 / 2, so it stops within
// v^2 / (2 g min(Cr / R)); the wheels' own spin adds sum I_w / R^2 to M, less than a tenth.
TEST_P(EveryItem, ComesToRestAfterAPush) {
  constexpr double kSpeed = 0.4;
  Scene scene = standing(assemble_item(describe(GetParam())));
  if (scene.items[0].model.casters.empty()) GTEST_SKIP() << "it does not roll: see feet_test.cpp";
  scene.items[0].initial.velocity = Vector3(kSpeed, kSpeed, 0) / std::sqrt(2.0);
  double least = 1;
  for (const Caster& caster : scene.items[0].model.casters)
    least = std::min(least, caster.tread.rolling_friction_length / caster.wheel_radius);
  SimulationSettings until_rest = settings(0);
  const Response response = simulate(scene, {}, until_rest);
  ASSERT_EQ(response.outcome, Outcome::kRested) << response.cause;
  EXPECT_LT(response.items[0].demands.path_length, 1.1 * kSpeed * kSpeed / (2 * kG * least));
  EXPECT_LT(response.items[0].demands.peak_tilt, 5 * kRadiansPerDegree);
  EXPECT_LT(response.quality.energy_closure, 1e-3);
  EXPECT_EQ(response.quality.unconverged_steps, 0);
}

TEST_P(EveryItem, ComesToRestAfterItWasPushedOver) {
  Scene scene = standing(assemble_item(describe(GetParam())));
  const MassProperties whole = whole_item(scene.items[0].model);
  // Its weight, or twice that, for a second, sideways above its centre of mass.
  for (const double weights : {1, 2}) {
    SCOPED_TRACE(weights);
    const double force = weights * whole.mass * kG;
    scene.items[0].loads = {PointForce{"push",
                                       whole.center_of_mass + Vector3(0, 0, 0.3),
                                       {-0.17, 0.98, 0},
                                       {0, 1},
                                       {force, force}}};
    const Response response = simulate(scene, {}, settings(0));
    EXPECT_TRUE(response.outcome == Outcome::kOverturned || response.outcome == Outcome::kRested)
        << name_of(response.outcome) << " " << response.cause;
    EXPECT_LT(response.end_time, 30);
    EXPECT_EQ(response.quality.unconverged_steps, 0);
    // Wheels that go from their tread to their side: Limitations in docs/theory/impact.md.
    EXPECT_LT(response.quality.energy_closure, 0.005);
  }
}

}  // namespace
}  // namespace gurney::equipment
