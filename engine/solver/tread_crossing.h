#pragma once

#include <array>
#include <vector>

#include "engine/solver/assembly.h"
#include "engine/solver/island.h"
#include "engine/solver/item_stage.h"

namespace gurney {

/// Times at which wheels leave the floor and land. There the force of a tread has a kink: a step of
/// length h with the kink inside gives a wheel that crosses with the speed v an error of up to
/// v (omega h)^2 / 8, omega being the frequency of the item on its treads, and with it the wheel
/// flies on. A step that ends at the kink has none inside.
class TreadCrossings {
 public:
  explicit TreadCrossings(const Assembly& assembly) : items_(assembly.items.size()) {}

  /// Slower crossings stay inside a step [m/s].
  static constexpr double kLeastSpeed = 0.001;
  /// A crossing nearer than this fraction of the step to one of its ends stays inside: its error
  /// is this squared of that in the middle.
  static constexpr double kNearEnd = 0.02;

  /// Takes the end of an accepted step of an item.
  /// @param floor_up  acceleration of the floor at its end [m/s2]
  void observe(std::size_t item, std::size_t casters, double duration,
               const ItemStage::Output& first, const ItemStage::Output& end, double floor_up);

  /// Whether a wheel of the island may cross the floor within `duration`.
  bool near(const Island& island, double duration) const;
  /// Time until the first one does within `duration`, under the floor's mean acceleration upwards
  /// until then; infinite if none does [s].
  double first(const Island& island, double floor_up, double duration) const;

 private:
  struct Wheel {
    double compression = 0, rate = 0, acceleration = 0;  // [m], [m/s], [m/s2]
  };
  struct Item {
    std::size_t wheels = 0;
    std::array<Wheel, kMaxCasters> wheel;
    double floor_up = 0;  // for which those accelerations hold [m/s2]
  };
  std::vector<Item> items_;
};

}  // namespace gurney
