#pragma once

#include <string>
#include <vector>

namespace gurney::groundmotions {

/// The name of a record of several files: what their stems begin and end with, without the names of
/// the components and the separators before them. "X_NIS000" and "X_NIS090" are of "X_NIS",
/// "16839_H1.cor" and "16839_V.cor" of "16839". Where that says little all stems, apart by " + ".
std::string common_name(const std::vector<std::string>& stems);

}  // namespace gurney::groundmotions
