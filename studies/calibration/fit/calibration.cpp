#include "studies/calibration/fit/calibration.h"

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
    if (const auto fault = check_averages(averages, false)) return leave_out(*fault);
    const RollingTrial trial{averages, average_method(averages)};
    result_.values.push_back(value_of(trial));
    if (averages.setup.use == TrialUse::kCalibration) result_.rolling.push_back(trial);
  }

  void add(Trial trial) {
    if (const auto fault = check_samples(trial)) return leave_out(*fault);
    switch (trial.kind) {
      case TrialKind::kPull:
        return add_pull(std::move(trial));
      case TrialKind::kStartPull:
        return add_breakaway(trial, ConstantKind::kStartUp, ConstantKind::kRolling);
      case TrialKind::kLockedPull:
        return add_breakaway(trial, ConstantKind::kStaticFriction, ConstantKind::kKineticFriction);
      case TrialKind::kImpact:
        return add_impact(trial);
      case TrialKind::kCrosswisePull:
        return add_crosswise(trial);
    }
  }

 private:
  void leave_out(const TrialFault& fault) {
    result_.left_out.push_back(fault);
    result_.trials.back().excluded = fault.reason;
  }

  void add_pull(Trial trial) {
    TrialFault fault;
    const auto phases = find_phases(trial, fault);
    if (!phases) return leave_out(fault);
    const auto averages = averages_of(trial, *phases, fault);
    if (!averages) return leave_out(fault);
    if (const auto wrong = check_averages(*averages, !trial.signals.displacement.empty()))
      return leave_out(*wrong);
    if (const auto wrong = check_phases(trial, *phases)) return leave_out(*wrong);
    add(*averages);
    result_.pulls.push_back({std::move(trial), *phases, *averages});
  }

  void add_breakaway(const Trial& trial, ConstantKind peak, ConstantKind moving) {
    TrialFault fault;
    const auto found = breakaway_of(trial, fault);
    if (!found) return leave_out(fault);
    result_.values.push_back(
        {peak, trial.name, trial.setup, found->peak, found->peak_error, found->peak_bounds});
    if (moving == ConstantKind::kKineticFriction)
      result_.values.push_back(
          {moving, trial.name, trial.setup, found->moving, found->moving_error});
  }

  void add_impact(const Trial& trial) {
    TrialFault fault;
    const auto found = rebound_of(trial, fault);
    if (!found) return leave_out(fault);
    result_.values.push_back(
        {ConstantKind::kRestitution, trial.name, trial.setup, found->restitution, found->error});
  }

  void add_crosswise(const Trial& trial) {
    TrialFault fault;
    const auto found = fit_crosswise(trial, fault);
    if (!found) return leave_out(fault);
    result_.values.push_back({ConstantKind::kSwivelTorque, trial.name, trial.setup,
                              found->torque_length, found->torque_length_error});
    result_.crosswise.push_back(*found);
  }

  Calibration& result_;
};

std::string hash_of(const std::string& file) {
  return file.empty() || !is_there(file) ? "" : sha256(read_input_file(file));
}

void note(Calibration& result, const ReadTrial& trial) {
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
