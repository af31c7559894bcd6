#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "engine/base/units.h"
#include "groundmotions/buildings/isolated_motion.h"
#include "groundmotions/buildings/modal_building.h"

namespace gurney::groundmotions {
namespace {

using std::numbers::pi;

/// The same building written down again as first-order equations and solved explicitly (classical
/// Runge-Kutta) with steps so small that they need no care: an independent method.
struct Explicit {
  Isolation isolation;
  std::array<ModalAxis, 2> axes;

  // u, v, z, then q and w of two modes for each axis
  using State = Eigen::Matrix<double, 14, 1>;

  Vector2 base_acceleration(const State& s, double load) const {
    const Vector2 u = s.segment<2>(0), v = s.segment<2>(2), z = s.segment<2>(4);
    const double mu =
        isolation.fast_strength - (isolation.fast_strength - isolation.slow_strength) *
                                      std::exp(-isolation.strength_rate * v.norm());
    Vector2 force = load * (isolation.stiffness * u + mu * z) + isolation.viscosity * v;
    for (int axis = 0; axis < 2; ++axis) {
      double free = 1;
      for (int i = 0; i < 2; ++i) {
        const Mode& mode = axes[static_cast<std::size_t>(axis)][static_cast<std::size_t>(i)];
        const double mass = (1 - isolation.base_mass_ratio) * mode.effective_mass;
        free -= mass;
        force[axis] += mass * acceleration(s, axis, i);
      }
      force[axis] /= free;
    }
    return -force;
  }

  /// Absolute, of mode i.
  double acceleration(const State& s, int axis, int i) const {
    const Mode& mode = axes[static_cast<std::size_t>(axis)][static_cast<std::size_t>(i)];
    const int at = 6 + 4 * axis + 2 * i;
    return -mode.omega * mode.omega * s[at] - 2 * mode.damping * mode.omega * s[at + 1];
  }

  State rate(const State& s, const Vector3& ground) const {
    const double load = isolation.follows_vertical ? 1 + ground.z() / kStandardGravity : 1;
    const Vector2 base = base_acceleration(s, load);
    const Vector2 v = s.segment<2>(2), z = s.segment<2>(4);
    State rate;
    rate << v, base - ground.head<2>(), v, State::Zero().tail<8>();
    if (z.squaredNorm() >= 1 - 1e-9 && z.dot(v) > 0)
      rate.segment<2>(4) -= z.dot(v) / z.squaredNorm() * z;
    rate.segment<2>(4) /= isolation.yield_displacement;
    for (int axis = 0; axis < 2; ++axis)
      for (int i = 0; i < 2; ++i) {
        rate[6 + 4 * axis + 2 * i] = s[7 + 4 * axis + 2 * i];
        rate[7 + 4 * axis + 2 * i] = acceleration(s, axis, i) - base[axis];
      }
    return rate;
  }

