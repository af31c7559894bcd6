#pragma once

#include <string>
#include <vector>

#include "studies/calibration/trials/trial.h"
#include "studies/statistics/bands.h"

/// Constants of casters from the results of single trials (docs/calibration.md).
namespace gurney::calibration {

enum class ConstantKind {
  kRolling,          ///< Cr / R
  kStartUp,          ///< the same at the start of rolling
  kStaticFriction,   ///< mu_s of locked wheels
  kKineticFriction,  ///< mu_k of locked wheels
  kRestitution,      ///< e
  kSwivelTorque,     ///< mu w / 4 + T / N of a swivel: scrub and friction together [m]
};
const char* symbol_of(ConstantKind kind);  ///< "Cr/R"
const char* name_of(ConstantKind kind);    ///< "rolling_resistance"
const char* unit_of(ConstantKind kind);    ///< "1" or "m"

/// One constant from one trial.
struct TrialValue {
  ConstantKind kind = ConstantKind::kRolling;
  std::string trial;
  TrialSetup setup;
  double value = 0;       ///< > 0
  double error = 0;       ///< standard error of its measurement
  bool at_least = false;  ///< the constant is `value` or more: mu_s with all wheels locked

  std::string constant() const;  ///< Constant::about() of its constant
};

/// One constant of one caster and floor, or of what was hit, from all trials with `use`
/// calibration. It is exp of the mean logarithm, so that scatter is a share: ln(value) of a trial
/// is the constant's, a scatter between trials and an error of measurement (fit_random_effects()).
struct Constant {
  ConstantKind kind = ConstantKind::kRolling;
  std::string caster, floor, against;
  double wheel_radius = 0;  ///< 0 where it is not known [m]
  double value = 0;
  bool at_least = false;            ///< it is `value` or more, and the interval has no upper end
  statistics::Interval interval;    ///< 95 % of the value; {0, infinity} for a single trial
  double scatter = 0;               ///< standard deviation of the logarithm between trials
  int degrees = 0;                  ///< of Student's t
  statistics::Interval prediction;  ///< 95 % of one more trial, with the errors of an average one
  std::vector<std::string> trials;

  std::string about() const;  ///< "Cr/R of R100 on polyflor_mystique"
};

/// A trial that does not go with the others of its constant. It stays in: whether to leave it out
/// is the user's decision.
struct Outlier {
  std::string trial, constant;
  double value = 0;
  double p = 1;  ///< two-sided, times the number of trials of its kind (Bonferroni), below 0.05
};

/// A trial with `use` validation against the constant of the others.
struct Prediction {
  std::string trial, constant;
  double measured = 0, predicted = 0;
  statistics::Interval interval;  ///< 95 % of one more trial

  double misfit() const { return measured / predicted - 1; }
  bool inside() const { return interval.contains(measured); }
};

/// In the order of kind, caster and floor. Trials that are `at_least` count only where there are no
/// others.
std::vector<Constant> constants_of(const std::vector<TrialValue>& values);

/// outlier_p_values() of all trials of a kind, each caster and floor with its own level.
std::vector<Outlier> outliers_of(const std::vector<TrialValue>& values);

/// @return validation trials; `unpredicted` are those whose constant no calibration trial gives,
/// and
///         bounds
std::vector<Prediction> predictions_of(const std::vector<TrialValue>& values,
                                       const std::vector<Constant>& constants,
                                       std::vector<std::string>& unpredicted);

}  // namespace gurney::calibration
