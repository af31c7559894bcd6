#include "groundmotions/models/bssa14.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <numbers>
#include <string_view>
#include <vector>

#include "embedded/bssa14_csv.h"
#include "engine/base/csv_row.h"
#include "engine/base/error.h"
#include "engine/base/number_text.h"
#include "engine/base/units.h"

namespace gurney::groundmotions {
namespace {

/// One row of bssa14.csv, in the order of its columns.
struct Coefficients {
  double period, e[7], mh, c1, c2, c3, h, c, vc, f4, f5, r1, r2, dphi_r, dphi_v, phi1, phi2, tau1,
      tau2;
};
constexpr std::size_t kColumns = 25;
static_assert(sizeof(Coefficients) == kColumns * sizeof(double));

constexpr double kMref = 4.5, kRref = 1, kVref = 760, kV1 = 225, kV2 = 300, kF3 = 0.1;

Coefficients row_of(std::string_view line) {
  std::array<double, kColumns> values;
  const std::vector<CsvCell> cells = csv_row(line);
  require(cells.size() == kColumns, fmt::format("bssa14.csv: {}", line));
  for (std::size_t i = 0; i < kColumns; ++i) values[i] = number(cells[i].text).value();
  return std::bit_cast<Coefficients>(values);
}

/// PGV, PGA, then PSA by growing period.
std::vector<Coefficients> read_table(std::string_view text) {
  std::vector<Coefficients> rows;
  while (!text.empty()) {
    const std::string_view line = text.substr(0, text.find('\n'));
    text.remove_prefix(std::min(line.size() + 1, text.size()));
    if (!line.starts_with('#') && !line.starts_with("period_s")) rows.push_back(row_of(line));
  }
  return rows;
}

const std::vector<Coefficients>& table() {
  static const std::vector<Coefficients> rows = read_table(embedded::bssa14_csv);
  return rows;
}

double source_term(const Coefficients& k, const Scenario& s) {
  const double above = s.magnitude - k.mh;
  const double mechanism = k.e[static_cast<std::size_t>(s.faulting)];
  return above <= 0 ? mechanism + k.e[4] * above + k.e[5] * above * above
                    : mechanism + k.e[6] * above;
}

double path_term(const Coefficients& k, const Scenario& s) {
  const double r = std::hypot(s.distance, k.h);
  return (k.c1 + k.c2 * (s.magnitude - kMref)) * std::log(r / kRref) + k.c3 * (r - kRref);
}

/// @param rock_pga  median PGA at V_S30 = 760 m/s [g]
double site_term(const Coefficients& k, double vs30, double rock_pga) {
  const double linear = k.c * std::log(std::min(vs30, k.vc) / kVref);
  const double f2 =
      k.f4 * (std::exp(k.f5 * (std::min(vs30, kVref) - 360)) - std::exp(k.f5 * (kVref - 360)));
  return linear + f2 * std::log((rock_pga + kF3) / kF3);
}

double phi_of(const Coefficients& k, const Scenario& s) {
  double phi = std::lerp(k.phi1, k.phi2, std::clamp(s.magnitude - 4.5, 0., 1.));
  if (s.distance > k.r1)
    phi += k.dphi_r * std::min(1., std::log(s.distance / k.r1) / std::log(k.r2 / k.r1));
  if (s.vs30 < kV2) phi -= k.dphi_v * std::min(1., std::log(kV2 / s.vs30) / std::log(kV2 / kV1));
  return phi;
}

void check(const Scenario& s) {
  require(3 <= s.magnitude && s.magnitude <= 8.5,
          fmt::format("magnitude {:g}: must be from 3 to 8.5", s.magnitude));
  require(0 <= s.distance && s.distance <= 400,
          fmt::format("distance {:g} km: must be from 0 to 400 km", s.distance));
  require(150 <= s.vs30 && s.vs30 <= 1500,
          fmt::format("V_S30 {:g} m/s: must be from 150 to 1500 m/s", s.vs30));
}

/// The median in the unit of the coefficients.
Prediction predicted(const Coefficients& k, const Scenario& s) {
  const Coefficients& pga = table()[1];
  const double rock_pga = std::exp(source_term(pga, s) + path_term(pga, s));
  return {std::exp(source_term(k, s) + path_term(k, s) + site_term(k, s.vs30, rock_pga)),
          std::lerp(k.tau1, k.tau2, std::clamp(s.magnitude - 4.5, 0., 1.)), phi_of(k, s)};
}

using std::numbers::pi;

void check(double period) {
  require(0.01 <= period && period <= 10,
          fmt::format("period {:g} s: correlations are for 0.01 to 10 s", period));
}

}  // namespace

const std::vector<std::string>& faulting_names() {
  static const std::vector<std::string> names = {"unspecified", "strike-slip", "normal", "reverse"};
  return names;
}

Prediction bssa14_sa(const Scenario& scenario, double period) {
  check(scenario);
  const auto first = table().begin() + 2, last = table().end() - 1;
  require(period == 0 || (first->period <= period && period <= last->period),
          fmt::format("period {:g} s: must be 0 or from {:g} to {:g} s", period, first->period,
                      last->period));
  auto next = std::lower_bound(first, last, period,
                               [](const Coefficients& k, double t) { return k.period < t; });
  if (period == 0) next = first - 1;
  Prediction result = predicted(*next, scenario);
  if (next->period > period) {
    const Prediction before = predicted(*(next - 1), scenario);
    const double share =
        std::log(period / (next - 1)->period) / std::log(next->period / (next - 1)->period);
    result = {before.median * std::pow(result.median / before.median, share),
              std::lerp(before.tau, result.tau, share), std::lerp(before.phi, result.phi, share)};
  }
  result.median *= kStandardGravity;
  return result;
}

Prediction bssa14_pgv(const Scenario& scenario) {
  check(scenario);
  constexpr double kCentimetre = 0.01;
  Prediction result = predicted(table()[0], scenario);
  result.median *= kCentimetre;
  return result;
}

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
