#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "studies/analysis/configuration_view.h"
#include "studies/statistics/sensitivity.h"

namespace gurney::study {

/// Input that may make an output vary: a parameter that was drawn, several with the same values, or
/// what the runs differ by otherwise.
struct SensitiveInput {
  std::vector<std::string> names;  ///< more than one: their values are equal in every run
  std::size_t set = 0;             ///< of inputs that go together: see StudySensitivity::correlated
  bool drawn = true;               ///< else record, angle, level or chaos, which have no order
  std::optional<statistics::VarianceIndex> index =
      {};  ///< first order; none: not to be had from these runs
  std::optional<statistics::VarianceIndex> total =
      {};                    ///< with all interactions; of a Saltelli design only
  double low = 0, high = 0;  ///< of a drawn number: its quantiles at the tornado's share and above
  statistics::TornadoBar bar = {};  ///< of a drawn number: means of the output there

  /// Whether the interval of its index does not reach 0.
  bool stands_out() const {
    const auto& shown = total ? total : index;
    return shown && shown->interval.low > 0;
  }
};

/// The input of studies with replicas that stands for changes that nobody can measure. Its index is
/// the share that is left where all else is given: with its interactions.
inline constexpr const char* kChaos = "chaos";

/// Which inputs rule an output of one configuration.
struct StudySensitivity {
  bool designed = false;  ///< from a Saltelli design
  std::string output, units;
  std::string level;      ///< empty: all levels together
  std::string why_level;  ///< of a level that was not asked for
  std::size_t runs = 0, left_out = 0, draws = 0, overturned = 0;
  bool repeated_draws = false;  ///< several runs share a draw: intervals are too narrow
  double mean = 0, deviation = 0;
  /// Sum of the indices; inputs that are correlated count once, by the largest.
  double sum = 0;
  std::vector<SensitiveInput> inputs;  ///< largest index, or total index, first
  std::vector<std::string> constant;   ///< drawn, but the same in every run
  /// Drawn numbers whose ranks are correlated, beyond chance and more than weakly: the index of
  /// each holds what the others do, too.
  std::vector<std::vector<std::string>> correlated;
  double share = 0.1;  ///< of the runs at each end of the tornado
};

struct SensitivityRequest {
  std::string demand;                ///< as demands_named(); it must be one
  std::string limit;                 ///< limit state: the output is 1 where it is exceeded, else 0
  std::optional<std::size_t> level;  ///< index in Levels; none: that nearest to a median
  double share = 0.1;
  bool all_levels = false;
};

/// Means of fewer runs are not stated in a tornado.
inline constexpr std::size_t kFewestOfMean = 10;

/// The bar, with NaN for a mean of fewer runs.
statistics::TornadoBar stated_bar(statistics::TornadoBar bar);

/// Fewest runs that a tornado of the lowest and the highest tenth can be made of.
inline constexpr std::size_t kFewestRuns = 20;

/// First-order indices and a tornado from /drawn and the runs; of a Saltelli design total indices
/// too.
/// @throws Error where the study has no draws, too few runs, no such level, or an output that does
///   not vary
StudySensitivity study_sensitivity(const ConfigurationView& side,
                                   const SensitivityRequest& request);

/// The output whose variance is shared out, run by run.
struct SensitivityOutput {
  std::string name, units;
  std::string level;      ///< empty: all levels together
  std::string why_level;  ///< of a level that was not asked for
  std::vector<std::size_t> runs;
  std::vector<double> values;     ///< of these runs
  std::size_t left_out = 0;       ///< runs without such a demand
  std::size_t overturned = 0;     ///< of the runs
  std::vector<std::size_t> draw;  ///< of the runs, as /runs has it
};

/// @throws Error for a level or a demand that the study does not have
SensitivityOutput sensitivity_output(const ConfigurationView& side,
                                     const SensitivityRequest& request);

/// @throws Error where fewer than kFewestRuns are left, or all have the same output
void require_variation(const SensitivityOutput& output, const std::string& file);

/// The numbers of each draw of a configuration, by their names in the order of the file.
struct DrawnNumbers {
  std::vector<std::string> names;
  std::map<std::string, std::map<std::size_t, double>> values;  ///< of a name and a draw

  std::vector<double> column(const std::string& name, const std::vector<std::size_t>& draws) const;
};

DrawnNumbers drawn_numbers(const ConfigurationView& side);

/// Inputs of a study's Saltelli design in their order, `variable mass_kg`, `group treads` or
/// `record`; none: it has no such design.
std::vector<std::string> design_inputs(const StudyData& data);

/// First-order and total indices (sobol_indices) of the inputs of a Saltelli design.
///
/// The output's mean under each angle and level is taken off, so that the variance is that under
/// one of them. A point counts if all its runs do.
/// @throws Error as study_sensitivity() does, and where fewer than kFewestRuns points are whole
StudySensitivity designed_sensitivity(const ConfigurationView& side,
                                      const SensitivityRequest& request);

}  // namespace gurney::study
