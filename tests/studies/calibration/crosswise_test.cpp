#include "studies/calibration/crosswise.h"

#include <gmock/gmock.h>

#include "engine/base/units.h"
#include "tests/studies/calibration/virtual_pulls.h"

namespace gurney {
namespace {

using testing::HasSubstr;

Trial crosswise(double width, double heading_deg) {
  VirtualPull pull;
  pull.patch_width = width;
  pull.resistance = 0.018;
  pull.heading = heading_deg * kRadiansPerDegree;
  pull.drop_mass = 8;
  return with_noise(virtual_pull(pull), 1, 0);
}

// The trial has a weight on a cable, blocks elsewhere and a start of its own; the fit has only the
// force that the load cell tells. What that costs is stated in docs/calibration.md, from three
// draws of the noise and two loads: up to 0.5 % of the torque of w = 12 mm, 6 % of that of 4 mm,
// 0.02 % of Cr / R. Each tolerance is twice that. The base's w is 8 mm.
TEST(Crosswise, FindsWhatTheTrialWasMadeWith) {
  const std::pair<double, double> cases[] = {{0.012, 0.01}, {0.004, 0.12}};
  for (const auto& [width, tolerance] : cases) {
    SCOPED_TRACE(width);
    TrialFault fault;
    const auto fit = fit_crosswise(crosswise(width, 90), fault);
    ASSERT_TRUE(fit) << fault.text();
    const double truth = 0.6 * width / 4 + 0.03 / fit->load;  // mu, w and T of R100
    EXPECT_NEAR(fit->torque_length, truth, tolerance * truth);
    EXPECT_NEAR(fit->friction_times_width / 4, 0.6 * width / 4, tolerance * truth);
    EXPECT_NEAR(fit->resistance, 0.018, 4e-4 * 0.018);
    EXPECT_LT(fit->misfit, 2 * kDisplacementNoise);
    EXPECT_EQ(fit->trial, "virtual");
  }
}

TEST(Crosswise, NamesTrialsThatItCannotMakeAgain) {
  TrialFault fault;
  Trial trial = crosswise(0.008, 90);
  trial.setup.mass += 14;
  EXPECT_FALSE(fit_crosswise(trial, fault));
  EXPECT_THAT(fault.text(), HasSubstr("virtual.csv: xu_trolley weighs 98.5 kg with its payload, "
                                      "but the trial 112.5 kg"));
  trial.setup.mass -= 14;
  trial.setup.caster = "R10";
  EXPECT_FALSE(fit_crosswise(trial, fault));
  EXPECT_THAT(fault.text(), HasSubstr("'R10': unknown caster; did you mean 'R100'?"));
}

}  // namespace
}  // namespace gurney
