#include "studies/verification/runner.h"

namespace gurney::verification {

Response Runner::operator()(Findings& findings, const Scene& scene, const FloorMotion& floor,
                            const SimulationSettings& settings) const {
  Response response = gurney::run(scene, floor, {settings, solver_});
  if (is_failure(response.outcome))
    findings.checks.push_back({"runs that failed", "", 1, 0, 0, response.cause});
  if (const auto steps = static_cast<double>(response.quality.unconverged_steps); steps > 0)
    findings.checks.push_back(
        {"steps that did not converge", "", steps, 0, 0, "every step must reach its residual"});
  return response;
}

}  // namespace gurney::verification
