#include "engine/base/random/distribution.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/base/error.h"
#include "engine/base/random/normal_draw.h"

namespace gurney {
namespace {

constexpr double kSumTolerance = 1e-9;  // of probabilities as somebody wrote them

double density(double x) { return std::exp(-x * x / 2) / std::sqrt(2 * std::numbers::pi); }

/// Probability of a standard normal number in [a, b], from the tail that is exact.
double normal_between(double a, double b) {
  return a > -b ? normal_cdf(-a) - normal_cdf(-b) : normal_cdf(b) - normal_cdf(a);
}

std::string bounds_text(double low, double high) {
  if (low == -Distribution::kInfinity && high == Distribution::kInfinity) return "";
  if (low == -Distribution::kInfinity) return fmt::format(", at most {:g}", high);
  if (high == Distribution::kInfinity) return fmt::format(", at least {:g}", low);
  return fmt::format(", within {:g} to {:g}", low, high);
}

bool increasing(const std::vector<double>& numbers) {
  return std::adjacent_find(numbers.begin(), numbers.end(),
                            [](double a, double b) { return !(a < b); }) == numbers.end();
}

/// Probability that a law with points has at, or just below, its point `i`.
template <typename Law>
double share(const Law& law, std::size_t i) {
  return law.cumulative[i] - (i == 0 ? 0 : law.cumulative[i - 1]);
}

void require_bounds(double low, double high) {
  require(low < high, fmt::format("low = {:g} must be below high = {:g}", low, high));
}

}  // namespace

Distribution Distribution::gaussian(Gaussian law, std::string text) {
  const double kept = law.kept();
  require(
      kept >= kLeastKept,
      fmt::format("low and high leave {:.2g} of the distribution ({}): must leave at least {:g}",
                  kept, text, kLeastKept));
  return {law, std::move(text)};
}

Distribution Distribution::normal(double mean, double sd, double low, double high) {
  require(sd > 0, fmt::format("sd = {:g} must be > 0", sd));
  require_bounds(low, high);
  return gaussian({false, mean, sd, low, high, (low - mean) / sd, (high - mean) / sd},
                  fmt::format("normal, mean {:g}, sd {:g}{}", mean, sd, bounds_text(low, high)));
}

Distribution Distribution::lognormal(double median, double beta, double low, double high) {
  require(median > 0, fmt::format("median = {:g} must be > 0", median));
  require(beta > 0, fmt::format("beta = {:g} must be > 0", beta));
  require(low >= 0, fmt::format("low = {:g} must be >= 0", low));
  require_bounds(low, high);
  const double mean = std::log(median);
  return gaussian(
      {true, mean, beta, low, high, (std::log(low) - mean) / beta, (std::log(high) - mean) / beta},
      fmt::format("lognormal, median {:g}, beta {:g}{}", median, beta,
                  bounds_text(low == 0 ? -kInfinity : low, high)));
}

Distribution Distribution::uniform(double low, double high) {
  require_bounds(low, high);
  return {Ramp{{low, high}, {0, 1}}, fmt::format("uniform, {:g} to {:g}", low, high)};
}

Distribution Distribution::discrete(std::vector<double> values, std::vector<double> probabilities) {
  require(!values.empty() && values.size() == probabilities.size(),
          fmt::format("{} values have {} probabilities: must be one for each", values.size(),
                      probabilities.size()));
  std::vector<std::pair<double, double>> pairs;
  double sum = 0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    require(probabilities[i] > 0,
            fmt::format("probabilities[{}] = {:g} must be > 0", i, probabilities[i]));
    sum += probabilities[i];
    pairs.emplace_back(values[i], probabilities[i]);
  }
  require(std::abs(sum - 1) <= kSumTolerance,
          fmt::format("the probabilities sum to {:.10g}: must be 1", sum));
  std::sort(pairs.begin(), pairs.end());
  Steps steps;
  std::string text = "discrete";
  double below = 0;
  for (const auto& [value, probability] : pairs) {
    require(steps.values.empty() || steps.values.back() < value,
            fmt::format("the value {:g} comes twice", value));
    steps.values.push_back(value);
    steps.cumulative.push_back((below += probability) / sum);
    text += fmt::format(", {:g} ({:g})", value, probability);
  }
  steps.cumulative.back() = 1;
  return {steps, text};
}

Distribution Distribution::samples(std::vector<double> values) {
  require(!values.empty(), "there are no samples");
  std::sort(values.begin(), values.end());
  Steps steps;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const double cumulative = static_cast<double>(i + 1) / static_cast<double>(values.size());
    if (!steps.values.empty() && steps.values.back() == values[i]) {
      steps.cumulative.back() = cumulative;
    } else {
      steps.values.push_back(values[i]);
      steps.cumulative.push_back(cumulative);
    }
  }
  return {steps,
          fmt::format("{} samples, {:g} to {:g}", values.size(), values.front(), values.back())};
}

Distribution Distribution::table(std::vector<double> values, std::vector<double> cumulative) {
  require(values.size() == cumulative.size() && values.size() >= 2,
          fmt::format("{} values have {} cumulative probabilities: must be 2 or more of each",
                      values.size(), cumulative.size()));
  require(increasing(values), "the values must increase");
  require(increasing(cumulative) && cumulative.front() == 0 && cumulative.back() == 1,
          "the cumulative probabilities must increase from 0 to 1");
  std::string text =
      fmt::format("table of {} points, {:g} to {:g}", values.size(), values.front(), values.back());
  return {Ramp{std::move(values), std::move(cumulative)}, text};
}

