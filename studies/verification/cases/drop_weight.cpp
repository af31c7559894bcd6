#include "studies/verification/cases/drop_weight.h"

#include <algorithm>
#include <cmath>
#include <complex>

#include "studies/verification/family.h"
#include "studies/verification/scenes/wind_up.h"

namespace gurney::verification::rig {

using namespace scenes;

Exact::Exact(const Rig& rig, const EquipmentModel& item) {
  const double radius = DropWeight().pulley_radius;
  const double inertia = total_mass(item) + wheel_inertia_mass(item);
  pulley = rig.pulley_inertia / (radius * radius);
  resistance = rig.resistance * total_mass(item) * kG;
  a1 = (rig.weight * kG - resistance - rig.trolley_string - rig.weight_string) /
       (inertia + rig.weight + pulley);
  a2 = (resistance + rig.trolley_string) / inertia;
  tension = rig.weight * (kG - a1) - rig.weight_string - pulley * a1;
  landing = std::sqrt(2 * rig.drop / a1);
  velocity = a1 * landing;
  distance = rig.drop + velocity * velocity / (2 * a2);
  stop = landing + velocity / a2;
}

double Exact::displacement(double t) const {
  const double pull = std::min(t, landing), coast = std::min(t, stop) - pull;
  return a1 * pull * pull / 2 + velocity * coast - a2 * coast * coast / 2;
}

double Exact::speed(double t) const {
  const double pull = std::min(t, landing), coast = std::min(t, stop) - pull;
  return a1 * pull - a2 * coast;
}

EquipmentModel pulled_trolley(const Rig& rig, double normal_stiffness) {
  ItemOptions options;
  options.total_mass = rig.mass;
  stiffen(options.caster.tread);
  options.caster.tread.normal_stiffness = normal_stiffness;
  options.caster.tread.rolling_friction_length = rig.resistance * options.caster.wheel_radius;
  return trolley(options);
}

std::vector<Load> rigged(const Rig& rig) {
  std::vector<Load> loads;
  DropWeight weight;
  weight.point = {0, 0, kPullHeight};
  weight.mass = rig.weight;
  weight.drop_height = rig.drop;
  weight.pulley_inertia = rig.pulley_inertia;
  weight.potentiometer_tension = rig.weight_string;
  weight.cable_stiffness = kCableStiffness;
  loads.push_back(weight);
  if (rig.trolley_string > 0)
    loads.push_back(
        StringPotentiometer{{0, 0, kPullHeight}, -Vector3::UnitX(), rig.trolley_string});
  Blocks blocks;
  blocks.point = {0, 0, rig.block_height};
  blocks.release_time = kReleaseTime;
  loads.push_back(blocks);
  return loads;
}

}  // namespace gurney::verification::rig

