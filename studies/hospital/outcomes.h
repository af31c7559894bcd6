#pragma once

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "studies/hospital/hospital.h"
#include "studies/loss/consequences.h"

namespace gurney::study {

/// What all pieces of a hospital share in one sample.
struct MotionSample {
  double common = 0;  ///< normal score of the capacities' common part
  double floor = 0;   ///< normal score of the floors' velocities
  double record = 0;  ///< uniform, which record
};

/// What one piece has for itself.
struct PieceSample {
  double capacity = 0;  ///< normal score
  double draw = 0;      ///< uniform, which run of the record
};

/// One estimate of what the runs say: as they are, or as other records would have it.
struct Replicate {
  double shift = 0;                  ///< of ln theta, in standard errors
  std::vector<std::size_t> records;  ///< that take the places of 0, 1, ...; empty: themselves
};

/// States that a piece reaches in a sample.
using Outcome = std::function<Reached(std::size_t level, const MotionSample&, const PieceSample&,
                                      const Replicate&)>;

/// Where outcomes of items come from, by equipment, storey, place and brakes.
class OutcomeSource {
 public:
  virtual ~OutcomeSource() = default;

  /// Names of the bits of Reached: those of the consequences first.
  virtual const std::vector<std::string>& states() const = 0;

  /// @throws Error `file:line:column: ...` where it is not known
  virtual Outcome outcome(const HospitalItem& item, const Storey& storey, Brakes brakes) const = 0;

  virtual std::size_t records() const { return 0; }  ///< of runs; 0: of curves
  virtual std::vector<std::string> cautions() const { return {}; }
};

/// Names of the states with consequences, and of the others behind them, each once.
/// @throws Error `path: ...` where they are more than kMostStates
std::vector<std::string> state_names(const Consequences& consequences,
                                     const std::vector<std::string>& others,
                                     const std::string& path);

/// Lognormal curves of tables such as that of the fragility catalogue. The capacity of a piece has
/// the normal score sqrt(r) z_common + sqrt(1 - r) z_own, r the correlation: given the intensity,
/// pieces fail together as far as the motion decides (one-factor Gaussian copula; Vasicek 2002, Risk
/// 15(12), 160-162). The states of one piece share its score, so that rarer ones come after more
/// frequent ones.
/// @param correlation  in [0, 1]
std::unique_ptr<OutcomeSource> curve_outcomes(const Hospital& hospital,
                                              const Consequences& consequences, double correlation);

/// Runs of the study that the hospital becomes (study_job()). A sample takes a record for all
/// pieces, and for each one of the runs that its configuration has with that record.
std::unique_ptr<OutcomeSource> run_outcomes(const Hospital& hospital,
                                            const Consequences& consequences,
                                            const std::string& results);

/// Configuration in study_job(): "icu_bed open, second floor, on".
std::string configuration_of(const HospitalItem& item, const Storey& storey, Brakes brakes);

/// The hospital as the job of one study, whose configurations are the settings that its items have
/// or may get by an action. Run and continued, in parallel or in shards, as any study.
/// @throws Error without a table [simulation]
std::string study_job(const Hospital& hospital, const Consequences& consequences);

}  // namespace gurney::study
