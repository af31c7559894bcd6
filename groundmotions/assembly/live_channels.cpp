#include "groundmotions/assembly/live_channels.h"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

#include "groundmotions/assembly/place.h"

namespace gurney::groundmotions {

namespace {

using Indices = std::vector<std::size_t>;

bool is_vertical(const Component& channel) {
  return channel.direction == Direction::kVertical ||
         (!channel.azimuth && sounds_vertical(channel.name));
}

bool all_zero(const Component& channel) { return (channel.acceleration.array() == 0).all(); }

bool has_places_for(const std::vector<Component>& channels, const Indices& kept) {
  const auto verticals =
      std::ranges::count_if(kept, [&](std::size_t i) { return is_vertical(channels[i]); });
  return !kept.empty() && verticals <= 1 && std::ssize(kept) - verticals <= 2;
}

template <class Keep>
LiveChannels filtered(const std::vector<Component>& channels, const char* reason, Keep keep) {
  LiveChannels result;
  for (std::size_t i = 0; i < channels.size(); ++i)
    if (keep(channels[i]))
      result.kept.push_back(i);
    else
      result.warnings.push_back(fmt::format("{}: channel {} ('{}') {}: not used", channels[i].file,
                                            i + 1, channels[i].name, reason));
  return result;
}

}  // namespace

LiveChannels live_channels(const std::vector<Component>& channels) {
  LiveChannels all;
  all.kept.resize(channels.size());
  std::iota(all.kept.begin(), all.kept.end(), 0);
  if (has_places_for(channels, all.kept)) return all;
  LiveChannels moving = filtered(channels, "is all zero",
                                 [](const Component& channel) { return !all_zero(channel); });
  if (has_places_for(channels, moving.kept)) return moving;
  LiveChannels axes = filtered(channels, "is no axis of the motion", [](const Component& channel) {
    return channel.azimuth.has_value() || is_vertical(channel);
  });
  const auto azimuths = std::ranges::count_if(
      axes.kept, [&](std::size_t i) { return channels[i].azimuth.has_value(); });
  return azimuths == 2 && has_places_for(channels, axes.kept) ? axes : all;
}

}  // namespace gurney::groundmotions
