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

Track::Track(std::string quantity, std::string unit, std::string derivation, std::string axis)
    : worst_{quantity, unit, 0, 0, 0, std::move(derivation), {}},
      series_{quantity, unit, std::move(axis), {}, {}, {}} {}

void Track::add(double at, double computed, double reference, double tolerance) {
  Check now = worst_;
  now.computed = computed;
  now.reference = reference;
  now.tolerance = tolerance;
  if (series_.at.empty() || now.used() > worst_.used()) {
    worst_ = now;
    worst_at_ = at;
  }
  series_.at.push_back(at);
  series_.computed.push_back(computed);
  series_.reference.push_back(reference);
}

void Track::report(Findings& findings) const {
  Check check = worst_;
  const std::size_t bracket = series_.axis.find('[');
  const std::string unit = series_.axis.substr(bracket + 1, series_.axis.find(']') - bracket - 1);
  check.where = fmt::format("{:.4g} {}", worst_at_, unit);
  if (series_.at.empty()) check.computed = std::numeric_limits<double>::quiet_NaN();
  findings.checks.push_back(check);
  findings.series.push_back(series_);
}

Response Runner::unjudged(const Scene& scene, const FloorMotion& floor,
                          const SimulationSettings& settings) const {
  return gurney::run(scene, floor, {settings, solver_});
}

void Runner::judge(const Response& response) {
  if (is_failure(response.outcome)) check("runs that failed", "", 1, exactly(0, response.cause));
  if (const auto steps = response.quality.unconverged_steps; steps > 0)
    check("steps that did not converge", "", steps,
          exactly(0, "every step must reach its residual"));
}

Response Runner::operator()(const Scene& scene, const FloorMotion& floor,
                            const SimulationSettings& settings) {
  Response response = unjudged(scene, floor, settings);
  judge(response);
  return response;
}

}  // namespace gurney::verification
