#pragma once

#include "equipment/catalogue/quantity.h"
#include "studies/job/item_reader.h"
#include "studies/job/remarks.h"

namespace gurney::study {

/// The keys headings_deg, brakes and swivel_locks of an item with casters.
///
/// One value or distribution for all is meant for the casters that can take it: a heading and a
/// lock for those that swivel, a brake for those that have one. In an array each caster has its
/// own value, and one that it cannot take is an error.
/// @param item  its description is there; headings, brakes and locks are set here
void read_caster_options(equipment::Quantities& in, equipment::Uncertain<JobItem>& item,
                         Remarks& remarks);

}  // namespace gurney::study
