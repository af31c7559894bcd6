#include "studies/limit_states/limit_state.h"

#include <algorithm>
#include <cmath>

namespace gurney::study {
namespace {

/// Of a limit that is converted to SI: two roundings, of the factor and of the product, are 2^-52
/// each; 4 times that for decimal fractions that are not exact.
constexpr double kRounding = 1e-15;

}  // namespace

bool exceeded(const std::vector<LimitState>& states, std::size_t index, const Values& values) {
  const LimitState& state = states[index];
  const auto part = [&](std::size_t i) { return exceeded(states, i, values); };
  const auto enough = [&](const auto& list, auto passes) {
    return std::ranges::count_if(list, passes) >= state.at_least;
  };
  switch (state.kind) {
    case LimitState::Kind::kAny:
      return enough(state.parts, part);
    case LimitState::Kind::kAll:
      return std::ranges::all_of(state.parts, part);
    case LimitState::Kind::kAbove:
      return enough(values(state.quantity), [&](double value) { return value > state.limit; });
    case LimitState::Kind::kBelow:
      return enough(values(state.quantity), [&](double value) { return value < state.limit; });
  }
  return false;
}

bool same_state(const std::vector<LimitState>& a, std::size_t i, const std::vector<LimitState>& b,
                std::size_t j) {
  if (a[i].kind != b[j].kind || a[i].quantity != b[j].quantity || a[i].at_least != b[j].at_least ||
      a[i].parts.size() != b[j].parts.size() ||
      std::abs(a[i].limit - b[j].limit) > kRounding * std::abs(a[i].limit))
    return false;
  for (std::size_t k = 0; k < a[i].parts.size(); ++k)
    if (!same_state(a, a[i].parts[k], b, b[j].parts[k])) return false;
  return true;
}

std::vector<LimitState> default_limit_states() {
  const auto above = [](const char* name, const char* column, double limit, const char* words,
                        const char* origin) {
    return LimitState{
        name, LimitState::Kind::kAbove, {Quantity::Of::kItem, column, "", ""}, limit, words, origin,
        {}};
  };
  return {above("moved", "residual_displacement", 0.02, "residual_displacement > 0.02 m",
                "damage state of Costa et al. as cited by Shang et al."),
          above("rolled", "peak_displacement", 0.3, "peak_displacement > 0.3 m",
                "assumption, 0.2 to 1 m: reach of tubes and cables"),
          above("hit", "largest_approach_speed", 0.4, "largest_approach_speed > 0.4 m/s",
                "assumption, 0.2 to 0.8 m/s: handling speeds of the threshold test of IEC 60601-1"),
          above("overturned", "time_of_overturning", -0.5, "overturned", "")};
}

}  // namespace gurney::study
