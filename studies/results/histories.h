#pragma once

#include "engine/response/response.h"
#include "studies/results/hdf5_writer.h"
#include "studies/results/run_facts.h"

namespace gurney::study {

/// The group /histories: samples of all items and of the floor at common times.
void add_histories(Hdf5Writer& file, const RunFacts& facts, const Response& response);

}  // namespace gurney::study
