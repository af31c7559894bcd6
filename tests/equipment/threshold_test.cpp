#include "tests/equipment/threshold.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <sstream>

#include "equipment/stability.h"

// Every item on casters over the thresholds of IEC 60601-1, and the table of docs/equipment.md.
namespace gurney::threshold {
namespace {

std::vector<std::string> items_on_casters() {
  std::vector<std::string> names;
  for (const std::string& name : catalogue_names(DataKind::kItem))
    if (!load_item_description(find_data(DataKind::kItem, name, "")).casters.empty())
      names.push_back(name);
  return names;
}

SimulationSettings settings(double time_step) {
  SimulationSettings settings;
  settings.time_step = time_step;
  settings.history_step = 1;
  return settings;
}

const char* word(Verdict verdict) {
  return verdict == Verdict::kPasses ? "passes" : verdict == Verdict::kStops ? "stops" : "falls";
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

class OverAThreshold : public testing::TestWithParam<std::string> {};
INSTANTIATE_TEST_SUITE_P(Catalogue, OverAThreshold, testing::ValuesIn(items_on_casters()),
                         [](const auto& test) { return test.param; });

TEST_P(OverAThreshold, DoesWhatThePageSaysAndItsEnergyAllows) {
  const std::vector<std::string> row = row_of_page(GetParam());
  std::string made = fmt::format("`{}`", GetParam());
  std::vector<double> tilts;
  for (const auto& [threshold, pushed] :
       {std::pair(kLow, true), std::pair(kHigh, true), std::pair(kLow, false)}) {
    SCOPED_TRACE(fmt::format("{} mm, {}", kMillimetersPerMeter * threshold.height,
                             pushed ? "pushed" : "let go"));
    const Trial run = trial(GetParam(), threshold, pushed);
    const EquipmentModel& model = run.scene.items[0].model;
    if (tilts.empty()) made += fmt::format(" | {:.0f} | {:.0f}", whole_item(model).mass, run.push);
    const Response response = simulate(run.scene, run.excitation, settings(0.002));
    ASSERT_TRUE(response.outcome == Outcome::kRested || response.outcome == Outcome::kOverturned)
        << name_of(response.outcome) << " " << response.cause;
    EXPECT_EQ(response.quality.unconverged_steps, 0);
    // Wheels on the obstruction touch it through Bullet's manifolds: Limits in
    // docs/theory/impact.md. All are below 0.0022.
    EXPECT_LT(response.quality.energy_closure, 0.005);

    const Verdict found = verdict(run, response);
    const ItemResponse& item = response.items[0];
    if (found == Verdict::kFalls)
      EXPECT_GT(energy_at_start(model, threshold.speed) + item.energy.work_of_forces,
                energy_to_fall(model));
    else
      EXPECT_LT(item.demands.peak_tilt, 20 * kRadiansPerDegree) << "it came back from there";
    if (pushed) made += fmt::format(" | {}", word(found));
    tilts.push_back(item.demands.peak_tilt / kRadiansPerDegree);
  }
  const std::string expected = made + fmt::format(" | {:.0f} |", tilts[0]);
  ASSERT_EQ(row.size(), 6u) << "the page has no row | " << expected;
  EXPECT_EQ(fmt::format("{} | {} | {} | {} | {}", row[0], row[1], row[2], row[3], row[4]), made);
  if (row[3] == "falls")
    EXPECT_EQ(row[5], "-");
  else
    EXPECT_NEAR(std::stod(row[5]), tilts[0], 0.8) << expected;
}

// The verdict is no matter of the time step.
TEST(OverAThreshold, AShorterStepSaysTheSame) {
  for (const char* name : {"crash_cart", "icu_ventilator", "ultrasound_two_rigid"})
    for (const Threshold& threshold : {kLow, kHigh}) {
      const Trial run = trial(name, threshold, true);
      const Verdict coarse = verdict(run, simulate(run.scene, run.excitation, settings(0.002)));
      const Verdict fine = verdict(run, simulate(run.scene, run.excitation, settings(0.001)));
      EXPECT_EQ(word(coarse), word(fine)) << name << " " << threshold.height;
    }
}

// The push holds the speed of the test before the obstruction, within its last 5 %, against the
// rolling resistance.
TEST(OverAThreshold, ThePushHoldsTheSpeed) {
  Trial run = trial("crash_cart", kLow, true);
  run.scene.room.clear();
  SimulationSettings two_seconds = settings(0.002);
  two_seconds.duration = 2;
  const Response response = simulate(run.scene, run.excitation, two_seconds);
  const double speed = response.items[0].history.back().velocity.x();
  EXPECT_GT(speed, 0.95 * kLow.speed);
  EXPECT_LT(speed, kLow.speed);
}

}  // namespace
}  // namespace gurney::threshold
