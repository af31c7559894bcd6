#pragma once

#include <vector>

#include "engine/base/floor_motion.h"
#include "studies/results/hdf5_writer.h"

namespace gurney::study {

/// Displacement of the floor since 0 s [m], from rest.
/// @param times  that increase [s]
std::vector<Vector3> floor_displacement(const FloorMotion& floor, const std::vector<double>& times);

/// The translation of the floor in /histories.
/// @param times  those of /histories/time
void add_floor_histories(Hdf5Writer& file, const FloorMotion& floor,
                         const std::vector<double>& times);

}  // namespace gurney::study
