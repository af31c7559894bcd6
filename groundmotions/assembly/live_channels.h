#pragma once

#include <string>
#include <vector>

#include "groundmotions/record/record.h"

namespace gurney::groundmotions {

/// The channels of one file that make up a record, where a recorder has more than three: without
/// those that are all zero, or without those that are no axis beside two azimuths. Everything where
/// that gives no record either.
struct LiveChannels {
  std::vector<std::size_t> kept;
  std::vector<std::string> warnings;  ///< for each channel that is left out
};
LiveChannels live_channels(const std::vector<Component>& channels);

}  // namespace gurney::groundmotions
