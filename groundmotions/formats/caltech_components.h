#pragma once

#include <vector>

#include "groundmotions/formats/format.h"

namespace gurney::groundmotions {

/// The acceleration of every channel of a volume 1 or 2 (caltech_volume.h), with what its header
/// states checked: unit, time step, length, peak and azimuth. Pairs of time and value at uneven
/// times are brought to an even step (uneven_samples.h).
/// @throws Error with all errors of the file.
std::vector<Component> caltech_components(const SourceFile& file, const ReadOptions& options);

}  // namespace gurney::groundmotions
