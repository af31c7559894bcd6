#include "studies/verification/scenes/rolling_disc.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <ostream>
#include <vector>

#include "engine/base/units.h"

// A disc that rolls on its edge without slip, in 3D: studies/verification/scenes/rolling_disc.h has its
// equations, and how the engine carries it.
namespace gurney {
namespace {

using std::numbers::pi;
constexpr double kG = kStandardGravity;

TEST(DiscReference, KeepsSteadyPrecessions) {
  // (C + m r^2) w3 Om sin th - A Om^2 sin th cos th + m g r cos th = 0, th from the vertical to the
  // axle, for a thin disc of r = 0.05 m: without spin at 20 and 40 degrees (the table has g
  // = 9.81), and at 60 degrees with Om = -12 rad/s.
  struct Row {
    double theta, precession, spin;
  };
  for (const Row& row : {Row{20, 47.90200, 0}, Row{40, 34.94184, 0}, Row{60, -12, 5.293118}}) {
    const Disc disc{1, 0.05, 0.5, 0};
    const double theta = row.theta * kRadiansPerDegree, scale = std::sqrt(kG / 9.81);
    const Vector3 axle(std::sin(theta), 0, std::cos(theta));
    // Om turns the axle; the rest of the angular velocity is along it.
    const Vector3 across = row.precession * scale * (Vector3::UnitZ() - axle.z() * axle);
    DiscReference reference(disc, axle, across + row.spin * scale * axle);
    for (int i = 0; i < 20; ++i) {
      reference.advance(0.02);
      EXPECT_NEAR(std::acos(reference.axle().z()) / kRadiansPerDegree, row.theta, 1e-4) << i;
    }
  }
}

struct Straight {
  Disc disc;
  double speed;  ///< over the critical one
  double known;  ///< frequency [Hz] or rate of growth [1/s] for g = 9.81 m/s2; 0: none
};

void PrintTo(const Straight& s, std::ostream* out) {
  *out << s.disc.mass << " kg, r " << s.disc.radius << " m, C " << s.disc.axial << " m r^2, "
       << s.speed << " v_crit";
}

class StraightRolling : public testing::TestWithParam<Straight> {};

TEST_P(StraightRolling, WobblesOrFallsAsTheLinearEquationSays) {
  const auto& [disc, ratio, known] = GetParam();
  // The lean x of a disc that rolls upright at n = v / r and is given a breath of yaw rate:
  //   x = X (1 - cos(sqrt(L) t)),   X = (C + m r^2) n yaw_rate / ((A + m r^2) L),
  //   L = [C (C + m r^2) n^2 / A - m g r] / (A + m r^2);   L < 0: cosh(sqrt(-L) t).
  // It leans by 1e-4 at most: the rest of the sine is 1e-9 of it.
  const double v = ratio * disc.critical_speed(), n = v / disc.radius;
  const double stiffness = disc.stiffness(v), lambda = std::sqrt(std::abs(stiffness));
  constexpr double kPhase = 7;  // a cycle, or a growth by e^7
  const double amplitude = stiffness > 0 ? 0.5e-4 : -1e-4 / std::cosh(kPhase);
  const double mr2 = disc.m() * disc.radius * disc.radius;
  const double yaw_rate = amplitude * (disc.A() + mr2) * stiffness / ((disc.C() + mr2) * n);
  EXPECT_EQ(stiffness > 0, ratio > 1);
  if (known > 0) {
    const double found = (ratio > 1 ? lambda / (2 * pi) : lambda) * std::sqrt(9.81 / kG);
    EXPECT_NEAR(found, known, 1e-4 * known);
  }
  const double step = 0.01 / std::max(n, lambda);
  const int count = static_cast<int>(kPhase / lambda / step);
  const Response response = roll(rolling_disc(disc, v, yaw_rate), {}, step, count * step, 1);
  ASSERT_EQ(response.outcome, Outcome::kStopped) << response.cause;
  for (const Sample& sample : response.items[0].history) {
    const double phase = lambda * sample.time;
    const double exact = amplitude * (1 - (stiffness > 0 ? std::cos(phase) : std::cosh(phase)));
    // A method of second order: its rates miss by less than (h n)^2 = 1e-4, here over 7 radians.
    EXPECT_NEAR(disc_axle(sample).z(), exact, 7e-4 * 1e-4) << sample.time;
  }
}

INSTANTIATE_TEST_SUITE_P(
    Discs, StraightRolling,
    testing::Values(Straight{{1, 0.05, 0.5}, 1.2, 1.32264}, Straight{{1, 0.05, 0.5}, 1.5, 2.22931},
                    Straight{{1, 0.05, 0.5}, 2, 3.45363}, Straight{{1, 0.05, 0.5}, 0.8, 7.517},
                    Straight{{1, 0.05, 0.5}, 1.02, 0}, Straight{{1, 0.05, 0.5}, 0.98, 0},
                    Straight{{1, 0.05, 1}, 1.2, 1.20740}, Straight{{1, 0.05, 1}, 1.5, 2.03506},
                    Straight{{1, 0.05, 1}, 2, 3.15271}, Straight{{1, 0.05, 1}, 0.8, 6.862},
                    Straight{{1, 0.05, 1}, 1.02, 0}, Straight{{1, 0.05, 1}, 0.98, 0},
                    Straight{{8, 0.3, 0.7}, 1.3, 0}, Straight{{8, 0.3, 0.7}, 0.6, 0}));

TEST(UprightDisc, PrecessesUnderAWeightAtItsAxle) {
  // A force F down at d to the left of the wheel turns the upright disc to the left, on a circle:
  // F d = Om (C n + m v r), n = v / r.
  for (const Disc& disc : {Disc{1, 0.05, 0.5}, Disc{2, 0.1, 1}, Disc{8, 0.3, 0.7}}) {
    const double force = 0.3 * disc.m() * kG, lever = 0.4 * disc.radius;
    const double v = 2 * disc.critical_speed();
    const double rate = force * lever / (v * (disc.C() / disc.radius + disc.m() * disc.radius));
    const double turn = 2 * pi / rate, step = 0.01 * disc.radius / v;
    Excitation excitation;
    excitation.forces = {
        {"weight", {0, lever, disc.radius}, -Vector3::UnitZ(), {0, turn}, {force, force}}};
    const Response response = roll(rolling_disc(disc, v, rate), excitation, step, turn, 20);
    ASSERT_EQ(response.outcome, Outcome::kStopped) << response.cause;
    for (const Sample& sample : response.items[0].history) {
      const double angle = rate * sample.time;
      const Vector3 circle = v / rate * Vector3(std::sin(angle), 1 - std::cos(angle), 0);
      // (h n)^2 = 1e-4 of a turn of 2 pi; a lean of the size of the sink (m g + F) / k over r.
      EXPECT_LT((sample.points[0].displacement - circle).norm(), 7e-4 * v / rate) << sample.time;
      EXPECT_NEAR(disc_axle(sample).z(), 0, 5e-5) << sample.time;
    }
  }
}

struct Turning {
  Disc disc;
  double speed, yaw_rate;
};

void PrintTo(const Turning& t, std::ostream* out) {
  *out << t.disc.mass << " kg, r " << t.disc.radius << " m, C " << t.disc.axial << " m r^2, "
       << t.speed << " m/s, " << t.yaw_rate << " rad/s";
}

class TurningDisc : public testing::TestWithParam<Turning> {
 protected:
  struct Miss {
    double axle = 0, path = 0;  ///< largest, of the axle's direction [-] and the centre [m]
    double lean = 0, rate = 0;  ///< largest of the reference [rad], [rad/s]
  };

