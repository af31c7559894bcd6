#include <algorithm>
#include <cmath>
#include <numbers>

#include "studies/verification/family.h"
#include "studies/verification/scenes/scenes.h"
#include "studies/verification/scenes/wind_up.h"

namespace gurney::verification {
namespace {

using namespace scenes;

struct Pull {
  double force, duration, resistance;  // F [N], [s], Cr / R
  double mass = 96.5, wheel_mass = 0.25, wheel_radius = 0.05;
};

EquipmentModel pulled_trolley(const Pull& c, double normal_stiffness) {
  ItemOptions options;
  options.total_mass = c.mass;
  Caster& caster = options.caster;
  stiffen(caster.tread);
  caster.tread.normal_stiffness = normal_stiffness;
  caster.wheel_mass = c.wheel_mass;
  caster.wheel_radius = c.wheel_radius;
  caster.height = c.wheel_radius + 0.081;
  caster.tread.rolling_friction_length = c.resistance * c.wheel_radius;
  set_wheel_inertia(caster);
  return trolley(options);
}

/// The closed form, and by how much a trolley on stiff treads may differ from it.
struct Exact {
  double mass, inertia, resistance, a1, a2, v1, stop, distance;
  double wind_up, pitch_rate, pitch;  // speeds and a length that the closed form does not know
  double recoil_rate, recoil;         // of the stop

