#include "tests/studies/calibration/virtual_pulls.h"

#include "engine/base/random/normal_draw.h"
#include "engine/simulate.h"
#include "equipment/catalogue.h"
#include "equipment/load_item.h"

namespace gurney {

Trial virtual_pull(const VirtualPull& pull) {
  constexpr double kRelease = 0.5, kRate = 120;
  ItemOptions options;
  options.payloads = {{"paver", pull.pavers}};
  Scene scene;
  EquipmentModel& model = scene.items[0].model;
  model = load_item(find_data(DataKind::kItem, "xu_trolley", ""), options).model;
  Trial trial;
  for (Caster& caster : model.casters) {
    caster.tread.rolling_resistance = pull.resistance * caster.wheel_radius;
    trial.setup.added_mass +=
        caster.wheel_axial_inertia / (caster.wheel_radius * caster.wheel_radius);
  }
  Excitation excitation;
  excitation.blocks = {Blocks{{0.49, 0, 0.05}, 1e7, 1e4, kRelease}};
  DropWeight weight;
  weight.point = {0.55, 0, 0.14};
  weight.mass = pull.drop_mass;
  weight.drop_height = pull.drop_height;
  weight.pulley_inertia = 1e-4;
  weight.potentiometer_tension = 1;
  weight.cable_stiffness = 1e5;
  weight.cable_damping = 300;
  excitation.drop_weights = {weight};
  excitation.string_potentiometers = {{{-0.55, 0, 0.14}, -Vector3::UnitX(), pull.string_tension}};
  SimulationSettings settings;
  settings.time_step = 1 / (2 * kRate);
  settings.history_step = 1 / kRate;
  settings.duration = 12;
  const Response response = simulate(scene, excitation, settings);

  trial.name = "virtual";
  trial.file = "virtual.csv";
  trial.setup.origin = TrialOrigin::kSimulated;
  trial.setup.caster = "R100";
  trial.setup.floor = "vinyl";
  trial.setup.tread = "rubber";
  trial.setup.wheel_radius = model.casters[0].wheel_radius;
  trial.setup.mass = whole_item(model).mass;
  trial.setup.string_tension = pull.string_tension;
  for (const Sample& sample : response.items[0].history) {
    trial.signals.time.push_back(sample.time);
    trial.signals.force.push_back(sample.cable_tension);
    trial.signals.displacement.push_back(sample.displacement.x());
  }
  return trial;
}

Trial with_noise(Trial trial, std::uint64_t seed, std::uint64_t stream) {
  TrialSignals& s = trial.signals;
  for (std::size_t i = 0; i < s.time.size(); ++i) {
    s.displacement[i] += kDisplacementNoise * normal_draw(seed, 2 * stream, i);
    s.force[i] += kForceNoise * normal_draw(seed, 2 * stream + 1, i);
  }
  return trial;
}

}  // namespace gurney
