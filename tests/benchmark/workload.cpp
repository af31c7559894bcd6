#include "tests/benchmark/workload.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <ctime>
#include <numbers>

#include "engine/base/units.h"
#include "engine/run/run.h"
#include "equipment/catalogue/catalogue.h"
#include "equipment/catalogue/load_item.h"
#include "groundmotions/record/record_motion.h"
#include "groundmotions/synthetic/clough_penzien.h"

namespace gurney::benchmark {

Scene trolley(const std::vector<double>& headings_deg) {
  equipment::ItemOptions options;
  for (double heading : headings_deg) options.headings.push_back(heading * kRadiansPerDegree);
  Scene scene =
      scene_of(equipment::load_item(
                   equipment::find_data(equipment::DataKind::kItem, "xu_trolley", ""), options)
                   .model);
  return scene;
}

void make_rigid(Scene& scene, double normal_stiffness, double tangential_stiffness) {
  for (Caster& caster : scene.items[0].model.casters) {
    Tread& tread = caster.tread;
    tread.normal_damping *= std::sqrt(normal_stiffness / tread.normal_stiffness);
    tread.tangential_damping *= std::sqrt(tangential_stiffness / tread.tangential_stiffness);
    tread.normal_stiffness = normal_stiffness;
    tread.tangential_stiffness = tangential_stiffness;
    tread.patch_width = 0;
    caster.swivel = {};
  }
}

FloorMotion shaking(unsigned seed, double peak_g, double vertical_ratio) {
  groundmotions::SyntheticMotion motion = groundmotions::shipped_synthetic_motion();
  motion.seed = seed;
  motion.samples = static_cast<int>(20 / motion.time_step) + 1;
  const double ratio[3] = {1, 0.75, vertical_ratio};
  for (std::size_t i = 0; i < 3; ++i)
    motion.components[i].peak_acceleration = ratio[i] * peak_g * kStandardGravity;
  return groundmotions::floor_motion(groundmotions::synthetic_record(motion));
}

PointForce pull() {
  return {.name = "pull",
          .point = {-0.55, 0, 0.618},
          .direction = Vector3::UnitX(),
          .time = {0, 3},
          .force = {40, 40}};
}

PullReference pull_reference(const Scene& scene) {
  const double mass = whole_item(scene.items[0].model).mass;
  double rolling_inertia = 0;
  for (const Caster& c : scene.items[0].model.casters)
    rolling_inertia += c.wheel_axial_inertia / (c.wheel_radius * c.wheel_radius);
  const Caster& c = scene.items[0].model.casters.front();
  const double resistance = c.tread.rolling_friction_length / c.wheel_radius * mass * scene.gravity;
  const double a1 = (40 - resistance) / (mass + rolling_inertia);
  const double a2 = resistance / (mass + rolling_inertia);
  const double speed = 3 * a1;
  return {0.5 * a1 * 9, 0.5 * a1 * 9 + 0.5 * speed * speed / a2};
}

double cpu_time() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

Timed timed(const Scene& scene, const FloorMotion& floor, const RunOptions& settings, int repeats) {
  Timed result{{}, 1e300};
  for (int i = 0; i < repeats; ++i) {
    const auto start = std::chrono::steady_clock::now();
    result.response = gurney::run(scene, floor, settings);
    const std::chrono::duration<double> wall = std::chrono::steady_clock::now() - start;
    result.seconds = std::min(result.seconds, wall.count());
  }
  return result;
}

}  // namespace gurney::benchmark