namespace gurney::verification {
namespace {

using namespace scenes;
using namespace rig;

/// By how much a trolley on treads and a weight on a cable may differ from the rigid train.
struct Bounds {
  double speed, pitch, swing, strain;  // [m/s], [m], tension [N], energy [J]
  double pitch_tension;                // [N]
  std::complex<double> rate;           // of the swing [1/s]
  double recoil_rate, recoil;          // of the stop [m/s], [m]
  double offset;                       // of the positions [m]
};

/// Result of one step of the method for y' = z / h y (engine/solver/quadrature.h).
std::complex<double> stability(std::complex<double> z) {
  const double gamma = 1 - std::sqrt(0.5);
  return (1.0 + (1 - 2 * gamma) * z) / ((1.0 - gamma * z) * (1.0 - gamma * z));
}

Bounds bounds(const Rig& c, const PlacedItem& placed, bool pitches) {
  const EquipmentModel& item = placed.model;
  const Exact e(c, item);
  const MassProperties whole = whole_item(item);
  const double M = whole.mass + wheel_inertia_mass(item), m = c.weight + e.pulley;
  const double h = whole.center_of_mass.z(), held = c.weight * kG - c.weight_string;
  Bounds b{};
  const double k = 4 * item.casters[0].tread.tangential_stiffness * 10 / 11;
  const double train = whole.mass + m, drive = held - c.trolley_string;
  b.speed = 2 * wind_up_speed(drive, e.resistance, k, train);
  // Released, the cable is stretched for the weight at rest, m_d g, and swings about T.
  b.swing = held - e.tension;
  const double reduced = 1 / (1 / M + 1 / m);
  const double decay = loads_of<DropWeight>(placed.loads)[0].cable_damping / (2 * reduced);
  b.rate = {-decay, std::sqrt(kCableStiffness / reduced - decay * decay)};
  b.speed += b.swing / std::sqrt(kCableStiffness * reduced) * m / (M + m);
  b.strain = held * held / (2 * kCableStiffness);
  b.speed += e.tension * e.tension / (2 * kCableStiffness * M * e.velocity);
  b.offset = held / kCableStiffness + held / loads_of<Blocks>(placed.loads)[0].stiffness;
  if (pitches) {
    const double base = item.casters[0].mount.x();
    const double stiffness = 4 * item.casters[0].tread.normal_stiffness * base * base;
    const double moment =
        e.resistance * h +
        held * (std::abs(kPullHeight - h) + std::abs(kPullHeight - c.block_height)) +
        c.trolley_string * std::abs(kPullHeight - h);
    const double angle = moment / stiffness, rate = std::sqrt(stiffness / whole.inertia(1, 1));
    const double lever = (M - whole.mass) / M * (h - item.casters[0].wheel_radius) +
                         c.resistance * item.casters[0].trail +
                         m / (M + m) * std::abs(kPullHeight - h);
    b.speed += lever * angle * rate + pitching_speed(drive, e.resistance, train,
                                                     h - item.casters[0].wheel_radius,
                                                     whole.inertia(1, 1), stiffness);
    b.offset += 2 * angle * (lever + std::abs(h - c.block_height));
    const double stopping = (e.resistance + c.trolley_string) * h;
    b.recoil = 2 * stopping * h / stiffness;
    b.recoil_rate =
        stopping * h / std::sqrt(stiffness * (whole.inertia(1, 1) + whole.mass * h * h));
    b.pitch_tension = (lever + std::abs(kPullHeight - h)) * angle * rate * rate * m;
  }
  b.speed += 1e-9 * kG * (kReleaseTime + e.stop);
  return b;
}

const char* const kTerms =
    "twice the wind-up of the treads (constant_pull); swing of the cable after the release, (m_d g "
    "- T) / sqrt(k_c m_r) m_d / (M + m_d), and what it gives back at the landing, T^2 / (2 k_c M "
    "v); residual 1e-9 g t";
const char* const kPitching =
    "; pitching before the wheels roll (constant_pull), then moment / sqrt(k_p I_p) times levers "
    "of wheels and cable";

/// Runs a rig and holds every phase against the closed form.
void compare(const Rig& c, double normal_stiffness, double step, bool hold_pitch,
             const std::string& how, Runner& runner) {
  Scene scene = scene_of(pulled_trolley(c, normal_stiffness));
  scene.items[0].loads = rigged(c);
  if (hold_pitch) scene.items[0].fixture = hold_rotations(false, true, false);
  const Exact e(c, scene.items[0].model);
  const Bounds b = bounds(c, scene.items[0], !hold_pitch);
  const Response response = runner(scene, {}, run_for(kReleaseTime + e.stop + 1, step, 0.02));

  const std::string terms = std::string(kTerms) + (hold_pitch ? "" : kPitching);
  Track displacement("displacement, " + how, "m",
                     "the tolerance of the velocity times the time; stretch of cable and blocks, "
                     "m_d g / k; a2 dt^2 at the stop: " +
                         terms);
  Track velocity("velocity, " + how, "m/s",
                 terms + "; a2 dt in the step in which it stops" +
                     (hold_pitch ? "" : "; then the swing back, f h^2 / sqrt(k_p (I_p + M h^2))"));
  Track tension("cable tension, " + how, "N",
                "(m_d g - F_w - T) |R(dt lambda)|^(t/dt - 1), the swing after the release as the "
                "method damps it, lambda^2 m_r + lambda c_c + k_c = 0; 1e-6 m_d g for the solve "
                "and 1e-10 m of cable for the start" +
                    std::string(hold_pitch ? "" : "; pitching accelerates the cable"));
  const double damping = std::abs(stability(step * b.rate));  // of the swing, in a step
  for (const Sample& s : response.items[0].history) {
    const PointSample& center = s.points[0];
    const double after = s.time - kReleaseTime, t = std::clamp(after, 0.0, e.stop);
    const bool stops = after > e.stop - step - b.speed / e.a2;
    displacement.add(s.time, center.displacement.x(), e.displacement(t),
                     b.speed * t + b.offset + e.a2 * step * step + (stops ? b.recoil : 0));
    velocity.add(s.time, center.velocity.x(), e.speed(t),
                 b.speed + (stops ? e.a2 * step + b.recoil_rate : 0));
    const double solve = 1e-6 * c.weight * kG + 1e-10 * kCableStiffness;
    if (after < -1e-9) {
      tension.add(s.time, s.cable_tension, c.weight * kG - c.weight_string,
                  solve + (hold_pitch ? 0 : b.pitch_tension));
    } else if (after > step && after < e.landing - step - b.offset / e.velocity) {
      tension.add(s.time, s.cable_tension, e.tension,
                  solve + b.swing * std::pow(damping, after / step - 1) + b.pitch_tension);
    } else if (after > e.landing + step) {
      tension.add(s.time, s.cable_tension, 0, 0);
    }
  }
  runner.report(displacement, velocity, tension);
  // The weight loses its energy where it lands, so the loss gives the speed at the event.
  const double loss = 0.5 * (c.weight + e.pulley) * e.velocity * e.velocity;
  runner.check("energy lost at the landing, " + how, "J", response.items[0].energy.damper_loss,
               near_to(loss, 2 * b.speed / e.velocity * loss + 2 * b.strain,
                       "twice the relative tolerance of the velocity; strain energy F^2 / (2 k) of "
                       "blocks and cable"));
  runner.check("energy of the weight, " + how, "J", response.items[0].energy.weight_energy,
               near_to(-c.weight * kG * c.drop, 1e-8 * c.weight * kG, "landing located to 1e-8 m"));
}

void pull(const Rig& c, Runner& runner) {
  compare(c, 3e6, 0.004, false, "4 ms", runner);
  compare(c, 3e8, 0.0005, true, "0.5 ms, pitch held", runner);
}

/// It starts, the cable stays taut, and the trolley stops within 30 s.
bool pulls(const Rig& c) {
  const Exact e(c, pulled_trolley(c, 3e6));
  return c.weight * kG - c.trolley_string - c.weight_string > 1.2 * e.resistance && e.stop < 30;
}

// --- the landing, and a cable that is slack

/// A landing rounded to a step would move the velocity by up to a1 dt.
struct Grid {
  double step;
  double weight = 5, drop = 0.7, resistance = 0.02;
};

void land(const Grid& c, Runner& runner) {
  const Rig rig{c.weight, c.drop, c.resistance};
  Scene scene = scene_of(pulled_trolley(rig, 3e8));
  scene.items[0].loads = rigged(rig);
  scene.items[0].fixture = hold_rotations(false, true, false);
  const EquipmentModel& item = scene.items[0].model;
  const Exact e(rig, item);
  const Response response = runner(scene, {}, run_for(kReleaseTime + e.stop + 1, c.step));
  const double M = total_mass(item) + wheel_inertia_mass(item), pull = rig.weight * kG;
  const double k = 4 * item.casters[0].tread.tangential_stiffness * 10 / 11;
  const double reduced = 1 / (1 / M + 1 / rig.weight);
  const double speed =
      wind_up_speed(pull, e.resistance, k, M + rig.weight) +
      (pull - e.tension) / std::sqrt(kCableStiffness * reduced) * rig.weight / (M + rig.weight) +
      e.tension * e.tension / (2 * kCableStiffness * M * e.velocity) +
      1e-9 * kG * (kReleaseTime + e.stop);
  const char* const terms =
      "wind-up of the treads, swing of the cable and what it gives back at the landing, residual, "
      "as in drop_weight";
  runner.check(
      "distance", "m", response.items[0].demands.residual_displacement_x,
      near_to(e.distance, speed * e.stop + 2 * pull / kCableStiffness + e.a2 * c.step * c.step,
              std::string("the tolerance of the speed times the time; stretch of cable and blocks, "
                          "2 m_d g / k; a2 dt^2 at the stop: ") +
                  terms));
  runner.check("peak velocity", "m/s", response.items[0].demands.peak_velocity,
               near_to(e.velocity, speed, terms));
}

/// All wheels are locked, so the item slides and brakes at mu g.
struct Slack {
  double pulley_inertia;
  double speed = 0.8, friction = 0.3, weight = 5, mass = 96.5;
};

double free_fall(const Slack& c) {
  const double radius = DropWeight().pulley_radius;
  return c.weight * kG / (c.weight + c.pulley_inertia / (radius * radius));
}

double time_taut(const Slack& c) { return 2 * c.speed / (free_fall(c) + c.friction * kG); }

void run_ahead(const Slack& c, Runner& runner) {
  constexpr double kStep = 0.001;
  ItemOptions options;
  options.total_mass = c.mass;
  stiffen(options.caster.tread);
  options.caster.tread.static_friction = options.caster.tread.kinetic_friction = c.friction;
  Scene scene = scene_of(locked_block(options));
  scene.items[0].initial.velocity.x() = c.speed;
  scene.items[0].initial.wheels_roll = false;
  scene.items[0].fixture = hold_rotations();
  DropWeight weight;
  weight.point = {0, 0, kPullHeight};
  weight.mass = c.weight;
  weight.drop_height = 2;
  weight.pulley_inertia = c.pulley_inertia;
  scene.items[0].loads = {weight};

  const double braking = c.friction * kG, taut = time_taut(c), pull = c.weight * kG;
  const Response response = runner(scene, {}, run_for(3, kStep, kStep));
  const double wound = braking * c.mass / (4 * options.caster.tread.tangential_stiffness);
  Track displacement("displacement while the cable is slack", "m",
                     "wind-up of the sliding treads, 2 mu M g / (n k_t); the speed that it adds, "
                     "f^2 / (2 k M v0), times the time; residual 1e-9 g t^2");
  Track tension("cable tension while it is slack", "N", "a slack cable carries nothing");
  Track energy("energy of the weight while it falls freely", "J", "1e-9 m_d g");
  double first_taut = 0;
  for (const Sample& s : response.items[0].history) {
    if (s.cable_tension > 0 && first_taut == 0) first_taut = s.time;
    if (s.time > taut - kStep) continue;
    tension.add(s.time, s.cable_tension, 0, 0);
    displacement.add(s.time, s.displacement.x(), c.speed * s.time - braking * s.time * s.time / 2,
                     2 * wound + (wound * braking / (2 * c.speed) + 1e-9 * kG * s.time) * s.time);
    energy.add(s.time, s.energy.weight_energy, 0, 1e-9 * pull);
  }
  runner.report(displacement, tension, energy);
  runner.check("time at which the cable is taut", "s", first_taut,
               near_to(taut, 2 * kStep, "one step to tighten, one to report it: 2 dt"));
  // Locked wheels hold the weight: all rests, the cable carries it.
  const Sample& end = response.items[0].history.back();
  const double swings = std::exp(-weight.cable_damping / (2 * c.weight) * (3 - 1.5));
  runner.check("cable tension at rest", "N", end.cable_tension,
               near_to(pull, pull * (swings + 1e-6),
                       "m_d g (exp(-c_c t / (2 m_d)) + 1e-6): the swing that is left"));
  runner.check("velocity at rest", "m/s", end.velocity.x(), near_to(0, 1e-6, "as for the tension"));
}

/// It still slides when the cable tightens, and then holds the weight.
bool holds(const Slack& c) {
  return time_taut(c) < 0.9 * c.speed / (c.friction * kG) && time_taut(c) < 1 &&
         c.weight < 0.5 * c.friction * c.mass;
}

}  // namespace

Family drop_weight() {
  return make_family<Rig>(
      {"drop_weight", "pulling", "A trolley pulled by a falling weight, then coasting to rest",
       "a1 = (m_d g - f_r - F_s - F_w) / (M + J + m_d + p), a2 = (f_r + F_s) / (M + J), T = m_d (g "
       "- a1) - F_w - p a1, p = I_p / r_p^2",
       "Newton's law for the rig of Xu, Ma & Kurata 2022"},
      fields(FIELD(Rig, weight, "kg", 4, 15), FIELD(Rig, drop, "m", 0.3, 1.2),
             FIELD(Rig, resistance, "Cr/R", 0.01, 0.04), FIELD(Rig, trolley_string, "N", 0, 6),
             FIELD(Rig, weight_string, "N", 0, 6), FIELD(Rig, pulley_inertia, "kg m2", 0, 0.004),
             FIELD(Rig, block_height, "m", 0.131, 0.618), FIELD(Rig, mass, "kg", 60, 200)),
      cases(at("plain", 5, 0.7, 0.02), at("strings", 6, 0.8, 0.02, 3, 2),
            at("pulley", 8, 0.6, 0.03, 2, 2, 0.002),
            at("low_blocks", 6, 0.8, 0.025, 0, 0, 0, 0.131),
            at("loaded", 9, 0.9, 0.015, 4, 4, 0.001, 0.618, 164.5)),
      pull, pulls);
}

Family drop_weight_grid() {
  return make_family<Grid>(
      {"drop_weight_landing", "pulling", "A landing does not depend on the grid of steps",
       "as drop_weight", "Newton's law; the landing is an event inside a step"},
      fields(FIELD(Grid, step, "s", 0.003, 0.006), FIELD(Grid, weight, "kg", 4, 10),
             FIELD(Grid, drop, "m", 0.3, 1.2), FIELD(Grid, resistance, "Cr/R", 0.01, 0.025)),
      cases(at("4_ms", 0.004), at("4.1_ms", 0.0041), at("4.3_ms", 0.0043), at("4.7_ms", 0.0047)),
      land);
}

Family drop_weight_slack() {
  return make_family<Slack>(
      {"drop_weight_slack", "pulling", "An item runs ahead of its weight: the cable is slack",
       "taut again after t = 2 v0 / (g' + mu g), g' = m_d g / (m_d + p)", "Newton's law"},
      fields(FIELD(Slack, pulley_inertia, "kg m2", 0, 0.01), FIELD(Slack, speed, "m/s", 0.3, 1.5),
             FIELD(Slack, friction, "mu", 0.1, 0.5), FIELD(Slack, weight, "kg", 2, 12),
             FIELD(Slack, mass, "kg", 60, 200)),
      cases(at("light_pulley", 0), at("heavy_pulley", 0.01)), run_ahead, holds);
}

}  // namespace gurney::verification
