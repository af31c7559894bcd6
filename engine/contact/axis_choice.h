#pragma once

#include <limits>

#include "engine/base/vector.h"

namespace gurney {

/// Axis along which two convex bodies meet, among those that may separate them.
///
/// Bodies that overlap, or that stay apart along some axis, meet along the one that separates them
/// most, or on which they overlap least. Where several axes separate them and `motion` closes all -
/// two bodies that pass each other at a corner - they meet along the one it closes last.
class AxisChoice {
 public:
  /// An axis with a handicap is taken only when it is better by this: the choice between equal ones
  /// does not flicker [m].
  static constexpr double kHandicap = 1e-6;

  /// @param motion  displacement of a relative to b until one asks again [m]
  AxisChoice(const Vector3& motion, double margin) : motion_(motion), margin_(margin) {}

  /// @param normal  unit, from b to a
  /// @param gap     distance of the bodies along it, negative where they overlap [m]
  /// @returns false when they are farther apart than the margin
  bool consider(const Vector3& normal, double gap, double handicap, int kind = 0) {
    if (!(gap <= margin_)) return false;
    if (gap > widest_.value + handicap) widest_ = {gap, normal, kind};
    if (gap > 0) {
      const double approach = -normal.dot(motion_);
      if (!(approach > gap)) {
        stays_apart_ = true;
      } else if (gap / approach > last_.value + handicap / approach) {
        last_ = {gap / approach, normal, kind};
      }
    }
    return true;
  }

  const Vector3& normal() const { return chosen().normal; }
  int kind() const { return chosen().kind; }
  /// Displacement of a until they meet, if they do.
  Vector3 shift() const { return meets() ? Vector3(last_.value * motion_) : Vector3::Zero(); }

 private:
  struct Best {
    double value;
    Vector3 normal;
    int kind;
  };

  bool meets() const { return widest_.value > 0 && !stays_apart_; }
  const Best& chosen() const { return meets() ? last_ : widest_; }

  Vector3 motion_;
  double margin_;
  Best widest_{-std::numeric_limits<double>::infinity(), Vector3::UnitZ(), 0};
  Best last_ = widest_;  // value: when, as a part of the motion
  bool stays_apart_ = false;
};

}  // namespace gurney
