#include "engine/base/config/nearest_name.h"

#include <algorithm>

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

std::string without_underscores(std::string name) {
  std::erase(name, '_');
  return name;
}

/// `mass` for `mass_kg`, `timestep` for `time_step_s`.
bool is_beginning(const std::string& name, const std::string& known) {
  constexpr std::size_t kFewestLetters = 3;
  return name.size() >= kFewestLetters &&
         without_underscores(known).rfind(without_underscores(name), 0) == 0;
}

}  // namespace

std::string suggestion(const std::string& name, const std::vector<std::string>& known) {
  if (known.empty()) return "";
  const auto nearest =
      std::min_element(known.begin(), known.end(), [&](const std::string& a, const std::string& b) {
        return edit_distance(name, a) < edit_distance(name, b);
      });
  // A third of the letters wrong is still a typo; more is another word.
  const int limit =
      std::min(std::max(2, static_cast<int>(name.size()) / 3), static_cast<int>(name.size()) - 1);
  for (const std::string& each : known)
    if (is_beginning(name, each)) return "; did you mean '" + each + "'?";
  if (edit_distance(name, *nearest) <= limit) return "; did you mean '" + *nearest + "'?";
  std::string list;
  for (const std::string& each : known) list += (list.empty() ? "" : ", ") + each;
  return "; known: " + list;
}

}  // namespace gurney::config
