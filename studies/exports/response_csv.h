#pragma once

#include "studies/exports/chosen_curves.h"
#include "studies/exports/export.h"

namespace gurney::study {

/// Samples of demands, run by run, for each configuration.
///
/// `response_CONFIGURATION.csv`, as SimCenter's tools have it: index of the run, a column for each
/// drawn number, intensity measure and demand of each item and point, and ERROR.
///
/// `demands_CONFIGURATION_LEVEL.csv`, as pelicun loads it, for each level of a study (none after a
/// ida): columns TYPE-LOCATION-DIRECTION, units pelicun knows; the floor's PFA and PFV at location
/// 0 in direction 1, demands of items at the item's name.
///
/// The second row has the units. Failed runs have ERROR 1 and no demand; a number that does not
/// exist is empty.
/// @throws Error for an unknown configuration, and unless it is the results file of a study
void export_responses(const StudyData& data, const ExportChoice& choice, const TakeFile& take);

}  // namespace gurney::study
