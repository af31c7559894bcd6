#pragma once

#include <fmt/format.h>

#include <bit>
#include <cstdint>
#include <cstring>
#include <string>
#include <utility>
#include <vector>

namespace gurney::groundmotions {

struct SacSample {
  int version = 6;
  bool is_swapped = false;
  std::string name = "HNE";
  std::vector<std::pair<int, float>> reals = {};   ///< word from 0, value
  std::vector<std::pair<int, int>> integers = {};  ///< likewise
  std::vector<float> values = {0.5F, -1.25F, 0.75F, 0.25F};
};

inline std::string sac_file(const SacSample& s = {}) {
  std::vector<std::uint32_t> words(158 + s.values.size());
  const auto set_real = [&](std::size_t i, float x) { words[i] = std::bit_cast<std::uint32_t>(x); };
  const auto set_integer = [&](std::size_t i, int x) { words[i] = static_cast<std::uint32_t>(x); };
  for (std::size_t i = 0; i < 70; ++i) set_real(i, -12345);
  for (std::size_t i = 70; i < 110; ++i) set_integer(i, -12345);
  const std::pair<int, float> reals[] = {{0, 0.02F}, {1, -1.25F}, {2, 0.75F},
                                         {5, 0.25F}, {57, 90},    {58, 90}};
  const std::pair<int, int> integers[] = {{70, 2001},
                                          {71, 152},
                                          {72, 15},
                                          {73, 5},
                                          {74, 37},
                                          {75, 500},
                                          {76, s.version},
                                          {85, 1},
                                          {86, 8},
                                          {105, 1},
                                          {79, static_cast<int>(s.values.size())}};
  for (const auto& [i, x] : reals) set_real(static_cast<std::size_t>(i), x);
  for (const auto& [i, x] : integers) set_integer(static_cast<std::size_t>(i), x);
  for (const auto& [i, x] : s.reals) set_real(static_cast<std::size_t>(i), x);
  for (const auto& [i, x] : s.integers) set_integer(static_cast<std::size_t>(i), x);
  for (std::size_t i = 0; i < s.values.size(); ++i) set_real(158 + i, s.values[i]);
  if (s.is_swapped)
    for (auto& word : words) word = __builtin_bswap32(word);
  std::string bytes(4 * words.size(), '\0');
  std::memcpy(bytes.data(), words.data(), bytes.size());
  for (std::size_t i = 0; i < 24; ++i) bytes.replace(440 + 8 * i, 8, "-12345  ");
  bytes.replace(440, 8, "XX01    ");
  bytes.replace(600, 8, fmt::format("{:8}", s.name));
  if (s.version == 7) {
    const double step = 0.02;
    std::string footer(22 * 8, '\0');
    std::memcpy(footer.data(), &step, sizeof step);
    bytes += footer;
  }
  return bytes;
}

}  // namespace gurney::groundmotions
