#include "studies/verification/family.h"

#include <fmt/format.h>

#include <cmath>

#include "engine/base/append_all.h"
#include "engine/base/error.h"
#include "engine/base/random/draw.h"

namespace gurney::verification {

std::vector<Case> combinations(const std::vector<std::vector<Case>>& lists) {
  std::vector<Case> all{{}};
  for (const std::vector<Case>& list : lists) {
    std::vector<Case> longer;
    for (const Case& begun : all)
      for (const Case& next : list) {
        longer.push_back({begun.name + next.name, begun.values});
        append_all(longer.back().values, next.values);
      }
    all = std::move(longer);
  }
  return all;
}

Case draw_case(const Family& family, std::uint64_t seed) {
  constexpr int kAttempts = 1000;
  for (int attempt = 0; attempt < kAttempts; ++attempt) {
    const Draw draw =
        Draw(seed, static_cast<std::uint64_t>(attempt)).of_part(family.statement.name);
    Case drawn{fmt::format("draw_{}", seed), {}};
    for (const Parameter& p : family.parameters) {
      const double u = draw.probability(p.name);
      drawn.values.push_back(p.whole ? p.low + std::floor(u * (p.high - p.low + 1))
                                     : p.low + u * (p.high - p.low));
    }
    if (family.possible(drawn.values)) return drawn;
  }
  throw Error(fmt::format("{}: {} sets drawn with seed {} and none is possible",
                          family.statement.name, kAttempts, seed));
}

}  // namespace gurney::verification
