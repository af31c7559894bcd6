#include "tests/peers/cone.h"

#include <cmath>
#include <numbers>

namespace gurney::peers {
namespace {

Vector2 direction(double angle) { return {std::cos(angle), std::sin(angle)}; }

/// Impulse of a contact that slides in the direction e, and its tangential velocity.
struct Sliding {
  Vector3 impulse;
  Vector2 velocity;
};

Sliding sliding(const ContactBlock& c, const Vector2& e) {
  const double normal =
      -c.start.z() / (c.block(2, 2) - c.friction * c.block.row(2).head<2>().dot(e));
  Vector3 p;
  p << -c.friction * normal * e, normal;
  return {p, c.start.head<2>() + c.block.topRows<2>() * p};
}

/// Zero where the contact slides in the direction that was supposed, or against it.
double aside(const ContactBlock& c, double angle) {
  const Vector2 e = direction(angle), v = sliding(c, e).velocity;
  return e.x() * v.y() - e.y() * v.x();
}

bool ahead(const ContactBlock& c, double angle) {
  const Vector2 e = direction(angle);
  return e.dot(sliding(c, e).velocity) >= 0;
}

/// By the secant method from a guess; not a number where it does not converge.
double by_secant(const ContactBlock& c, double angle) {
  double last = angle - 1e-3, value = aside(c, last);
  for (int i = 0; i < 20; ++i) {
    const double here = aside(c, angle);
    if (here == value) return angle;
    const double next = angle - here * (angle - last) / (here - value);
    last = angle;
    value = here;
    angle = next;
    if (std::abs(angle - last) < 1e-14) return angle;
  }
  return NAN;
}

double by_bisection(const ContactBlock& c) {
  constexpr int kParts = 72;
  constexpr double kPart = 2 * std::numbers::pi / kParts;
  for (int i = 0; i < kParts; ++i) {
    double low = i * kPart, high = low + kPart;
    const double at_low = aside(c, low);
    if (at_low * aside(c, high) > 0) continue;
    for (int k = 0; k < 50; ++k) {
      const double middle = 0.5 * (low + high);
      (at_low * aside(c, middle) > 0 ? low : high) = middle;
    }
    if (ahead(c, low)) return low;
  }
  return NAN;
}

}  // namespace

Vector3 cone_impulse(const ContactBlock& contact) {
  if (contact.start.z() >= 0) return Vector3::Zero();
  const Vector3 stuck = contact.block.inverse() * -contact.start;
  if (stuck.z() > 0 && stuck.head<2>().norm() <= contact.friction * stuck.z()) return stuck;
  double angle = by_secant(contact, std::atan2(-stuck.y(), -stuck.x()));
  if (!std::isfinite(angle) || !ahead(contact, angle)) angle = by_bisection(contact);
  return sliding(contact, direction(angle)).impulse;
}

}  // namespace gurney::peers
