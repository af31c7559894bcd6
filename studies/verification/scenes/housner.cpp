#include "studies/verification/scenes/housner.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/base/units.h"

namespace gurney {
namespace {

constexpr double kStep = 1e-3;         // [s]
constexpr double kSlowestRate = 1e-4;  // stands below this [rad/s]

/// The smallest part of a step of length h that `has` passed the event, to 1e-12 h.
template <class Has>
double located(double h, Has has) {
  double before = 0, after = h;
  for (int i = 0; i < 40; ++i) {
    const double middle = 0.5 * (before + after);
    (has(middle) ? after : before) = middle;
  }
  return after;
}

using Eigen::Matrix3d, Eigen::Quaterniond, Eigen::Vector2d, Eigen::Vector3d;

Quaterniond orientation(const FourFeet::Motion& y) {
  return Quaterniond(y[3], y[4], y[5], y[6]).normalized();
}

}  // namespace

bool RockingReference::fallen() const { return std::abs(theta_) > 1; }

void RockingReference::step(const std::function<double(double)>& acceleration, double h) {
  const auto accelerate = [&](double t, double theta) {
    const double angle = block_.alpha * sign_ - theta;
    return -block_.p * block_.p *
           (std::sin(angle) + acceleration(t) / kStandardGravity * std::cos(angle));
  };
  const double t = time_, k1 = accelerate(t, theta_), v1 = rate_;
  const double k2 = accelerate(t + h / 2, theta_ + h / 2 * v1), v2 = rate_ + h / 2 * k1;
  const double k3 = accelerate(t + h / 2, theta_ + h / 2 * v2), v3 = rate_ + h / 2 * k2;
  const double k4 = accelerate(t + h, theta_ + h * v3), v4 = rate_ + h * k3;
  theta_ += h / 6 * (v1 + 2 * v2 + 2 * v3 + v4);
  rate_ += h / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
  time_ += h;
}

void RockingReference::advance(const std::function<double(double)>& acceleration, double duration) {
  const double end = time_ + duration;
  while (time_ < end && !fallen()) {
    const double h = std::min(kStep, end - time_);
    if (sign_ == 0) {
      const auto lifts = [&](double t) {
        return std::abs(acceleration(t)) > kStandardGravity * std::tan(block_.alpha);
      };
      if (!lifts(time_)) {
        const bool soon = lifts(time_ + h);
        time_ = soon ? located(h, [&](double part) { return lifts(time_ + part); }) + time_
                     : std::min(time_ + h, end);
        if (!soon) continue;
      }
      sign_ = acceleration(time_) > 0 ? -1 : 1;
      continue;
    }
    const RockingReference start = *this;
    step(acceleration, h);
    if (h < kStep) time_ = end;
    if (theta_ * sign_ >= 0) continue;
    const double impact = located(h, [&](double part) {
      *this = start;
      step(acceleration, part);
      return theta_ * sign_ < 0;
    });
    *this = start;
    step(acceleration, impact);
    theta_ = 0;
    rate_ *= block_.eta;
    sign_ = -sign_;
    ++impacts_;
    if (std::abs(rate_) < kSlowestRate) rate_ = sign_ = 0;
  }
}

void RockingReference::jump(double change) {
  if (sign_ == 0) sign_ = change > 0 ? -1 : 1;
  rate_ -=
      block_.p * block_.p / kStandardGravity * std::cos(block_.alpha * sign_ - theta_) * change;
}

double quarter_period(const RockingBlock& block, double theta0) {
  constexpr int kParts = 20000;
  double sum = 0;  // theta = theta0 (1 - s^2) takes the root out of the integrand
  for (int i = 0; i < kParts; ++i) {
    const double s = (i + 0.5) / kParts, theta = theta0 * (1 - s * s);
    sum +=
        2 * theta0 * s / kParts /
        (block.p * std::sqrt(2 * (std::cos(block.alpha - theta0) - std::cos(block.alpha - theta))));
  }
  return sum;
}

RockingEnd SineRegions::end(const RockingBlock& block, double ratio, double strength) {
  const double omega = ratio * block.p;
  RockingReference r(block);
  r.advance(
      [&](double t) { return strength * block.alpha * kStandardGravity * std::sin(omega * t); },
      2 * std::numbers::pi / omega);
  // The block leaves its unstable balance as exp(p t): 20 / p to see on which side.
  r.advance([](double) { return 0.0; }, 20 / block.p);
  if (!r.fallen()) return RockingEnd::kStands;
  return r.impacts() == 0 ? RockingEnd::kWithoutImpact : RockingEnd::kAfterImpact;
}

double SineRegions::boundary(const RockingBlock& block, double ratio, RockingEnd wanted,
                             double without, double with) {
  for (int i = 0; i < 24; ++i) {
    const double middle = 0.5 * (without + with);
    (end(block, ratio, middle) == wanted ? with : without) = middle;
  }
  return 0.5 * (without + with);
}

SineRegions::SineRegions(const RockingBlock& block, double ratio) {
  c = boundary(block, ratio, RockingEnd::kWithoutImpact, 1, 40);
  for (double inside = 0.99 * c; inside > 1 && a == 0; inside *= 0.98) {
    if (end(block, ratio, inside) != RockingEnd::kAfterImpact) continue;
    a = boundary(block, ratio, RockingEnd::kAfterImpact, 1, inside);
    b = boundary(block, ratio, RockingEnd::kAfterImpact, 0.9999 * c, inside);
  }
}

FourFeet::Motion FourFeet::at_rest() const {
  Motion y = Motion::Zero();
  y[2] = radius - wheels[0].z() - mass * gravity / (4 * normal_stiffness);
  y[3] = 1;
  return y;
}

FourFeet::Foot FourFeet::foot(const Motion& y, const Matrix3d& rotation, std::size_t i) const {
  Foot foot;
  foot.axle = rotation.col(1);
  foot.rim = -radius * (Vector3d::UnitZ() - foot.axle.z() * foot.axle).normalized();
  foot.arm = rotation * wheels[i] + foot.rim;
  foot.depth = -(y[2] + foot.arm.z());
  return foot;
}

FourFeet::Motion FourFeet::rates(const Motion& y, const Vector3& floor) const {
  const Quaterniond q = orientation(y);
  const Matrix3d rotation = q.toRotationMatrix();
  const Vector3d v = y.segment<3>(7), w = y.segment<3>(10);
  Motion rate = Motion::Zero();
  rate.head<3>() = v;
  const Quaterniond turn = Quaterniond(0, w.x(), w.y(), w.z()) * q;
  rate.segment<4>(3) << 0.5 * turn.w(), 0.5 * turn.x(), 0.5 * turn.y(), 0.5 * turn.z();

  Vector3d force = mass * (Vector3d(0, 0, -gravity) - floor), moment = Vector3d::Zero();
  for (std::size_t i = 0; i < 4; ++i) {
    const auto at = static_cast<Eigen::Index>(13 + 4 * i);
    const Foot f = foot(y, rotation, i);
    const double angle = y[at], spin = y[at + 1];
    const Vector3d u = v + w.cross(f.arm) + spin * f.axle.cross(f.rim);
    Vector3d push = Vector3d::Zero();
    Vector2d slip = Vector2d::Zero();
    if (f.depth > 0) {
      const double elastic = normal_stiffness * f.depth;
      const double normal = elastic + std::clamp(-normal_damping * u.z(), -elastic, elastic);
      const Vector2d e = y.segment<2>(at + 2), across = u.head<2>();
      Vector2d held = tangential_stiffness * e + tangential_damping * across;
      slip = across;
      if (held.norm() > friction * normal) {
        held *= friction * normal / held.norm();
        slip = (held - tangential_stiffness * e) / tangential_damping;
      }
      push << -held, normal;
    }
    const double torque = f.axle.dot(f.rim.cross(push)) - axle_stiffness * angle;
    rate[at] = spin;
    rate[at + 1] = torque / wheel_inertia;
    rate.segment<2>(at + 2) = slip;
    force += push;
    moment += f.arm.cross(push) - torque * f.axle;
  }
  rate.segment<3>(7) = force / mass;
  const Vector3d body_w = rotation.transpose() * w, body_moment = rotation.transpose() * moment;
  const Vector3d momentum = inertia.cwiseProduct(body_w);
  const Vector3d gain = (body_moment - body_w.cross(momentum)).cwiseQuotient(inertia);
  rate.segment<3>(10) = rotation * gain;
  return rate;
}

void FourFeet::step(Motion& y, double h, const std::array<Vector3, 3>& floor) const {
  const Motion a = rates(y, floor[0]), b = rates(y + 0.5 * h * a, floor[1]);
  const Motion c = rates(y + 0.5 * h * b, floor[1]), d = rates(y + h * c, floor[2]);
  y += h / 6 * (a + 2 * b + 2 * c + d);
  y.segment<4>(3).normalize();
  const Matrix3d rotation = orientation(y).toRotationMatrix();
  for (std::size_t i = 0; i < 4; ++i)
    if (foot(y, rotation, i).depth <= 0)
      y.segment<2>(static_cast<Eigen::Index>(15 + 4 * i)).setZero();
}

Eigen::Vector3d FourFeet::point(const Motion& y, const Vector3& from_centre) const {
  return y.head<3>() + orientation(y) * from_centre;
}

double FourFeet::tilt(const Motion& y) const {
  return std::acos(std::min(1.0, orientation(y).toRotationMatrix()(2, 2)));
}

int FourFeet::feet_on_floor(const Motion& y) const {
  const Matrix3d rotation = orientation(y).toRotationMatrix();
  int count = 0;
  for (std::size_t i = 0; i < 4; ++i) count += foot(y, rotation, i).depth > 0;
  return count;
}

}  // namespace gurney
