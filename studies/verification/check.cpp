#include "studies/verification/check.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

namespace gurney::verification {

double Check::used() const {
  if (passed() && tolerance == 0) return 0;
  const double share = std::abs(error()) / tolerance;
  return std::isnan(share) ? std::numeric_limits<double>::infinity() : share;
}

bool Findings::passed() const {
  return !checks.empty() && std::ranges::all_of(checks, &Check::passed);
}

const Check& Findings::worst() const { return *std::ranges::max_element(checks, {}, &Check::used); }

Track::Track(std::string quantity, std::string unit, std::string derivation)
    : worst_{quantity, unit, 0, 0, 0, std::move(derivation)}, series_{quantity, unit, {}, {}, {}} {}

void Track::add(double time, double computed, double reference, double tolerance) {
  Check now = worst_;
  now.computed = computed;
  now.reference = reference;
  now.tolerance = tolerance;
  if (series_.time.empty() || now.used() > worst_.used()) {
    worst_ = now;
    worst_time_ = time;
  }
  series_.time.push_back(time);
  series_.computed.push_back(computed);
  series_.reference.push_back(reference);
}

void Track::report(Findings& findings) const {
  Check check = worst_;
  check.quantity +=
      series_.time.empty() ? ", never compared" : fmt::format(", worst at {:.4g} s", worst_time_);
  if (series_.time.empty()) check.computed = std::numeric_limits<double>::quiet_NaN();
  findings.checks.push_back(check);
  findings.series.push_back(series_);
}

}  // namespace gurney::verification
