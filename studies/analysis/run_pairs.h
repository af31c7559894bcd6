#pragma once

#include <string>
#include <vector>

#include "studies/analysis/configuration_view.h"

namespace gurney::study {

/// Runs of two configurations that had the same record at the same level, and the same angle and
/// draw where both have those in common.
struct RunPairs {
  /// Runs that are held against each other; several of a side count by their mean.
  struct Pair {
    std::vector<std::size_t> a, b;
    std::size_t group = 0;
  };

  /// What is drawn from a population: runs of one group are not independent of each other.
  enum class Group {
    kRecord,
    kDraw,  ///< of the only record in common: what is found holds for that record
    kNone   ///< one record, no draws in common: no chance is left, and no p
  };

  std::vector<Pair> pairs;
  Group group = Group::kRecord;
  std::size_t groups = 0;
  bool by_intensity = false;  ///< else by the factor on the records
  bool by_draw = false, by_angle = false;
  std::string level;                           ///< the study's measure, or "scale"
  std::size_t paired_a = 0, paired_b = 0;      ///< runs
  std::size_t left_out_a = 0, left_out_b = 0;  ///< runs that did not fail but have no partner

  /// Runs of records in common, at whatever level, with their groups.
  std::vector<std::pair<std::size_t, std::size_t>> common_a, common_b;
};

/// Levels are those of the study's intensity measure where both have the same, else factors on the
/// records. Draws are the same numbers where both studies have the same seed, number and sampling
/// of draws; angles are left out of sight where the two have none in common.
/// @throws Error where no run of one has a partner in the other
RunPairs pair_runs(const ConfigurationView& a, const ConfigurationView& b);

}  // namespace gurney::study
