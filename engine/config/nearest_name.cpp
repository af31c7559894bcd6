#include "engine/config/nearest_name.h"

#include <algorithm>
#include <cctype>

namespace gurney::config {

int edit_distance(const std::string& a, const std::string& b) {
  const std::size_t rows = a.size() + 1, columns = b.size() + 1;
  std::vector<int> cost(rows * columns);
  const auto at = [&](std::size_t i, std::size_t j) -> int& { return cost[i * columns + j]; };
  for (std::size_t i = 0; i < rows; ++i) at(i, 0) = static_cast<int>(i);
  for (std::size_t j = 0; j < columns; ++j) at(0, j) = static_cast<int>(j);
  for (std::size_t i = 1; i < rows; ++i)
    for (std::size_t j = 1; j < columns; ++j) {
      const int substitution = a[i - 1] == b[j - 1] ? 0 : 1;
      at(i, j) = std::min({at(i - 1, j) + 1, at(i, j - 1) + 1, at(i - 1, j - 1) + substitution});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
        at(i, j) = std::min(at(i, j), at(i - 2, j - 2) + 1);
    }
  return cost.back();
}

namespace {

std::string in_lower_case(std::string name) {
  for (char& c : name) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return name;
}

/// `PU 125` and `pu_125` are one word.
std::string plain(const std::string& name) {
  std::string letters = in_lower_case(name);
  std::erase_if(letters, [](char c) { return c == '_' || c == '-' || c == ' ' || c == '.'; });
  return letters;
}

/// `mass` for `mass_kg`, `timestep` for `time_step_s`.
bool is_beginning(const std::string& name, const std::string& known) {
  constexpr std::size_t kFewestLetters = 3;
  return name.size() >= kFewestLetters && plain(known).starts_with(plain(name));
}

/// `lead_ruber` for `lead_rubber_hospital`: the beginning, with one letter wrong.
bool is_nearly_beginning(const std::string& name, const std::string& known) {
  constexpr std::size_t kFewestLetters = 6;
  if (name.size() < kFewestLetters) return false;
  for (const std::size_t letters : {name.size() - 1, name.size(), name.size() + 1})
    if (edit_distance(in_lower_case(name), in_lower_case(known.substr(0, letters))) <= 1)
      return true;
  return false;
}

/// `ventilator` for `icu_ventilator`.
bool is_end(const std::string& name, const std::string& known) {
  constexpr std::size_t kFewestLetters = 4;
  return name.size() >= kFewestLetters && in_lower_case(known).ends_with('_' + in_lower_case(name));
}

/// A third of the letters wrong is still a typo; more is another word.
int largest_distance(const std::string& name) {
  const int letters = static_cast<int>(name.size());
  return std::min(std::max(2, letters / 3), letters - 1);
}

/// Order of preference: the word spelt otherwise, the first word of a name (`PGV` for `PGV geomean`),
/// one letter wrong, a forgotten unit, a typo, the beginning of one name only with a typo, the end of
/// one name only: `swivel` is `swivels` and not the beginning of `swivel_lock`.
const std::string* nearest(const std::string& name, const std::vector<std::string>& known) {
  constexpr std::size_t kLongest = 200;  // a file may have keys of megabytes
  if (name.size() > kLongest) return nullptr;
  const auto found = [&](auto is_it) -> const std::string* {
    const auto at = std::ranges::find_if(known, is_it);
    return at == known.end() ? nullptr : &*at;
  };
  const std::string lower = in_lower_case(name);
  const auto distance = [&](const std::string& each) {
    return edit_distance(lower, in_lower_case(each));
  };
  if (const auto* same = found([&](const auto& each) { return plain(each) == plain(name); }))
    return same;
  if (const auto* begun =
          found([&](const auto& each) { return in_lower_case(each).starts_with(lower + ' '); }))
    return begun;
  const std::string& closest = *std::ranges::min_element(known, {}, distance);
  if (distance(closest) <= std::min(1, largest_distance(name))) return &closest;
  if (const auto* longer = found([&](const auto& each) { return is_beginning(name, each); }))
    return longer;
  if (distance(closest) <= largest_distance(name)) return &closest;
  const auto only = [&](auto is_it) {
    return std::ranges::count_if(known, is_it) == 1 ? found(is_it) : nullptr;
  };
  if (const auto* begun = only([&](const auto& each) { return is_nearly_beginning(name, each); }))
    return begun;
  return only([&](const auto& each) { return is_end(name, each); });
}

}  // namespace

std::string suggestion(const std::string& name, const std::vector<std::string>& known) {
  if (known.empty()) return "";
  if (const std::string* near = nearest(name, known)) return "; did you mean '" + *near + "'?";
  std::string list;
  for (const std::string& each : known) list += (list.empty() ? "" : ", ") + each;
  return "; known: " + list;
}

std::string near_name(const std::string& name, const std::vector<std::string>& known) {
  const std::string* near = known.empty() ? nullptr : nearest(name, known);
  return near == nullptr ? "" : "; did you mean '" + *near + "'?";
}

}  // namespace gurney::config