  Exact(const Pull& c, const EquipmentModel& item) {
    mass = total_mass(item);
    inertia = mass + wheel_inertia_mass(item);
    resistance = c.resistance * mass * kG;
    a1 = (c.force - resistance) / inertia;
    a2 = resistance / inertia;
    v1 = a1 * c.duration;
    stop = c.duration + v1 / a2;
    distance = v1 * stop / 2;
    const Tread& tread = item.casters[0].tread;
    wind_up =
        2 * wind_up_speed(c.force, resistance, 4 * tread.tangential_stiffness * 10 / 11, mass);
    // The resistance, f below the centre of mass at h, sets the trolley pitching by up to twice
    // f h / k_pitch; the wheels take part with J (h - R), their resistance with the heave of a base
    // that a trail moves back.
    const MassProperties whole = whole_item(item);
    const double h = whole.center_of_mass.z(), base = item.casters[0].mount.x();
    const double stiffness = 4 * tread.normal_stiffness * base * base;
    const double lever =
        (inertia - mass) / inertia * (h - c.wheel_radius) + c.resistance * item.casters[0].trail;
    pitch = 2 * lever * resistance * h / stiffness;
    pitch_rate = pitch / 2 * std::sqrt(stiffness / whole.inertia(1, 1));
    pitch_rate += pitching_speed(c.force, resistance, mass, h - c.wheel_radius, whole.inertia(1, 1),
                                 stiffness);
    // At the stop the resistance and its moment are gone: the trolley swings back over wheels that
    // stick now.
    const double treads = 4 * tread.tangential_stiffness * 10 / 11;
    recoil = 2 * resistance * (h * h / stiffness + 1 / treads);
    recoil_rate =
        resistance * (h * h / std::sqrt(stiffness * (whole.inertia(1, 1) + mass * h * h)) +
                      1 / std::sqrt(treads * mass));
  }
  double velocity(double t, double pull) const {
    return t <= pull ? a1 * t : std::max(0.0, v1 - a2 * (t - pull));
  }
  double displacement(double t, double pull) const {
    if (t <= pull) return a1 * t * t / 2;
    const double coast = std::min(t, stop) - pull;
    return v1 * pull / 2 + v1 * coast - a2 * coast * coast / 2;
  }
};

void compare(const Pull& c, double normal_stiffness, double step, bool hold_pitch,
             const std::string& how, Runner& runner) {
  Scene scene = scene_of(pulled_trolley(c, normal_stiffness));
  if (hold_pitch) scene.items[0].fixture = hold_rotations(false, true, false);
  scene.items[0].loads = {
      constant_force(c.force, c.duration, scene.items[0].model.marked_points[0].position)};
  const Exact exact(c, scene.items[0].model);
  const Response response = runner(scene, {}, run_for(exact.stop + 1, step, 0.02));

  // A run of n steps may lose or gain 1e-9 g dt of speed in each: the residual of the solve.
  const double residual = 1e-9 * kG * exact.stop;
  const double speed = exact.wind_up + (hold_pitch ? 0 : exact.pitch_rate) + residual;
  const double still = exact.a2 * step;  // it stops inside a step
  const std::string terms =
      std::string(
          "twice the wind-up of the treads (steps of its period resolve it that well), (sqrt(f (2 "
          "F - f)) - (F - f) acos(1 - f / F)) / sqrt(k M)") +
      (hold_pitch ? ""
                  : "; pitching about the axles before the wheels roll, h t' - (F - f) t1 / M, and "
                    "then (J (h - R) / (M + J) + (Cr/R) trail) f h / sqrt(k_p I_p)") +
      "; residual of the solve, 1e-9 g t";
  Track displacement("displacement, " + how, "m",
                     "the tolerance of the velocity times the time, and a2 dt^2: " + terms);
  Track velocity("velocity, " + how, "m/s",
                 terms + "; a2 dt in the step in which it stops" +
                     (hold_pitch ? "" : "; then the swing back, f h^2 / sqrt(k_p (I_p + M h^2))"));
  for (const Sample& s : response.items[0].history) {
    const PointSample& center = s.points[0];  // the item's origin swings as the trolley pitches
    const bool stops = s.time > exact.stop - step - speed / exact.a2;
    const double swing = hold_pitch ? 0 : exact.recoil_rate;
    displacement.add(s.time, center.displacement.x(), exact.displacement(s.time, c.duration),
                     speed * std::min(s.time, exact.stop) + exact.a2 * step * step +
                         (hold_pitch ? 0 : exact.pitch + (stops ? exact.recoil : 0)));
    velocity.add(s.time, center.velocity.x(), exact.velocity(s.time, c.duration),
                 speed + (stops ? still + swing : 0));
  }
  runner.report(displacement, velocity);
  runner.check("distance, " + how, "m", response.items[0].demands.residual_displacement_x,
               near_to(exact.distance, speed * exact.stop + exact.a2 * step * step,
                       "the tolerance of the velocity times the time, and a2 dt^2"));
}

void pull(const Pull& c, Runner& runner) {
  compare(c, 3e6, 0.004, false, "4 ms", runner);
  if (!runner.stock()) compare(c, 3e8, 0.0005, true, "0.5 ms, pitch held", runner);
}

/// It starts, and stops within 30 s.
bool moves(const Pull& c) {
  const double f = c.resistance * c.mass * kG;
  return c.force > 1.2 * f && c.duration * c.force / f < 30;
}

// --- wind-up of the treads
//
// A wheel does not resist in full at once: its tread and the stuck rolling resistance wind up. They
// are springs in series, k_t and 10 k_t at the rim (engine/contact/tread_law.cpp), so with
// k = n k_t 10 / 11 and the wheels turning by 1/11 of the motion, the trolley is an oscillator
// until the resistance is reached at x1 = f / k, and accelerates uniformly from x1, v1 on.

struct Soft {
  double force, duration;    // [N], [s]
  double stiffness = 1e5;    // k_t [N/m]
  double resistance = 0.02;  // Cr / R
  double mass = 96.5;        // [kg]
};

void pull(const Soft& c, Runner& runner) {
  ItemOptions options;
  options.total_mass = c.mass;
  options.caster.tread.tangential_stiffness = c.stiffness;
  options.caster.tread.rolling_friction_length = c.resistance * options.caster.wheel_radius;
  Scene scene = scene_of(trolley(options));
  const Tread& tread = scene.items[0].model.casters[0].tread;
  scene.items[0].fixture = hold_rotations(false, true, false);
  scene.items[0].loads = {constant_force(c.force, c.duration, {0, 0, 0.6})};

  const double inertia = wheel_inertia_mass(scene.items[0].model);
  const double f = c.resistance * c.mass * kG, k = 4 * c.stiffness * 10 / 11;
  const double x1 = f / k, t1 = std::acos(1 - f / c.force) / std::sqrt(k / c.mass);
  const double v1 = std::sqrt(f * (2 * c.force - f) / (k * c.mass));
  const double a1 = (c.force - f) / (c.mass + inertia), t = c.duration - t1;

  const Response response = runner(scene, {}, run_for(c.duration, 0.001, 0.01));
  // Not in the formula: the damping of the patch, and the wheels that spin up from 1/11 to 1.
  const double missing =
      2.0 / 3 * 4 * tread.tangential_damping * x1 / c.mass + 10.0 / 11 * inertia / c.mass * v1;
  const Sample& end = response.items[0].history.back();
  const char* const terms =
      "1.5 times what the formula leaves out: damping of the patch, (2/3) n c_t x1 / M, and the "
      "wheels that spin up, (10/11) J/M v1";
  runner.check("velocity at the end of the pull", "m/s", end.velocity.x(),
               near_to(v1 + a1 * t, 1.5 * missing, terms));
  runner.check("displacement at the end of the pull", "m", end.displacement.x(),
               near_to(x1 + v1 * t + a1 * t * t / 2, 1.5 * missing * c.duration,
                       std::string("times the duration: ") + terms));
  runner.check(
      "speed that winding up adds", "m/s", end.velocity.x() - a1 * c.duration,
      near_to(wind_up_speed(c.force, f, k, c.mass + inertia), 1.5 * missing + inertia / c.mass * v1,
              std::string(terms) + "; J/M v1 for the mass that starts"));
}

/// The wind-up is over before the pull is.
bool winds_up(const Soft& c) { return c.force > 1.1 * c.resistance * c.mass * kG; }

// --- a slope

struct Ramp {
  double slope, share;  // tan(angle), and Cr / R over it
  double mass = 96.5, wheel_mass = 0.25;
};

/// Casters trail as the trolley rolls down; x points uphill.
Scene on_slope(const Ramp& c, double slope, double resistance, bool stiff) {
  ItemOptions options;
  options.total_mass = c.mass;
  options.caster.wheel_mass = c.wheel_mass;
  options.caster.tread.rolling_friction_length = resistance * options.caster.wheel_radius;
  if (stiff) stiffen(options.caster.tread);
  set_wheel_inertia(options.caster);
  options.headings.assign(4, std::numbers::pi);
  Scene scene = scene_of(trolley(options));
  scene.slope = slope;
  return scene;
}

// A run starts from equilibrium, so the trolley winds up its treads from rest (wind_up.h).
void accelerates(const Ramp& c, Runner& runner) {
  constexpr double kDuration = 4;
  Scene scene = on_slope(c, c.slope, c.share * c.slope, true);
  const EquipmentModel& item = scene.items[0].model;
  const double mass = total_mass(item), inertia = mass + wheel_inertia_mass(item);
  const double pull = mass * kG * std::sin(std::atan(c.slope)), resistance = c.share * pull;
  const double a = (pull - resistance) / inertia;
  scene.items[0].fixture = hold_rotations(false, true, false);
  const Response response = runner(scene, {}, run_for(kDuration, 0.004, 0.02));
  const double k = 4 * item.casters[0].tread.tangential_stiffness * 10 / 11;
  const double speed = wind_up_speed(pull, resistance, k, mass);
  const char* const terms =
      "wind-up of the treads, (sqrt(f (2 F - f)) - (F - f) acos(1 - f / F)) / sqrt(k M) with F = M "
      "g sin; residual of the solve, 1e-9 g t";
  Track displacement("displacement", "m", std::string("times the time: ") + terms);
  Track velocity("velocity", "m/s", terms);
  for (const Sample& s : response.items[0].history) {
    const double tolerance = speed + 1e-9 * kG * s.time, t = s.time;
    displacement.add(t, s.displacement.x(), -a * t * t / 2, tolerance * t);
    velocity.add(t, s.velocity.x(), -a * t, tolerance);
  }
  runner.report(displacement, velocity);
}

// The hold on soft treads is stuck rolling resistance: it neither creeps nor rolls.
void holds(const Ramp& c, Runner& runner) {
  constexpr double kRolled = 1e-3, kDuration = 10;  // [m], [s]
  const double resistance = c.slope / 2;
  const double threshold = locate(0.8, 1.2, 0.004, [&](double share) {
    return runner(on_slope(c, share * resistance, resistance, false), {}, run_for(kDuration, 0.004))
               .items[0]
               .demands.residual_displacement_x < -kRolled;
  });
  runner.check("slope from which it rolls, over Cr/R", "", threshold,
               near_to(1, 0.002 + 2 * kRolled / (kG * kDuration * kDuration * resistance),
                       "half of the last bracket, 0.002, and the slope that needs 10 s to roll 1 "
                       "mm, 2 x / (g t^2 Cr/R)"));
}

void ramp(const Ramp& c, Runner& runner) {
  accelerates(c, runner);
  holds(c, runner);
}

}  // namespace

Family constant_pull() {
  return on_stock_too(make_family<Pull>(
      {"constant_pull", "pulling", "A trolley pulled by a constant force, then coasting to rest",
       "a1 = (F - f_r) / (M + J), a2 = f_r / (M + J), f_r = (Cr/R) M g, J = sum I_w / R^2",
       "Newton's law for cart and wheels; Xu, Ma & Kurata 2022, 5th SPONSE workshop"},
      fields(FIELD(Pull, force, "N", 20, 150), FIELD(Pull, duration, "s", 0.5, 4),
             FIELD(Pull, resistance, "Cr/R", 0.005, 0.05), FIELD(Pull, mass, "kg", 40, 250),
             FIELD(Pull, wheel_mass, "kg", 0.1, 2), FIELD(Pull, wheel_radius, "m", 0.0375, 0.1)),
      cases(at("light", 40, 3, 0.02), at("strong", 80, 1.5, 0.03),
            at("loaded", 60, 2, 0.015, 164.5), at("heavy_wheels", 50, 2, 0.02, 96.5, 1.5),
            at("large_wheels", 35, 2.5, 0.01, 96.5, 0.6, 0.0625)),
      pull, moves));
}

Family wind_up() {
  return make_family<Soft>(
      {"wind_up", "pulling", "A trolley on soft treads: they wind up before they resist",
       "x = F/k (1 - cos(w t)) until x1 = f/k, w^2 = k/M; v1^2 = f (2 F - f) / (k M); then a1",
       "Newton's law for an oscillator, then for cart and wheels"},
      fields(FIELD(Soft, force, "N", 20, 150), FIELD(Soft, duration, "s", 0.5, 3),
             FIELD(Soft, stiffness, "N/m", 5e4, 5e5), FIELD(Soft, resistance, "Cr/R", 0.005, 0.03),
             FIELD(Soft, mass, "kg", 60, 250)),
      cases(at("weak", 30, 3), at("plain", 40, 2.25), at("strong", 80, 1.125)), pull, winds_up);
}

Family slope() {
  return make_family<Ramp>(
      {"slope", "pulling", "A trolley on a slope: it rests below a threshold and rolls above it",
       "rests while tan(a) < Cr/R, else a = M g sin(a) (1 - Cr/R / tan(a)) / (M + J)",
       "Newton's law; rolling resistance as dry friction"},
      fields(FIELD(Ramp, slope, "tan", 0.004, 0.08), FIELD(Ramp, share, "Cr/R over tan", 0, 0.8),
             FIELD(Ramp, mass, "kg", 40, 250), FIELD(Ramp, wheel_mass, "kg", 0.1, 2)),
      cases(at("gentle_free", 0.005, 0), at("gentle", 0.005, 0.3), at("gentle_half", 0.005, 0.5),
            at("free", 0.01, 0), at("plain", 0.01, 0.3), at("half", 0.01, 0.5),
            at("steep_free", 0.03, 0), at("steep", 0.03, 0.3), at("steep_half", 0.03, 0.5)),
      ramp);
}

}  // namespace gurney::verification
