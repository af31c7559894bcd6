#include "studies/verification/scenes/planar_impact.h"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>

namespace gurney {
namespace {

using State = Eigen::Matrix<double, 12, 1>;  // x, y, yaw of both bodies; their rates

Vector2 across(double rate, const Vector2& arm) { return {-rate * arm.y(), rate * arm.x()}; }

double moment(const Vector2& arm, const Vector2& force) {
  return arm.x() * force.y() - arm.y() * force.x();
}

struct Touch {
  double gap;
  Vector2 normal;              // from the second body to the first
  std::array<Vector2, 2> arm;  // from the centres to the point of contact

  double rate(const State& s) const {
    return normal.dot(s.segment<2>(6) + across(s[8], arm[0]) - s.segment<2>(9) -
                      across(s[11], arm[1]));
  }
};

/// Points of both bodies, their axes, and a normal that stay.
struct Kept {
  std::array<Vector2, 2> on;
  Vector2 normal;
};

class Pair {
 public:
  Pair(const PlanarBody& first, const PlanarBody& second, const PlanarSurfaces& surfaces,
       double stiffness, double damping_number, PlanarImpact::Contact contact)
      : bodies_{first, second}, surfaces_(surfaces), stiffness_(stiffness) {
    const State start = state();
    for (std::size_t i = 0; i < surfaces.points.size(); ++i) {
      const Touch t = follow(start, i);
      damping_.push_back(damping_number / -t.rate(start));
      if (contact == PlanarImpact::Contact::kStays)
        kept_.push_back({{Eigen::Rotation2Dd(-first.yaw) * t.arm[0],
                          Eigen::Rotation2Dd(-second.yaw) * t.arm[1]},
                         t.normal});
    }
  }

  State state() const {
    State s;
    for (int b = 0; b < 2; ++b) {
      const PlanarBody& body = bodies_[static_cast<std::size_t>(b)];
      s.segment<3>(3 * b) << body.position, body.yaw;
      s.segment<3>(6 + 3 * b) << body.velocity, body.yaw_rate;
    }
    return s;
  }

  Touch touch(const State& s, std::size_t i) const {
    if (kept_.empty()) return follow(s, i);
    const Kept& kept = kept_[i];
    const std::array<Vector2, 2> arm{Eigen::Rotation2Dd(s[2]) * kept.on[0],
                                     Eigen::Rotation2Dd(s[5]) * kept.on[1]};
    const Vector2 apart = s.segment<2>(0) + arm[0] - s.segment<2>(3) - arm[1];
    return {kept.normal.dot(apart), kept.normal, arm};
  }

  State rates(const State& s) const {
    State r;
    r << s.tail<6>(), Eigen::Matrix<double, 6, 1>::Zero();
    for (std::size_t i = 0; i < surfaces_.points.size(); ++i) {
      const Touch t = touch(s, i);
      const double size =
          stiffness_ * std::max(0.0, -t.gap) * std::max(0.0, 1 - damping_[i] * t.rate(s));
      for (int b = 0; b < 2; ++b) {
        const PlanarBody& body = bodies_[static_cast<std::size_t>(b)];
        const Vector2 force = (b == 0 ? size : -size) * t.normal;
        r.segment<2>(6 + 3 * b) += force * body.inverse_mass;
        r[8 + 3 * b] += moment(t.arm[static_cast<std::size_t>(b)], force) * body.inverse_inertia;
      }
    }
    return r;
  }

  bool touches(const State& s) const {
    for (std::size_t i = 0; i < surfaces_.points.size(); ++i)
      if (touch(s, i).gap < 0) return true;
    return false;
  }

  bool parts(const State& s) const {
    for (std::size_t i = 0; i < surfaces_.points.size(); ++i)
      if (touch(s, i).rate(s) <= 0) return false;
    return !touches(s);
  }

  std::array<PlanarBody, 2> bodies(const State& s) const {
    std::array<PlanarBody, 2> result = bodies_;
    for (int b = 0; b < 2; ++b) {
      PlanarBody& body = result[static_cast<std::size_t>(b)];
      body.position = s.segment<2>(3 * b);
      body.yaw = s[3 * b + 2];
      body.velocity = s.segment<2>(6 + 3 * b);
      body.yaw_rate = s[8 + 3 * b];
    }
    return result;
  }

