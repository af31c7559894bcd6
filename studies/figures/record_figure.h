#pragma once

#include <string>

#include "groundmotions/record/record.h"

namespace gurney::figures {

/// One page of SVG: acceleration, velocity and displacement of each component from rest, what they
/// leave at the end, and the response spectra (5 % damping) of the components and of RotD50.
std::string record_figure(const groundmotions::Record& record);

}  // namespace gurney::figures
