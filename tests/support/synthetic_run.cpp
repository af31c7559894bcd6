#include "tests/support/synthetic_run.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>
#include <string_view>
#include <variant>

#include "studies/results/columns.h"

namespace gurney {
namespace {

constexpr double kPi = std::numbers::pi;

WheelSample wheel_sample(std::size_t i, double t, double calm) {
  WheelSample w;
  const double phase = 0.7 * static_cast<double>(i);
  w.swivel_angle = -1.2 + phase + 2.4 * (1 - calm) * std::sin(0.9 * t + phase);
  w.swivel_rate = 2.4 * 0.9 * std::cos(0.9 * t + phase);
  w.wheel_rate = 8 * calm * std::sin(5 * t + phase);
  w.normal_force = 236.6 * (1 + 0.3 * calm * std::sin(11 * t + phase));
  w.longitudinal_force = 20 * calm * std::sin(5 * t + phase);
  w.lateral_force = 15 * calm * std::cos(5 * t + phase);
  w.scrub_torque = 0.2 * calm * std::sin(3 * t);
  w.rolling_resistance_force = -2.9 * calm;
  w.mode = static_cast<WheelMode>((i + static_cast<std::size_t>(t)) % 5);
  return w;
}

Sample sample_at(double t, bool pulled) {
  Sample s;
  const double calm = std::exp(-0.5 * std::pow((t - 6) / 4, 2));
  s.time = t;
  s.displacement = pulled ? Vector3(0.05 * t * t / (1 + 0.02 * t * t), 0.01 * t, 0)
                          : Vector3(0.21 * calm * std::sin(2.1 * t) + 0.02 * t,
                                    0.13 * calm * std::cos(1.7 * t) - 0.13 * std::exp(-1.125), 0);
  s.velocity = Vector3(0.44 * calm * std::cos(2.1 * t), -0.22 * calm * std::sin(1.7 * t), 0);
  s.acceleration = Vector3(-2.6 * calm * std::sin(9.1 * t), 1.9 * calm * std::cos(8.3 * t), 0);
  s.yaw = 0.3 * (1 - std::exp(-t / 5));
  s.tilt = 0.004 * calm * std::abs(std::sin(8 * t));
  s.orientation = Eigen::AngleAxisd(s.yaw, Vector3::UnitZ());
  s.cable_tension = pulled && t < 5 ? 38.2 + std::sin(20 * t) * std::exp(-t) : 0;
  for (std::size_t i = 0; i < 4; ++i) s.wheels[i] = wheel_sample(i, t, calm);
  s.points = {{s.displacement + Vector3(0, 0, 0.001), s.velocity, s.acceleration}};
  s.energy.kinetic = 9 * calm * std::pow(std::cos(2.1 * t), 2);
  s.energy.work_of_floor = 30 * (1 - std::exp(-t / 6));
  s.energy.rolling_loss = 14 * (1 - std::exp(-t / 6));
  s.energy.sliding_loss = 9 * (1 - std::exp(-t / 7));
  s.energy.tread_loss = 4 * (1 - std::exp(-t / 8));
  return s;
}

/// 0.125, 0.25, 0.375, ... for each number of the demands in turn, also for one that is new. Left as
/// they are those of impacts and of overturning: there are none.
Demands counted_demands() {
  constexpr std::string_view kOfImpacts[] = {"largest_approach_speed", "largest_impulse"};
  Demands d;
  double next = 0;
  for (const study::TableColumn<Demands>& column : study::demand_columns())
    if (const auto* const member = std::get_if<double Demands::*>(&column.source);
        member && column.missing == 0 &&
        std::ranges::find(kOfImpacts, column.name) == std::end(kOfImpacts))
      d.*(*member) = 0.125 * ++next;
  d.most_wheels_lifted = 2;
  for (int i = 0; i < 4; ++i)
    d.wheels.push_back({300.0 + i, 90.0 + i, 0.01 * i, i, 0.001 * (i + 1), -1});
  d.points = {{0.231, 5.25, 4.75, 98.5}};
  return d;
}

}  // namespace

study::RunFacts synthetic_facts(bool pulled) {
  study::RunFacts facts;
  facts.job_name = pulled ? "pull" : "shake";
  facts.job_text = "title = \"A trolley\"\n";
  facts.job_sha256 = std::string(64, 'a');
  facts.title = pulled ? "A trolley pulled by a drop weight" : "A trolley under a made-up motion";
  facts.scene = scene_of({});
  EquipmentModel& item = facts.scene.items[0].model;
  item.name = "Trolley";
  item.chassis_mass = 94.5;
  item.shape = {{{0, 0, 0.8}, {1.1, 0.55, 1.3}}};
  item.marked_points = {{"top", {0, 0, 1.4}}};
  const char* const names[] = {"front left", "front right", "rear left", "rear right"};
  for (int i = 0; i < 4; ++i) {
    Caster caster;
    caster.name = names[i];
    caster.mount = {i < 2 ? 0.45 : -0.45, i % 2 == 0 ? 0.22 : -0.22, 0.131};
    item.casters.push_back(caster);
  }
  if (!pulled)
    facts.record =
        study::RecordFacts{"made-up",
                           {{"x.AT2", std::string(64, 'b')}, {"y.AT2", std::string(64, 'c')}},
                           {"h1: 'x' of x.AT2", "h2: 'y' of y.AT2, azimuth 90 deg"},
                           {"a step", "another step"},
                           20,
                           0.005,
                           {3.92266, 2.941995, 1.96133},
                           {0.31, 0.22, 0.11},
                           {0.08, 0.05, 0.02},
                           {0.001, -0.002, 0.0},
                           {0.01, 0.02, -0.03}};
  facts.assumptions = {{"tread.rolling_resistance_m", "0.001", "0.0005 to 0.0015",
                        "no value is published for this tread", "r100.toml"}};
  if (!pulled) {
    facts.draw = Draw(1, 3);
    facts.drawn = {{"front left/tread.rolling_resistance_mm", 1.0625, "mm",
                    "lognormal, median 1, beta 0.3, within 0.5 to 1.5", "R100.toml"},
                   {"floor.slope", 0.001, "1", "uniform, 0 to 0.002", "shake.toml"}};
  }
  facts.warnings = {"the record ends with 2.0 mm/s"};
  return facts;
}

Response synthetic_response(bool pulled) {
  Response response;
  response.outcome = Outcome::kRested;
  response.end_time = 24;
  response.items.resize(1);
  response.items[0].demands = counted_demands();
  response.quality = {1e-7, 2e-6, 3e-10, 6000, 4, 5, 6, 12000, 7};
  for (int i = 0; i <= 2400; ++i) response.items[0].history.push_back(sample_at(0.01 * i, pulled));
  response.items[0].energy = response.items[0].history.back().energy;
  return response;
}

}  // namespace gurney
