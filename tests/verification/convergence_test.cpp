#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "engine/run/simulate.h"
#include "studies/verification/scenes/small_scenes.h"

// The observed order is in studies/verification/cases/method.cpp.
namespace gurney {
namespace {

TEST(Convergence, ARecordAtFourMillisecondsAgainstAQuarter) {
  const std::vector<std::vector<double>> angles = {
      {10, 100, 200, 300}, {45, 45, 45, 45}, {0, 75, 150, 225}};
  std::vector<double> displacement, acceleration, force;
  for (std::size_t i = 0; i < angles.size(); ++i) {
    Scene scene = scene_of(small::trolley(angles[i], Tread()));
    const FloorMotion floor = small::noise_record(10 + i, 10, {4, 3, 2});
    const auto demands = [&](double step) {
      const Response response = simulate(scene, floor, small::settings_for(step, 11, 1000));
      EXPECT_EQ(response.outcome, Outcome::kStopped) << response.cause;
      EXPECT_EQ(response.quality.unconverged_steps, 0);
      EXPECT_LT(response.quality.energy_closure, 0.01);
      return response.items[0].demands;
    };
    const Demands coarse = demands(0.004), fine = demands(2.5e-4);
    EXPECT_GT(fine.peak_displacement, 0.02);
    const auto error = [](double a, double b) { return std::abs(a / b - 1); };
    displacement.push_back(error(coarse.peak_displacement, fine.peak_displacement));
    acceleration.push_back(error(coarse.points[0].peak_absolute_acceleration,
                                 fine.points[0].peak_absolute_acceleration));
    force.push_back(error(coarse.peak_normal_force, fine.peak_normal_force));
  }
  const auto median = [](std::vector<double> errors) {
    std::sort(errors.begin(), errors.end());
    return errors[errors.size() / 2];
  };
  EXPECT_LT(median(displacement), 0.005);
  EXPECT_LT(median(acceleration), 0.02);
  EXPECT_LT(median(force), 0.02);
}

}  // namespace
}  // namespace gurney
