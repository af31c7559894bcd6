#include <cstring>
#include <thread>

#include "studies/verification/family.h"
#include "studies/verification/scenes/small_scenes.h"

namespace gurney::verification {
namespace {

struct Shaking {
  double seed, duration, peak;  // of the noise [-], [s], [m/s2]
};

bool same(double a, double b) { return std::memcmp(&a, &b, sizeof a) == 0; }

bool same(const Sample& a, const Sample& b) {
  bool equal = same(a.time, b.time) && same(a.yaw, b.yaw) && same(a.tilt, b.tilt) &&
               same(a.energy.loss(), b.energy.loss()) && same(a.energy.stored(), b.energy.stored());
  for (int k = 0; k < 3; ++k)
    equal &= same(a.displacement[k], b.displacement[k]) && same(a.velocity[k], b.velocity[k]) &&
             same(a.acceleration[k], b.acceleration[k]);
  for (std::size_t w = 0; w < 4; ++w)
    equal &= same(a.wheels[w].normal_force, b.wheels[w].normal_force) &&
             same(a.wheels[w].lateral_force, b.wheels[w].lateral_force) &&
             same(a.wheels[w].swivel_angle, b.wheels[w].swivel_angle);
  return equal;
}

double different_samples(const Response& a, const Response& b) {
  const auto &first = a.items[0].history, &second = b.items[0].history;
  if (first.size() != second.size() || first.size() < 2) return INFINITY;
  int different = 0;
  for (std::size_t i = 0; i < first.size(); ++i) different += !same(first[i], second[i]);
  return different;
}

Findings repeat(const Shaking& c, const Runner& runner) {
  Findings findings;
  Scene scene = scene_of(small::trolley({10, 100, 200, 300}, Tread()));
  const FloorMotion floor = small::noise_record(static_cast<std::uint64_t>(c.seed), c.duration,
                                                {c.peak, 0.75 * c.peak, 0.5 * c.peak});
  SimulationSettings settings = small::settings_for(0.004, c.duration, 5);
  const Response alone = runner(findings, scene, floor, settings);
  Response one, two;
  Findings of_one, of_two;
  std::thread first([&] { one = runner(of_one, scene, floor, settings); });
  std::thread second([&] { two = runner(of_two, scene, floor, settings); });
  first.join();
  second.join();
  settings.skip_clear_collision_passes = false;
  const Response every = runner(findings, scene, floor, settings);
  const char* const why = "every bit is the same";
  findings.checks.push_back(
      {"samples that differ in another thread", "", different_samples(alone, one), 0, 0, why});
  findings.checks.push_back({"samples that differ in a third thread beside it", "",
                             different_samples(alone, two), 0, 0, why});
  findings.checks.push_back({"samples that differ with every collision pass made", "",
                             different_samples(alone, every), 0, 0, why});
  return findings;
}

}  // namespace

Family determinism() {
  return make_family<Shaking>(
      {"determinism", "method", "A shaken trolley, again and in several threads at once",
       "the same bits", "docs/conventions.md, Repeating a run"},
      {{{"seed", "", 1, 1000, true}, &Shaking::seed},
       {{"duration", "s", 2, 6}, &Shaking::duration},
       {{"peak", "m/s2", 1, 6}, &Shaking::peak}},
      {{"plain", {5, 4, 4}}, {"strong", {8, 3, 6}}}, repeat);
}

}  // namespace gurney::verification
