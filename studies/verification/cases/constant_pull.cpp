#include <algorithm>
#include <cmath>

#include "studies/verification/family.h"
#include "studies/verification/gravity.h"
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
             const std::string& how, const Runner& runner, Findings& findings) {
  Scene scene = scene_of(pulled_trolley(c, normal_stiffness));
  if (hold_pitch) scene.items[0].fixture = hold_rotations(false, true, false);
  scene.items[0].loads = {
      constant_force(c.force, c.duration, scene.items[0].model.marked_points[0].position)};
  const Exact exact(c, scene.items[0].model);
  const Response response = runner(findings, scene, {}, run_for(exact.stop + 1, step, 0.02));

  // A run of n steps may lose or gain 1e-9 g dt of speed in each: the residual of the solve.
  const double residual = 1e-9 * kG * exact.stop;
  const double speed = exact.wind_up + (hold_pitch ? 0 : exact.pitch_rate) + residual;
  const double still = exact.a2 * step;  // it stops inside a step
  const std::string terms =
      std::string(
          "twice the wind-up of the treads (steps of its period resolve it that well), (sqrt(f (2 "
          "F - f)) - (F - f) acos(1 - f / F)) / sqrt(k M)") +
      (hold_pitch
           ? ""
           : "; pitching about the axles before the wheels roll, h t' - (F - f) t1 / M, and then "
             "(J (h - R) / (M + J) + (Cr/R) trail) f h / sqrt(k_p I_p)") +
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
  displacement.report(findings);
  velocity.report(findings);
  findings.checks.push_back({"distance, " + how, "m",
                             response.items[0].demands.residual_displacement_x, exact.distance,
                             speed * exact.stop + exact.a2 * step * step,
                             "the tolerance of the velocity times the time, and a2 dt^2"});
}

Findings pull(const Pull& c, const Runner& runner) {
  Findings findings;
  compare(c, 3e6, 0.004, false, "4 ms", runner, findings);
  if (!runner.stock()) compare(c, 3e8, 0.0005, true, "0.5 ms, pitch held", runner, findings);
  return findings;
}

/// It starts, and stops within 30 s.
bool moves(const Pull& c) {
  const double f = c.resistance * c.mass * kG;
  return c.force > 1.2 * f && c.duration * c.force / f < 30;
}

}  // namespace

Family constant_pull() {
  Family family = make_family<Pull>(
      {"constant_pull", "pulling", "A trolley pulled by a constant force, then coasting to rest",
       "a1 = (F - f_r) / (M + J), a2 = f_r / (M + J), f_r = (Cr/R) M g, J = sum I_w / R^2",
       "Newton's law for cart and wheels; Xu, Ma & Kurata 2022, 5th SPONSE workshop"},
      {{{"force", "N", 20, 150}, &Pull::force},
       {{"duration", "s", 0.5, 4}, &Pull::duration},
       {{"resistance", "Cr/R", 0.005, 0.05}, &Pull::resistance},
       {{"mass", "kg", 40, 250}, &Pull::mass},
       {{"wheel_mass", "kg", 0.1, 2}, &Pull::wheel_mass},
       {{"wheel_radius", "m", 0.0375, 0.1}, &Pull::wheel_radius}},
      {{"light", {40, 3, 0.02}},
       {"strong", {80, 1.5, 0.03}},
       {"loaded", {60, 2, 0.015, 164.5}},
       {"heavy_wheels", {50, 2, 0.02, 96.5, 1.5}},
       {"large_wheels", {35, 2.5, 0.01, 96.5, 0.6, 0.0625}}},
      pull, moves);
  family.on_stock = true;
  return family;
}

}  // namespace gurney::verification
