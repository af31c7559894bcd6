#pragma once

#include <filesystem>
#include <optional>
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

}  // namespace gurney::groundmotions
