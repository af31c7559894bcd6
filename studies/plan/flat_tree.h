#pragma once

#include <map>
#include <string>

#include "engine/config/node.h"

namespace gurney::study {

/// Adds each value of a tree by its dotted key under `path`; tables of an array by their name, or
/// else by their number from 1: `item[bed].mass_kg`.
void flatten(const config::Node& node, const std::string& path,
             std::map<std::string, std::string>& entries);

}  // namespace gurney::study
