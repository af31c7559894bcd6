#include <algorithm>
#include <cmath>

#include "engine/base/units.h"
#include "studies/verification/family.h"
#include "studies/verification/scenes/small_scenes.h"

// A heavy trolley that rolls on leads its casters as a rail would (alignment.cpp): stock Bullet,
// which knows no fixtures, can run it too. Casters on both sides stand at opposite headings, so
// that neither their side forces nor their moments steer it.
//
// What casters and wheels have of energy as they turn comes from the trolley. With psi' = -v sin(psi)
// / L and a spin of v cos(psi) / R the whole has the energy G v^2 / 2,
//
//     G(psi) = M + n [(I_p / L^2 - 2 S / L) sin(psi)^2 + J cos(psi)^2 / R^2],
//
// S and I_p being the first and second moment of a caster about its swivel axis. It stays, so v
// goes as sqrt(1 / G). A run starts with casters and wheels that turn as its speed asks.
namespace gurney::verification {
namespace {

constexpr double kStiffness = 1e9, kRelaxation = 0.01;  // k_t [N/m], sigma [m]
constexpr double kTrails = 8, kStep = 0.05;             // path of a run and a step, in trails

struct Start {
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

Findings align(const Start& c, const Runner& runner) {
  Findings findings;
  Tread tread = small::bare_tread(3e8, kStiffness);
  tread.relaxation_length = kRelaxation;
  tread.normal_damping = 1.6e4;
  tread.tangential_damping = 100;
  tread.static_friction = tread.kinetic_friction = 5;
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
      runner(findings, scene, {}, small::settings_for(kStep * time, kTrails * time));
  const double inertia = small::swivel_inertia(caster);
  const double slip = inertia / (2 * time * time * caster.trail) / (kStiffness * kRelaxation);
  double shift = 0;
  for (const Sample& s : response.items[0].history) {
    const double path = s.time / time;
    shift = std::max(shift, path * std::sin(2 * std::atan(std::tan(start / 2) * std::exp(-path))));
  }
  const double tolerance = shift * 0.0404 * kStep * kStep + kTrails * slip;
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
  left.report(findings);
  right.report(findings);
  return findings;
}

}  // namespace

Family alignment_free() {
  Family family = make_family<Start>(
      {"alignment_free", "casters", "Casters of a heavy trolley that rolls on turn into line",
       "psi' = -v sin(psi) / trail, G(psi) v^2 = const, G = M + 4 [(I_p/L^2 - 2 S/L) sin^2 + J "
       "cos^2 / R^2]",
       "kinematics of rolling: the tractrix; energy of trolley and casters"},
      {{{"heading", "deg", 20, 160}, &Start::heading},
       {{"speed", "m/s", 0.2, 1.5}, &Start::speed},
       {{"mass", "kg", 150, 400}, &Start::mass}},
      {{"30", {30, 1, 300}}, {"crosswise", {90, 0.5, 300}}, {"150", {150, 1, 300}}}, align);
  family.on_stock = true;
  return family;
}

}  // namespace gurney::verification
