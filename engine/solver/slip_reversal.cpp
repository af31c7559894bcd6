#include "engine/solver/slip_reversal.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/caster/contact_jacobian.h"

namespace gurney {

SlipReversals::SlipReversals(const Assembly& assembly, double time_step)
    : assembly_(assembly), time_step_(time_step) {
  for (const Mechanism& item : assembly.items) {
    double stiffness = 0;
    for (const CasterDynamics& caster : item.casters)
      stiffness += caster.tread().tangential_stiffness();
    stiff_treads_.push_back(item.total_mass < stiffness * time_step * time_step);
  }
}

void SlipReversals::collect_treads(std::size_t item, const State& state, const Course& course) {
  const Mechanism& mechanism = assembly_.items[item];
  const Pose pose = state.pose();
  for (std::size_t i = 0; i < mechanism.casters.size(); ++i) {
    const TreadState& tread = state.casters[i].tread;
    if (!tread.sliding && !tread.rolling) continue;
    const CasterDynamics& caster = mechanism.casters[i];
    const CasterGeometry<double> g = caster.contact(pose, state.casters[i].swivel_angle);
    const auto rates = [&](const Velocity& v) {
      return contact_rates<double>(g, caster.constants().spin_radius,
                                   {splat<double>(v.chassis), v.joints[i][0], v.joints[i][1]});
    };
    const TreadRates<double> u = rates(state.velocity), a = rates(course.acceleration);
    if (tread.sliding)
      slips_.push_back({lane(u.patch, 0), lane(a.patch, 0), Vector3(1, 1, 0).asDiagonal(),
                        course.floor_acceleration});
    if (tread.rolling) {
      const double radius = caster.wheel_radius();
      const Vector3 heading = lane(g.axle_level, 0).cross(Vector3::UnitZ());
      Matrix3 along = Matrix3::Zero();
      along.row(0) = std::copysign(1.0, u.roll) * heading.transpose();
      slips_.push_back({{radius * std::abs(u.roll), 0, 0},
                        {std::copysign(radius * a.roll, u.roll * a.roll), 0, 0},
                        along,
                        course.floor_acceleration});
    }
  }
}

void SlipReversals::collect_contact(const Island& island, const BodyContactState& memory,
                                    const SceneState& state, const std::vector<Course>& courses) {
  const BodyContact& contact = memory.contact;
  const BodyContact::Side &side = contact.side, &other = contact.other_side;
  const bool two = contact.between_items();
  if (!memory.sliding || side.caster >= 0 || !courses[side.item].known) return;
  if (two && (other.caster >= 0 || !courses[other.item].known)) return;
  double mass = assembly_.items[side.item].total_mass;
  if (two) mass = std::min(mass, assembly_.items[other.item].total_mass);
  const double stiffness = assembly_.laws.of(contact).tangential_stiffness() *
                           static_cast<double>(island.end_contact - island.first_contact);
  if (mass >= stiffness * time_step_ * time_step_) return;
  const auto acceleration_of = [&](const BodyContact::Side& at) -> Vector3 {
    const Vector6& a = courses[at.item].acceleration.chassis;
    const Vector3 point = assembly_.items[at.item].point(at, state.items[at.item]);
    return a.head<3>() + a.tail<3>().cross(point);
  };
  const Vector3& floor = courses[side.item].floor_acceleration;
  Vector3 acceleration = acceleration_of(side);
  double left_behind = 1;  // share of the floor's acceleration that the slip feels
  if (two) {
    const Vector3 of_other = acceleration_of(other);
    const auto slides = [&](const Vector3& a) { return a.norm() < 0.5 * floor.norm() ? 0.0 : 1.0; };
    left_behind = slides(acceleration) - slides(of_other);
    acceleration -= of_other;
  }
  const Matrix3 tangents = Matrix3::Identity() - contact.normal * contact.normal.transpose();
  slips_.push_back({tangents * assembly_.velocity(contact, state), tangents * acceleration,
                    left_behind * tangents, floor});
}

void SlipReversals::collect(const Island& island, const SceneState& state,
                            const std::vector<Course>& courses) {
  slips_.clear();
  for (std::size_t i : island.items)
    if (stiff_treads_[i] && courses[i].known) collect_treads(i, state.items[i], courses[i]);
  for (std::size_t c = island.first_contact; c < island.end_contact; ++c)
    collect_contact(island, state.contacts[c], state, courses);
}

double SlipReversals::first(const Vector3& floor) const {
  double earliest = std::numeric_limits<double>::infinity();
  for (const Slip& slip : slips_) {
    const Vector3 a = slip.acceleration + slip.of_floor * (slip.floor_acceleration - floor);
    const double approach = -slip.velocity.dot(a);
    if (approach > 0) earliest = std::min(earliest, approach / a.squaredNorm());
  }
  return earliest;
}

}  // namespace gurney