  Miss miss(double step) const {
    const auto& [disc, speed, yaw_rate] = GetParam();
    DiscReference reference(disc, Vector3::UnitY(), {0, speed / disc.radius, yaw_rate});
    const int stride = static_cast<int>(std::lround(0.01 / step));
    const Response response = roll(rolling_disc(disc, speed, yaw_rate), {}, step, 1, stride);
    EXPECT_NE(response.outcome, Outcome::kDiverged) << response.cause;
    EXPECT_LT(response.quality.energy_closure, 1e-4);
    Miss worst;
    double time = 0;
    for (const Sample& sample : response.items[0].history) {
      if (sample.time > time) reference.advance(sample.time - time);
      time = sample.time;
      worst.lean = std::max(worst.lean, std::abs(std::asin(reference.axle().z())));
      worst.rate = std::max(worst.rate, reference.angular_velocity().norm());
      worst.axle = std::max(worst.axle, (disc_axle(sample) - reference.axle()).norm());
      worst.path = std::max(worst.path, (sample.points[0].displacement - reference.moved()).norm());
    }
    EXPECT_EQ(time, 1);
    return worst;
  }
};

TEST_P(TurningDisc, LeansAndTurnsAsTheRigidDiscDoes) {
  // A disc that starts upright with a yaw rate leans out, turns and rises again. The error falls
  // with the square of the step (or better) down to what the tread's sink of m g / k makes of it: a
  // few times the sink over r. It is at most (h w)^2 of the angle w t that the disc turns in t = 1
  // s.
  const Disc& disc = GetParam().disc;
  const Miss coarse = miss(1e-3), fine = miss(5e-4);
  EXPECT_GT(fine.lean, 9 * kRadiansPerDegree) << "a test that asks";
  const double sink = 10 * disc.m() * kG / (kDiscTread * disc.radius);
  EXPECT_LT(fine.axle, std::max(coarse.axle / 3, sink));
  EXPECT_LT(fine.path / disc.radius, std::max(coarse.path / disc.radius / 3, sink));
  const double largest = std::max(std::pow(5e-4 * fine.rate, 2) * fine.rate, sink);
  EXPECT_LT(fine.axle, largest);
  EXPECT_LT(fine.path / disc.radius, largest);
}

INSTANTIATE_TEST_SUITE_P(
    Discs, TurningDisc,
    testing::Values(Turning{{1, 0.05, 0.5}, 0.8, 2}, Turning{{1, 0.05, 0.5}, 0.8, 5},
                    Turning{{1, 0.05, 0.5}, 0.5, 2}, Turning{{1, 0.05, 1}, 0.6, 2},
                    Turning{{8, 0.3, 0.7}, 1.5, 2}, Turning{{8, 0.3, 0.7}, 1.5, 3},
                    Turning{{8, 0.3, 0.7}, 1.3, 2.5}));

class SteadyPrecession : public testing::TestWithParam<Turning> {
 protected:
  static constexpr double kLed = 0.4, kSample = 1e-3;  // [s]

