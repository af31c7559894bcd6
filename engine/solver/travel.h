#pragma once

#include <array>
#include <limits>
#include <vector>

#include "engine/solver/assembly.h"

namespace gurney {

/// How far an item has moved, summed over its steps.
struct Travel {
  double path = 0;   ///< of the chassis' centre [m]
  double turn = 0;   ///< of the chassis, sum of 2 sin(angle / 2) [-]
  double swing = 0;  ///< of the points of its casters about their swivels, at most [m]

  /// How far a point of the chassis at most `reach` from its centre has moved at most: a rotation
  /// moves it along a chord of 2 r sin(angle / 2).
  double chassis(double reach) const { return path + reach * turn; }
};

/// The travel of each item of a scene between the states that it is shown.
class Travels {
 public:
  /// @param known  else each has moved infinitely far at any time
  Travels(const Assembly& assembly, bool known);

  void observe(const SceneState& state);
  const Travel& of(std::size_t item) const { return items_[item].travel; }

 private:
  struct Item {
    Travel travel;
    Vector3 position = Vector3::Zero();
    Quaternion rotation = Quaternion::Identity();
    std::array<double, kMaxCasters> swivel_angles{};
  };
  const Assembly& assembly_;
  std::vector<Item> items_;
};

/// Two things that were apart by a gap when it was measured, and that are so by what is left of it
/// after they have moved: their search for contacts can be left out.
class Clearance {
 public:
  /// Rounding of gaps and sums of travel in 64 bits, and the part that gaps omit (ChassisPoints).
  static constexpr double kRounding = 1e-5;  // [m]

  void measure(double gap, double travelled) { until_ = gap + travelled; }
  /// Whether the gap is still larger than `margin` for sure.
  bool exceeds(double margin, double travelled) const {
    return until_ - travelled > margin + kRounding;
  }

 private:
  double until_ = -std::numeric_limits<double>::infinity();
};

}  // namespace gurney
