#include "studies/calibration/pulling/simulated_trial.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/base/error.h"
#include "engine/base/units.h"
#include "studies/calibration/trials/trial.h"
#include "studies/plan/study_job.h"

namespace gurney::calibration {
namespace {

bool along_x(const Vector3& direction) { return std::abs(direction.normalized().x()) > 1 - 1e-9; }

void add_item(const Scene& scene, PullTheory& theory) {
  const EquipmentModel& item = scene.items[0].model;
  theory.mass = whole_item(item).mass;
  theory.normal_force = theory.mass * scene.gravity;
  const double each = theory.normal_force / static_cast<double>(item.casters.size());
  for (const Caster& c : item.casters) {
    theory.added_mass += c.wheel_axial_inertia / (c.wheel_radius * c.wheel_radius);
    theory.resistance += c.tread.rolling_friction_length / c.wheel_radius * each;
  }
}

void add_drop_weight(const Scene& scene, const DropWeight& weight, const Blocks& blocks,
                     PullTheory& theory) {
  const double pulley = weight.pulley_inertia / (weight.pulley_radius * weight.pulley_radius);
  theory.drop_mass = weight.mass;
  theory.start = blocks.release_time;
  theory.held_force = weight.mass * scene.gravity - weight.potentiometer_tension;
  theory.acceleration = (theory.held_force - theory.resistance - theory.string_tension) /
                        (theory.mass + theory.added_mass + weight.mass + pulley);
  theory.force = theory.held_force - (weight.mass + pulley) * theory.acceleration;
  theory.release = theory.start + std::sqrt(2 * weight.drop_height / theory.acceleration);
  theory.pull = {{theory.start, theory.force, theory.acceleration},
                 {theory.release, theory.force, theory.acceleration}};
}

void add_force(const PointForce& force, PullTheory& theory) {
  theory.start = force.time.front();
  theory.release = force.time.back();
  double impulse = 0;
  for (std::size_t i = 0; i < force.time.size(); ++i) {
    theory.pull.push_back({force.time[i], force.force[i],
                           (force.force[i] - theory.resistance - theory.string_tension) /
                               (theory.mass + theory.added_mass)});
    if (i > 0)
      impulse += (force.time[i] - force.time[i - 1]) * (force.force[i] + force.force[i - 1]) / 2;
  }
  theory.force = impulse / (theory.release - theory.start);
  theory.acceleration = (theory.force - theory.resistance - theory.string_tension) /
                        (theory.mass + theory.added_mass);
}

/// `time` after a knot, towards the next one: the acceleration is linear, the speed its integral.
PullTheory::Knot moved_on(const PullTheory::Knot& from, const PullTheory::Knot& to, double time) {
  const double share = time / (to.time - from.time);
  const double jerk = (to.acceleration - from.acceleration) / (to.time - from.time);
  return {from.time + time, from.force + share * (to.force - from.force),
          from.acceleration + jerk * time,
          from.velocity + from.acceleration * time + jerk * time * time / 2,
          from.displacement + from.velocity * time + from.acceleration * time * time / 2 +
              jerk * time * time * time / 6};
}

void integrate(std::vector<PullTheory::Knot>& pull) {
  for (std::size_t i = 1; i < pull.size(); ++i)
    pull[i] = moved_on(pull[i - 1], pull[i], pull[i].time - pull[i - 1].time);
}

constexpr const char* kEndOfFlooring = "end of the flooring";

std::string text_at(const config::Node& tree, const std::string& table, const std::string& key) {
  const config::Node* in = tree.find(table);
  const config::Node* found = in == nullptr ? nullptr : in->find(key);
  return found == nullptr ? "" : found->text;
}

/// When each run's item came to the end of the flooring; infinite: never.
std::vector<double> ends_of_flooring(const study::StudyReader& file) {
  std::vector<double> ends(file.runs(), std::numeric_limits<double>::infinity());
  if (!file.has("zones")) return ends;
  const auto zones = file.strings("zones/zone");
  const auto runs = file.numbers("zones/run"), times = file.numbers("zones/time_of_entry");
  for (std::size_t row = 0; row < runs.size(); ++row)
    if (zones[row] == kEndOfFlooring && times[row] >= 0)
      ends.at(static_cast<std::size_t>(runs[row])) = times[row];
  return ends;
}

/// The columns of /histories of which trials consist.
struct HistoryColumns {
  std::vector<double> time, x, y, velocity, acceleration, tension, force, yaw;
  std::vector<double> kinetic, rolling, weights, forces, dampers;  ///< empty: not kept

