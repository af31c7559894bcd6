#pragma once

#include <cstddef>
#include <limits>
#include <string>

#include "engine/base/vector.h"

namespace gurney {

/// Joins a part of an item to the body that carries it: a drawer, a door, an arm, a mast, a bag.
/// Body and part are items of the scene whose item axes coincide at the start, where the coordinate q
/// of the joint is 0.
struct Joint {
  enum class Kind {
    kFixed,     ///< no motion
    kHinge,     ///< q turns about the axis through the point [rad]
    kSlider,    ///< q moves along the axis [m]
    kBall,      ///< turns about the point in all directions
    kFlexible,  ///< bends in the point like a mast along the axis, about which it does not twist
  };
  static constexpr double kFree = std::numeric_limits<double>::infinity();

  Kind kind = Kind::kFixed;
  std::string name;                 ///< in results
  std::size_t base = 0;             ///< index in Scene::items of what carries the part
  std::size_t part = 0;             ///< > base; an item is the part of one joint at most
  Vector3 point = Vector3::Zero();  ///< item axes [m]
  Vector3 axis = Vector3::UnitZ();  ///< unit, item axes; of hinges, sliders and flexible joints
  // In the directions that are left free, of q or of the bending angle: forces in N with q in m,
  // moments in N m with angles in rad.
  double stiffness = 0;                  ///< of a spring that rests at `rest`, >= 0
  double rest = 0;                       ///< of hinges and sliders
  double damping = 0;                    ///< viscous, >= 0
  double friction = 0;                   ///< dry, >= 0; of hinges and sliders
  double lower = -kFree, upper = kFree;  ///< stops of hinges and sliders, lower <= 0 <= upper
  double stop_stiffness = 1e5;           ///< of a stop, > 0
  double restitution = 0.3;              ///< of a stop, 0.01..1
  /// The most that a latch at q = 0 holds, >= 0; 0: none; infinite: locked. Of hinges and sliders.
  double latch = 0;
  bool relatches = false;  ///< it catches the part when that comes back slowly
};

}  // namespace gurney
