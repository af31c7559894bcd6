#pragma once

#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "engine/base/units.h"
#include "engine/run/run.h"

namespace gurney {

/// Gravity of every case that does not state its own [m/s2].
inline constexpr double kG = kStandardGravity;

}  // namespace gurney

/// Comparison of the engine with a known solution (docs/verification.md). How to add a
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

/// Findings of a case.
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

/// The reference of a check and its tolerance, with how this follows from the parameters.
struct Expected {
  double reference, tolerance;
  std::string derivation;
};
inline Expected near_to(double reference, double tolerance, std::string derivation) {
  return {reference, tolerance, std::move(derivation)};
}
inline Expected exactly(double reference, std::string derivation) {
  return {reference, 0, std::move(derivation)};
}

/// Runs the scenes of a case with one solver and keeps what is found.
class Runner {
 public:
  explicit Runner(Solver solver = Solver::kImplicit) : solver_(solver) {}

  /// run() with this solver. A run that diverges, or steps of our solver that do not converge,
  /// are checks that fail.
  Response operator()(const Scene& scene, const FloorMotion& floor,
                      const SimulationSettings& settings);

  /// Both parts of it, for runs of which not all is asked.
  Response unjudged(const Scene& scene, const FloorMotion& floor,
                    const SimulationSettings& settings) const;
  void judge(const Response& response);

  /// Compares a number: `runner.check("distance", "m", way, near_to(2, 0.1, "a dt^2"))`.
  template <class Number>
  void check(const std::string& quantity, const std::string& unit, Number computed,
             const Expected& expected) {
    findings.checks.push_back({quantity, unit, static_cast<double>(computed), expected.reference,
                               expected.tolerance, expected.derivation});
  }

  template <class... Tracks>
  void report(const Tracks&... tracks) {
    (tracks.report(findings), ...);
  }

  /// Stock Bullet knows no fixtures (engine/baselines/stock_baseline.h): a case leaves them out.
  bool stock() const { return solver_ != Solver::kImplicit; }

  Findings findings;

 private:
  Solver solver_;
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
