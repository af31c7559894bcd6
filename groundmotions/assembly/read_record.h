#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "groundmotions/formats/format.h"
#include "groundmotions/record/record.h"

namespace gurney::groundmotions {

/// One file of a record, and what to take from it.
struct RecordFile {
  std::filesystem::path path;
  std::optional<Direction> direction = {};  ///< none: the file itself or its azimuths say it
  std::optional<int> channel = {};  ///< of several in the file, from 1; none: all that are there
};

/// Reads one to three components into one record: the files are read, their components placed
/// (assembly/place.h) and brought to one time step, start and length (assembly/align.h).
/// Horizontals that were placed by their azimuths and are not at a right angle are resolved into
/// such a pair (processing/rotate.h). What was done becomes a warning; whether the amplitudes are
/// plausible is checked by implausible().
///
/// @throws Error for no files, a file that cannot be read, a place that is not known, stated twice
///         or stated against the file, horizontal components that are too far from a right angle,
///         starts that do not belong together, and a record that is all zero. The errors of all
///         files are reported in one Error.
Record read_record(const std::vector<RecordFile>& files, const ReadOptions& options = {});

/// The channels of one file that make up a record, where a recorder has more than three: without
/// those that are all zero, or without those that are no axis beside two azimuths. Everything where
/// that gives no record either.
struct LiveChannels {
  std::vector<std::size_t> kept;
  std::vector<std::string> warnings;  ///< for each channel that is left out
};
LiveChannels live_channels(const std::vector<Component>& channels);

/// Brings the components of a record to one time step, one start and one length; each change is a
/// warning.
///
/// 1. Time steps that differ by more than 1e-6: all components are resampled to the smallest
///    (processing/resample.h).
/// 2. Starts that differ by a sample or more, where every file states its own (if only some do, a
///    warning says that no start is used): the record begins
///    with the earliest component, zeros stand before the others. They are shifted by whole
///    samples; what is left, half a sample at most, is part of the warning if it is more than 0.01
///    of a sample.
/// 3. Shorter components are filled with zeros at their end.
///
/// @throws Error for starts further apart than the shortest component is long: other earthquakes.
void align(Record& record);

}  // namespace gurney::groundmotions
