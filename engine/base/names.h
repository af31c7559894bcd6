#pragma once

#include <ranges>
#include <string>
#include <vector>

namespace gurney {

/// The member `name` of each, in their order.
template <std::ranges::input_range Named>
std::vector<std::string> names_of(const Named& list) {
  std::vector<std::string> names;
  for (const auto& each : list) names.emplace_back(each.name);
  return names;
}

}  // namespace gurney
