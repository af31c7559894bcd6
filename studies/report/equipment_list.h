#pragma once

#include <string>

namespace gurney::report {

/// The catalogue as tables for people, or as a JSON object.
/// @throws Error with the errors of a catalogue file.
std::string equipment_list();
std::string equipment_list_json();

}  // namespace gurney::report
