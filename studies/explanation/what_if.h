#pragma once

#include <functional>
#include <string>
#include <vector>

#include "studies/explanation/facts.h"
#include "studies/results/run_facts.h"

namespace gurney::explanation {

/// Displacement of an event that counts as prevented [m].
inline constexpr double kHarmless = 0.05;

/// What one variant did to the explained item. With replicas numbers are medians.
struct VariantOutcome {
  std::string name, clause;
  std::string reason;            ///< why it was not run, or failed; empty: it is there
  double peak_displacement = 0;  ///< [m]
  double tilt_ratio = 0;         ///< largest tilt / critical, until it overturned [-]
  double hardest_impact = 0;     ///< with anything but the floor; 0: none [m/s]
  std::size_t runs = 0;          ///< that did not fail
  std::size_t failed = 0;
  std::size_t overturned = 0;  ///< runs
  std::size_t happened = 0;    ///< runs in which the event was not prevented

  bool prevented() const { return runs > 0 && happened == 0; }
};

struct WhatIf {
  std::size_t replicas = 1;  ///< runs of each variant
  VariantOutcome as_it_was;  ///< with as many replicas
  std::vector<VariantOutcome> variants;
};

/// Runs all variants; the result does not depend on `threads`.
/// @param replicas  of each: runs under changes that nobody can measure (replica_of())
/// @param progress  called from one thread at a time with the runs that are finished, and all
WhatIf what_if(const study::RunFacts& facts, const Explanation& of, std::size_t replicas,
               int threads, const std::function<void(std::size_t, std::size_t)>& progress = {});

/// The table and the sentence below it.
std::string text(const WhatIf& what, const Explanation& of);

/// The sentence: what would have prevented the event, and what would not.
std::string conclusion(const WhatIf& what, const Explanation& of);

}  // namespace gurney::explanation