  void step(State& s, const Vector3& a, const Vector3& b, double h) const {
    const Vector3 middle = (a + b) / 2;
    const State k1 = rate(s, a), k2 = rate(s + h / 2 * k1, middle);
    const State k3 = rate(s + h / 2 * k2, middle), k4 = rate(s + h * k3, b);
    s += h / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
    if (s.segment<2>(4).norm() > 1) s.segment<2>(4).normalize();
  }
};

Vector3 shake(double t) {
  const double envelope = std::pow(std::sin(pi * t / 8), 2);
  return envelope * Vector3(4 * std::sin(3 * t), 3 * std::sin(4.3 * t + 1), 3 * std::sin(11 * t));
}

std::array<ModalAxis, 2> two_storeys() {
  std::array<ModalAxis, 2> axes;
  for (ModalAxis& axis : axes) {
    axis = modes_of(Eigen::Vector2d(1, 1.2), shear_stiffness(Eigen::Vector2d(1, 0.8)));
    scale_to_period(axis, &axis == &axes[0] ? 0.5 : 0.6);
    set_damping(axis, 0.05);
  }
  return axes;
}

struct Path {
  std::vector<Vector2> base, roof;  // displacement, absolute acceleration, every 0.5 ms
};

double difference(const std::vector<Vector2>& a, const std::vector<Vector2>& b) {
  double worst = 0, peak = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    worst = std::max(worst, (a[i] - b[i]).norm());
    peak = std::max(peak, b[i].norm());
  }
  return worst / peak;
}

constexpr int kSamples = 16000;
constexpr double kSample = 5e-4;

/// @param substeps  in 0.5 ms
Path implicit_path(const Isolation& isolation, const std::array<ModalAxis, 2>& axes, int substeps) {
  IsolatedMotion motion(isolation, axes, kSample / substeps);
  Path path;
  for (int i = 0; i < kSamples; ++i) {
    const Vector3 a = shake(kSample * i), b = shake(kSample * (i + 1));
    for (int j = 0; j < substeps; ++j)
      motion.step(a + (b - a) * j / substeps, a + (b - a) * (j + 1) / substeps);
    path.base.push_back(motion.displacement());
    path.roof.push_back(motion.floor_acceleration(2));
  }
  return path;
}

Path explicit_path(const Explicit& reference, int substeps) {
  Explicit::State s = Explicit::State::Zero();
  Path path;
  for (int i = 0; i < kSamples; ++i) {
    const Vector3 a = shake(kSample * i), b = shake(kSample * (i + 1));
    for (int j = 0; j < substeps; ++j)
      reference.step(s, a + (b - a) * j / substeps, a + (b - a) * (j + 1) / substeps,
                     kSample / substeps);
    const double load = reference.isolation.follows_vertical ? 1 + b.z() / kStandardGravity : 1;
    const Vector2 base = reference.base_acceleration(s, load);
    Vector2 roof = base;
    for (int axis = 0; axis < 2; ++axis)
      for (int k = 0; k < 2; ++k)
        roof[axis] += reference.axes[static_cast<std::size_t>(axis)][static_cast<std::size_t>(k)]
                          .effective_shape[2] *
                      (reference.acceleration(s, axis, k) - base[axis]);
    path.base.push_back(s.head<2>());
    path.roof.push_back(roof);
  }
  return path;
}

class ExplicitMotion : public testing::TestWithParam<Isolation> {};

// Both are of second order or better: at a halving of the step each changes by more than it then
// still lacks. If they have one limit, they are no further apart than the sum of the two changes.
TEST_P(ExplicitMotion, AgreesWithTheImplicitOne) {
  Explicit reference{GetParam(), two_storeys()};
  reference.isolation.base_mass_ratio = 0.25;
  const Path ours = implicit_path(reference.isolation, reference.axes, 2);
  const Path ours_coarse = implicit_path(reference.isolation, reference.axes, 1);
  const Path other = explicit_path(reference, 100), other_coarse = explicit_path(reference, 50);
  const double base = difference(ours_coarse.base, ours.base);
  const double roof = difference(ours_coarse.roof, ours.roof);
  EXPECT_LT(difference(ours.base, other.base), base + difference(other_coarse.base, other.base));
  EXPECT_LT(difference(ours.roof, other.roof), roof + difference(other_coarse.roof, other.roof));
  EXPECT_LT(base, 1e-4);
  EXPECT_LT(roof, 1e-3);
  EXPECT_LT(difference(other_coarse.roof, other.roof), 1e-3);
}

INSTANTIATE_TEST_SUITE_P(Kinds, ExplicitMotion,
                         testing::Values(linear_isolation(2, 0.1),
                                         lead_rubber(2.5, 0.06, 0.01, 0.02),
                                         friction_pendulum(2, 0.03, 0.06, 50, 1e-3)),
                         [](const auto& test) { return std::to_string(test.index); });

}  // namespace
}  // namespace gurney::groundmotions
