#include "studies/hospital/outcomes.h"

#include <fmt/format.h>

#include <algorithm>

#include "engine/base/error.h"
#include "engine/base/names.h"

namespace gurney::study {

std::vector<std::string> state_names(const Consequences& consequences,
                                     const std::vector<std::string>& others,
                                     const std::string& path) {
  std::vector<std::string> names = names_of(consequences.limit_states());
  for (const std::string& name : others)
    if (std::ranges::find(names, name) == names.end()) names.push_back(name);
  require(names.size() <= kMostStates,
          fmt::format("{}: {} limit states; at most {}", path, names.size(), kMostStates));
  return names;
}

}  // namespace gurney::study
