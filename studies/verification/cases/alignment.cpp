#include <algorithm>
#include <cmath>

#include "engine/base/units.h"
#include "studies/verification/family.h"
#include "studies/verification/scenes/small_scenes.h"

// A caster whose pivot is led at constant speed v along x turns into line. Without slip the contact
// point moves along the wheel only: trail psi' = -v sin psi. The tread is stiff and its friction
// (mu = 5) never reached; it slips by F / (k_t sigma) of its path.
namespace gurney::verification {
namespace {

constexpr double kStiffness = 1e9, kRelaxation = 0.01;  // k_t [N/m], sigma [m]
constexpr double kTrails = 12;                          // path of a run, in trails

struct Start {
  double heading, trail, speed;  // [deg], [m], [m/s]
};

Tread stiff_tread() {
  Tread tread = small::bare_tread(3e8, kStiffness);
  tread.relaxation_length = kRelaxation;
  tread.tangential_damping = 100;
  tread.static_friction = tread.kinetic_friction = 5;
  return tread;
}

/// An error of the path s = v t / trail turns the caster by sin(psi) of it. Two sources are errors
/// of the path: the slip, F / (k_t sigma) of it with F <= I_p (v / trail)^2 / (2 trail), which
/// follows from psi'' = (v / trail)^2 sin(2 psi) / 2; and the method, which for y' = -y, and so for
/// psi near its end, makes 3 gamma^2 - 2 gamma^3 - 1/6 = 0.0404 h^2 of it; elsewhere the third
/// derivative is smaller.
/// @param step  h, in trails
void follow(const Start& c, double step, const Runner& runner, Findings& findings) {
  const double time = c.trail / c.speed, start = c.heading * kRadiansPerDegree;
  const Scene towed = small::towed_caster(c.speed, c.trail, c.heading, stiff_tread());
  const Response response =
      runner(findings, towed, {}, small::settings_for(step * time, kTrails * time));
  const double force =
      small::swivel_inertia(towed.items[0].model.casters[0]) / (2 * time * time * c.trail);
  const double slip = force / (kStiffness * kRelaxation);
  const auto heading = [&](double path) {
    return 2 * std::atan(std::tan(start / 2) * std::exp(-path));
  };
  double shift = 0;
  for (const Sample& s : response.items[0].history)
    shift = std::max(shift, s.time / time * std::abs(std::sin(heading(s.time / time))));
  Track track(step == 0.05 ? "swivel angle, steps of 1/20 trail" : "swivel angle, 1/40 trail",
              "rad",
              "the method's 0.0404 h^2 of the path, h in trails, at most max(s sin psi) of it in "
              "angle; slip I_p (v/L)^2 / (2 L k_t sigma) of 12 trails");
  for (const Sample& s : response.items[0].history)
    track.add(s.time, s.wheels[0].swivel_angle, heading(s.time / time),
              shift * 0.0404 * step * step + kTrails * slip);
  track.report(findings);
}

Findings align(const Start& c, const Runner& runner) {
  Findings findings;
  follow(c, 0.05, runner, findings);
  follow(c, 0.025, runner, findings);
  return findings;
}

/// The longer of the steps is one that the engine takes.
bool short_steps(const Start& c) { return 0.05 * c.trail / c.speed <= 0.02; }

}  // namespace

Family alignment() {
  return make_family<Start>(
      {"alignment", "casters", "A caster that is led along a line turns into it",
       "tan(psi/2) = tan(psi_0/2) exp(-v t / trail)", "kinematics of rolling: the tractrix"},
      {{{"heading", "deg", -179, 179}, &Start::heading},
       {{"trail", "m", 0.015, 0.08}, &Start::trail},
       {{"speed", "m/s", 0.1, 3}, &Start::speed}},
      {{"30", {30, 0.034, 1}},
       {"60_slow", {60, 0.034, 0.2}},
       {"crosswise", {90, 0.034, 1}},
       {"120_long_trail", {120, 0.05, 2}},
       {"150_short_trail", {150, 0.02, 0.5}},
       {"170", {170, 0.034, 1}},
       {"minus_30", {-30, 0.02, 1}},
       {"minus_75", {-75, 0.05, 0.2}},
       {"minus_135_fast", {-135, 0.034, 3}},
       {"minus_170", {-170, 0.034, 0.3}},
       {"reversed", {179, 0.034, 0.5}},  // on a crest: one degree off it turns over, to either side
       {"minus_reversed", {-179, 0.034, 0.5}}},
      align, short_steps);
}

}  // namespace gurney::verification
