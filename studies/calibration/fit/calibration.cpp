#include "studies/calibration/fit/calibration.h"

#include <fmt/format.h>

#include "engine/base/error.h"
#include "engine/base/files.h"
#include "engine/base/hash/sha256.h"
#include "engine/base/input_file.h"
#include "studies/calibration/fit/breakaway.h"
#include "studies/calibration/fit/rebound.h"
#include "studies/calibration/trials/trial_check.h"

namespace gurney::calibration {
namespace {

class Collector {
 public:
  explicit Collector(Calibration& result) : result_(result) {}

  void add(const TrialAverages& averages) {
    try_to([&] { add_averages(averages, false); });
  }

  void add(Trial trial) {
    try_to([&] {
      check_samples(trial);
      switch (trial.kind) {
        case TrialKind::kPull:
          return add_pull(std::move(trial));
        case TrialKind::kStartPull:
        case TrialKind::kLockedPull:
          return add_breakaway(trial);
        case TrialKind::kImpact: {
          const Rebound found = rebound_of(trial);
          return add_value(ConstantKind::kRestitution, trial, found.restitution, found.error);
        }
        case TrialKind::kCrosswisePull:
          return add_crosswise(trial);
      }
    });
  }

 private:
  template <class Action>
  void try_to(Action action) {
    try {
      action();
    } catch (const UnusableTrial& error) {
      result_.left_out.push_back(error.fault);
      result_.trials.back().excluded = error.fault.reason;
    }
  }

  void add_value(ConstantKind kind, const Trial& trial, double value, double error,
                 bool at_least = false) {
    result_.values.push_back({kind, trial.name, trial.setup, value, error, at_least});
  }

  void add_averages(const TrialAverages& averages, bool of_displacement) {
    check_averages(averages, of_displacement);
    const RollingTrial trial{averages, average_method(averages)};
    result_.values.push_back(value_of(trial));
    if (averages.setup.use == TrialUse::kCalibration) result_.rolling.push_back(trial);
  }

  void add_pull(Trial trial) {
    const Phases phases = find_phases(trial);
    const TrialAverages averages = averages_of(trial, phases);
    check_averages(averages, !trial.signals.displacement.empty());
    check_phases(trial, phases);
    add_averages(averages, false);
    result_.pulls.push_back({std::move(trial), phases, averages});
  }

  void add_breakaway(const Trial& trial) {
    const Breakaway found = breakaway_of(trial);
    const bool locked = trial.kind == TrialKind::kLockedPull;
    add_value(locked ? ConstantKind::kStaticFriction : ConstantKind::kStartUp, trial, found.peak,
              found.peak_error, found.peak_bounds);
    if (!found.moving_lost.empty())
      result_.without_kinetic.push_back({trial.file, 0, found.moving_lost});
    else if (locked)
      add_value(ConstantKind::kKineticFriction, trial, found.moving, found.moving_error);
  }

  void add_crosswise(const Trial& trial) {
    const CrosswiseFit found = fit_crosswise(trial);
    add_value(ConstantKind::kSwivelTorque, trial, found.torque_length, found.torque_length_error);
    result_.crosswise.push_back(found);
  }

  Calibration& result_;
};

std::string hash_of(const std::string& file) {
  return file.empty() || !is_there(file) ? "" : sha256(read_input_file(file));
}

/// @throws Error for the content of another file
void note(Calibration& result, const ReadTrial& trial) {
  for (const ReadTrial& other : result.trials)
    require(trial.sha256.empty() || other.sha256 != trial.sha256 || other.file == trial.file,
            fmt::format("{}: has the same content as {}; one trial must not count twice",
                        trial.file, other.file));
  ++result.read;
  result.simulated += trial.setup.origin == TrialOrigin::kSimulated;
  result.trials.push_back(trial);
}

}  // namespace

Calibration calibrate(TrialSet trials, const std::string& source) {
  Calibration result;
  result.source = source;
  Collector collector(result);
  for (const TrialAverages& each : trials.averages) {
    note(result,
         {each.name, each.file, each.line, hash_of(each.file), TrialKind::kPull, each.setup});
    collector.add(each);
  }
  for (Trial& each : trials.trials) {
    note(result, {each.name, each.file, 0, hash_of(each.file), each.kind, each.setup});
    collector.add(std::move(each));
  }
  result.constants = constants_of(result.values);
  if (result.constants.empty()) {
    std::string text = source + ": no trial with use = calibration can be used";
    for (const TrialFault& fault : result.left_out) text += "\n" + fault.text();
    throw Error(text);
  }
  result.tests = rolling_tests(result.rolling);
  result.outliers = outliers_of(result.values);
  result.predictions = predictions_of(result.values, result.constants, result.unpredicted);
  return result;
}

}  // namespace gurney::calibration
