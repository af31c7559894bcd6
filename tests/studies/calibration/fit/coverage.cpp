#include "tests/studies/calibration/fit/coverage.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "engine/base/random/normal_draw.h"
#include "studies/statistics/special.h"

namespace gurney::calibration {

statistics::Interval acceptance(double probability, int repeats) {
  int low = 0, high = repeats;
  while (statistics::binomial_cdf(low, repeats, probability) < 0.0005) ++low;
  while (1 - statistics::binomial_cdf(high - 1, repeats, probability) < 0.0005) --high;
  return {static_cast<double>(low), static_cast<double>(high)};
}

std::vector<double> scattered(double median, double scatter, int size, int variable) {
  std::vector<std::pair<double, double>> order;
  for (int i = 0; i < size; ++i)
    order.emplace_back(variable == 0 ? i
                                     : uniform_draw(static_cast<std::uint64_t>(variable), 7,
                                                    static_cast<std::uint64_t>(i)),
                       median * std::exp(scatter * normal_quantile((i + 0.5) / size)));
  std::ranges::sort(order);
  std::vector<double> values;
  for (const auto& [place, value] : order) values.push_back(value);
  return values;
}

std::vector<TrialValue> read_all(const std::vector<Trial>& trials, int noises,
                                 const std::function<TrialValue(const Trial&)>& value) {
  std::vector<TrialValue> values;
  for (std::size_t i = 0; i < trials.size(); ++i)
    for (int k = 0; k < noises; ++k) {
      values.push_back(value(with_noise(trials[i], i + 1, static_cast<std::uint64_t>(k))));
    }
  return values;
}

Coverage coverage(const std::vector<TrialValue>& values, double truth, int trials) {
  Coverage result;
  for (int repeat = 0; repeat < kRepeats; ++repeat) {
    const auto drawn = [&](int i) {
      return values[static_cast<std::size_t>(
          static_cast<double>(values.size()) *
          uniform_draw(static_cast<std::uint64_t>(repeat), 100, static_cast<std::uint64_t>(i)))];
    };
    std::vector<TrialValue> laboratory;
    for (int i = 0; i < trials; ++i) laboratory.push_back(drawn(i));
    const Constant constant = constants_of(laboratory).at(0);
    result.interval += constant.interval.contains(truth);
    result.prediction += constant.prediction.contains(drawn(trials).value);
    result.bias += std::log(constant.value / truth) / kRepeats;
    result.width += (constant.interval.high / constant.interval.low - 1) / 2 / kRepeats;
  }
  return result;
}

}  // namespace gurney::calibration
