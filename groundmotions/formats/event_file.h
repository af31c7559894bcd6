#pragma once

#include <map>
#include <string>
#include <vector>

#include "groundmotions/formats/source_file.h"

namespace gurney::groundmotions {

/// A time series of an event file.
struct EventSeries {
  double time_step = 0;         ///< in [kShortestTimeStep, kLongestTimeStep] [s]
  std::vector<double> samples;  ///< times the factor of the series, if it has one; at least 2
};

/// The time series of a JSON file with the layout of SimCenter's EVENT.json, by name: each of
/// `Events[].timeSeries[]` has `name`, `dT` in seconds, `data`, and may have a `factor`.
/// @throws Error for another file
std::map<std::string, EventSeries> event_series(const SourceFile& file);

}  // namespace gurney::groundmotions
