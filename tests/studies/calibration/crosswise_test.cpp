#include "studies/calibration/crosswise.h"

#include <gmock/gmock.h>

#include <cmath>

#include "engine/base/units.h"
#include "tests/studies/calibration/virtual_pulls.h"

namespace gurney {
namespace {

using testing::HasSubstr;

Trial crosswise(double width, double resistance) {
  VirtualPull pull;
  pull.patch_width = width;
  pull.resistance = resistance;
  pull.heading = 90 * kRadiansPerDegree;
  pull.drop_mass = 8;
  return virtual_pull(pull);
}

// The trial has a weight on a cable and steps of its own; the fit has only the force that the load
// cell tells. The intervals are those of the residuals.
TEST(Crosswise, FindsWhatTheTrialWasMadeWith) {
  for (const double width : {0.004, 0.012}) {
    SCOPED_TRACE(width);
    TrialFault fault;
    const auto fit = fit_crosswise(with_noise(crosswise(width, 0.018), 1, 0), fault);
    ASSERT_TRUE(fit) << fault.text();
    std::printf(
        "w %.5f (%.5f) Cr/R %.5f +- %.5f, torque %.6f +- %.6f shift %.4f misfit %.6f corr %.2f\n",
        fit->patch_width, width, fit->resistance, fit->resistance_error, fit->torque_length,
        fit->torque_length_error, fit->shift, fit->misfit, fit->correlation);
    EXPECT_NEAR(fit->patch_width, width, 0.05 * width);
    EXPECT_NEAR(fit->resistance, 0.018, 0.01 * 0.018);
  }
}

}  // namespace
}  // namespace gurney
