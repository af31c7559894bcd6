#pragma once

#include <vector>

#include "groundmotions/assembly/place.h"

namespace gurney::groundmotions {

/// Azimuth or vertical of a component of which its file says nothing but a time and a number, from
/// the end of the file's name: NIS000, NIS090, NIS-UP. With a warning.
/// @returns whether the name says it
bool orient_by_file_name(Component& component);

/// The same for the components of one record, if all that need it get it and the horizontals are
/// then at a right angle; else they stay as they are.
void orient_by_file_names(std::vector<UnplacedComponent>& components);

}  // namespace gurney::groundmotions