double Distribution::Gaussian::kept() const { return normal_between(a, b); }

double Distribution::Gaussian::mean_value() const {
  if (!logarithmic) return mean + sd * (density(a) - density(b)) / kept();
  // Completing the square moves the bounds by sd.
  return std::exp(mean + sd * sd / 2) * normal_between(a - sd, b - sd) / kept();
}

double Distribution::Gaussian::variance() const {
  if (!logarithmic) {
    const double shift = (density(a) - density(b)) / kept();
    const auto edge = [](double x) { return std::isinf(x) ? 0 : x * density(x); };
    return sd * sd * (1 + (edge(a) - edge(b)) / kept() - shift * shift);
  }
  // E x^2 / (E x)^2 - 1
  const double first = normal_between(a - sd, b - sd) / kept();
  const double second = normal_between(a - 2 * sd, b - 2 * sd) / kept();
  const double growth = std::expm1(sd * sd);
  const double ratio = second / (first * first);
  return std::pow(mean_value(), 2) * (growth * ratio + (ratio - 1));
}

double Distribution::quantile(double p) const {
  if (const auto* law = std::get_if<Gaussian>(&law_)) {
    // From the tail that is exact, as normal_between().
    const double score = law->a > -law->b
                             ? -normal_quantile(normal_cdf(-law->b) + (1 - p) * law->kept())
                             : normal_quantile(normal_cdf(law->a) + p * law->kept());
    const double x = law->mean + law->sd * score;
    return std::clamp(law->logarithmic ? std::exp(x) : x, law->low, law->high);
  }
  if (const auto* law = std::get_if<Steps>(&law_)) {
    const auto at = std::lower_bound(law->cumulative.begin(), law->cumulative.end(), p);
    return law->values[static_cast<std::size_t>(at - law->cumulative.begin())];
  }
  const Ramp& law = std::get<Ramp>(law_);
  const auto at = std::lower_bound(law.cumulative.begin(), law.cumulative.end(), p);
  const std::size_t i = static_cast<std::size_t>(at - law.cumulative.begin());
  const double part = (p - law.cumulative[i - 1]) / share(law, i);
  return std::min(law.values[i - 1] + part * (law.values[i] - law.values[i - 1]), law.values[i]);
}

double Distribution::cdf(double x) const {
  if (x < low()) return 0;
  if (x >= high()) return 1;
  if (const auto* law = std::get_if<Gaussian>(&law_)) {
    const double score = ((law->logarithmic ? std::log(x) : x) - law->mean) / law->sd;
    return normal_between(law->a, score) / law->kept();
  }
  if (const auto* law = std::get_if<Steps>(&law_)) {
    const auto at = std::upper_bound(law->values.begin(), law->values.end(), x);
    return law->cumulative[static_cast<std::size_t>(at - law->values.begin()) - 1];
  }
  const Ramp& law = std::get<Ramp>(law_);
  const auto at = std::upper_bound(law.values.begin(), law.values.end(), x);
  const std::size_t i = static_cast<std::size_t>(at - law.values.begin());
  return law.cumulative[i - 1] +
         (x - law.values[i - 1]) / (law.values[i] - law.values[i - 1]) * share(law, i);
}

double Distribution::mean() const {
  if (const auto* law = std::get_if<Gaussian>(&law_)) return law->mean_value();
  double sum = 0;
  if (const auto* law = std::get_if<Steps>(&law_)) {
    for (std::size_t i = 0; i < law->values.size(); ++i) sum += share(*law, i) * law->values[i];
    return sum;
  }
  const Ramp& law = std::get<Ramp>(law_);
  for (std::size_t i = 1; i < law.values.size(); ++i)
    sum += share(law, i) * (law.values[i - 1] + law.values[i]) / 2;
  return sum;
}

double Distribution::sd() const {
  if (const auto* law = std::get_if<Gaussian>(&law_)) return std::sqrt(law->variance());
  const double middle = mean();
  double sum = 0;
  if (const auto* law = std::get_if<Steps>(&law_)) {
    for (std::size_t i = 0; i < law->values.size(); ++i)
      sum += share(*law, i) * std::pow(law->values[i] - middle, 2);
    return std::sqrt(sum);
  }
  const Ramp& law = std::get<Ramp>(law_);
  for (std::size_t i = 1; i < law.values.size(); ++i) {
    const double u = law.values[i - 1] - middle, v = law.values[i] - middle;
    sum += share(law, i) * (u * u + u * v + v * v) / 3;
  }
  return std::sqrt(sum);
}

double Distribution::low() const {
  if (const auto* law = std::get_if<Gaussian>(&law_)) return law->low;
  if (const auto* law = std::get_if<Steps>(&law_)) return law->values.front();
  return std::get<Ramp>(law_).values.front();
}

double Distribution::high() const {
  if (const auto* law = std::get_if<Gaussian>(&law_)) return law->high;
  if (const auto* law = std::get_if<Steps>(&law_)) return law->values.back();
  return std::get<Ramp>(law_).values.back();
}

bool Distribution::contains(double x) const {
  if (const auto* law = std::get_if<Steps>(&law_))
    return std::binary_search(law->values.begin(), law->values.end(), x);
  return low() <= x && x <= high();
}

const std::vector<double>& Distribution::values() const {
  static const std::vector<double> kNone;
  const auto* law = std::get_if<Steps>(&law_);
  return law == nullptr ? kNone : law->values;
}

}  // namespace gurney
