#pragma once

#include <vector>

#include "engine/contact/body_contact.h"
#include "engine/contact/body_form.h"
#include "engine/solver/travel.h"

namespace gurney {

/// Points of an item that may touch the flat floor besides a wheel on its tread: the corners of the
/// chassis' boxes and hulls, the lowest points of its spheres and of both ends of its cylinders, points
/// on the rim of an end that stands flat, and points on both rims of a wheel that lies on its side
/// (CasterDynamics::lies), where the contact on one point of the tread has ended.
///
/// Corners against a plane are exact and always all of them, which Bullet's plane algorithm is not;
/// so this contact is analytic like that of wheels.
class FloorPoints {
 public:
  /// @param item  index of the item, for its contacts
  FloorPoints(const EquipmentModel& model, const Mechanism& mechanism, std::size_t item);

  /// Appends the contacts of points lower than `margin` above the floor [m].
  /// @param travel  of the item up to `state`
  void collect(const State& state, const Travel& travel, double margin,
               std::vector<BodyContact>& contacts);

 private:
  /// A cylinder or a sphere, chassis axes.
  struct Round {
    int shape;  // index in EquipmentModel::shape
    BodyForm form;
  };
  /// Its points that may touch.
  void add_points(const Round& round, const Matrix3& rotation,
                  std::vector<BodyContact::Side>& sides) const;

  const Mechanism& mechanism_;
  std::size_t item_;
  std::vector<Vector3> corners_;  // chassis axes, relative to its centre
  std::vector<Round> rounds_;
  Clearance clearance_;  // of the lowest point
};

}  // namespace gurney
