#include "studies/playback/channel.h"

#include <algorithm>
#include <cmath>

namespace gurney::playback {

std::string base64(std::span<const std::uint8_t> bytes) {
  static const char* const kDigits =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const std::size_t count = std::min<std::size_t>(3, bytes.size() - i);
    std::uint32_t group = 0;
    for (std::size_t k = 0; k < 3; ++k) group = group << 8 | (k < count ? bytes[i + k] : 0u);
    for (std::size_t k = 0; k < 4; ++k)
      text += k <= count ? kDigits[group >> (18 - 6 * k) & 63u] : '=';
  }
  return text;
}

Channel quantised(const std::vector<double>& values, int bits) {
  const double largest = std::exp2(bits) - 1;
  double low = INFINITY, high = -INFINITY;
  for (const double value : values) {
    if (!std::isfinite(value)) continue;
    low = std::min(low, value);
    high = std::max(high, value);
  }
  Channel channel{std::isfinite(low) ? low : 0, 0, bits, {}};
  const double step = (high - low) / largest;
  if (!(step > 0)) return channel;
  channel.step = step;
  std::vector<std::uint8_t> bytes;
  for (const double value : values) {
    const double number = std::isfinite(value) ? std::round((value - low) / step) : 0;
    const auto whole = static_cast<std::uint32_t>(std::clamp(number, 0.0, largest));
    bytes.push_back(static_cast<std::uint8_t>(whole & 255u));
    if (bits == 16) bytes.push_back(static_cast<std::uint8_t>(whole >> 8));
  }
  channel.data = base64(bytes);
  return channel;
}

}  // namespace gurney::playback
