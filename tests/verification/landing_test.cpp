#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <vector>

#include "engine/base/units.h"
#include "engine/run/simulate.h"
#include "studies/verification/scenes/small_scenes.h"

// Wheels that leave the floor and land again and again, and wheels that climb over a threshold,
// against Newton's law integrated by Runge-Kutta: the force of a tread has a kink where it touches,
// and the plane of an edge turns under the wheel.
namespace gurney {
namespace {

constexpr double kMass = 96.5, kStiffness = 3e5, kRadius = 0.05;
constexpr double kStatic = kMass * kStandardGravity / (4 * kStiffness);

using Planar = std::array<double, 4>;  // x, z, their rates

/// Calls `see` every `step` until `end`.
void integrate(Planar state, double end, double step,
               const std::function<std::array<double, 2>(double, const Planar&)>& acceleration,
               const std::function<void(const Planar&)>& see) {
  constexpr double kFine = 1e-5;
  const auto parts = std::lround(step / kFine);
  const auto rates = [&](double t, const Planar& s) -> Planar {
    const auto a = acceleration(t, s);
    return {s[2], s[3], a[0], a[1]};
  };
  const auto moved = [](const Planar& s, double h, const Planar& r) {
    Planar next;
    for (std::size_t i = 0; i < 4; ++i) next[i] = s[i] + h * r[i];
    return next;
  };
  see(state);
  for (long k = 0; k < std::lround(end / step) * parts; ++k) {
    const double t = static_cast<double>(k) * kFine;
    const Planar a = rates(t, state), b = rates(t + kFine / 2, moved(state, kFine / 2, a)),
                 c = rates(t + kFine / 2, moved(state, kFine / 2, b)),
                 d = rates(t + kFine, moved(state, kFine, c));
    for (std::size_t i = 0; i < 4; ++i) state[i] += kFine / 6 * (a[i] + 2 * (b[i] + c[i]) + d[i]);
    if ((k + 1) % parts == 0) see(state);
  }
}

Scene led(double friction) {
  Tread tread = small::bare_tread(kStiffness, 1e6);
  tread.static_friction = tread.kinetic_friction = friction;
  Scene scene = scene_of(small::trolley({0, 0, 0, 0}, tread));
  for (int dof : {3, 4, 5}) scene.items[0].fixture.guides[dof].kind = Guide::Kind::kHeld;
  return scene;
}

TEST(Landing, OfSecondOrderOverThreeFlights) {
  // 1.4 g at 4 Hz throws the trolley up in each of three cycles.
  constexpr double kRate = 5e-4, kCycles = 3, kHertz = 4, kEnd = 1;
  const auto samples = static_cast<Eigen::Index>(std::lround(kCycles / kHertz / kRate)) + 1;
  Eigen::Matrix3Xd motion = Eigen::Matrix3Xd::Zero(3, samples);
  for (Eigen::Index i = 0; i < samples; ++i)
    motion(2, i) = 1.4 * kStandardGravity *
                   std::sin(2 * std::numbers::pi * kHertz * kRate * static_cast<double>(i));
  const FloorMotion floor(kRate, motion);

  std::vector<double> exact;
  integrate(
      {0, -kStatic, 0, 0}, kEnd, 0.004,
      [&](double t, const Planar& s) -> std::array<double, 2> {
        return {0, 4 * kStiffness * std::max(0.0, -s[1]) / kMass - kStandardGravity -
                       floor.acceleration_at(t).z()};
      },
      [&](const Planar& s) { exact.push_back(s[1] + kStatic); });
  ASSERT_GT(*std::max_element(exact.begin(), exact.end()), 0.1);

  std::vector<double> errors;
  for (const int halvings : {0, 1, 2, 3}) {
    const double step = 0.004 / (1 << halvings);
    const Response response =
        simulate(led(0.6), floor, small::settings_for(step, kEnd, 1 << halvings));
    const std::vector<Sample>& history = response.items[0].history;
    ASSERT_EQ(history.size(), exact.size());
    double& error = errors.emplace_back(0);
    for (std::size_t i = 0; i < exact.size(); ++i)
      error = std::max(error, std::abs(history[i].displacement.z() - exact[i]));
  }
  // Second order: a quarter for each halving, to leading order. An order of 1.7 is a ratio of 3.2;
  // kinks left inside steps make it swing with their place in the step.
  for (std::size_t i = 1; i < errors.size(); ++i) {
    RecordProperty("error_" + std::to_string(i), std::to_string(errors[i]));
    EXPECT_GT(errors[i - 1] / errors[i], 3.2) << errors[i - 1] << " to " << errors[i];
    EXPECT_LT(errors[i - 1] / errors[i], 5) << errors[i - 1] << " to " << errors[i];
  }
}

TEST(Landing, FourWheelsClimbAThreshold) {
  constexpr double kFace = 0.575, kWidth = 0.05, kHeight = 0.012, kEnd = 1;
  constexpr double kFront = 0.4 - 0.034, kRear = -0.4 - 0.034;  // of the wheels' axles
  for (const double speed : {0.7, 0.8, 1.0}) {
    /// On the axle at (x, z): of a half plane below, and of the corners of the threshold.
    const auto on_wheel = [&](double x, double z) -> std::array<double, 2> {
      std::array<double, 2> force{0, kStiffness * std::max(0.0, kRadius - z)};
      const bool above = x > kFace && x < kFace + kWidth;
      const double edge = x <= kFace ? kFace : kFace + kWidth;
      const double dx = above ? 0 : x - edge, dz = z - kHeight;
      const double distance = std::hypot(dx, dz);
      const double push = kStiffness * std::max(0.0, kRadius - distance);
      force[0] += push * dx / distance;
      force[1] += push * dz / distance;
      return force;
    };
    double exact = 0;
    integrate(
        {0, kRadius - kStatic, speed, 0}, kEnd, 0.004,
        [&](double, const Planar& s) -> std::array<double, 2> {
          const auto front = on_wheel(s[0] + kFront, s[1]), rear = on_wheel(s[0] + kRear, s[1]);
          return {2 * (front[0] + rear[0]) / kMass,
                  2 * (front[1] + rear[1]) / kMass - kStandardGravity};
        },
        [&](const Planar& s) { exact = std::max(exact, s[1] - kRadius + kStatic); });
    ASSERT_GT(exact, kHeight);
    for (const double step : {0.004, 0.002, 0.001}) {
      Scene scene = led(0);
      scene.items[0].initial.velocity = {speed, 0, 0};
      scene.room.push_back({"threshold",
                            "steel",
                            {kFace + kWidth / 2, 0, kHeight / 2},
                            Quaternion::Identity(),
                            RoomBox{{kWidth, 2, kHeight}}});
      scene.pairs.push_back({scene.items[0].model.material, "steel", {}});
      const int stride = static_cast<int>(std::lround(0.004 / step));
      const Response response = simulate(scene, {}, small::settings_for(step, kEnd, stride));
      double climb = 0;
      for (const Sample& sample : response.items[0].history)
        climb = std::max(climb, sample.displacement.z());
      // The plane of the middle of a step overlaps by (v h)^2 / 8 R more at its ends; the bodies
      // store and return energy in it to 5e-4, the closure of the balance.
      const double way = speed * step;
      EXPECT_NEAR(climb, exact, way * way / (8 * kRadius) + 5e-4 * exact)
          << speed << " m/s, " << step << " s";
    }
  }
}

}  // namespace
}  // namespace gurney