  explicit HistoryColumns(const study::StudyReader& file) {
    const auto column = [&](const char* name) {
      return file.numbers(std::string("histories/") + name);
    };
    time = column("time");
    x = column("displacement_x");
    y = column("displacement_y");
    velocity = column("velocity_x");
    acceleration = column("acceleration_x");
    tension = column("cable_tension");
    force = column("pull_force");
    yaw = column("yaw");
    if (!file.has("energy")) return;
    kinetic = column("energy_kinetic");
    rolling = column("loss_rolling");
    weights = column("energy_of_weights");
    forces = column("work_of_forces");
    dampers = column("loss_damper");
  }
};

/// The first marked point of each run: what an accelerometer there would have measured.
class Accelerometers {
 public:
  explicit Accelerometers(const study::StudyReader& file) {
    if (!file.has("point_histories")) return;
    rows_ = file.rows_of_runs("point_histories");
    points_ = file.strings("point_histories/point");
    along_ = file.numbers("point_histories/absolute_acceleration_x");
  }

  void add_to(SimulatedTrial& trial) const {
    if (rows_.empty() || rows_[trial.run].first == rows_[trial.run].second) return;
    const auto [first, last] = rows_[trial.run];
    trial.accelerometer = points_[first];
    for (std::size_t row = first; row < last; ++row)
      if (points_[row] == trial.accelerometer) trial.accelerometer_signal.push_back(along_[row]);
    trial.accelerometer_signal.resize(trial.trial.signals.time.size());
  }

