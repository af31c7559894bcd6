#include "groundmotions/suites/name_pattern.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <vector>

#include "engine/base/units.h"
#include "groundmotions/formats/words.h"

namespace gurney::groundmotions {

namespace {

namespace fs = std::filesystem;

constexpr std::string_view kSeparators = "-_. ";
constexpr std::array<std::string_view, 8> kVerticals = {"UP",  "DWN", "DOWN", "VER",
                                                        "VRT", "UD",  "V",    "Z"};

bool all_digits(std::string_view text) {
  return std::ranges::all_of(text, [](unsigned char c) { return std::isdigit(c); });
}

/// Whether two characters side by side are of one word or one number.
bool touches(unsigned char a, unsigned char b) {
  return (std::isdigit(a) && std::isdigit(b)) || (std::isalpha(a) && std::isalpha(b));
}

/// Three digits, UP and its like are known at the end of a name whatever is before them.
bool is_known_at_end(std::string_view part) {
  return (part.size() == 3 && all_digits(part)) ||
         (part.size() > 1 && std::ranges::find(kVerticals, part) != kVerticals.end());
}

/// Where `part` stands last in `text` with no character of its own kind beside it: no letter beside
/// a letter, no digit beside a digit.
std::size_t find_apart(std::string_view text, std::string_view part) {
  const auto at_byte = [](std::string_view s, std::size_t i) {
    return static_cast<unsigned char>(s[i]);
  };
  for (auto at = text.rfind(part); at != text.npos;
       at = at > 0 ? text.rfind(part, at - 1) : text.npos) {
    const std::size_t end = at + part.size();
    const bool at_end = end == text.size();
    const bool before = at > 0 && touches(at_byte(text, at - 1), at_byte(part, 0));
    const bool after = !at_end && touches(at_byte(text, end), at_byte(part, part.size() - 1));
    const bool may_touch = at > 0 && at_end && is_known_at_end(part);
    if ((!before || may_touch) && !after) return at;
  }
  return text.npos;
}

std::vector<std::string> spellings_of(const Component& component) {
  std::vector<std::string> spellings = {component.name};
  if (component.direction == Direction::kVertical)
    spellings.insert(spellings.end(), kVerticals.begin(), kVerticals.end());
  if (!component.azimuth) return spellings;
  const double degrees = std::round(*component.azimuth / kRadiansPerDegree);
  spellings.push_back(fmt::format("{:03.0f}", degrees));
  if (degrees == 0) spellings.emplace_back("360");
  return spellings;
}

}  // namespace

std::string name_without_component(const std::string& file_name, const std::string& component) {
  std::string plain = upper(component);
  std::erase_if(plain, [](char c) { return c == '-'; });  // "E-W" is "EW" in file names
  if (plain.empty()) return {};
  const std::string extension = fs::path(file_name).extension().string();
  if (upper(extension) == "." + plain)
    return file_name.substr(0, file_name.size() - extension.size()) + "*";
  const std::string stem = file_name.substr(0, file_name.size() - extension.size());
  const std::string padded =
      all_digits(plain) && plain.size() < 3 ? std::string(3 - plain.size(), '0') + plain : plain;
  for (const std::string& text : {padded, plain})
    if (const auto at = find_apart(upper(stem), text); at != std::string::npos) {
      std::size_t begin = at;
      while (begin > 0 && kSeparators.find(stem[begin - 1]) != std::string_view::npos) --begin;
      if (begin == 0) begin = at;
      return stem.substr(0, begin) + "*" + stem.substr(at + text.size()) + extension;
    }
  return {};
}

std::string name_pattern(const std::string& file_name, const Component& component) {
  for (const std::string& spelling : spellings_of(component))
    if (std::string pattern = name_without_component(file_name, spelling); !pattern.empty())
      return pattern;
  return {};
}

std::string name_of_pattern(std::string pattern) {
  const auto star = pattern.find('*');
  if (star != std::string::npos) pattern.erase(star, 1);
  std::string name = fs::path(pattern).stem().string();
  while (!name.empty() && kSeparators.find(name.back()) != std::string_view::npos) name.pop_back();
  return name.empty() ? pattern : name;
}

}  // namespace gurney::groundmotions
