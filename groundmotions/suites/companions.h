#pragma once

#include <filesystem>
#include <vector>

namespace gurney::groundmotions {

/// Takes the velocities and displacements out of `files` whose acceleration is among them: X.VT2
/// and X.DT2 beside X.AT2, X.vel and X.dis beside X.acc, X.VEL.ASC beside X.ACC.ASC, letter case
/// apart.
/// @returns how many were taken out
std::size_t drop_companions(std::vector<std::filesystem::path>& files);

}  // namespace gurney::groundmotions
