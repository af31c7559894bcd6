#include <algorithm>
#include <cmath>
#include <numbers>

#include "studies/verification/cases/slider.h"
#include "studies/verification/family.h"
#include "studies/verification/scenes/scenes.h"
#include "studies/verification/scenes/wind_up.h"

// A floor that rotates about y by theta(t): in its frame a mass m at height h feels m g theta along
// x, and m h theta'' against it.
namespace gurney::verification {
namespace {

using namespace scenes;

constexpr double kPi = std::numbers::pi;

template <class Angle, class Acceleration>
FloorMotion rotating_floor(double time_step, double duration, const Angle& angle,
                           const Acceleration& acceleration) {
  const auto samples = static_cast<Eigen::Index>(std::lround(duration / time_step)) + 1;
  FloorRotation rotation{Eigen::Matrix3Xd::Zero(3, samples), Eigen::Matrix3Xd::Zero(3, samples)};
  for (Eigen::Index i = 0; i < samples; ++i) {
    const double time = time_step * static_cast<double>(i);
    rotation.angle(1, i) = angle(time);
    rotation.acceleration(1, i) = acceleration(time);
  }
  return FloorMotion(time_step, Eigen::Matrix3Xd::Zero(3, samples)).with_rotation(rotation);
}

/// theta_0 sin(w t).
FloorMotion harmonic_floor(double time_step, double duration, double angle, double w) {
  return rotating_floor(
      time_step, duration, [=](double t) { return angle * std::sin(w * t); },
      [=](double t) { return -w * w * angle * std::sin(w * t); });
}

// ---------------------------------------------------------------- a constant angle

struct Tilted {
  double angle, share;  // [rad], and Cr / R over it
  double mass = 96.5;
};

/// Casters trail as the trolley rolls down; x points downhill.
Scene on_level_floor(const Tilted& c) {
  ItemOptions options;
  options.total_mass = c.mass;
  options.caster.tread.rolling_friction_length = c.share * c.angle * options.caster.wheel_radius;
  stiffen(options.caster.tread);
  set_wheel_inertia(options.caster);
  options.headings.assign(4, 0);
  Scene scene = scene_of(trolley(options));
  scene.items[0].fixture = hold_rotations(false, true, false);
  return scene;
}

void tilted(const Tilted& c, Runner& runner) {
  constexpr double kDuration = 4, kStep = 0.004;
  const Scene level = on_level_floor(c);
  Scene sloping = level;
  sloping.slope = -std::tan(c.angle);
  const FloorMotion rotated = rotating_floor(
      1, kDuration, [&](double) { return c.angle; }, [](double) { return 0.0; });
  const SimulationSettings settings = run_for(kDuration, kStep, 0.02);
  const Response rolls = runner(level, rotated, settings);
  const Response on_slope = runner(sloping, {}, settings);

  const EquipmentModel& item = level.items[0].model;
  const double mass = total_mass(item), inertia = mass + wheel_inertia_mass(item);
  const double pull = mass * kG * c.angle, resistance = c.share * pull;
  const double a = (pull - resistance) / inertia;
  const double k = 4 * item.casters[0].tread.tangential_stiffness * 10 / 11;
  const double wind_up = wind_up_speed(pull, resistance, k, mass);
  const double square = kG * std::pow(c.angle, 3) * (1.0 / 6 + c.share / 2);
  Track displacement("displacement", "m",
                     "times the time: wind-up of the treads, (sqrt(f (2 F - f)) - (F - f) acos(1 - "
                     "f / F)) / sqrt(k M) with F = M g theta; residual of the solve, 1e-9 g t");
  Track slope("displacement, less that on a slope of theta", "m",
              "sin and cos of a slope are theta and 1 of a rotation, g theta^3 (1/6 + share / 2) "
              "t^2 / 2; residuals of both solves, 2e-9 g t^2");
  const std::vector<Sample>&here = rolls.items[0].history, &there = on_slope.items[0].history;
  for (std::size_t i = 0; i < std::min(here.size(), there.size()); ++i) {
    const double t = here[i].time, x = here[i].displacement.x();
    displacement.add(t, x, a * t * t / 2, (wind_up + 1e-9 * kG * t) * t);
    slope.add(t, x - there[i].displacement.x(), 0, (square / 2 + 2e-9 * kG) * t * t);
  }
  runner.report(displacement, slope);
}

// ---------------------------------------------------------------- sliding and rolling

struct Rocked {
  double rolls, friction, angle, frequency;  // cart or block, mu or Cr/R, theta_0 [rad], [Hz]
};

/// Amplitude of the apparent acceleration of the floor, g theta_0 + h w^2 theta_0. The spin of
/// wheels lags behind the floor's, which adds J R to M h.
double amplitude(const Rocked& c, const sliding::Slider& slider) {
  const MassProperties whole = whole_item(slider.item);
  const double w = 2 * kPi * c.frequency;
  const double spin = c.rolls != 0 ? wheel_inertia_mass(slider.item) *
                                         slider.item.casters[0].wheel_radius / whole.mass
                                   : 0.0;
  return c.angle * (kG + w * w * (whole.center_of_mass.z() + spin));
}

/// Steady, of a block that always slides (harmonic_slip).
double peak_to_peak(double friction, double amplitude, double w) {
  return 2 * amplitude / (w * w) * std::sqrt(1 - std::pow(kPi * friction * kG / amplitude / 2, 2));
}

void rocked(const Rocked& c, Runner& runner) {
  constexpr double kStep = 2e-4, kSampling = 1e-3;  // [s]
  const sliding::Slider slider = sliding::make_slider(c.rolls != 0, c.friction);
  const double w = 2 * kPi * c.frequency, a = amplitude(c, slider), cycles = 3 / c.frequency;
  // Steady motion starts where the triangular velocity of friction meets that of the floor.
  const double eta = kPi * c.friction * kG / a / 2;
  const double start = -(a / w - c.friction * kG / w * (kPi / 2 - std::acos(eta)));
  const Response response =
      sliding::shake(slider, harmonic_floor(kSampling, cycles, c.angle, w),
                     run_for(cycles, kStep, kSampling), slider.scale * start, runner);
  double low = INFINITY, high = -INFINITY;
  for (const Sample& s : response.items[0].history) {
    if (s.time < cycles - 1.5 / c.frequency) continue;
    low = std::min(low, s.displacement.x());
    high = std::max(high, s.displacement.x());
  }
  const double exact = slider.scale * peak_to_peak(c.friction, a, w);
  const double lever = w * w * c.angle * exact / kG;
  const double pressed = exact - slider.scale * peak_to_peak(c.friction * (1 + lever), a, w);
  const double reversal = 2 * c.friction * kG * kStep;
  const double sampling = (a + c.friction * kG) * kSampling * kSampling / 4;
  runner.check("steady displacement, peak to peak", "m", high - low,
               near_to(exact,
                       (reversal + slider.wind_up) / (2 * c.frequency) + sampling + pressed +
                           std::pow(w * kSampling, 2) * exact,
                       "2 mu g dt at a reversal and mu g sqrt(M/k) of winding up, for half a "
                       "cycle; extremes between samples, (A + mu g) dt_s^2 / 4; friction times 1 + "
                       "theta'' x / g, by the formula; the sampled sine, (w dt_s)^2"));

  Rocked gentle = c;
  gentle.angle *= 0.95 * c.friction * kG / a;
  const Response still = sliding::shake(slider, harmonic_floor(kSampling, cycles, gentle.angle, w),
                                        run_for(cycles, 0.002), 0, runner);
  const double sway = 0.95 * c.friction * kG * total_mass(slider.item) / slider.stiffness;
  runner.check("peak displacement at 0.95 of the threshold", "m",
               still.items[0].demands.peak_displacement,
               near_to(0, 2 * sway + 1e-10,
                       "sway of the treads, M a / k, at most twice; 1e-10 m for rounding"));
}

/// Slides all the time, pi mu g / (2 A) < 1, with a margin.
bool slides(const Rocked& c) {
  return amplitude(c, sliding::make_slider(c.rolls != 0, c.friction)) > 1.8 * c.friction * kG;
}

// ---------------------------------------------------------------- standing

struct Stood {
  double angle, frequency;  // theta_0 [rad], [Hz]
  double height = 0.618, mass = 96.5;
};

void stood(const Stood& c, Runner& runner) {
  constexpr double kStep = 0.002;
  ItemOptions options;
  options.total_mass = c.mass;
  options.chassis_center.z() = c.height;
  options.caster.tread.rolling_friction_length =
      0;  // or Cr N of the moment goes through the patches
  stiffen(options.caster.tread);
  Scene scene = scene_of(locked_block(options));
  const EquipmentModel& item = scene.items[0].model;
  const MassProperties whole = whole_item(item);
  const Vector3 center = whole.center_of_mass;
  const double w = 2 * kPi * c.frequency, cycles = 2 / c.frequency;
  const FloorMotion floor = harmonic_floor(kStep, cycles, c.angle, w);
  const Response response = runner(scene, floor, run_for(cycles, kStep, kStep));

  const Caster& caster = item.casters[0];
  const double front = options.half_wheelbase - caster.trail - center.x();
  const double rear = -options.half_wheelbase - caster.trail - center.x();
  const double inertia = whole.inertia(1, 1) + whole.mass * center.z() * center.z();
  const double moment = c.angle * (whole.mass * kG * center.z() + w * w * inertia);
  const double pitch = std::sqrt(4 * caster.tread.normal_stiffness * front * front / inertia);
  const double sway = std::sqrt(4 * caster.tread.tangential_stiffness / whole.mass);
  const double tilt = whole.mass * kG / (4 * caster.tread.normal_stiffness * (front - rear));
  Track load("load of the front wheels", "N",
             "the load's rise from rest vibrates on stiff treads, w / w_pitch of its amplitude M_0 "
             "/ l, twice; the chassis leans by M g / (4 k_n l) of M g; 1e-9 M g of the solve");
  Track carried("absolute acceleration of the centre of mass along x", "m/s2",
                "the same vibration at the height h, w / w_pitch, and that of the treads along x, "
                "w / w_sway of (g + w^2 h) theta_0, twice; 1e-6 g of the solve");
  const double amplitude = moment / (front - rear);
  const double push = (kG + w * w * center.z()) * c.angle;
  for (const Sample& s : response.items[0].history) {
    if (s.time <= 0 || s.time >= cycles) continue;
    const double theta = c.angle * std::sin(w * s.time), twice = -w * w * theta;
    const double weight = whole.mass * (kG - twice * center.x());
    const double pitching = whole.mass * kG * center.z() * theta - inertia * twice;
    load.add(s.time, s.wheels[0].normal_force + s.wheels[1].normal_force,
             (pitching - rear * weight) / (front - rear),
             2 * w / pitch * amplitude + (tilt + 1e-9) * whole.mass * kG);
    carried.add(s.time, s.points[0].absolute_acceleration.x(), twice * center.z(),
                2 * w * (1 / pitch + 1 / sway) * push + 1e-6 * kG);
  }
  runner.report(load, carried);
}

}  // namespace

Family tilted_floor() {
  return make_family<Tilted>(
      {"tilted_floor", "rotation", "A trolley rolls on a floor that stays rotated",
       "a = M g theta (1 - Cr/R / theta) / (M + J); as on a slope of theta",
       "Newton's law; rolling resistance as dry friction"},
      fields(FIELD(Tilted, angle, "rad", 0.002, 0.05), FIELD(Tilted, share, "Cr/R over it", 0, 0.8),
             FIELD(Tilted, mass, "kg", 40, 250)),
      cases(at("free", 0.005, 0), at("gentle", 0.002, 0.5), at("plain", 0.005, 0.5),
            at("steep", 0.05, 0.3)),
      tilted);
}

Family rocking_floor() {
  return make_family<Rocked>(
      {"rocking_floor", "rotation", "Sliding and rolling on a floor that rocks harmonically",
       "(2 A/w^2) sqrt(1 - (pi mu g / (2 A))^2), A = theta_0 (g + w^2 h), so 2 theta_0 (g / w^2 + "
       "h) without friction; a cart with mu = Cr/R: h + J R / M, times M / (M + J)",
       "Newton's law in the frame of the floor; then harmonic_slip"},
      fields(FIELD(Rocked, rolls, "0 block, 1 cart", 0, 1, true),
             FIELD(Rocked, friction, "mu or Cr/R", 0.0002, 0.01),
             FIELD(Rocked, angle, "rad", 0.002, 0.02), FIELD(Rocked, frequency, "Hz", 0.3, 2)),
      cases(at("block", 0, 0.003, 0.005, 0.5), at("block_1_Hz", 0, 0.005, 0.005, 1),
            at("cart", 1, 0.003, 0.005, 0.5), at("cart_free", 1, 0.0002, 0.005, 0.5),
            at("cart_1_Hz", 1, 0.005, 0.005, 1), at("cart_strong", 1, 0.01, 0.02, 1)),
      rocked, slides);
}

Family rocking_floor_loads() {
  return make_family<Stood>(
      {"rocking_floor_loads", "rotation", "Wheel loads of an item that a rocking floor carries",
       "N_front l = M g theta h - (I + M h^2) theta'' - x_rear M (g - theta'' x_G); a = theta'' h",
       "Newton's and Euler's laws in the frame of the floor"},
      fields(FIELD(Stood, angle, "rad", 0.002, 0.02), FIELD(Stood, frequency, "Hz", 0.3, 3),
             FIELD(Stood, height, "m", 0.4, 0.9), FIELD(Stood, mass, "kg", 40, 250)),
      cases(at("slow", 0.005, 0.5), at("plain", 0.005, 1), at("fast", 0.005, 3),
            at("high", 0.01, 1, 0.9)),
      stood);
}

}  // namespace gurney::verification
