#pragma once

#include <vector>

#include "studies/playback/page.h"

namespace gurney::playback {

/// What is left of a run that is drawn in the scene of another: its items without wheels, their
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

}  // namespace gurney::playback
