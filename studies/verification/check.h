#pragma once

#include <cmath>
#include <string>
#include <vector>

/// What the engine computes, held against what is known otherwise (docs/verification.md). How to add a
/// closed form: docs/contributing.md. The tests run the same list (tests/verification/cases_test.cpp).
namespace gurney::verification {

/// A computed number against its reference.
struct Check {
  std::string quantity;
  std::string unit;  ///< empty: a pure number
  double computed = 0, reference = 0;
  double tolerance = 0;    ///< of the difference, >= 0
  std::string derivation;  ///< how the tolerance follows from the parameters
  std::string where = {};  ///< of a Track: the instant, `0.04 s`

  double error() const { return computed - reference; }
  bool passed() const { return std::abs(error()) <= tolerance; }  ///< false for NaN
  double used() const;  ///< |error| over tolerance; 0 where both are 0
};

/// A quantity through time, or over something else, for the figure.
struct Series {
  std::string quantity, unit;
  std::string axis;  ///< of `at`, with its unit
  std::vector<double> at, computed, reference;
};

/// What running a case finds.
struct Findings {
  std::vector<Check> checks;
  std::vector<Series> series;

  bool passed() const;         ///< there are checks and all of them passed
  const Check& worst() const;  ///< the one that used most of its tolerance; there must be one
};

/// Compares a quantity all through a run. Its check is the instant that uses most of the tolerance.
class Track {
 public:
  Track(std::string quantity, std::string unit, std::string derivation,
        std::string axis = "time [s]");
  void add(double at, double computed, double reference, double tolerance);
  void report(Findings& findings) const;  ///< adds the check and the series

 private:
  Check worst_;
  double worst_at_ = 0;
  Series series_;
};

/// The level at which a test begins to hold: bisection between `low`, where it must not hold, and
/// `high`, where it must, until the bracket is `width` wide.
/// @returns the middle of the last bracket; `low` or `high` if the test holds there otherwise
template <class Test>
double locate(double low, double high, double width, Test test) {
  if (test(low)) return low;
  if (!test(high)) return high;
  while (high - low > width) {
    const double middle = (low + high) / 2;
    (test(middle) ? high : low) = middle;
  }
  return (low + high) / 2;
}

}  // namespace gurney::verification
