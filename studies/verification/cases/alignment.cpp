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
void follow(const Start& c, double step, Runner& runner) {
  const double time = c.trail / c.speed, start = c.heading * kRadiansPerDegree;
  const Scene towed = small::towed_caster(c.speed, c.trail, c.heading, stiff_tread());
  const Response response = runner(towed, {}, small::settings_for(step * time, kTrails * time));
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
  runner.report(track);
}

void align(const Start& c, Runner& runner) {
  follow(c, 0.05, runner);
  follow(c, 0.025, runner);
}

/// The longer of the steps is one that the engine takes.
bool short_steps(const Start& c) { return 0.05 * c.trail / c.speed <= 0.02; }

// --- the same, of a trolley that is not led
//
// A heavy trolley that rolls on leads its casters as a rail would (alignment.cpp): stock Bullet,
// which knows no fixtures, can run it too. Casters on both sides stand at opposite headings, so
// that neither their side forces nor their moments steer it.
//
// Energy of casters and wheels as they turn comes from the trolley. With psi' = -v sin(psi)
// / L and a spin of v cos(psi) / R the whole has the energy G v^2 / 2,
//
//     G(psi) = M + n [(I_p / L^2 - 2 S / L) sin(psi)^2 + J cos(psi)^2 / R^2],
//
// S and I_p being the first and second moment of a caster about its swivel axis. It stays, so v
// goes as sqrt(1 / G). A run starts with casters and wheels that turn as its speed asks.

constexpr double kFreeTrails = 8, kFreeStep = 0.05;  // path of a run and a step, in trails

struct FreeStart {
  double heading, speed, mass;  // [deg], [m/s], of the chassis [kg]
};

/// Heading over the path that the trolley would go at the speed it starts with, in trails.
class Tractrix {
 public:
  Tractrix(const EquipmentModel& item, double heading) : heading_(heading) {
    const Caster& c = item.casters[0];
    const double L = c.trail, R = c.wheel_radius, mass = whole_item(item).mass;
    const double first = -c.fork_mass * c.fork_center_of_mass.x() + c.wheel_mass * L;
    turn_ = 4 / mass * (small::swivel_inertia(c) / (L * L) - 2 * first / L);
    roll_ = 4 / mass * c.wheel_axial_inertia / (R * R);
    energy_ = share(heading);
  }

  /// Runge-Kutta of fourth order.
  void advance(double path) {
    const int steps = static_cast<int>(std::ceil(path / 0.01));
    const double h = path / steps;
    for (int i = 0; i < steps; ++i) {
      const double a = rate(heading_), b = rate(heading_ + h / 2 * a),
                   c = rate(heading_ + h / 2 * b), d = rate(heading_ + h * c);
      heading_ += h / 6 * (a + 2 * b + 2 * c + d);
    }
  }
  double heading() const { return heading_; }

 private:
  double share(double heading) const {
    const double s2 = std::pow(std::sin(heading), 2);
    return 1 + turn_ * s2 + roll_ * (1 - s2);
  }
  double rate(double heading) const {
    return -std::sqrt(energy_ / share(heading)) * std::sin(heading);
  }
  double heading_, turn_ = 0, roll_ = 0, energy_ = 1;
};

void align(const FreeStart& c, Runner& runner) {
  Tread tread = stiff_tread();
  tread.normal_damping = 1.6e4;
  Scene scene = scene_of({});
  EquipmentModel& item = scene.items[0].model;
  item = small::trolley({c.heading, -c.heading, c.heading, -c.heading}, tread);
  item.chassis_mass = c.mass;
  item.chassis_inertia = solid_box_inertia(c.mass, {1.0, 0.5, 0.7});
  item.chassis_center_of_mass.z() = 0.131;  // low: side forces roll it little
  scene.items[0].initial.velocity.x() = c.speed;

  const Caster& caster = item.casters[0];
  const double time = caster.trail / c.speed, start = c.heading * kRadiansPerDegree;
  const Response response =
      runner(scene, {}, small::settings_for(kFreeStep * time, kFreeTrails * time));
  const double inertia = small::swivel_inertia(caster);
  const double slip = inertia / (2 * time * time * caster.trail) / (kStiffness * kRelaxation);
  double shift = 0;
  for (const Sample& s : response.items[0].history) {
    const double path = s.time / time;
    shift = std::max(shift, path * std::sin(2 * std::atan(std::tan(start / 2) * std::exp(-path))));
  }
  const double tolerance = shift * 0.0404 * kFreeStep * kFreeStep + kFreeTrails * slip;
  const char* const why = "as alignment";
  Track left("swivel angle, front left", "rad", why),
      right("swivel angle, front right", "rad", why);
  Tractrix tractrix(item, start);
  double path = 0;
  for (const Sample& s : response.items[0].history) {
    if (s.time / time > path) tractrix.advance(s.time / time - path);
    path = s.time / time;

    left.add(s.time, s.wheels[0].swivel_angle, tractrix.heading(), tolerance);
    right.add(s.time, s.wheels[1].swivel_angle, -tractrix.heading(), tolerance);
  }
  runner.report(left, right);
}

}  // namespace

Family alignment() {
  return make_family<Start>(
      {"alignment", "casters", "A caster that is led along a line turns into it",
       "tan(psi/2) = tan(psi_0/2) exp(-v t / trail)", "kinematics of rolling: the tractrix"},
      fields(FIELD(Start, heading, "deg", -179, 179), FIELD(Start, trail, "m", 0.015, 0.08),
             FIELD(Start, speed, "m/s", 0.1, 3)),
      cases(at("30", 30, 0.034, 1), at("60_slow", 60, 0.034, 0.2), at("crosswise", 90, 0.034, 1),
            at("120_long_trail", 120, 0.05, 2), at("150_short_trail", 150, 0.02, 0.5),
            at("170", 170, 0.034, 1), at("minus_30", -30, 0.02, 1), at("minus_75", -75, 0.05, 0.2),
            at("minus_135_fast", -135, 0.034, 3), at("minus_170", -170, 0.034, 0.3),
            at("reversed", 179, 0.034,
               0.5),  // on a crest: one degree off it turns over, to either side
            at("minus_reversed", -179, 0.034, 0.5)),
      align, short_steps);
}

Family alignment_free() {
  return on_stock_too(make_family<FreeStart>(
      {"alignment_free", "casters", "Casters of a heavy trolley that rolls on turn into line",
       "psi' = -v sin(psi) / trail, G(psi) v^2 = const, G = M + 4 [(I_p/L^2 - 2 S/L) sin^2 + J "
       "cos^2 / R^2]",
       "kinematics of rolling: the tractrix; energy of trolley and casters"},
      fields(FIELD(FreeStart, heading, "deg", 20, 160), FIELD(FreeStart, speed, "m/s", 0.2, 1.5),
             FIELD(FreeStart, mass, "kg", 150, 400)),
      cases(at("30", 30, 1, 300), at("crosswise", 90, 0.5, 300), at("150", 150, 1, 300)), align));
}

}  // namespace gurney::verification
