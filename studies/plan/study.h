#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "engine/base/random/sampling.h"
#include "engine/config/document.h"
#include "engine/config/table.h"
#include "studies/job/job.h"
#include "studies/limit_states/limit_state.h"
#include "studies/statistics/hazard.h"

namespace gurney::study {

/// A variant of the job: a patch over it, as variants are patches over items.
struct FactorLevel {
  std::string name;
  config::Node patch;  ///< a table
};

/// Factor that is varied on purpose; each level is combined with each level of every other factor,
/// unless the study lists its combinations.
struct Factor {
  std::string name;
  std::vector<FactorLevel> levels;
};

/// How each record's intensity goes up.
struct IntensityPlan {
  enum class Kind {
    kScales,   ///< factors on the records
    kStripes,  ///< values of the measure
    kIda       ///< incremental dynamic analysis: values found one after the other
  };
  Kind kind = Kind::kScales;
  groundmotions::Measure measure;  ///< of kStripes and kIda
  groundmotions::Combination combination = groundmotions::Combination::kGeometricMean;
  std::string unit = "1";           ///< as the job states levels, for display
  double unit_in_si = 1;            ///< one `unit` in SI
  std::vector<double> levels{1.0};  ///< of kScales: factors; of kStripes: values in SI; increasing
  int more_stages =
      0;  ///< of kStripes: after the levels, each planned from those before (stages.h)
  groundmotions::VerticalScaling vertical;

  double first = 0;       ///< of kIda: first value [SI]
  double increment = 0;   ///< added at the second step, growing by itself at each more [SI]
  int most_runs = 0;      ///< of one record, >= 3
  double resolution = 0;  ///< the bracket of the capacity is halved until it is narrower than this
                          ///< fraction of its lower end
  int fill = 0;           ///< runs below the capacity once the bracket is narrow

  /// Limit state that ends the IDA, or that more stages look for: index in Study::limit_states.
  std::size_t until = 0;
};

/// A measure of each scaled ground motion that the results keep.
struct KeptMeasure {
  groundmotions::Measure measure;
  groundmotions::Combination combination = groundmotions::Combination::kGeometricMean;
};

/// Which runs keep their histories.
enum class Histories { kNone, kFailed, kOverturned, kAll };

/// Tables that a study's results keep besides runs, items and points.
struct OutputOptions {
  Histories histories = Histories::kNone;
  bool events = true, zones = true, tethers = true, wheels = false, energy = false;
};

/// Variations of a job: its table [study] (docs/formats/study.md).
struct Study {
  std::vector<Factor> factors;
  /// Which combinations of levels are made: for each the level of each factor. Empty: all.
  std::vector<std::vector<std::size_t>> combinations;
  std::vector<double> angles{0.0};       ///< record against floor axes [rad]
  int synthetic_records = 0;             ///< > 0: seeds 1, 2, ... of the synthetic motion
  std::vector<LimitState> limit_states;  ///< at least one
  IntensityPlan intensity;
  std::optional<statistics::HazardCurve> hazard;  ///< of the study's measure [SI]
  std::vector<std::size_t> performance;           ///< limit states, mildest first
  std::uint64_t seed = 1;
  int draws = 0;  ///< of each record; 0: every parameter has its value
  Sampling sampling = Sampling::kMonteCarlo;
  int replicas = 1;  ///< of each draw, under changes that nobody can measure (replica_of())
  std::vector<KeptMeasure> measures;
  OutputOptions keep;
  double step_check = 0;  ///< fraction of the runs that are repeated with half the time step
};

/// Reads the table [study.hazard]: rates at which the study's measure is exceeded at the site, as
/// `im` and `rate_per_year` or as `k0` and `k`. Errors are noted in its document.
std::optional<statistics::HazardCurve> read_hazard(config::Table& hazard,
                                                   const IntensityPlan& intensity);

/// Reads the table [study] of a job. Errors are noted in its document.
/// @param node  the same table, from which the patches of factors are taken
Study read_study(config::Table& study, const config::Node& node);

}  // namespace gurney::study
