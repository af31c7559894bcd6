#include "equipment/catalogue/assumption.h"

#include <algorithm>
#include <cmath>

namespace gurney::equipment {

void add_assumptions(std::vector<Assumption>& list, const std::vector<Assumption>& more) {
  for (const Assumption& candidate : more) {
    const bool known = std::any_of(list.begin(), list.end(), [&](const Assumption& each) {
      return each.file == candidate.file && each.key == candidate.key &&
             each.choice == candidate.choice &&
             (each.value == candidate.value || std::isnan(candidate.value));
    });
    if (!known) list.push_back(candidate);
  }
}

}  // namespace gurney::equipment
