#pragma once

#include <optional>
#include <string>
#include <vector>

#include "groundmotions/formats/file_errors.h"
#include "groundmotions/formats/source_file.h"
#include "groundmotions/record/acceleration_unit.h"

namespace gurney::groundmotions {

/// A series of samples and the line that announces it: "12001 POINTS OF ACCEL DATA EQUALLY SPACED
/// AT .005 SEC. (UNITS: G)". Without such a line the numbers are pairs of a time and a value.
struct CaltechSeries {
  enum class Quantity { kAcceleration, kVelocity, kDisplacement };

  std::size_t line = 0;  ///< index from 0 of the announcement, else of the first numbers
  Quantity quantity = Quantity::kAcceleration;
  std::optional<double> time_step;       ///< as announced [s]
  std::optional<AccelerationUnit> unit;  ///< as announced
  std::vector<double> times;             ///< of pairs [s], else empty
  std::vector<double> values;
};

/// One channel of a strong motion volume in the layout that the California Institute of Technology
/// began and CSMIP, USC and RENADIC use: lines of text, 100 integers in 16I5, 50 real numbers
/// (volume 1) or 100 (volume 2) in 8F10.3, then series.
struct CaltechChannel {
  std::size_t first_line = 0;     ///< index from 0
  std::vector<std::string> text;  ///< header lines, in capitals
  std::vector<double> integers;   ///< 100; NaN where a number did not fit its field
  std::vector<double> reals;      ///< 50 or 100
  std::vector<CaltechSeries> series;
  std::string trailing;  ///< a last line of the file that is neither samples nor a header

  bool corrected() const { return reals.size() > 50; }  ///< volume 2

  /// Index in `text` of the first line that has `key`, from `begin` on.
  std::optional<std::size_t> find(std::string_view key, std::size_t begin = 0) const;
};

/// All channels of a file. Counts are checked against the numbers that are there.
std::vector<CaltechChannel> caltech_channels(const SourceFile& file, FileErrors& errors);

}  // namespace gurney::groundmotions
