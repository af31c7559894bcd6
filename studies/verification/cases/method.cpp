#include <cmath>
#include <cstring>
#include <functional>
#include <thread>

#include "studies/verification/family.h"
#include "studies/verification/scenes/small_scenes.h"

// The method is of second order on smooth problems (docs/theory/solver.md).
namespace gurney::verification {
namespace {

constexpr double kStep = 0.002;
const char* const kWhy =
    "terms of third order move it by about h times a rate of the problem, below 0.25; a "
    "first-order method shows 1";
const char* const kOrder = "log2 |y_h - y_h/2| / |y_h/2 - y_h/4| = 2";
const char* const kSource = "Richardson's extrapolation";

/// The order of `quantity` from runs with steps of 2, 1 and 0.5 ms.
void add_order(const std::string& quantity, const std::function<double(double step)>& run,
               Runner& runner) {
  const double a = run(kStep), b = run(kStep / 2), c = run(kStep / 4);
  runner.check("order of " + quantity, "", std::log2(std::abs(a - b) / std::abs(b - c)),
               near_to(2, 0.25, kWhy));
}

struct Towed {
  double heading;  // [deg]
};

void towed(const Towed& c, Runner& runner) {
  Tread tread = small::bare_tread(3e7, 1e7);
  tread.tangential_damping = 100;
  tread.static_friction = tread.kinetic_friction = 5;
  add_order(
      "the swivel angle",
      [&](double step) {
        const Scene scene = small::towed_caster(1, 0.034, c.heading, tread);
        return runner(scene, {}, small::settings_for(step, 0.048))
            .items[0]
            .history.back()
            .wheels[0]
            .swivel_angle;
      },
      runner);
}

struct Heave {
  double speed;  // [m/s]
};

void heave(const Heave& c, Runner& runner) {
  Scene scene = scene_of(small::trolley({0, 0, 0, 0}, small::bare_tread(3e5, 1e5)));
  scene.items[0].initial.velocity = {0, 0, c.speed};
  add_order(
      "the height",
      [&](double step) {
        return runner(scene, {}, small::settings_for(step, 0.064))
            .items[0]
            .history.back()
            .displacement.z();
      },
      runner);
}

struct Turning {
  double speed, yaw_rate;  // [m/s], [rad/s]
};

void turning(const Turning& c, Runner& runner) {
  Scene scene = scene_of({});
  Tread tread = small::bare_tread(3e5, 1e5);
  tread.normal_damping = 500;
  tread.tangential_damping = 50;
  tread.static_friction = tread.kinetic_friction = 5;
  scene.items[0].model = small::trolley({20, 60, -30, 100}, tread);
  scene.items[0].initial.velocity = {c.speed, c.speed / 3, 0};
  scene.items[0].initial.yaw_rate = c.yaw_rate;
  const auto run = [&](double step) {
    return runner(scene, {}, small::settings_for(step, 0.8)).items[0].history.back();
  };
  add_order(
      "x", [&](double h) { return run(h).displacement.x(); }, runner);
  add_order(
      "y", [&](double h) { return run(h).displacement.y(); }, runner);
  add_order(
      "yaw", [&](double h) { return run(h).yaw; }, runner);
}

// --- the same bits

struct Shaking {
  double seed, duration, peak;  // of the noise [-], [s], [m/s2]
};

bool same_bits(double a, double b) { return std::memcmp(&a, &b, sizeof a) == 0; }

bool same_bits(const Sample& a, const Sample& b) {
  bool equal = same_bits(a.time, b.time) && same_bits(a.yaw, b.yaw) && same_bits(a.tilt, b.tilt) &&
               same_bits(a.energy.loss(), b.energy.loss()) &&
               same_bits(a.energy.stored(), b.energy.stored());
  for (int k = 0; k < 3; ++k)
    equal &= same_bits(a.displacement[k], b.displacement[k]) &&
             same_bits(a.velocity[k], b.velocity[k]) &&
             same_bits(a.acceleration[k], b.acceleration[k]);
  for (std::size_t w = 0; w < 4; ++w)
    equal &= same_bits(a.wheels[w].normal_force, b.wheels[w].normal_force) &&
             same_bits(a.wheels[w].lateral_force, b.wheels[w].lateral_force) &&
             same_bits(a.wheels[w].swivel_angle, b.wheels[w].swivel_angle);
  return equal;
}

double different_samples(const Response& a, const Response& b) {
  const auto &first = a.items[0].history, &second = b.items[0].history;
  if (first.size() != second.size() || first.size() < 2) return INFINITY;
  int different = 0;
  for (std::size_t i = 0; i < first.size(); ++i) different += !same_bits(first[i], second[i]);
  return different;
}

void repeat(const Shaking& c, Runner& runner) {
  Scene scene = scene_of(small::trolley({10, 100, 200, 300}, Tread()));
  const FloorMotion floor = small::noise_record(static_cast<std::uint64_t>(c.seed), c.duration,
                                                {c.peak, 0.75 * c.peak, 0.5 * c.peak});
  SimulationSettings settings = small::settings_for(0.004, c.duration, 5);
  const Response alone = runner(scene, floor, settings);
  Response one, two;
  Runner of_one = runner, of_two = runner;
  std::thread first([&] { one = of_one(scene, floor, settings); });
  std::thread second([&] { two = of_two(scene, floor, settings); });
  first.join();
  second.join();
  settings.skip_clear_collision_passes = false;
  const Response every = runner(scene, floor, settings);
  const char* const why = "every bit is the same";
  runner.check("samples that differ in another thread", "", different_samples(alone, one),
               exactly(0, why));
  runner.check("samples that differ in a third thread beside it", "", different_samples(alone, two),
               exactly(0, why));
  runner.check("samples that differ with every collision pass made", "",
               different_samples(alone, every), exactly(0, why));
}

}  // namespace

Family order_towed() {
  // An error that happens to pass through zero has no order.
  return never_drawn(make_family<Towed>(
      {"order_towed", "method", "Order of convergence of a towed caster", kOrder, kSource},
      fields(FIELD(Towed, heading, "deg", 20, 140)), cases(at("40", 40), at("120", 120)), towed));
}

Family order_heave() {
  return never_drawn(make_family<Heave>(
      {"order_heave", "method", "Order of convergence of a heaving trolley", kOrder, kSource},
      fields(FIELD(Heave, speed, "m/s", 0.005, 0.02)), cases(at("plain", 0.01)), heave));
}

Family order_turning() {
  return never_drawn(make_family<Turning>(
      {"order_turning", "method", "Order of convergence of a coasting, turning trolley", kOrder,
       kSource},
      fields(FIELD(Turning, speed, "m/s", 0.1, 0.5), FIELD(Turning, yaw_rate, "rad/s", 0, 1)),
      cases(at("plain", 0.3, 0.5)), turning));
}

Family determinism() {
  return make_family<Shaking>(
      {"determinism", "method", "A shaken trolley, again and in several threads at once",
       "the same bits", "docs/conventions.md, Repeating a run"},
      fields(FIELD(Shaking, seed, "", 1, 1000, true), FIELD(Shaking, duration, "s", 2, 6),
             FIELD(Shaking, peak, "m/s2", 1, 6)),
      cases(at("plain", 5, 4, 4), at("strong", 8, 3, 6)), repeat);
}

}  // namespace gurney::verification
