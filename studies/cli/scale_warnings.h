#pragma once

#include <string>
#include <vector>

#include "studies/run/run_task.h"

namespace gurney::cli {

/// Records that a stated level of the study scales by more than groundmotions::kDubiousFactor, one
/// sentence each; of an IDA at its first level.
std::vector<std::string> scale_warnings(const study::Batch& batch);

}  // namespace gurney::cli
