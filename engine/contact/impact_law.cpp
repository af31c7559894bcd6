#include "engine/contact/impact_law.h"

#include <algorithm>
#include <cmath>

#include "engine/contact/one_sided_spring.h"

namespace gurney {
namespace {

constexpr double kMindlinRatio = 0.8;
constexpr double kCompliantDampingTime = 1e-3;  // [s]

}  // namespace

double ImpactLaw::damping_number(double e) {
  // x = 3 (1 - e^2) / (2 (1 + e^3)) is the root of the two leading terms of the series in x.
  const double series = 1.5 * (1 - e * e) / (1 + e * e * e);
  if (series < 1e-4) return series;
  double low = 0.5 * series, high = 1 / e;
  for (int i = 0; i < 200 && high - low > 1e-15 * high; ++i) {
    const double x = 0.5 * (low + high);
    (std::log1p(x) - std::log1p(-e * x) < (1 + e) * x ? low : high) = x;
  }
  return 0.5 * (low + high);
}

ImpactLaw::ImpactLaw(const ContactConstants& c)
    : compliant_(c.kind == ContactConstants::Kind::kCompliant),
      stiffness_(c.stiffness),
      damping_(c.damping),
      damping_number_(compliant_ ? 0 : damping_number(c.restitution)),
      friction_(c.friction),
      tangential_stiffness_(kMindlinRatio * c.stiffness),
      rolling_resistance_(c.rolling_resistance) {}

double ImpactLaw::damping_slope(const Stage& stage) const {
  return damping_number_ / std::max(stage.approach_speed, kLeastApproach);
}

ImpactLaw::Tangent ImpactLaw::tangent(const Stage& stage, const Vector3& u) const {
  const double d = stage.compression - stage.tau * u.z();
  const double time = compliant_ ? kCompliantDampingTime : damping_slope(stage) * d;
  return {tangential_stiffness_ * time / stage.tau,
          compliant_ ? 0 : tangential_stiffness_ * damping_slope(stage)};
}

ImpactLaw::Normal ImpactLaw::normal(const Stage& stage, double u_z) const {
  const double d = stage.compression - stage.tau * u_z;
  if (!(d > 0)) return {0, 0, 0};
  const double elastic = stiffness_ * d, elastic_slope = stiffness_ * stage.tau;
  if (compliant_) {
    const double damping = -damping_ * u_z;
    if (damping <= -elastic) return {0, 0, -elastic};
    if (damping >= elastic) return {2 * elastic, 2 * elastic_slope, elastic};
    return {elastic + damping, elastic_slope + damping_, damping};
  }
  const double rate = damping_slope(stage);
  const double g = -rate * u_z;
  if (g <= -1) return {0, 0, -elastic};
  return {elastic * (1 + g), elastic_slope * (1 + g) + elastic * rate, elastic * g};
}

Vector3 ImpactLaw::force(const Stage& stage, const Vector3& u, Matrix3& slope) const {
  slope.setZero();
  const Normal n = normal(stage, u.z());
  if (n.force <= 0) return Vector3::Zero();
  slope(2, 2) = n.slope;
  const auto [damping_rate, damping_by_depth] = this->tangent(stage, u);
  const double stiffness = tangential_stiffness_ + damping_rate;
  Vector2 tangent =
      damping_rate * stage.deflection - stiffness * (stage.deflection + stage.tau * u.head<2>());
  Vector2 by_normal = -stage.tau * damping_by_depth * u.head<2>();
  const double size = tangent.norm(), limit = friction_ * n.force;
  Matrix2 tangent_slope = Matrix2::Identity() * (stiffness * stage.tau);
  if (size > limit) {
    const Vector2 direction = tangent / size;
    const Matrix2 turning =
        limit / size * (Matrix2::Identity() - direction * direction.transpose());
    tangent = limit * direction;
    tangent_slope = stiffness * stage.tau * turning;
    by_normal = friction_ * n.slope * direction + turning * by_normal;
  }
  slope.block<2, 1>(0, 2) = by_normal;
  slope.topLeftCorner<2, 2>() = tangent_slope;
  return {tangent.x(), tangent.y(), n.force};
}

ImpactLaw::Result ImpactLaw::finish(const Stage& stage, const Vector3& u,
                                    const Vector3& force) const {
  Result result;
  result.force = force;
  result.compression = stage.compression - stage.tau * u.z();
  const Normal n = normal(stage, u.z());
  result.damping_power = -n.damping_force * u.z();
  result.spring_rates = one_sided_rates(
      stiffness_,
      {stage.compression - stage.turned, stage.compression, result.compression, stage.ahead},
      stage.tau);
  // Between the end of the force and that of the overlap the deflection still relaxes.
  if (result.compression <= 0) {
    result.spring_rates += tangential_stiffness_ * (stage.deflection / stage.tau).squaredNorm();
    return result;
  }
  const double damping_rate = this->tangent(stage, u).damping_rate;
  const Vector2 tangent = result.force.head<2>();
  result.deflection =
      (damping_rate * stage.deflection - tangent) / (tangential_stiffness_ + damping_rate);
  result.sliding = tangent.norm() >= friction_ * n.force * (1 - 1e-12);
  const Vector2 rate = (result.deflection - stage.deflection) / stage.tau;
  result.sliding_power = -tangent.dot(u.head<2>() - rate);
  result.damping_power += damping_rate * stage.tau * rate.squaredNorm();
  result.spring_rates += tangential_stiffness_ * rate.squaredNorm();
  return result;
}

double ImpactLaw::stored_energy(double compression, double deflection) const {
  const double d = std::max(compression, 0.0);
  return 0.5 * stiffness_ * d * d + 0.5 * tangential_stiffness_ * deflection * deflection;
}

}  // namespace gurney
