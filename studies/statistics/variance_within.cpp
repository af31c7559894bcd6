#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "engine/base/error.h"
#include "engine/base/random/normal_draw.h"
#include "studies/statistics/quantiles.h"
#include "studies/statistics/sensitivity.h"

namespace gurney::statistics {
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
  const auto estimate = share_within(all);
  if (!estimate) return {};
  std::vector<double> resampled;
  for (int r = 0; r < options.resamples; ++r) {
    std::vector<Class> drawn;
    for (std::size_t i = 0; i < all.size(); ++i) {
      const double u = uniform_draw(options.seed, static_cast<std::uint64_t>(r), i);
      drawn.push_back(all[std::min(all.size() - 1,
                                   static_cast<std::size_t>(u * static_cast<double>(all.size())))]);
    }
    if (const auto share = share_within(drawn)) resampled.push_back(*share);
  }
  if (resampled.empty()) return VarianceIndex{*estimate, {0, 1}};
  const double bias = moments_of(resampled).mean - *estimate;
  const auto end = [&](double p) { return quantile_of(resampled, p) - bias; };
  return VarianceIndex::within_0_and_1(
      *estimate, {end((1 - options.confidence) / 2), end((1 + options.confidence) / 2)});
}

}  // namespace gurney::statistics
