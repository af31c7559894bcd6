#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>

#include "studies/doctor/finding.h"

namespace gurney::doctor {

Finding cpu();

/// @param hardware  threads that the system lets this process use
/// @param quota     of the control group, in CPUs; none: unlimited
Finding threads(unsigned hardware, std::optional<double> quota);
Finding threads();

/// @param available  of the machine and of the control group [bytes]; none: not known
Finding memory(std::optional<std::uint64_t> available);
Finding memory();

/// Space where results go by default: the current folder.
Finding disk(const std::filesystem::path& folder);

/// Rounding to nearest, and numbers below 1e-308 that are not taken for zero.
Finding arithmetic();

}  // namespace gurney::doctor
