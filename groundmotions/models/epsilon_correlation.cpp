#include "groundmotions/models/epsilon_correlation.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/base/error.h"

namespace gurney::groundmotions {

namespace {

using std::numbers::pi;

void check(double period) {
  require(0.01 <= period && period <= 10,
          fmt::format("period {:g} s: correlations are for 0.01 to 10 s", period));
}

}  // namespace

double epsilon_correlation(double a, double b) {
  check(a);
  check(b);
  constexpr double kShort = 0.109;  // [s]
  const double low = std::min(a, b), high = std::max(a, b);
  const double c1 = 1 - std::cos(pi / 2 - 0.366 * std::log(high / std::max(low, kShort)));
  const double c2 = high < 0.2 ? 1 - 0.105 * (1 - 1 / (1 + std::exp(100 * high - 5))) *
                                         (high - low) / (high - 0.0099)
                               : 0;
  const double c3 = high < kShort ? c2 : c1;
  const double c4 = c1 + 0.5 * (std::sqrt(c3) - c3) * (1 + std::cos(pi * low / kShort));
  if (high < kShort) return c2;
  if (low > kShort) return c1;
  return high < 0.2 ? std::min(c2, c4) : c4;
}

double pgv_correlation(double period) {
  check(period);
  struct Range {
    double end, a, b, c, d;
  };
  constexpr Range kRanges[] = {{0.1, 0.73, 0.54, 0.045, 1.8},
                               {0.75, 0.54, 0.81, 0.28, 1.5},
                               {2.5, 0.80, 0.76, 1.1, 3.0},
                               {10, 0.76, 0.70, 5.0, 3.2}};
  const Range& r = *std::ranges::lower_bound(kRanges, period, {}, &Range::end);
  return (r.a + r.b) / 2 - (r.a - r.b) / 2 * std::tanh(r.d * std::log(period / r.c));
}

}  // namespace gurney::groundmotions
