#pragma once

#include "engine/response/response.h"
#include "engine/scene/scene.h"
#include "studies/study/results/hdf5_writer.h"

namespace gurney::study {

/// The group /histories: samples of all items at common times.
void add_histories(Hdf5Writer& file, const Scene& scene, const Response& response);

}  // namespace gurney::study
