#pragma once

#include <limits>
#include <string>
#include <variant>
#include <vector>

namespace gurney {

/// The distribution of one number (docs/theory/uncertainty.md). Every kind is given by its quantile
/// function, so that one uniform number makes one value.
class Distribution {
 public:
  static constexpr double kInfinity = std::numeric_limits<double>::infinity();

  /// Least probability that a distribution must have between its bounds.
  static constexpr double kLeastKept = 1e-6;

  /// Truncated to [low, high].
  /// @throws Error unless sd > 0, low < high and kLeastKept holds.
  static Distribution normal(double mean, double sd, double low = -kInfinity,
                             double high = kInfinity);

  /// ln x is normal with mean ln(median) and standard deviation beta; truncated to [low, high].
  /// @throws Error unless median > 0, beta > 0, 0 <= low < high and kLeastKept holds.
  static Distribution lognormal(double median, double beta, double low = 0,
                                double high = kInfinity);

  /// @throws Error unless low < high.
  static Distribution uniform(double low, double high);

  /// @throws Error unless there is a probability > 0 for each value, their sum is 1 to 1e-9 and no
  /// value comes twice.
  static Distribution discrete(std::vector<double> values, std::vector<double> probabilities);

  /// Each of the samples with equal probability; the same sample may come more than once.
  /// @throws Error unless there is one or more.
  static Distribution samples(std::vector<double> values);

  /// The distribution function is linear between the points (value, cumulative probability).
  /// @throws Error unless both increase, from 0 to 1.
  static Distribution table(std::vector<double> values, std::vector<double> cumulative);

  /// Smallest x with cdf(x) >= p; within [low(), high()]. Never falls with p.
  /// @param p  in (0, 1)
  double quantile(double p) const;
  double cdf(double x) const;  ///< probability of a number <= x
  double mean() const;
  double sd() const;
  double low() const;                                ///< of the support; may be -inf
  double high() const;                               ///< may be +inf
  bool contains(double x) const;                     ///< x is in the support
  const std::vector<double>& values() const;         ///< of a discrete one, increasing; else empty
  const std::string& text() const { return text_; }  ///< `lognormal, median 30, beta 0.1`

 private:
  /// x = s or exp(s), with s normal and truncated at (s - mean) / sd = a and b.
  struct Gaussian {
    bool logarithmic;
    double mean, sd, low, high, a, b;

    double kept() const;  ///< probability between a and b
    double mean_value() const;
    double variance() const;
  };
  struct Steps {
    std::vector<double> values, cumulative;
  };
  struct Ramp {
    std::vector<double> values, cumulative;
  };

  using Law = std::variant<Gaussian, Steps, Ramp>;
  Distribution(Law law, std::string text) : law_(std::move(law)), text_(std::move(text)) {}
  static Distribution gaussian(Gaussian law, std::string text);

  Law law_;
  std::string text_;
};

}  // namespace gurney
