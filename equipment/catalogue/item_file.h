#pragma once

#include <string>
#include <vector>

#include "equipment/catalogue/item_description.h"

namespace gurney::equipment {

/// Every variant is checked, whether selected or not.
/// @param variants  laid over the item in this order
/// @throws Error with every error of the file, its variants and the casters it names, and for a
///         variant it does not have.
Uncertain<ItemDescription> load_item_description(const std::string& file,
                                                 const std::vector<std::string>& variants = {});

/// Names of the variants of an item, the tables [variant.NAME] of its file, sorted.
/// @throws Error if the file is not TOML.
std::vector<std::string> variant_names(const std::string& item_file);

/// Empty if all are known; else what is wrong, with the nearest name.
std::string unknown_variant(const std::vector<std::string>& wanted,
                            const std::vector<std::string>& known);

}  // namespace gurney::equipment
