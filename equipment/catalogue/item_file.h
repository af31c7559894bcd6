#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/base/random/draw.h"
#include "equipment/catalogue/item_description.h"

namespace gurney::equipment {

/// Which form of an item is wanted.
struct ItemSelection {
  std::vector<std::string> variants;  ///< laid over the item in this order
  std::optional<Draw> draw;           ///< of its uncertain numbers; none: as their values
};

/// Every variant is checked, whether selected or not.
/// @throws Error with every mistake of the file, its variants and the casters it names, and for a
///         variant it does not have.
ItemDescription load_item_description(const std::string& file, const ItemSelection& selection = {});

/// Names of the variants of an item, the tables [variant.NAME] of its file, sorted.
/// @throws Error if the file is not TOML.
std::vector<std::string> variant_names(const std::string& item_file);

/// Empty if all are known; else what is wrong, with the nearest name.
std::string unknown_variant(const std::vector<std::string>& wanted,
                            const std::vector<std::string>& known);

}  // namespace gurney::equipment
