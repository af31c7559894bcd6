#include <algorithm>
#include <cmath>
#include <complex>

#include "studies/verification/cases/drop_weight_rig.h"
#include "studies/verification/family.h"
#include "studies/verification/gravity.h"
#include "studies/verification/scenes/wind_up.h"

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

/// What one step of the method makes of y' = z / h y (engine/solver/quadrature.h).
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
    "- T) / sqrt(k_c m_r) "
    "m_d / (M + m_d), and what it gives back at the landing, T^2 / (2 k_c M v); residual 1e-9 g t";
const char* const kPitching =
    "; pitching before the wheels roll (constant_pull), then moment / sqrt(k_p I_p) times levers "
    "of wheels and cable";

/// Runs a rig and holds every phase against the closed form.
void compare(const Rig& c, double normal_stiffness, double step, bool hold_pitch,
             const std::string& how, const Runner& runner, Findings& findings) {
  Scene scene = scene_of(pulled_trolley(c, normal_stiffness));
  scene.items[0].loads = rigged(c);
  if (hold_pitch) scene.items[0].fixture = hold_rotations(false, true, false);
  const Exact e(c, scene.items[0].model);
  const Bounds b = bounds(c, scene.items[0], !hold_pitch);
  const Response response =
      runner(findings, scene, {}, run_for(kReleaseTime + e.stop + 1, step, 0.02));

  const std::string terms = std::string(kTerms) + (hold_pitch ? "" : kPitching);
  Track displacement("displacement, " + how, "m",
                     "the tolerance of the velocity times the time; stretch of cable and blocks, "
                     "m_d g / k; a2 dt^2 at the stop: " +
                         terms);
  Track velocity("velocity, " + how, "m/s",
                 terms + "; a2 dt in the step in which it stops" +
                     (hold_pitch ? "" : "; then the swing back, f h^2 / sqrt(k_p (I_p + M h^2))"));
  Track tension(
      "cable tension, " + how, "N",
      "(m_d g - F_w - T) |R(dt lambda)|^(t/dt - 1), the swing after the release as the method "
      "damps it, lambda^2 m_r + lambda c_c + k_c = 0; 1e-6 m_d g for the solve and 1e-10 m of "
      "cable for the start" +
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
  displacement.report(findings);
  velocity.report(findings);
  tension.report(findings);
  // The weight loses its energy where it lands, so the loss gives the speed at the event.
  const double loss = 0.5 * (c.weight + e.pulley) * e.velocity * e.velocity;
  findings.checks.push_back({"energy lost at the landing, " + how, "J",
                             response.items[0].energy.damper_loss, loss,
                             2 * b.speed / e.velocity * loss + 2 * b.strain,
                             "twice the relative tolerance of the velocity; strain energy F^2 / "
                             "(2 k) of blocks and cable"});
  findings.checks.push_back({"energy of the weight, " + how, "J",
                             response.items[0].energy.weight_energy, -c.weight * kG * c.drop,
                             1e-8 * c.weight * kG, "landing located to 1e-8 m"});
}

Findings pull(const Rig& c, const Runner& runner) {
  Findings findings;
  compare(c, 3e6, 0.004, false, "4 ms", runner, findings);
  compare(c, 3e8, 0.0005, true, "0.5 ms, pitch held", runner, findings);
  return findings;
}

/// It starts, the cable stays taut, and the trolley stops within 30 s.
bool pulls(const Rig& c) {
  const Exact e(c, pulled_trolley(c, 3e6));
  return c.weight * kG - c.trolley_string - c.weight_string > 1.2 * e.resistance && e.stop < 30;
}

}  // namespace

Family drop_weight() {
  return make_family<Rig>(
      {"drop_weight", "pulling", "A trolley pulled by a falling weight, then coasting to rest",
       "a1 = (m_d g - f_r - F_s - F_w) / (M + J + m_d + p), a2 = (f_r + F_s) / (M + J), "
       "T = m_d (g - a1) - F_w - p a1, p = I_p / r_p^2",
       "Newton's law for the rig of Xu, Ma & Kurata 2022"},
      {{{"weight", "kg", 4, 15}, &Rig::weight},
       {{"drop", "m", 0.3, 1.2}, &Rig::drop},
       {{"resistance", "Cr/R", 0.01, 0.04}, &Rig::resistance},
       {{"trolley_string", "N", 0, 6}, &Rig::trolley_string},
       {{"weight_string", "N", 0, 6}, &Rig::weight_string},
       {{"pulley_inertia", "kg m2", 0, 0.004}, &Rig::pulley_inertia},
       {{"block_height", "m", 0.131, 0.618}, &Rig::block_height},
       {{"mass", "kg", 60, 200}, &Rig::mass}},
      {{"plain", {5, 0.7, 0.02}},
       {"strings", {6, 0.8, 0.02, 3, 2}},
       {"pulley", {8, 0.6, 0.03, 2, 2, 0.002}},
       {"low_blocks", {6, 0.8, 0.025, 0, 0, 0, 0.131}},
       {"loaded", {9, 0.9, 0.015, 4, 4, 0.001, 0.618, 164.5}}},
      pull, pulls);
}

}  // namespace gurney::verification
