#pragma once

#include <string>
#include <vector>

#include "engine/scene/loads.h"
#include "equipment/catalogue/load_item.h"
#include "equipment/catalogue/quantity.h"
#include "equipment/catalogue/uncertainty.h"

namespace gurney::study {

/// Statements of a job without effect, apart from errors.
struct Remarks {
  std::vector<std::string> warnings;
  /// Inputs that change nothing in this job, `file:line:column: ...` each. An error in a single
  /// run, and in a study where none of its configurations needs the input.
  std::vector<std::string> without_effect;
};

/// Which item, what is changed on it, where it stands.
struct JobItem {
  InitialMotion initial;  ///< position and yaw
  equipment::ItemDescription description;
  equipment::ItemOptions options;
};

/// Reads the keys headings_deg, brakes, brake_share and swivel_locks of an item with casters.
///
/// One value or distribution for all is meant for the casters that can take it: a heading and a
/// lock for those that swivel, a brake for those that have one. In an array each caster has its
/// own value, and one that it cannot take is an error.
/// @param item  its description is there; headings, brakes and locks are set here
void read_caster_options(equipment::Quantities& in, equipment::Uncertain<JobItem>& item,
                         Remarks& remarks);

}  // namespace gurney::study
