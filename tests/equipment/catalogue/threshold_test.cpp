#include "tests/equipment/catalogue/threshold.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <sstream>
#include <vector>

#include "equipment/catalogue/support.h"

// Every item on casters over the thresholds of IEC 60601-1, and the table of docs/equipment.md.
namespace gurney::equipment::threshold {
namespace {

bool is_on_casters(const std::string& name) {
  return !load_item_description(find_data(DataKind::kItem, name, "")).stated().casters.empty();
}

SimulationSettings settings(double time_step) {
  SimulationSettings settings;
  settings.time_step = time_step;
  settings.history_step = 1;
  return settings;
}

const char* word(Verdict verdict) {
  return verdict == Verdict::kPasses  ? "passes"
         : verdict == Verdict::kStops ? "stops"
                                      : "overturns";
}

/// Energy that the item must have got to fall, at least [J]: the centre of mass goes over the
/// nearest edge of support, M g (sqrt(b^2 + h^2) - h), whatever edge of the obstruction it is that
/// holds the wheel (an edge above the floor makes it more).
double energy_to_fall(const EquipmentModel& model) {
  const Stability stability = stability_of(model);
  const double b = stability.base, h = stability.height;
  return whole_item(model).mass * kStandardGravity * (std::hypot(b, h) - h);
}

/// Motion at the start [J]: wheels roll.
double energy_at_start(const EquipmentModel& model, double speed) {
  double inertia = whole_item(model).mass;
  for (const Caster& c : model.casters)
    inertia += c.wheel_axial_inertia / (c.wheel_radius * c.wheel_radius);
  return inertia * speed * speed / 2;
}

/// Restitution of a mass on springs k with dampers c that at most double or cancel their force
/// (docs/theory/tread.md), from the touch to the end of the force, in steps of 1/2000 of its phase.
double rebound(double mass, double k, double c) {
  const double omega = std::sqrt(k / mass), h = 5e-4 / omega;
  double depth = 0, speed = 1;
  do {
    const double elastic = k * depth;
    speed -= h / mass * (elastic + std::clamp(c * speed, -elastic, elastic));
    depth += h * speed;
  } while (depth > 0 && k * depth + c * speed > 0);
  return std::max(0.0, -speed);
}

/// An item whose front wheels are stopped at their axles (Mallet 1862) turns about them with w = M v
/// h' / I and keeps the share kappa = h'^2 M / I of its energy; its centre must rise from h' to r, so
/// that v = sqrt(2 g (r - h') I / M) / h', with b from the axles to the centre, h' above them,
/// r^2 = b^2 + h'^2 and I about the axles.
///
/// That is an impact without rebound. Treads are springs: the rest of the energy, 1 - kappa of it,
/// is stored in those of the front wheels, at the kerb and on the floor, and they give back the
/// share e^2 of it, e being largest for the mode of the largest mass, M. What an item has then must
/// still lift its centre:
///
///     v^2 (kappa + e^2 (1 - kappa)) >= kappa v_Mallet^2
///
/// A tall item keeps most of its energy anyhow and needs 0.7 to 0.88 of Mallet's speed at least; a
/// hospital bed keeps an eighth, and half comes back: it is thrown up and turns over its rear.
struct Tripping {
  double speed = 0, b = 0, height = 0, radius = 0;  // of the item, radius of its front wheels
  double least = 0;                                 // speed below which it cannot fall
};

Tripping tripping(const EquipmentModel& model) {
  const MassProperties whole = whole_item(model);
  Tripping result;
  const auto axle = [](const Caster& c) { return c.mount.x() - c.trail * std::cos(c.heading); };
  double front = -1e9, stiffness = 0, damping = 0;
  for (const Caster& c : model.casters) {
    front = std::max(front, axle(c));
    result.radius = std::max(result.radius, c.wheel_radius);
  }
  for (const Caster& c : model.casters)
    if (axle(c) > front - c.wheel_radius) {
      stiffness += c.tread.normal_stiffness;
      damping += c.tread.normal_damping;
    }
  result.b = front - whole.center_of_mass.x();
  result.height = whole.center_of_mass.z() - result.radius;
  const double r = std::hypot(result.b, result.height);
  const double inertia = whole.inertia(1, 1) / whole.mass + r * r;
  result.speed = std::sqrt(2 * kStandardGravity * (r - result.height) * inertia) / result.height;
  const double kappa = result.height * result.height / inertia;
  const double e = rebound(whole.mass, stiffness, damping);
  result.least = result.speed * std::sqrt(kappa / (kappa + e * e * (1 - kappa)));
  return result;
}

/// Cells of the item's row below "## Over a threshold".
std::vector<std::string> row_of_page(const std::string& name) {
  std::ifstream page(GURNEY_SOURCE_DIR "/docs/equipment.md");
  bool inside = false;
  for (std::string line; std::getline(page, line);) {
    if (line.rfind("## ", 0) == 0) inside = line == "## Over a threshold";
    if (!inside || line.rfind("| `" + name + "` |", 0) != 0) continue;
    std::istringstream text(line.substr(2));
    std::vector<std::string> cells;
    for (std::string cell; std::getline(text, cell, '|');) {
      const std::size_t first = cell.find_first_not_of(' '), last = cell.find_last_not_of(' ');
      cells.push_back(first == std::string::npos ? "" : cell.substr(first, last + 1 - first));
    }
    return cells;
  }
  return {};
}

class OverAThreshold : public testing::TestWithParam<std::string> {
 protected:
  void SetUp() override {
    if (!is_on_casters(GetParam())) GTEST_SKIP() << "it stands on feet";
  }
};
INSTANTIATE_TEST_SUITE_P(Catalogue, OverAThreshold,
                         testing::ValuesIn(catalogue_names(DataKind::kItem)),
                         [](const auto& test) { return test.param; });

TEST_P(OverAThreshold, DoesWhatThePageSaysAndItsEnergyAllows) {
  const std::vector<std::string> row = row_of_page(GetParam());
  std::string made = fmt::format("`{}`", GetParam());
  std::vector<double> tilts;
  std::vector<Verdict> verdicts;
  for (const auto& [threshold, pushed] : {std::pair(kLow, true), std::pair(kHigh, true),
                                          std::pair(kLow, false), std::pair(kHigh, false)}) {
    SCOPED_TRACE(fmt::format("{} mm, {}", kMillimetersPerMeter * threshold.height,
                             pushed ? "pushed" : "let go"));
    const Trial run = trial(GetParam(), threshold, pushed);
    const EquipmentModel& model = run.scene.items[0].model;
    if (tilts.empty()) made += fmt::format(" | {:.0f} | {:.0f}", whole_item(model).mass, run.push);
    const Response response = simulate(run.scene, {}, settings(0.002));
    ASSERT_TRUE(response.outcome == Outcome::kRested || response.outcome == Outcome::kOverturned)
        << name_of(response.outcome) << " " << response.cause;
    EXPECT_EQ(response.quality.unconverged_steps, 0);
    const Verdict found = verdict(run, response);
    // Wheels that roll over an edge meet a plane in each step: Limitations in docs/theory/impact.md.
    // All are below 0.002, also of items that overturn.
    EXPECT_LT(response.quality.energy_closure, 0.003);

    const ItemResponse& item = response.items[0];
    if (found == Verdict::kFalls)
      EXPECT_GT(energy_at_start(model, threshold.speed) + item.energy.work_of_forces,
                energy_to_fall(model));
    else
      EXPECT_LT(item.demands.peak_tilt, 20 * kRadiansPerDegree) << "it came back from there";
    EXPECT_TRUE(pushed || found != Verdict::kFalls);
    if (pushed) made += fmt::format(" | {}", word(found));
    verdicts.push_back(found);
    tilts.push_back(item.demands.peak_tilt / kRadiansPerDegree);
  }
  made +=
      fmt::format(" | {:.1f}", tripping(trial(GetParam(), kLow, false).scene.items[0].model).speed);
  const bool falls = verdicts[0] == Verdict::kFalls;
  const std::string expected =
      fmt::format("{} | {} |", made, falls ? "-" : fmt::format("{:.0f}", tilts[0]));
  ASSERT_EQ(row.size(), 7u) << "the page has no row | " << expected;
  EXPECT_EQ(
      fmt::format("{} | {} | {} | {} | {} | {}", row[0], row[1], row[2], row[3], row[4], row[5]),
      made);
  if (falls)
    EXPECT_EQ(row[6], "-") << expected;
  else
    EXPECT_NEAR(std::stod(row[6]), tilts[0], 0.8) << expected;
}

// The verdict is no matter of the time step.
TEST(OverAThreshold, AShorterStepSaysTheSame) {
  for (const char* name : {"crash_cart", "icu_ventilator", "ultrasound_two_rigid"})
    for (const Threshold& threshold : {kLow, kHigh}) {
      const Trial run = trial(name, threshold, true);
      const Verdict coarse = verdict(run, simulate(run.scene, {}, settings(0.002)));
      const Verdict fine = verdict(run, simulate(run.scene, {}, settings(0.001)));
      EXPECT_EQ(word(coarse), word(fine)) << name << " " << threshold.height;
    }
}

bool trips(Trial run) {
  const Response response = simulate(run.scene, {}, settings(0.002));
  EXPECT_LT(response.quality.energy_closure, 0.01);
  return verdict(run, response) == Verdict::kFalls;
}

// Against a kerb as high as the axles. Found by bisection, items fall from 0.86 to 1.03 of Mallet's
// speed on, the hospital bed from 0.78; the bounds are 0.70 to 0.88 (X-ray unit and the other bed
// 0.53 and 0.56) and 0.41. Above, forks that swing and wheels that leave the kerb are not in the
// formula: 15 % are left for them. Beds and the X-ray unit are longer than high and would have to
// come with 4 m/s and more.
TEST_P(OverAThreshold, TripsAtAKerbFromMalletsSpeedOn) {
  const Tripping item = tripping(trial(GetParam(), kLow, false).scene.items[0].model);
  EXPECT_FALSE(trips(trial(GetParam(), {item.radius, 0.99 * item.least}, false))) << item.least;
  if (item.b > item.height) return;
  EXPECT_TRUE(trips(trial(GetParam(), {item.radius, 1.15 * item.speed}, false))) << item.speed;
}

// It is the treads that let the bed fall below Mallet's speed: it does from 0.78 of it on, and not at
// that speed itself where treads are damped so that they give nothing back.
TEST(OverAThreshold, TreadsThatGiveNothingBackMakeTheBedTripAtMalletsSpeed) {
  const auto bed = [](double share, double damping) {
    Trial run = trial("hospital_bed", kLow, false);
    EquipmentModel& model = run.scene.items[0].model;
    for (Caster& c : model.casters) c.tread.normal_damping *= damping;
    const Tripping item = tripping(model);
    const std::vector<Caster> casters = model.casters;
    run = trial("hospital_bed", {item.radius, share * item.speed}, false);
    run.scene.items[0].model.casters = casters;
    return run;
  };
  EXPECT_FALSE(trips(bed(0.7, 1)));
  EXPECT_TRUE(trips(bed(0.85, 1)));
  EXPECT_FALSE(trips(bed(1, 80)));
}

// The push holds the speed of the test before the obstruction, within its last 5 %, against the
// rolling resistance.
TEST(OverAThreshold, ThePushHoldsTheSpeed) {
  Trial run = trial("crash_cart", kLow, true);
  run.scene.room.clear();
  SimulationSettings two_seconds = settings(0.002);
  two_seconds.duration = 2;
  const Response response = simulate(run.scene, {}, two_seconds);
  const double speed = response.items[0].history.back().velocity.x();
  EXPECT_GT(speed, 0.95 * kLow.speed);
  EXPECT_LT(speed, kLow.speed);
}

}  // namespace
}  // namespace gurney::equipment::threshold
