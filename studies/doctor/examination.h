#pragma once

#include <vector>

#include "studies/doctor/finding.h"

namespace gurney::doctor {

/// Everything, in the order in which it is to be read.
std::vector<Finding> examination();

}  // namespace gurney::doctor
