#include "groundmotions/assembly/record_name.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

#include "groundmotions/formats/numbers.h"

namespace gurney::groundmotions {

namespace {

constexpr std::size_t kFewestLetters = 3;

bool is_digit(char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; }

std::size_t common_size(const std::vector<std::string>& stems) {
  std::size_t size = stems[0].size();
  for (const std::string& stem : stems)
    size = std::min(size, static_cast<std::size_t>(std::ranges::mismatch(stems[0], stem).in1 -
                                                   stems[0].begin()));
  return size;
}

/// Whether all stems that go on with a digit have three digits of an azimuth from `at` on.
bool azimuths_follow(const std::vector<std::string>& stems, std::size_t at) {
  std::size_t azimuths = 0;
  for (const std::string& stem : stems) {
    std::size_t end = at;
    while (end < stem.size() && is_digit(stem[end])) ++end;
    if (end == at) continue;
    if (end != at + 3 || number(stem.substr(at, 3)).value_or(999) > 360) return false;
    ++azimuths;
  }
  return azimuths > 1;
}

/// The first digits of azimuths are no part of the name: 000 and 090 begin alike.
std::size_t before_azimuths(const std::vector<std::string>& stems, std::size_t size) {
  for (std::size_t back = 0; back < 3 && back <= size; ++back) {
    if (azimuths_follow(stems, size - back)) return size - back;
    if (back < size && !is_digit(stems[0][size - back - 1])) break;
  }
  return size;
}

bool is_blank_part(char c) { return std::string_view("-_. ").find(c) != std::string_view::npos; }

}  // namespace

std::string common_name(const std::vector<std::string>& stems) {
  if (std::ranges::all_of(stems, [&](const auto& stem) { return stem == stems[0]; }))
    return stems[0];
  std::size_t size = before_azimuths(stems, common_size(stems));
  while (size > 0 && is_blank_part(stems[0][size - 1])) --size;
  return size < kFewestLetters ? fmt::format("{}", fmt::join(stems, " + "))
                               : stems[0].substr(0, size);
}

}  // namespace gurney::groundmotions
