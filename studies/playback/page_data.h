#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "studies/playback/recorded_run.h"

namespace gurney::playback {

/// Bytes of base64 for all runs of a page, of which every n-th sample is kept so that it has no
/// more. A page has 60 kB besides.
inline constexpr std::size_t kMaxBytes = 4'500'000;

/// One of the runs that a page shows side by side.
struct PageRun {
  std::string name;  ///< "run 3"; empty where it is the only one
  RecordedRun run;
};

/// Every how many samples one is kept.
std::size_t stride(const std::vector<PageRun>& runs, std::size_t most_bytes = kMaxBytes);

/// A run as it is drawn in the scene of another: its items without wheels, their
/// poses, and when they overturned.
RecordedRun ghost_of(const RecordedRun& run);

/// How far poses that a page shows at the times of the samples are from these at most.
struct ThinningError {
  double position = 0;  ///< [m]
  double angle = 0;     ///< [rad]
};

/// Of runs of which every n-th sample and the last are kept, as whole numbers of 16 bits, with lines
/// between them.
ThinningError thinning_error(const std::vector<PageRun>& runs, std::size_t stride);

/// A history in whole numbers: value = offset + step x number.
struct Channel {
  double offset = 0;  ///< least value
  double step = 0;    ///< range / (2^bits - 1); 0: all values are the offset
  int bits = 16;      ///< 8 or 16
  std::string data;   ///< base64 of the numbers, the low byte first; empty: step is 0
};

/// The values differ from those of the channel by half a step at most. What is no number becomes
/// the offset.
Channel quantised(const std::vector<double>& values, int bits);

std::string base64(std::span<const std::uint8_t> bytes);

/// The runs as JSON, without any '<'.
/// @param ghosts  drawn in the scene of the first run, without wheels; runs and ghosts have
///                kMaxBytes together, runs at most half of it
std::string page_data(const std::vector<PageRun>& runs, const std::vector<PageRun>& ghosts = {});

}  // namespace gurney::playback
