#include "studies/statistics/sensitivity.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include "engine/base/append_all.h"
#include "engine/base/error.h"
#include "engine/base/random/normal_draw.h"
#include "studies/statistics/quantiles.h"

namespace gurney::statistics {
namespace {

constexpr int kMaxBins = 50;

using Rows = std::vector<std::size_t>;

Rows all_rows(std::size_t n) {
  Rows rows(n);
  std::iota(rows.begin(), rows.end(), 0);
  return rows;
}

Rows drawn_rows(std::size_t n, std::uint64_t seed, int resample) {
  Rows rows(n);
  for (std::size_t i = 0; i < n; ++i)
    rows[i] = drawn_index(uniform_draw(seed, static_cast<std::uint64_t>(resample), i), n);
  return rows;
}

/// Percentiles of resampled estimates, moved so that their mean is the estimate.
VarianceIndex with_interval(double estimate, const std::vector<double>& resampled,
                            double confidence) {
  if (resampled.empty()) return {estimate, {0, 1}};
  const double bias = moments_of(resampled).mean - estimate;
  return VarianceIndex::within_0_and_1(estimate,
                                       {quantile_of(resampled, (1 - confidence) / 2) - bias,
                                        quantile_of(resampled, (1 + confidence) / 2) - bias});
}

/// An index of all rows, with the interval of those drawn with replacement; none where the rows have
/// no estimate.
template <class Estimate>
std::optional<VarianceIndex> index_of(std::size_t rows, const SensitivityOptions& options,
                                      Estimate estimate_of) {
  const std::optional<double> estimate = estimate_of(all_rows(rows));
  if (!estimate) return {};
  std::vector<double> resampled;
  for (int i = 0; i < options.resamples; ++i)
    if (const auto drawn = estimate_of(drawn_rows(rows, options.seed, i)))
      resampled.push_back(*drawn);
  return with_interval(*estimate, resampled, options.confidence);
}

/// Kelley's epsilon squared of some rows; none if y does not vary there.
std::optional<double> share_between(const std::vector<std::size_t>& classes, std::size_t most,
                                    const std::vector<double>& y, const Rows& rows) {
  std::vector<double> count(most, 0), sum(most, 0);
  double total = 0;
  for (const std::size_t i : rows) {
    count[classes[i]] += 1;
    sum[classes[i]] += y[i];
    total += y[i];
  }
  const double n = static_cast<double>(rows.size()), mean = total / n;
  double within = 0, all = 0;
  for (const std::size_t i : rows) {
    within += std::pow(y[i] - sum[classes[i]] / count[classes[i]], 2);
    all += std::pow(y[i] - mean, 2);
  }
  const double m = static_cast<double>(
      std::count_if(count.begin(), count.end(), [](double c) { return c > 0; }));
  if (!(all > 0) || !(n > m)) return {};
  return 1 - (n - 1) / (n - m) * within / all;
}

struct Terms {
  double first, total;
};

Terms sobol_terms(const std::vector<double>& a, const std::vector<double>& b,
                  const std::vector<double>& ab, const Rows& rows) {
  double mean = 0, squares = 0, first = 0, total = 0;
  const double n = static_cast<double>(rows.size());
  for (const std::size_t i : rows) mean += (a[i] + b[i]) / (2 * n);
  for (const std::size_t i : rows) {
    squares += (std::pow(a[i] - mean, 2) + std::pow(b[i] - mean, 2)) / (2 * n);
    first += (b[i] - mean) * (ab[i] - a[i]) / n;
    total += std::pow(a[i] - ab[i], 2) / (2 * n);
  }
  return {first / squares, total / squares};
}

}  // namespace

VarianceIndex VarianceIndex::within_0_and_1(double estimate, const Interval& interval) {
  const auto share = [](double value) { return std::clamp(value, 0.0, 1.0); };
  const double index = share(estimate);
  return {index, {std::min(share(interval.low), index), std::max(share(interval.high), index)}};
}

void sort_by_swing(std::vector<TornadoBar>& bars) {
  std::sort(bars.begin(), bars.end(), [](const TornadoBar& a, const TornadoBar& b) {
    const double x = std::abs(a.swing()), y = std::abs(b.swing());
    return x > y || (x == y && a.input < b.input);
  });
}

std::vector<TornadoBar> tornado(const std::vector<std::vector<double>>& inputs,
                                const std::vector<double>& output, double share) {
  const double n = static_cast<double>(output.size());
  require(share > 0 && share <= 0.5, fmt::format("share = {:g} must be in (0, 0.5]", share));
  require(share * n >= 2, fmt::format("a share {:g} of {} runs is less than 2", share, n));
  std::vector<TornadoBar> bars;
  for (std::size_t input = 0; input < inputs.size(); ++input) {
    require(inputs[input].size() == output.size(),
            fmt::format("input {} has {} values for {} runs", input, inputs[input].size(), n));
    const double low = quantile_of(inputs[input], share);
    const double high = quantile_of(inputs[input], 1 - share);
    std::vector<double> at_low, at_high;
    for (std::size_t i = 0; i < output.size(); ++i) {
      if (inputs[input][i] <= low) at_low.push_back(output[i]);
      if (inputs[input][i] >= high) at_high.push_back(output[i]);
    }
    const Moments below = moments_of(at_low), above = moments_of(at_high);
    bars.push_back({input, below.mean, above.mean,
                    std::sqrt(below.variance / static_cast<double>(at_low.size())),
                    std::sqrt(above.variance / static_cast<double>(at_high.size())), at_low.size(),
                    at_high.size()});
  }
  sort_by_swing(bars);
  return bars;
}

std::optional<VarianceIndex> first_order_index(const std::vector<double>& x,
                                               const std::vector<double>& y,
                                               const SensitivityOptions& options) {
  const double n = static_cast<double>(y.size());
  const int bins = options.bins > 0
                       ? options.bins
                       : std::min(kMaxBins, static_cast<int>(std::lround(std::sqrt(n))));
  std::vector<std::size_t> classes;
  for (const double rank : ranks_of(x))
    classes.push_back(static_cast<std::size_t>((rank - 0.5) / n * bins));
  return first_order_index_of_classes(classes, y, options);
}

std::optional<VarianceIndex> first_order_index_of_classes(const std::vector<std::size_t>& classes,
                                                          const std::vector<double>& y,
                                                          const SensitivityOptions& options) {
  require(classes.size() == y.size(),
          fmt::format("{} inputs have {} outputs: must be one for each", classes.size(), y.size()));
  std::map<std::size_t, std::size_t> number;
  for (const std::size_t c : classes) number.emplace(c, number.size());
  std::vector<std::size_t> numbered;
  for (const std::size_t c : classes) numbered.push_back(number[c]);
  if (y.empty() || y.size() < 2 * number.size()) return {};
  return index_of(y.size(), options, [&](const Rows& rows) {
    return share_between(numbered, number.size(), y, rows);
  });
}

std::vector<SobolIndices> sobol_indices(const std::vector<double>& a, const std::vector<double>& b,
                                        const std::vector<std::vector<double>>& ab,
                                        const SensitivityOptions& options) {
  require(a.size() >= 2 && a.size() == b.size(),
          fmt::format("A has {} runs and B {}: must be 2 or more of each", a.size(), b.size()));
  for (std::size_t i = 0; i < ab.size(); ++i)
    require(ab[i].size() == a.size(),
            fmt::format("AB[{}] has {} runs: must be {}", i, ab[i].size(), a.size()));
  std::vector<double> both = a;
  append_all(both, b);
  if (!(moments_of(both).variance > 0)) return {};
  std::vector<SobolIndices> indices;
  for (const std::vector<double>& column : ab) {
    const Terms estimate = sobol_terms(a, b, column, all_rows(a.size()));
    std::vector<double> first, total;
    for (int i = 0; i < options.resamples; ++i) {
      const Terms drawn = sobol_terms(a, b, column, drawn_rows(a.size(), options.seed, i));
      if (!std::isfinite(drawn.first) || !std::isfinite(drawn.total)) continue;
      first.push_back(drawn.first);
      total.push_back(drawn.total);
    }
    indices.push_back({with_interval(estimate.first, first, options.confidence),
                       with_interval(estimate.total, total, options.confidence)});
  }
  return indices;
}

namespace {

struct Class {
  double count = 0, mean = 0, squares = 0;  ///< squares: about the mean
};

std::vector<Class> classes_of(const std::vector<std::size_t>& classes,
                              const std::vector<double>& y) {
  std::map<std::size_t, Class> all;
  for (std::size_t i = 0; i < y.size(); ++i) {
    Class& of = all[classes[i]];
    of.count += 1;
    const double away = y[i] - of.mean;
    of.mean += away / of.count;
    of.squares += away * (y[i] - of.mean);
  }
  std::vector<Class> listed;
  for (const auto& [number, of] : all) listed.push_back(of);
  return listed;
}

std::optional<double> share_within(const std::vector<Class>& classes) {
  double n = 0, sum = 0, count_squares = 0, within = 0, between = 0;
  for (const Class& of : classes) {
    n += of.count;
    sum += of.count * of.mean;
    count_squares += of.count * of.count;
    within += of.squares;
  }
  const double m = static_cast<double>(classes.size());
  if (m < 2 || !(n > m)) return {};
  for (const Class& of : classes) between += of.count * std::pow(of.mean - sum / n, 2);
  const double ms_within = within / (n - m), ms_between = between / (m - 1);
  const double n0 = (n - count_squares / n) / (m - 1);
  const double total = ms_within + (ms_between - ms_within) / n0;
  if (!(total > 0)) return {};
  return ms_within / total;
}

}  // namespace

std::optional<VarianceIndex> share_within_classes(const std::vector<std::size_t>& classes,
                                                  const std::vector<double>& y,
                                                  const SensitivityOptions& options) {
  require(
      classes.size() == y.size(),
      fmt::format("{} classes have {} outputs: must be one for each", classes.size(), y.size()));
  const std::vector<Class> all = classes_of(classes, y);
  return index_of(all.size(), options, [&](const Rows& rows) {
    std::vector<Class> drawn;
    for (const std::size_t i : rows) drawn.push_back(all[i]);
    return share_within(drawn);
  });
}

}  // namespace gurney::statistics
