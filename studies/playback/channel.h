#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace gurney::playback {

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

}  // namespace gurney::playback
