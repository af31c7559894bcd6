#pragma once

#include <string>
#include <vector>

#include "equipment/catalogue/catalogue.h"

namespace gurney::equipment {

/// A data file without errors.
struct CheckedFile {
  DataKind kind = DataKind::kItem;
  std::string name;                   ///< what the file calls it
  std::vector<std::string> warnings;  ///< of stability and plausibility
};

/// Reads an item (with all its variants), a caster or a floor covering, whichever `schema` says.
/// @throws Error with every error of the file.
CheckedFile check_data_file(const std::string& file);

}  // namespace gurney::equipment
