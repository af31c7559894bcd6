#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <ostream>

#include "engine/base/units.h"
#include "engine/simulate.h"
#include "studies/verification/scenes/small_scenes.h"

// A caster whose pivot is led at constant speed v along x turns into line. Without slip the contact
// point moves along the wheel only: trail psi' = -v sin psi, so
//
//     tan(psi / 2) = tan(psi_0 / 2) exp(-v t / trail).
//
// The tread is stiff and its friction (mu = 5) never reached. It slips by F / (k_t sigma) of the
// way; from psi'' = (v / trail)^2 sin(2 psi) / 2, F <= I_p (v / trail)^2 / (2 trail).
namespace gurney {
namespace {

constexpr double kStiffness = 1e9;  // k_t [N/m]

struct Case {
  double start_degrees, trail, speed;
};

Tread stiff() {
  Tread tread = small::bare_tread(3e8, kStiffness);
  tread.tangential_damping = 100;
  tread.static_friction = tread.kinetic_friction = 5;
  return tread;
}

double closed_form(double start, double path) {
  return 2 * std::atan(std::tan(start / 2) * std::exp(-path));
}

void PrintTo(const Case& c, std::ostream* out) {
  *out << c.start_degrees << " degrees, trail " << c.trail << " m, " << c.speed << " m/s";
}

class Alignment : public testing::TestWithParam<Case> {
 protected:
  /// Largest deviation from the closed form over 12 trails of path, against its bound [rad].
  ///
  /// An error of the path s = v t / trail turns the caster by sin(psi) of it, and both sources are
  /// errors of the path: the slip, F / (k_t sigma) of it, and the integrator. For y' = -y, and so
  /// for psi near its end, the latter makes 3 gamma^2 - 2 gamma^3 - 1/6 = 0.0404 h^2 of it at a
  /// step h (in trails); elsewhere the third derivative, sin(psi) cos(2 psi), is smaller.
  /// @param step  h
  void compare(double step) {
    const Case c = GetParam();
    const double time = c.trail / c.speed, start = c.start_degrees * kRadiansPerDegree;
    const auto towed = small::towed_caster(c.speed, c.trail, c.start_degrees, stiff());
    const Response response =
        simulate(towed.scene, towed.excitation, small::settings_for(step * time, 12 * time));
    ASSERT_EQ(response.outcome, Outcome::kStopped) << response.cause;
    ASSERT_GT(response.items[0].history.size(), 12 / step);
    const double force =
        small::swivel_inertia(towed.scene.items[0].model.casters[0]) / (2 * time * time * c.trail);
    const double slip = force / (kStiffness * 0.01);
    double largest = 0, shift = 0;
    for (const Sample& sample : response.items[0].history) {
      const double path = sample.time / time, expected = closed_form(start, path);
      largest = std::max(largest, std::abs(sample.wheels[0].swivel_angle - expected));
      shift = std::max(shift, path * std::abs(std::sin(expected)));
    }
    EXPECT_LT(largest, shift * 0.0404 * step * step + 12 * slip);
    EXPECT_LT(std::abs(response.items[0].history.back().wheels[0].swivel_angle), 2e-3);
  }
};

TEST_P(Alignment, FollowsTheTractrix) {
  compare(0.05);
  compare(0.025);
}

INSTANTIATE_TEST_SUITE_P(Starts, Alignment,
                         testing::Values(Case{30, 0.034, 1}, Case{60, 0.034, 0.2},
                                         Case{90, 0.034, 1}, Case{120, 0.05, 2},
                                         Case{150, 0.02, 0.5}, Case{170, 0.034, 1},
                                         Case{-30, 0.02, 1}, Case{-75, 0.05, 0.2},
                                         Case{-135, 0.034, 3}, Case{-170, 0.034, 0.3}));
// Led backwards, a caster stands on a crest: one degree off it turns over, to either side.
INSTANTIATE_TEST_SUITE_P(Reversed, Alignment,
                         testing::Values(Case{179, 0.034, 0.5}, Case{-179, 0.034, 0.5}));

}  // namespace
}  // namespace gurney