 private:
  Touch follow(const State& s, std::size_t i) const {
    const Vector2 first = s.segment<2>(0), second = s.segment<2>(3);
    const Vector2 point = first + Eigen::Rotation2Dd(s[2]) * surfaces_.points[i];
    const Vector2 origin = second + Eigen::Rotation2Dd(s[5]) * surfaces_.origin;
    const bool flat = !surfaces_.normal.isZero();
    const Vector2 normal = flat ? Vector2(Eigen::Rotation2Dd(s[5]) * surfaces_.normal)
                                : Vector2((point - origin).normalized());
    // The circle is the first body's where it meets a plane, else the second's.
    const Vector2 at = flat ? Vector2(point - surfaces_.radius * normal) : point;
    return {normal.dot(point - origin) - surfaces_.radius, normal, {at - first, at - second}};
  }

  std::array<PlanarBody, 2> bodies_;
  PlanarSurfaces surfaces_;
  double stiffness_;
  std::vector<double> damping_;
  std::vector<Kept> kept_;
};

}  // namespace

PlanarImpact::PlanarImpact(const PlanarBody& first, const PlanarBody& second,
                           const PlanarSurfaces& surfaces, double stiffness, double damping_number,
                           Contact contact) {
  const Pair pair(first, second, surfaces, stiffness, damping_number, contact);
  // A point deflects by v / omega and the slope of its force is k (1 + X) at first.
  const double points = static_cast<double>(surfaces.points.size());
  const double h = 2e-3 / std::sqrt(stiffness * points * (1 + damping_number) *
                                    (first.inverse_mass + second.inverse_mass));
  State s = pair.state();
  bool touching = false;
  for (int i = 0; i < 100000 && !parted; ++i) {
    const State a = pair.rates(s), b = pair.rates(s + 0.5 * h * a), c = pair.rates(s + 0.5 * h * b);
    s += h / 6 * (a + 2 * b + 2 * c + pair.rates(s + h * c));
    const bool now = pair.touches(s);
    touches += now && !touching;
    touching = now;
    if (now) duration = (i + 1) * h;
    parted = pair.parts(s);
  }
  after = pair.bodies(s);
}

FaceContact::FaceContact(const Body& first, const Body& second, const std::vector<double>& points,
                         double stiffness, double damping_number, const TurningFace& turning) {
  using Vector8 = Eigen::Matrix<double, 8, 1>;  // x1, yaw1, x2, yaw2 and their rates
  const auto of_wall = [&](std::size_t i) {
    return !turning.of_wall.empty() && turning.of_wall[i];
  };
  const auto lever = [&](const Vector8& s, std::size_t i) {
    return points[i] - first.y + (of_wall(i) ? 0 : turning.ahead * s[1]);
  };
  const auto force_at = [&](const Vector8& s, std::size_t i) {
    const double y = points[i], bent = (of_wall(i) ? 0.5 : -0.5) * turning.ahead * s[1] * s[1];
    const double depth = s[0] - s[2] - (y - first.y) * s[1] + (y - second.y) * s[3] + bent;
    const double rate = s[4] - s[6] - lever(s, i) * s[5] + (y - second.y) * s[7];
    return stiffness * std::max(0.0, depth) * std::max(0.0, 1 + damping_number * rate);
  };
  const auto rates = [&](const Vector8& s) {
    Vector8 r;
    r << s.tail<4>(), Eigen::Vector4d::Zero();
    for (std::size_t i = 0; i < points.size(); ++i) {
      const double force = force_at(s, i);
      r[4] -= force * first.inverse_mass;
      r[5] += lever(s, i) * force * first.inverse_inertia;
      r[6] += force * second.inverse_mass;
      r[7] -= (points[i] - second.y) * force * second.inverse_inertia;
    }
    return r;
  };
  Vector8 s = Vector8::Zero();
  s[4] = 1;
  const double h = 1e-3 / std::sqrt(stiffness * (first.inverse_mass + second.inverse_mass));
  bool touched = false;
  for (int i = 0; i < 12000; ++i) {
    const Vector8 a = rates(s), b = rates(s + 0.5 * h * a), c = rates(s + 0.5 * h * b);
    const double force = -a[4] / first.inverse_mass;
    peak_force = std::max(peak_force, force);
    if (force > 0) contact = (i + 1) * h;
    touches += force > 0 && !touched;
    touched = force > 0;
    s += h / 6 * (a + 2 * b + 2 * c + rates(s + h * c));
  }
  speed = {s[4], s[6]};
  yaw_rate = {s[5], s[7]};
  parts = std::ranges::all_of(points, [&](double y) {
    return s[4] - s[6] - (y - first.y) * s[5] + (y - second.y) * s[7] < -0.01;
  });
}

double FaceContact::damping_number(double e) {
  double low = 1e-9, high = 1 / e;
  for (int i = 0; i < 100; ++i) {
    const double middle = (low + high) / 2;
    ((1 + e) * middle > std::log((1 + middle) / (1 - e * middle)) ? low : high) = middle;
  }
  return low;
}

}  // namespace gurney
