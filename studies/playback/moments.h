#pragma once

#include <vector>

#include "studies/playback/recorded_run.h"
#include "studies/results/hdf5_reader.h"

namespace gurney::playback {

/// What happened, by time: impacts, overturnings, tethers that got taut or unplugged, entries of
/// zones and peaks as the tables of the file state them; lift-offs at the samples of the histories,
/// one for each time from the first wheel that leaves the floor until all are back for 0.2 s.
std::vector<Moment> moments(const study::Hdf5Reader& file, const RecordedRun& run);

}  // namespace gurney::playback
