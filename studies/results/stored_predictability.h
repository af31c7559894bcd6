#pragma once

#include <string>
#include <utility>
#include <vector>

#include "engine/response/predictability.h"
#include "studies/results/hdf5_reader.h"

namespace gurney::study {

/// Each item of a results file with its row of /predictability, without the demands of the
/// repetitions. Empty where the program that wrote the file did not judge its run.
std::vector<std::pair<std::string, Predictability>> stored_predictability(const Hdf5Reader& file);

}  // namespace gurney::study
