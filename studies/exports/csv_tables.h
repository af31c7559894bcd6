#pragma once

#include "studies/exports/export.h"
#include "studies/units/unit_system.h"

namespace gurney::study {

/// Every table of a results file, of a study or of one run, as a CSV file: names, units, rows. A
/// column with more dimensions than rows becomes one for each place in them:
/// `displacement.Trolley.x`. Numbers in SI read back exactly; a number that does not exist is empty.
/// @throws Error for other files
void export_tables(const std::string& path, const TakeFile& take, const UnitSystem& units = {});

}  // namespace gurney::study
