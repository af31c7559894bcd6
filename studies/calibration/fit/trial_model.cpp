#include "studies/calibration/fit/trial_model.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/base/error.h"
#include "engine/run/simulate.h"
#include "equipment/catalogue/catalogue.h"
#include "equipment/catalogue/load_item.h"
#include "studies/calibration/trials/average_method.h"

namespace gurney::calibration {
namespace {

constexpr double kTimeStep = 1.0 / 240;  // [s]
constexpr std::size_t kFewest = 12;
constexpr double kFalls = 1e-6;  // [s]
constexpr double kEarly = 0.5;   // the cable swings, the casters swivel [s]
constexpr double kHeld = 0.3;    // before the start, to come to rest [s]

/// Between two samples by the cubic of places and speeds.
double between(double share, double step, double y0, double v0, double y1, double v1) {
  const double s = share, s2 = s * s, s3 = s2 * s;
  return (2 * s3 - 3 * s2 + 1) * y0 + (s3 - 2 * s2 + s) * step * v0 + (3 * s2 - 2 * s3) * y1 +
         (s3 - s2) * step * v1;
}

constexpr double kMassAgrees = 0.02;

std::string found(equipment::DataKind kind, const std::string& name) {
  try {
    return equipment::find_data(kind, name, "");
  } catch (const Error& error) {
    throw Error("'" + name + "': " + error.what());
  }
}

}  // namespace

TrialModel::TrialModel(const Trial& trial, const Phases& phases)
    : trial_(trial),
      phases_(phases),
      settled_(phases.start + std::min(kEarly, (phases.release - phases.start) / 2)) {
  Span steady = settled_of_pull(trial, phases);
  steady.begin = index_at(trial.signals.time, settled_);
  require(steady.size() >= kFewest, "phase II is too short");
  force_ = fit_polynomial(trial.signals.time, trial.signals.force, steady, 1);
  scene_ = scene_of(item_of(trial.setup));
}

TrialModel::Unknowns TrialModel::usual() const {
  const Caster& caster = scene_.items[0].model.casters[0];
  return {caster.tread.rolling_friction_length / caster.wheel_radius, caster.tread.patch_width, 0,
          0, 0};
}

double TrialModel::friction() const {
  return scene_.items[0].model.casters[0].tread.static_friction;
}

double TrialModel::swivel_coulomb() const {
  return scene_.items[0].model.casters[0].swivel.coulomb;
}

double TrialModel::load_of_wheel() const {
  const EquipmentModel& model = scene_.items[0].model;
  return whole_item(model).mass * scene_.gravity / static_cast<double>(model.casters.size());
}

TrialModel::Motion TrialModel::run(const Unknowns& unknowns) const {
  // The engine's clock is 0 at kHeld before the motion, so that blocks go at the end of a step.
  const double held = std::ceil(kHeld / kTimeStep) * kTimeStep;
  const double zero = phases_.start + unknowns.shift - held;
  const TrialSignals& s = trial_.signals;
  Scene scene = scene_;
  for (Caster& caster : scene.items[0].model.casters) {
    caster.tread.rolling_friction_length = unknowns.resistance * caster.wheel_radius;
    caster.tread.patch_width = unknowns.patch_width;
  }
  const std::vector<double>& at = trial_.setup.pull_point;
  const Vector3 point(at[0], at[1], at[2]);
  PointForce pull{"pull", point, Vector3::UnitX(), {}, {}};
  const double release = phases_.release + unknowns.release;
  const auto add = [&](double time, double force) {
    pull.time.push_back(time - zero);
    pull.force.push_back(force);
  };
  const double start = phases_.start + unknowns.shift;
  double held_force = 0;
  for (std::size_t i = phases_.held.begin; i < phases_.held.end; ++i)
    held_force += s.force[i] / static_cast<double>(phases_.held.size());
  add(zero, held_force);
  add(start - kFalls, held_force);
  const auto first =
      static_cast<std::size_t>(std::ranges::upper_bound(s.time, start) - s.time.begin());
  add(start, s.force[first] + unknowns.force);
  for (std::size_t i = first; i < s.time.size() && s.time[i] < settled_; ++i)
    add(s.time[i], s.force[i] + unknowns.force);
  add(settled_, force_.value(settled_) + unknowns.force);
  add(release, force_.value(release) + unknowns.force);
  add(release + kFalls, 0);
  std::vector<Load>& loads = scene.items[0].loads;
  loads.push_back(std::move(pull));
  loads.push_back(Blocks{{point.x(), 0, point.z()}, 1e7, 1e4, held});
  if (trial_.setup.string_tension > 0)
    loads.push_back(StringPotentiometer{point, -Vector3::UnitX(), trial_.setup.string_tension});
  SimulationSettings settings;
  settings.time_step = settings.history_step = kTimeStep;
  settings.duration = phases_.stop - zero + 2 * kTimeStep;
  const Response response = simulate(scene, {}, settings);
  const std::vector<Sample>& history = response.items[0].history;

  Motion motion;
  for (const double t : s.time) {
    const double place =
        std::clamp((t - zero) / kTimeStep, 0.0, static_cast<double>(history.size()) - 1.000001);
    const auto i = static_cast<std::size_t>(place);
    const double share = place - static_cast<double>(i);
    const Sample &a = history[i], &b = history[i + 1];
    const auto along = [&](Eigen::Index axis) {
      return between(share, kTimeStep, a.displacement[axis], a.velocity[axis], b.displacement[axis],
                     b.velocity[axis]);
    };
    motion.displacement.push_back(along(0));
    motion.lateral.push_back(along(1));
    motion.yaw.push_back(a.yaw + share * (b.yaw - a.yaw));
  }
  return motion;
}

EquipmentModel item_of(const TrialSetup& setup) {
  equipment::ItemOptions options;
  if (!setup.caster.empty())
    options.caster =
        equipment::load_caster_type(found(equipment::DataKind::kCaster, setup.caster)).stated();
  const std::vector<std::string> floors = equipment::catalogue_names(equipment::DataKind::kFloor);
  if (std::ranges::find(floors, setup.floor) != floors.end())
    options.floor =
        equipment::load_floor_covering(find_data(equipment::DataKind::kFloor, setup.floor, ""))
            .stated();
  if (!setup.payload_name.empty()) options.payloads = {{setup.payload_name, setup.payload_count}};
  options.headings = setup.headings;
  if (setup.headings.size() == 1)
    options.headings.assign(static_cast<std::size_t>(setup.wheels), setup.headings[0]);
  // A pull is slow: parts and contents stay where they are.
  EquipmentModel model =
      as_rigid(equipment::load_item(found(equipment::DataKind::kItem, setup.item), options));
  const double mass = whole_item(model).mass;
  require(setup.mass == 0 || std::abs(mass / setup.mass - 1) < kMassAgrees,
          fmt::format("{} weighs {:.4g} kg with its payload, but the trial {:.4g} kg", setup.item,
                      mass, setup.mass));
  require(!model.casters.empty(), setup.item + " has no casters");
  return model;
}

}  // namespace gurney::calibration
