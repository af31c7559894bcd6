#pragma once

#include <functional>
#include <string>
#include <vector>

#include "studies/explanation/facts.h"
#include "studies/results/run_facts.h"

namespace gurney::explanation {

/// A change of the case that might have prevented what is explained.
struct Variant {
  std::string name;    ///< "all brakes on"
  std::string clause;  ///< begins a sentence: "Locking every wheel"
  Scene scene = {};
  std::string reason = {};  ///< why it does not apply; empty: it does
};

/// Brakes on and off, turned by 90, 180 and 270 degrees, farther from what it hit and without it,
/// centre of mass 10 and 20 % lower, straps, without its cords; of the explained item only.
///
/// Braked wheels are locked, whatever torque their brakes have. The straps are two of 50 kN/m with
/// 20 mm of slack, at the centre of mass, along and against the direction of the event. Cords become
/// as long as the new place needs.
std::vector<Variant> variants_of(const study::RunFacts& facts, const Explanation& of);

/// A strap of 50 kN/m with 20 mm of slack from the centre of mass of an item, as it stands at the start,
/// to an anchor 0.3 m outside of it.
/// @param towards  unit, in plan
Tether strap_of(const Scene& scene, std::size_t item, const std::string& name,
                const Vector2& towards);

/// Displacement of an event that counts as prevented [m].
inline constexpr double kHarmless = 0.05;

/// Effect of one variant on the explained item. With replicas numbers are medians.
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

/// The sentence: what would have prevented the event, and what would not.
std::string conclusion(const WhatIf& what, const Explanation& of);

}  // namespace gurney::explanation
