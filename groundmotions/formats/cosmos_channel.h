#pragma once

#include <optional>
#include <string>
#include <vector>

#include "groundmotions/formats/file_errors.h"
#include "groundmotions/formats/source_file.h"

namespace gurney::groundmotions {

/// The samples of a channel and the line that announces them: "7000 raw acceleration pts, approx
/// 70 secs, units=cm/sec2(04),Format=(8f10.3)".
struct CosmosSeries {
  std::size_t line = 0;          ///< index from 0 of that line
  std::string text;              ///< that line, in capitals
  std::optional<int> unit_code;  ///< in its brackets
  std::vector<double> values;
};

/// One channel of a COSMOS file as it stands there: text, integer and real header, comments,
/// series.
struct CosmosChannel {
  std::size_t first_line = 0;     ///< index from 0
  std::vector<std::string> text;  ///< in capitals
  std::vector<double> integers, reals;
  double unknown_integer = -999, unknown_real = -999;  ///< what stands for "unknown"
  std::string
      code;  ///< SEED code of the comment "<SCNL>STATION.CODE.NETWORK.LOCATION"; may be empty
  std::vector<CosmosSeries> series;  ///< at least one

  /// A number of the header, counted from 1 as the format's definition does; nothing if it is not
  /// known.
  std::optional<double> integer(std::size_t number) const;
  std::optional<double> real(std::size_t number) const;
};

/// Whether a line is the first of a COSMOS channel: "... (Format v01.20 with 13 text lines) ...".
bool starts_cosmos_channel(std::string_view line);

/// All channels of a file. Counts are checked against the numbers that are there.
std::vector<CosmosChannel> cosmos_channels(const SourceFile& file, FileErrors& errors);

}  // namespace gurney::groundmotions
