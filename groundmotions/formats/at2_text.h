#pragma once

#include <string>

#include "groundmotions/record/record.h"

namespace gurney::groundmotions {

/// A component as a PEER AT2 file: four lines of header, then accelerations in g, five in a row
/// with eight significant digits.
/// @param title  first line of the header
/// @param event  second line, before the name of the component; commas end its fields
std::string at2_text(const Component& component, const std::string& title,
                     const std::string& event);

}  // namespace gurney::groundmotions
