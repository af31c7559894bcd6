#include "engine/solver/quadrature.h"
#include "engine/solver/stage_solver.h"

// Contacts of bodies in a stage.
namespace gurney {

void StageSolver::place(const Input& input, const std::vector<Velocity>& v, const Matrix3& frame,
                        const BodyContact::Side& at, Side& side) const {
  const ItemStage& item = items_[at.item];
  side.joints.setZero();
  if (at.caster < 0) {
    side.point = item.mechanism().chassis_point(at, item.pose().rotation);
  } else {
    const auto i = static_cast<std::size_t>(at.caster);
    const CasterDynamics& caster = item.mechanism().casters[i];
    const CasterLanes& lanes = item.lanes_of(at.caster);
    const std::size_t lane = ItemStage::lane_of(at.caster);
    const double swivel =
        input.start->items[at.item].casters[i].swivel_angle + input.tau * v[at.item].joints[i][0];
    side.point = point_of(caster, item.pose(), swivel, at);
    if (caster.swivels())
      side.joints.col(0) = frame * lanes.swivel_axis(lane).cross(side.point - lanes.mount(lane));
    side.joints.col(1) = frame * lanes.axle(lane).cross(side.point - lanes.wheel_center(lane));
    side.joints(2, 1) = 0;  // a wheel that spins comes no nearer
  }
  side.chassis.leftCols<3>() = frame;
  for (int k = 0; k < 3; ++k)
    side.chassis.block<1, 3>(k, 3) = side.point.cross(frame.row(k).transpose()).transpose();
}

Vector3 StageSolver::rates(const BodyContact::Side& at, const Side& side,
                           const std::vector<Velocity>& v) const {
  Vector3 u = side.chassis * v[at.item].chassis;
  if (at.caster >= 0) u += side.joints * v[at.item].joints[static_cast<std::size_t>(at.caster)];
  return u;
}

Vector3 StageSolver::contact_rates(const ContactWork& work, const std::vector<Velocity>& v) const {
  Vector3 u = rates(work.contact->side, work.side, v);
  if (work.contact->between_items()) u -= rates(work.contact->other_side, work.other_side, v);
  return u;
}

/// Angular velocity between the bodies [rad/s].
Vector3 StageSolver::turning(const ContactWork& work, const std::vector<Velocity>& v) const {
  Vector3 w = v[work.contact->side.item].chassis.tail<3>();
  if (work.contact->between_items()) w -= v[work.contact->other_side.item].chassis.tail<3>();
  return w;
}

void StageSolver::set_rolling(ContactWork& work) const {
  const auto roller = assembly_.roller(*work.contact);
  work.rolls = roller.has_value();
  if (!roller) return;
  work.resistance = roller->resistance;
  const Vector3 axis = items_[roller->item].pose().rotation * roller->axis;
  const Vector3& n = work.contact->normal;
  work.resistance.directions = axis.isZero() ? Matrix3(Matrix3::Identity() - n * n.transpose())
                                             : Matrix3(axis * axis.transpose());
}

void StageSolver::add_rolling(const Input& input, std::size_t c, const std::vector<Velocity>& v) {
  ContactWork& work = contacts_[c];
  const BodyContactState& memory = input.start->contacts[input.island->first_contact + c];
  work.rolling = work.resistance.evaluate(memory.lead, turning(work, v), work.force.z(), input.tau);
  items_[work.contact->side.item].add_moment(work.rolling.moment);
  if (work.contact->between_items())
    items_[work.contact->other_side.item].add_moment(-work.rolling.moment);
}

/// Whether the bodies certainly do not touch at the end of the stage, by the normal rate alone, which settles
/// most of the contacts that are near.
bool StageSolver::stays_apart(const ContactWork& work, const std::vector<Velocity>& v) const {
  constexpr double kRounding = 1e-9;  // [m]
  const auto rate = [&](const BodyContact::Side& at, const Side& side) {
    const double of_chassis = side.chassis.row(2).dot(v[at.item].chassis);
    if (at.caster < 0) return of_chassis;
    return of_chassis +
           side.joints.row(2).dot(v[at.item].joints[static_cast<std::size_t>(at.caster)]);
  };
  double u_z = rate(work.contact->side, work.side);
  if (work.contact->between_items()) u_z -= rate(work.contact->other_side, work.other_side);
  return work.stage.compression - work.stage.tau * u_z < -kRounding;
}

void StageSolver::update_contacts(const Input& input, const std::vector<Velocity>& v) {
  const std::size_t first = input.island->first_contact;
  contacts_.resize(input.island->end_contact - first);
  for (std::size_t c = 0; c < contacts_.size(); ++c) {
    const BodyContactState& memory = input.start->contacts[first + c];
    const BodyContact& contact = memory.contact;
    const BodyContact::Side &a = contact.side, &b = contact.other_side;
    ContactWork& work = contacts_[c];
    work.contact = &contact;
    work.law = &assembly_.laws.of(contact);
    work.frame.row(2) = contact.normal.transpose();
    work.frame.row(0) = contact.normal.unitOrthogonal().transpose();
    work.frame.row(1) = work.frame.row(2).cross(work.frame.row(0));
    place(input, v, work.frame, a, work.side);
    double gap = contact.normal.dot(items_[a.item].pose().position + work.side.point);
    if (contact.between_items()) {
      place(input, v, work.frame, b, work.other_side);
      gap -= contact.normal.dot(items_[b.item].pose().position + work.other_side.point);
      if (a.caster >= 0) items_[a.item].keep(a.caster);
      if (b.caster >= 0) items_[b.item].keep(b.caster);
    }
    gap -= contact.offset;
    set_rolling(work);
    work.stage.tau = input.tau;
    work.stage.ahead = input.loads.first ? kSdirkExtrapolation : 0;
    // Laws take the compression at zero rate, so that it ends at compression - tau u_z.
    work.stage.compression = -gap + input.tau * contact_rates(work, v).z();
    work.stage.turned = work.stage.compression - memory.compression;
    work.stage.approach_speed = memory.approach_speed;
    work.stage.deflection = work.frame.topRows<2>() * memory.deflection;
  }
}

void StageSolver::finish_contacts(const Input& input, const std::vector<Velocity>& v,
                                  Output& out) const {
  const std::size_t first = input.island->first_contact;
  out.end.contacts.resize(input.start->contacts.size());
  out.contacts.resize(input.start->contacts.size());
  for (std::size_t c = 0; c < contacts_.size(); ++c) {
    const ContactWork& work = contacts_[c];
    const BodyContact::Side &a = work.contact->side, &b = work.contact->other_side;
    const Vector3 u = contact_rates(work, v);
    const ImpactLaw::Result result = work.law->finish(work.stage, u, work.force);
    BodyContactState& end = out.end.contacts[first + c];
    end = input.start->contacts[first + c];
    end.deflection = work.frame.topRows<2>().transpose() * result.deflection;
    RollingResistance::Result rolling;
    if (work.rolls)  // apart, the pressure only relaxes
      rolling = work.pushes() ? work.rolling
                              : work.resistance.evaluate(end.lead, Vector3::Zero(), 0, input.tau);
    end.lead = rolling.lead;
    end.compression = result.compression;
    end.sliding = result.sliding;
    out.contacts[first + c] = {result.force.z(), u.z(),
                               items_[a.item].pose().position + work.side.point};
    EnergyAccount& power = out.items[a.item].power;
    power.contact_loss += result.sliding_power + result.damping_power + rolling.loss;
    out.items[a.item].spring_rates += result.spring_rates + rolling.spring_rates;
    if (!work.contact->between_items()) continue;
    // Work that one item gives the other is no loss: the sum over both vanishes but for the contact's own power.
    const double given = -result.force.dot(rates(b, work.other_side, v)) -
                         rolling.moment.dot(v[b.item].chassis.tail<3>());
    out.items[b.item].power.work_of_neighbours += given;
    power.work_of_neighbours -= given;
  }
}

}  // namespace gurney
