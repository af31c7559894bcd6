#pragma once

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

}  // namespace gurney::explanation
