#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "groundmotions/formats/format.h"
#include "groundmotions/record.h"

namespace gurney {

/// One file of a record and the place of its component.
struct RecordFile {
  std::filesystem::path path;
  std::optional<Direction> direction;  ///< none: the file itself says it (columns x, y, z of a CSV)
};

/// Reads one to three components into one record.
///
/// Components of unequal length start together; the shorter ones are filled with zeros at their end
/// up to the longest, with a warning. Further warnings: components that seem to be in the wrong
/// place or are not at right angles by their azimuths, a peak below 0.001 g or above 3 g, a
/// component that is all zero. Azimuths are reported, not used: h2 is taken as h1 turned by 90
/// degrees counter-clockwise seen from above.
///
/// @throws Error for no files, a file that cannot be read, a place that is not stated, stated twice
///         or stated against the file, components of different time steps, and a record that is
///         all zero. The mistakes of all files are told in one Error.
Record read_record(const std::vector<RecordFile>& files, const ReadOptions& options = {});

}  // namespace gurney
