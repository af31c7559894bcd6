#pragma once

#include "studies/findings/findings.h"

namespace gurney::report {

/// The catalogue as tables.
/// @throws Error with the errors of a catalogue file.
findings::Section equipment_list();

}  // namespace gurney::report
