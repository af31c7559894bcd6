#pragma once

#include "engine/scene/scene.h"
#include "studies/results/hdf5_writer.h"

namespace gurney::study {

/// Adds /shapes: what items and room look like, for pictures of the histories. A shape is convex
/// and given by its points in the axes of its body: of a chassis item axes, of a caster fork axes
/// (engine/scene/equipment_model.h), of the room floor axes.
void add_shapes(Hdf5Writer& file, const Scene& scene);

}  // namespace gurney::study
