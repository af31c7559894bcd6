#include <algorithm>
#include <cmath>

#include "engine/base/units.h"
#include "studies/verification/family.h"
#include "studies/verification/scenes/small_scenes.h"

// A heavy trolley that rolls on leads its casters as a rail would (alignment.cpp): stock Bullet,
// which knows no fixtures, can run it too. Casters on both sides stand at opposite headings, so
// that neither their side forces nor their moments steer it.
namespace gurney::verification {
namespace {

constexpr double kStiffness = 1e9, kRelaxation = 0.01;  // k_t [N/m], sigma [m]
constexpr double kTrails = 8, kStep = 0.05;             // path of a run and a step, in trails

struct Start {
  double heading, speed, mass;  // [deg], [m/s], of the chassis [kg]
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
  const auto heading = [&](double path) {
    return 2 * std::atan(std::tan(start / 2) * std::exp(-path));
  };
  const double inertia = small::swivel_inertia(caster);
  const double slip = inertia / (2 * time * time * caster.trail) / (kStiffness * kRelaxation);
  // Casters that turn take I_p (v / L)^2 / 2 each from the trolley's energy, and give it back.
  const double slower = 4 * inertia / (caster.trail * caster.trail * c.mass);
  double shift = 0;
  for (const Sample& s : response.items[0].history)
    shift = std::max(shift, s.time / time * std::abs(std::sin(heading(s.time / time))));
  const double tolerance = shift * (0.0404 * kStep * kStep + slower) + kTrails * slip;
  const char* const why =
      "as alignment; casters that turn take up to 4 I_p / (M L^2) of the speed: that of the path";
  Track left("swivel angle, front left", "rad", why),
      right("swivel angle, front right", "rad", why);
  for (const Sample& s : response.items[0].history) {
    const double expected = heading(s.time / time);
    left.add(s.time, s.wheels[0].swivel_angle, expected, tolerance);
    right.add(s.time, s.wheels[1].swivel_angle, -expected, tolerance);
  }
  left.report(findings);
  right.report(findings);
  return findings;
}

}  // namespace

Family alignment_free() {
  Family family = make_family<Start>(
      {"alignment_free", "casters", "Casters of a heavy trolley that rolls on turn into line",
       "tan(psi/2) = tan(psi_0/2) exp(-v t / trail)", "kinematics of rolling: the tractrix"},
      {{{"heading", "deg", 20, 160}, &Start::heading},
       {{"speed", "m/s", 0.2, 1.5}, &Start::speed},
       {{"mass", "kg", 150, 400}, &Start::mass}},
      {{"30", {30, 1, 300}}, {"crosswise", {90, 0.5, 300}}, {"150", {150, 1, 300}}}, align);
  family.on_stock = true;
  return family;
}

}  // namespace gurney::verification
