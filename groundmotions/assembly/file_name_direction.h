#pragma once

#include <vector>

#include "groundmotions/assembly/name_marks.h"
#include "groundmotions/assembly/place.h"

namespace gurney::groundmotions {

/// Whether the file of a component says nothing but times and numbers.
bool lacks_direction(const Component& component);

/// Directions of the components whose files say none and that nobody stated, from the names of
/// their files (name_marks.h), with a warning each. A lone file is a vertical if its name says so.
void orient_by_file_names(std::vector<UnplacedComponent>& components);

}  // namespace gurney::groundmotions