 private:
  std::vector<std::pair<std::size_t, std::size_t>> rows_;
  std::vector<std::string> points_;
  std::vector<double> along_;
};

/// Whether the last sample is as far from the one before as the first two are: a history has the
/// end of its run, too.
bool in_step(const std::vector<double>& time, std::size_t first, std::size_t last) {
  if (last - first < 3) return true;
  const double step = time[first + 1] - time[first];
  return std::abs(time[last - 1] - time[last - 2] - step) < 1e-6 * step;
}

void add_signals(const HistoryColumns& all, std::size_t first, std::size_t last, double end,
                 SimulatedTrial& result) {
  TrialSignals& s = result.trial.signals;
  if (!in_step(all.time, first, last)) --last;
  for (std::size_t row = first; row < last && all.time[row] < end; ++row) {
    s.time.push_back(all.time[row]);
    s.force.push_back(all.tension[row] + all.force[row]);
    s.displacement.push_back(all.x[row]);
    s.lateral.push_back(all.y[row]);
    s.acceleration.push_back(all.acceleration[row]);
    s.yaw.push_back(all.yaw[row]);
    result.velocity.push_back(all.velocity[row]);
    if (all.kinetic.empty()) continue;
    result.kinetic.push_back(all.kinetic[row]);
    result.rolling_loss.push_back(all.rolling[row]);
    // Energy lost by the weight goes into the item, but for the dampers of blocks and cable.
    result.work.push_back(all.forces[row] - (all.weights[row] - all.weights[first]) -
                          all.dampers[row]);
  }
}

TrialSetup setup_of(const config::Node& tree, const study::Job& job, const PullTheory& theory) {
  const PlacedItem& placed = job.scene.items.front();
  const EquipmentModel& item = placed.model;
  TrialSetup setup;
  setup.use = TrialUse::kValidation;
  setup.origin = TrialOrigin::kSimulated;
  setup.item = text_at(tree, "item", "equipment");
  setup.caster = text_at(tree, "item", "casters");
  if (setup.caster.empty()) setup.caster = "as of " + setup.item;
  setup.floor = text_at(tree, "floor", "covering");
  if (setup.floor.empty()) setup.floor = "as of the casters";
  setup.wheels = static_cast<int>(item.casters.size());
  setup.wheel_radius = item.casters[0].wheel_radius;
  setup.mass = theory.mass;
  setup.added_mass = theory.added_mass;
  for (const Payload& payload : item.payloads) setup.payload += payload.mass;
  if (!item.payloads.empty()) {
    const std::string& name = item.payloads[0].name;
    // One is `paver`, several are `paver 1` and so on.
    setup.payload_name = item.payloads.size() == 1 ? name : name.substr(0, name.rfind(' '));
    setup.payload_count = static_cast<int>(item.payloads.size());
  }
  if (theory.drop_mass > 0) setup.drop_mass = theory.drop_mass;
  setup.string_tension = theory.string_tension;
  for (const Caster& caster : item.casters) setup.headings.push_back(caster.heading);
  const Vector3 point = theory.drop_mass > 0 ? loads_of<DropWeight>(placed.loads)[0].point
                                             : loads_of<PointForce>(placed.loads)[0].point;
  setup.pull_point = {point.x(), point.y(), point.z()};
  return setup;
}

void apply_method(SimulatedTrial& result) {
  try {
    result.phases = find_phases(result.trial);
    result.averages = averages_of(result.trial, *result.phases);
  } catch (const UnusableTrial& error) {
    result.fault = error.fault.reason;
  }
}

void add_noise(std::uint64_t seed, SimulatedTrial& result) {
  result.trial = with_noise(std::move(result.trial), seed, result.run);
  result.velocity = rate(result.trial.signals.time, result.trial.signals.displacement);
}

/// Name of the force, where it is sampled.
std::string sampled_force(const Scene& scene) {
  const auto forces = loads_of<PointForce>(scene.items.front().loads);
  return forces.size() == 1 && forces[0].force.size() > 2 ? forces[0].name : "";
}

double bias(double found, const PullTheory& theory) { return found / theory.resistance - 1; }

}  // namespace

PullTheory::Knot PullTheory::pulled_at(double time) const {
  const double within = std::clamp(time, start, release);
  const auto after = std::ranges::upper_bound(pull, within, {}, &Knot::time) - pull.begin();
  const auto next = std::clamp<std::size_t>(static_cast<std::size_t>(after), 1, pull.size() - 1);
  return moved_on(pull[next - 1], pull[next], within - pull[next - 1].time);
}

double PullTheory::displacement_at(double time) const {
  const double coast = std::clamp(time, release, stop) - release;
  return pulled_at(time).displacement + release_velocity * coast - deceleration * coast * coast / 2;
}

double PullTheory::velocity_at(double time) const {
  return pulled_at(time).velocity - deceleration * (std::clamp(time, release, stop) - release);
}

double PullTheory::acceleration_at(double time) const {
  if (time < start || time >= stop) return 0;
  return time < release ? pulled_at(time).acceleration : -deceleration;
}

double PullTheory::force_at(double time) const {
  if (time < start) return held_force;
  return time < release ? pulled_at(time).force : 0;
}

PullTheory theory_of(const Scene& scene) {
  const PlacedItem& item = scene.items.front();
  const auto weights = loads_of<DropWeight>(item.loads);
  const auto blocks = loads_of<Blocks>(item.loads);
  const auto forces = loads_of<PointForce>(item.loads);
  const bool dropped =
      weights.size() == 1 && forces.empty() && !blocks.empty() && along_x(weights[0].direction);
  const bool forced = weights.empty() && forces.size() == 1 && forces[0].time.size() >= 2 &&
                      std::isinf(forces[0].speed_limit) && along_x(forces[0].direction);
  require(scene.items.size() == 1 && !item.model.casters.empty() && (dropped || forced),
          "is no pulling test: one item on casters must be pulled along x by one drop weight that "
          "blocks hold, or by one force without a speed limit");
  PullTheory theory;
  add_item(scene, theory);
  for (const StringPotentiometer& string : loads_of<StringPotentiometer>(item.loads)) {
    require(along_x(string.direction), "string potentiometers must pull along x");
    theory.string_tension -= string.tension * string.direction.normalized().x();
  }
  if (dropped)
    add_drop_weight(scene, weights[0], blocks[0], theory);
  else
    add_force(forces[0], theory);
  theory.deceleration =
      (theory.resistance + theory.string_tension) / (theory.mass + theory.added_mass);
  require(theory.acceleration > 0 && theory.deceleration > 0,
          "is no pulling test: the pull must move the item, which must come to rest after it");
  integrate(theory.pull);
  theory.release_velocity = theory.pull.back().velocity;
  theory.release_displacement = theory.pull.back().displacement;
  const double coast = theory.release_velocity / theory.deceleration;
  theory.stop = theory.release + coast;
  theory.rest_displacement = theory.release_displacement + theory.release_velocity * coast / 2;
  return theory;
}

const char* name_of(Alignment alignment) {
  static const char* const names[] = {"aligned", "crosswise", "reversed"};
  return names[static_cast<std::size_t>(alignment)];
}

Alignment alignment_of(const std::vector<double>& headings) {
  double farthest = 0;
  for (const double heading : headings)
    farthest = std::max(farthest, std::abs(std::remainder(heading, 360 * kRadiansPerDegree)));
  if (farthest <= 45 * kRadiansPerDegree) return Alignment::kAligned;
  return farthest <= 135 * kRadiansPerDegree ? Alignment::kCrosswise : Alignment::kReversed;
}

double mean_resistance(const TrialAverages& averages) {
  const Resistance found = average_method(averages);
  return (found.pulled + found.coasting) / 2;
}

double SimulatedTrial::bias_pulled() const {
  return bias(average_method(*averages).pulled, theory);
}
double SimulatedTrial::bias_coasting() const {
  return bias(average_method(*averages).coasting, theory);
}
double SimulatedTrial::bias_mean() const { return bias(mean_resistance(*averages), theory); }

std::vector<SimulatedTrial> simulated_trials(const study::StudyReader& file,
                                             const std::optional<std::uint64_t>& noise) {
  require(file.has("histories"), file.path() +
                                     ": keeps no histories; the job needs\n"
                                     "[study.keep]\nhistories = \"all\"");
  const study::StudyJob study(file.job_text(), file.path() + " (its job)");
  const auto ends = ends_of_flooring(file);
  const auto rows = file.rows_of_runs("histories");
  const auto configurations = file.numbers("runs/configuration");
  const auto names = file.strings("configurations/name");
  const HistoryColumns histories(file);
  const Accelerometers accelerometers(file);
  std::vector<SimulatedTrial> trials;
  for (std::size_t run = 0; run < file.runs(); ++run) {
    const auto [first, last] = rows[run];
    if (first == last) continue;  // it failed
    const auto configuration = static_cast<std::size_t>(configurations[run]);
    const study::Job job = study.job(configuration, {});
    SimulatedTrial result;
    result.run = run;
    result.configuration = names[configuration];
    result.solver = text_at(study.configurations()[configuration].tree, "settings", "solver");
    if (result.solver.empty()) result.solver = "implicit";
    result.time_step = job.settings.time_step;
    try {
      result.theory = theory_of(job.scene);
    } catch (const Error& error) {
      throw Error(
          fmt::format("{}: run {} ({}): {}", file.path(), run, result.configuration, error.what()));
    }
    result.trial.name = fmt::format("trial_{:02}", run);
    result.trial.setup = setup_of(study.configurations()[configuration].tree, job, result.theory);
    result.alignment = alignment_of(result.trial.setup.headings);
    if (result.alignment != Alignment::kAligned) result.trial.kind = TrialKind::kCrosswisePull;
    result.driven_by = sampled_force(job.scene);
    add_signals(histories, first, last, ends[run], result);
    accelerometers.add_to(result);
    if (noise) add_noise(*noise, result);
    result.left_flooring = std::isfinite(ends[run]);
    apply_method(result);
    trials.push_back(std::move(result));
  }
  return trials;
}

}  // namespace gurney::calibration