  /// A disc that starts upright is led to a_z = `height` in kLed, by a polynomial of fifth order.
  /// @returns the push that is left to hold it there; `table`: the push from the start on.
  double lead(double height, Excitation* table) const {
    const auto& [disc, speed, yaw_rate] = GetParam();
    DiscReference reference(disc, Vector3::UnitY(), {0, speed / disc.radius, yaw_rate});
    const auto height_rate2 = [&](double t) {
      const double s = t / kLed;
      return height / (kLed * kLed) * (60 * s - 180 * s * s + 120 * s * s * s);
    };
    PointForce x{"x", {0, 0, disc.radius}, Vector3::UnitX(), {}, {}};
    PointForce y{"y", {0, 0, disc.radius}, Vector3::UnitY(), {}, {}};
    const auto note = [&] {
      const Vector3& axle = reference.axle();
      const Vector2 push =
          reference.push_for(height_rate2(reference.time())) * axle.head<2>().normalized();
      for (auto* force : {&x, &y}) force->time.push_back(reference.time());
      x.force.push_back(push.x());
      y.force.push_back(push.y());
      return push.dot(axle.head<2>());
    };
    note();
    double left = 0;
    for (int i = 0; i < std::lround(kLed / kSample); ++i) {
      reference.advance_led(kSample, height_rate2);
      left = note();
    }
    if (table) {
      table->forces = {x, y};
      reference.advance(1);
      EXPECT_NEAR(reference.axle().z(), height, 1e-6) << "stays";
    }
    return left;
  }
};

TEST_P(SteadyPrecession, StaysAsItIsWhenItIsLeftAlone) {
  const auto& [disc, speed, yaw_rate] = GetParam();
  // Upright it takes a push against the yaw rate; where no push is left it is steady.
  const double push = lead(0, nullptr);
  double steady = 0, beyond = std::copysign(0.9, yaw_rate);
  for (int i = 0; i < 24; ++i) {
    const double height = 0.5 * (steady + beyond);
    (lead(height, nullptr) * push > 0 ? steady : beyond) = height;
  }
  Excitation excitation;
  lead(steady, &excitation);
  const Response response =
      roll(rolling_disc(disc, speed, yaw_rate), excitation, 2.5e-4, kLed + 1, 40);
  ASSERT_NE(response.outcome, Outcome::kDiverged) << response.cause;
  const double C = disc.C(), A = disc.A(), r = disc.radius, mgr = disc.m() * kG * r;
  const double mr2 = disc.m() * r * r;
  // Ten sinks of the tread over r, as for turning discs.
  const double nutation = 10 * mgr / (kDiscTread * r * r);
  std::vector<Vector2> middles;  // of the circle
  const auto& history = response.items[0].history;
  for (std::size_t i = 1; i < history.size(); ++i) {
    if (history[i - 1].time < kLed - 1e-6) continue;
    const Vector3 before = disc_axle(history[i - 1]), a = disc_axle(history[i]);
    const double turn =
        std::atan2(before.x() * a.y() - before.y() * a.x(), before.head<2>().dot(a.head<2>()));
    const double rate = turn / (history[i].time - history[i - 1].time);
    const double spin = history[i].wheels[0].wheel_rate;
    const double cosine = a.z(), sine = std::sqrt(1 - cosine * cosine);
    const double left =
        (C + mr2) * spin * rate * sine - A * rate * rate * sine * cosine + mgr * cosine;
    // A nutation changes the yaw rate by C w3 / A = 2 w3 times its size.
    const double yaw = 2 * std::abs(spin / rate) * nutation;
    EXPECT_NEAR(cosine, steady, nutation) << history[i].time;
    EXPECT_NEAR(left, 0, yaw * mgr * std::abs(cosine)) << history[i].time;
    const Vector2 centre = history[i].points[0].displacement.head<2>();
    const double radius = spin * r / rate;
    middles.push_back(centre + radius * a.head<2>().normalized());
    EXPECT_LT((middles.back() - middles.front()).norm(), yaw * std::abs(radius));
  }
  ASSERT_GT(middles.size(), 90u);
}

INSTANTIATE_TEST_SUITE_P(
    Discs, SteadyPrecession,
    testing::Values(Turning{{1, 0.05, 0.5}, 0.6, -4}, Turning{{1, 0.05, 0.5}, 0.8, 10},
                    Turning{{1, 0.05, 1}, 0.8, 10}, Turning{{1, 0.05, 1}, 0.6, 5},
                    Turning{{8, 0.3, 0.7}, 2, 4}, Turning{{8, 0.3, 0.7}, 2, -3}));

}  // namespace
}  // namespace gurney
