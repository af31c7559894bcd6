#pragma once

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

/// The runs as JSON, without any '<'.
/// @param ghosts  drawn in the scene of the first run, without wheels; runs and ghosts have
///                kMaxBytes together, runs at most half of it
std::string page_data(const std::vector<PageRun>& runs, const std::vector<PageRun>& ghosts = {});

/// A page that needs no other file and nothing from a network.
std::string playback_page(const std::vector<PageRun>& runs,
                          const std::vector<PageRun>& ghosts = {});

}  // namespace gurney::playback
