#include "tests/peers/our_path.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "engine/run/simulate.h"
#include "tests/benchmark/workload.h"

namespace gurney::peers {

Path our_path(const CrossCheck& check, double time_step) {
  SimulationSettings settings;
  settings.duration = check.duration;
  settings.history_step = check.sampling;
  settings.time_step = time_step;
  const Response response = simulate(check.scene, check.floor, settings);
  Path path;
  for (const Sample& s : response.items[0].history)
    path.push_back({{s.displacement.x(), s.displacement.y(), s.yaw}, s.tilt});
  return path;
}

double peak(const Path& path) {
  double largest = 0;
  for (const Snapshot& at : path)
    largest = std::max(largest, (at.place - path[0].place).head<2>().norm());
  return largest;
}

double distance(const Path& a, const Path& b) {
  EXPECT_EQ(a.size(), b.size());
  double largest = 0;
  for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i)
    largest = std::max(largest, (a[i].place - b[i].place).head<2>().norm());
  return largest;
}

CrossCheck trolley_check(unsigned record, double peak_g) {
  CrossCheck check;
  check.scene = benchmark::trolley({10, 100, 200, 300});
  for (Caster& caster : check.scene.items[0].model.casters) {
    caster.tread.static_friction = caster.tread.kinetic_friction;
    caster.tread.patch_width = 0;
    caster.axle = caster.swivel = {};
  }
  check.floor = benchmark::shaking(record, peak_g);
  check.duration = 12;
  check.sampling = 0.02;
  return check;
}

CrossCheck half_locked_check(unsigned record, double peak_g) {
  CrossCheck check = trolley_check(record, peak_g);
  for (const std::size_t i : {0, 1}) {
    Caster& caster = check.scene.items[0].model.casters[i];
    caster.brake_torque = std::numeric_limits<double>::infinity();
    caster.swivels = false;
  }
  return check;
}

}  // namespace gurney::peers
