#include "tests/studies/calibration/fit/virtual_pulls.h"

#include <cmath>
#include <limits>

#include "engine/run/simulate.h"
#include "equipment/catalogue/catalogue.h"
#include "equipment/catalogue/load_item.h"
#include "studies/calibration/trials/average_method.h"

namespace gurney::calibration {
namespace {

constexpr double kRate = 120;  // of the motion capture [Hz]

void describe(const EquipmentModel& model, Trial& trial) {
  trial.name = "virtual";
  trial.file = "virtual.csv";
  trial.setup.origin = TrialOrigin::kSimulated;
  trial.setup.caster = "R100";
  trial.setup.floor = "polyflor_mystique";
  trial.setup.tread = "rubber";
  trial.setup.item = "xu_trolley";
  trial.setup.wheel_radius = model.casters[0].wheel_radius;
  trial.setup.mass = whole_item(model).mass;
  for (const Caster& caster : model.casters)
    trial.setup.added_mass +=
        caster.wheel_axial_inertia / (caster.wheel_radius * caster.wheel_radius);
}

void record(const Response& response, Trial& trial) {
  for (const Sample& sample : response.items[0].history) {
    trial.signals.time.push_back(sample.time);
    trial.signals.force.push_back(sample.cable_tension + sample.pull_force);
    trial.signals.displacement.push_back(sample.displacement.x());
  }
}

}  // namespace

Trial virtual_pull(const VirtualPull& pull) {
  constexpr double kRelease = 0.5;
  equipment::ItemOptions options;
  options.payloads = {{"paver", pull.pavers}};
  options.headings.assign(4, pull.heading);
  Scene scene = scene_of({});
  EquipmentModel& model = scene.items[0].model;
  model = equipment::load_item(equipment::find_data(equipment::DataKind::kItem, "xu_trolley", ""),
                               options)
              .model;
  Trial trial;
  for (Caster& caster : model.casters) {
    caster.tread.rolling_friction_length = pull.resistance * caster.wheel_radius;
    if (pull.patch_width >= 0) caster.tread.patch_width = pull.patch_width;
  }
  DropWeight weight;
  weight.point = {0.55, 0, 0.14};
  weight.mass = pull.drop_mass;
  weight.drop_height = pull.drop_height;
  weight.pulley_inertia = 1e-4;
  weight.potentiometer_tension = 1;
  weight.cable_stiffness = 1e5;
  weight.cable_damping = 300;
  scene.items[0].loads = {
      StringPotentiometer{{-0.55, 0, 0.14}, -Vector3::UnitX(), pull.string_tension}, weight,
      Blocks{{0.49, 0, 0.05}, 1e7, 1e4, kRelease}};
  SimulationSettings settings;
  settings.time_step = 1 / (2 * kRate);
  settings.history_step = 1 / kRate;
  settings.duration = 12;
  const Response response = simulate(scene, {}, settings);

  describe(model, trial);
  trial.setup.string_tension = pull.string_tension;
  trial.setup.payload_name = "paver";
  trial.setup.payload_count = pull.pavers;
  trial.setup.headings = {pull.heading};
  trial.setup.pull_point = {0.55, 0, 0.14};
  record(response, trial);
  return trial;
}

/// Share of the weight on the front axle at rest, as scales under the wheels say it.
double front_share(const Response& response) {
  const auto& wheels = response.items[0].history[0].wheels;
  double front = 0, all = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    all += wheels[i].normal_force;
    front += i < 2 ? wheels[i].normal_force : 0;
  }
  return front / all;
}

Trial virtual_winch(const VirtualWinch& v) {
  constexpr double kStart = 0.5, kHeight = 0.14, kMoves = 3;
  Scene scene = scene_of({});
  EquipmentModel& model = scene.items[0].model;
  model = equipment::load_item(equipment::find_data(equipment::DataKind::kItem, "xu_trolley", ""))
              .model;
  Trial trial;
  describe(model, trial);
  for (Caster& caster : model.casters) {
    const bool front = caster.mount.x() > 0;
    caster.tread.static_friction = v.static_friction;
    caster.tread.kinetic_friction = v.kinetic_friction;
    caster.tread.rolling_friction_length = v.resistance * caster.wheel_radius;
    if (v.locked && *v.locked != (front ? LockedWheels::kRear : LockedWheels::kFront))
      caster.brake_torque = std::numeric_limits<double>::infinity();
  }
  const double most = v.locked ? v.static_friction * (*v.locked == LockedWheels::kAll ? 1 : 0.7)
                               : 1.2 * v.resistance;
  const double pulled = std::ceil(1.1 * most * normal_force(trial.setup) / v.ramp + kMoves);
  PointForce winch{"winch",
                   {0.55, 0, kHeight},
                   Vector3::UnitX(),
                   {0, kStart, kStart + pulled},
                   {0, 0, pulled * v.ramp}};
  winch.speed_limit = 0.1;
  scene.items[0].loads = {winch};
  SimulationSettings settings;
  settings.time_step = 1 / (2 * kRate);
  settings.history_step = 1 / kRate;
  settings.duration = kStart + pulled;
  const Response response = simulate(scene, {}, settings);
  trial.kind = v.locked ? TrialKind::kLockedPull : TrialKind::kStartPull;
  trial.setup.locked = v.locked.value_or(LockedWheels::kAll);
  trial.setup.pull_height = kHeight;
  trial.setup.wheelbase = model.casters[0].mount.x() - model.casters[2].mount.x();
  trial.setup.front_share = front_share(response);
  trial.setup.rolling_ratio = v.resistance;
  record(response, trial);
  return trial;
}

Trial virtual_impact(double speed, double restitution) {
  Scene scene = scene_of({});
  EquipmentModel& model = scene.items[0].model;
  model = equipment::load_item(equipment::find_data(equipment::DataKind::kItem, "xu_trolley", ""))
              .model;
  model.material = "trolley";
  scene.items[0].initial.velocity = {speed, 0, 0};
  ContactConstants wall;
  wall.restitution = restitution;
  scene.pairs = {{"trolley", "wall", wall}, {"trolley", "", wall}};
  RoomShape box;
  box.name = box.material = "wall";
  box.position = {0.55 + 0.3 + 0.05, 0, 0.75};
  box.shape = RoomBox{{0.1, 4, 1.5}};
  scene.room = {box};
  SimulationSettings settings;
  settings.time_step = 1 / (2 * kRate);
  settings.history_step = 1 / kRate;
  settings.duration = 0.3 / speed + 0.8;
  Trial trial;
  trial.kind = TrialKind::kImpact;
  describe(model, trial);
  trial.setup.against = "wall";
  record(simulate(scene, {}, settings), trial);
  trial.signals.force.clear();
  return trial;
}

}  // namespace gurney::calibration
