#include "studies/calibration/pulling/simulated_trial.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/base/error.h"
#include "engine/base/units.h"
#include "studies/calibration/trials/instrument_noise.h"
#include "studies/plan/study_job.h"

namespace gurney::calibration {
namespace {

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
    // What the weight loses goes into the item, but for the dampers of blocks and cable.
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
  TrialFault fault;
  result.phases = find_phases(result.trial, fault);
  if (result.phases) result.averages = averages_of(result.trial, *result.phases, fault);
  if (!result.averages) result.fault = fault.reason;
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
