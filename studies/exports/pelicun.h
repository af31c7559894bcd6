#pragma once

#include "studies/exports/chosen_curves.h"
#include "studies/exports/export.h"

namespace gurney::study {

/// Rows of a fragility table of the Damage and Loss Model Library, which pelicun reads, and the
/// file that describes them: fragility.csv and fragility.json. A component for each configuration
/// and limit state, with that one limit state: those of a study may come in any order, but the
/// limit states of one row follow each other in pelicun.
/// @return the curves that were left out, and why
/// @throws Error for unknown names, a measure that DLML does not name, and without any curve
std::vector<std::string> export_pelicun(const StudyData& data, const ExportChoice& choice,
                                        const TakeFile& take);

}  // namespace gurney::study
