#include "studies/statistics/two_groups.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "engine/base/append_all.h"
#include "engine/base/random/normal_draw.h"
#include "studies/statistics/fragility.h"
#include "studies/statistics/quantiles.h"
#include "studies/statistics/special.h"

namespace gurney::statistics {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr std::size_t kMaxEnumerated = 20;
constexpr int kSignFlips = 99999;
constexpr double kRounding = 1e-12;  // sums that are equal but for the order of addition

std::map<std::size_t, double> means_of_groups(const std::vector<Measured>& measured) {
  std::map<std::size_t, std::pair<double, int>> sums;
  for (const Measured& m : measured) {
    sums[m.group].first += m.value;
    ++sums[m.group].second;
  }
  std::map<std::size_t, double> means;
  for (const auto& [group, sum] : sums) means[group] = sum.first / sum.second;
  return means;
}

/// Sum of the differences, with the sign of each turned where `turned(i)`.
template <typename Turned>
double signed_sum(const std::vector<double>& differences, const Turned& turned) {
  double sum = 0;
  for (std::size_t i = 0; i < differences.size(); ++i)
    sum += turned(i) ? -differences[i] : differences[i];
  return sum;
}

double sign_flip_test(const std::vector<double>& all, std::uint64_t seed) {
  std::vector<double> differences;
  for (const double d : all)
    if (d != 0) differences.push_back(d);
  double scale = 0;
  for (const double d : differences) scale += std::abs(d);
  const double seen = std::abs(signed_sum(differences, [](std::size_t) { return false; }));
  const auto as_far = [&](double sum) { return std::abs(sum) >= seen - kRounding * scale; };
  if (differences.size() <= kMaxEnumerated) {
    const std::uint64_t assignments = std::uint64_t{1} << differences.size();
    std::uint64_t count = 0;
    for (std::uint64_t signs = 0; signs < assignments; ++signs)
      count += as_far(signed_sum(differences, [&](std::size_t i) { return (signs >> i) & 1; }));
    return static_cast<double>(count) / static_cast<double>(assignments);
  }
  int count = 0;
  for (int flip = 0; flip < kSignFlips; ++flip)
    count += as_far(signed_sum(differences, [&](std::size_t i) {
      return uniform_draw(seed, static_cast<std::uint64_t>(flip), i) < 0.5;
    }));
  return (1.0 + count) / (1.0 + kSignFlips);
}

double best_log_likelihood(const std::vector<Observation>& seen) {
  return fit_probit(StripeTable(seen).stripes()).log_likelihood;
}

double best_log_likelihood(const std::vector<Capacity>& seen) {
  return fit_capacities(seen).log_likelihood;
}

template <class Seen>
double likelihood_ratio(const std::vector<Seen>& a, const std::vector<Seen>& b) {
  std::vector<Seen> both = a;
  append_all(both, b);
  return std::max(
      0.0, 2 * (best_log_likelihood(a) + best_log_likelihood(b) - best_log_likelihood(both)));
}

template <class Seen>
FragilityComparison compare(const std::vector<Seen>& a, const std::vector<Seen>& b, int resamples,
                            std::uint64_t seed) {
  FragilityComparison result;
  result.likelihood_ratio = likelihood_ratio(a, b);
  std::map<std::size_t, int> sides;  // bit 1: in a, bit 2: in b
  for (const Seen& seen : a) sides[seen.group] |= 1;
  for (const Seen& seen : b) sides[seen.group] |= 2;
  for (const auto& [group, side] : sides) result.pairs += side == 3;
  if (result.pairs == 0) return result;
  int as_large = 0;
  for (int i = 0; i < resamples; ++i) {
    std::vector<Seen> swapped_a, swapped_b;
    const auto swapped = [&](const Seen& seen) {
      return sides[seen.group] == 3 &&
             uniform_draw(seed, static_cast<std::uint64_t>(i), seen.group) < 0.5;
    };
    for (const Seen& seen : a) (swapped(seen) ? swapped_b : swapped_a).push_back(seen);
    for (const Seen& seen : b) (swapped(seen) ? swapped_a : swapped_b).push_back(seen);
    as_large += likelihood_ratio(swapped_a, swapped_b) >= result.likelihood_ratio - 1e-9;
  }
  result.p_permutation = (1.0 + as_large) / (1.0 + resamples);
  return result;
}

}  // namespace

double sign_test(int rises, int falls) {
  return std::min(1.0, 2 * binomial_cdf(std::min(rises, falls), rises + falls, 0.5));
}

PairedDifference paired_difference(const std::vector<Measured>& a, const std::vector<Measured>& b,
                                   double confidence, std::uint64_t seed) {
  const auto of_a = means_of_groups(a), of_b = means_of_groups(b);
  std::vector<double> differences, values_a, values_b;
  PairedDifference result;
  for (const auto& [group, value] : of_a) {
    const auto other = of_b.find(group);
    if (other == of_b.end()) continue;
    values_a.push_back(value);
    values_b.push_back(other->second);
    differences.push_back(other->second - value);
    result.rises += other->second > value;
    result.falls += other->second < value;
  }
  result.pairs = static_cast<int>(differences.size());
  result.interval = {-kInfinity, kInfinity};
  if (differences.empty()) return result;
  result.mean_a = moments_of(values_a).mean;
  result.mean_b = moments_of(values_b).mean;
  const Moments moments = moments_of(differences);
  result.difference = moments.mean;
  double size = 0;
  for (const double value : values_a) size = std::max(size, std::abs(value));
  for (const double value : values_b) size = std::max(size, std::abs(value));
  if (result.pairs > 1 && std::sqrt(moments.variance) > kRounding * size) {
    const double reach = student_quantile((1 + confidence) / 2, result.pairs - 1) *
                         std::sqrt(moments.variance / result.pairs);
    result.interval = {moments.mean - reach, moments.mean + reach};
  }
  result.p_permutation = sign_flip_test(differences, seed);
  result.p_sign = sign_test(result.rises, result.falls);
  return result;
}

FragilityComparison compare_fragilities(const std::vector<Observation>& a,
                                        const std::vector<Observation>& b, int resamples,
                                        std::uint64_t seed) {
  return compare(a, b, resamples, seed);
}

FragilityComparison compare_capacities(const std::vector<Capacity>& a,
                                       const std::vector<Capacity>& b, int resamples,
                                       std::uint64_t seed) {
  return compare(a, b, resamples, seed);
}

std::vector<double> holm_adjusted(const std::vector<double>& p_values) {
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < p_values.size(); ++i)
    if (!std::isnan(p_values[i])) order.push_back(i);
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return p_values[a] < p_values[b]; });
  std::vector<double> adjusted = p_values;
  double largest = 0;
  for (std::size_t k = 0; k < order.size(); ++k) {
    const double p = static_cast<double>(order.size() - k) * p_values[order[k]];
    largest = std::min(1.0, std::max(largest, p));
    adjusted[order[k]] = largest;
  }
  return adjusted;
}

}  // namespace gurney::statistics
