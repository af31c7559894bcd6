#pragma once

#include "studies/exports/chosen_curves.h"
#include "studies/exports/export.h"

namespace gurney::study {

/// Fragility models in NRML 0.5 for OpenQuake: a file for each limit state, since the limit states
/// of one file follow each other there, and in it a function for each configuration: the lognormal
/// curve by mean and standard deviation of the intensity, which is what NRML asks for.
/// @return the curves that were left out, and why
/// @throws Error for unknown names, a measure of the floor and others that NRML does not name, and
///         without any curve
std::vector<std::string> export_nrml(const StudyData& data, const ExportChoice& choice,
                                     const TakeFile& take);

}  // namespace gurney::study
