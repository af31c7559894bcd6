#include "engine/solver/stage_solver.h"

// Contacts of bodies in a stage.
namespace gurney {

void StageSolver::update_contacts(const Input& input, const Velocity& v) {
  const State& start = *input.start;
  contacts_.resize(input.contacts ? input.contacts->size() : 0);
  for (std::size_t c = 0; c < contacts_.size(); ++c) {
    const BodyContact& contact = (*input.contacts)[c];
    ContactWork& work = contacts_[c];
    work.law = &mechanism_.law_of(contact);
    work.frame.row(2) = contact.normal.transpose();
    work.frame.row(0) = contact.normal.unitOrthogonal().transpose();
    work.frame.row(1) = work.frame.row(2).cross(work.frame.row(0));
    work.jacobian_joints.setZero();
    if (contact.leg < 0) {
      work.point = pose_.rotation * contact.local;
    } else {
      const auto i = static_cast<std::size_t>(contact.leg);
      const Leg& leg = mechanism_.legs[i];
      const Leg::Geometry& g = legs_[i].g;
      const double swivel = start.legs[i].swivel_angle + input.tau * v.joints[i][0];
      work.point = leg.point(pose_, swivel, contact.local);
      if (leg.swivels())
        work.jacobian_joints.col(0) = work.frame * g.swivel_axis.cross(work.point - g.mount);
      work.jacobian_joints.col(1) = work.frame * g.axle.cross(work.point - g.wheel_center);
    }
    work.jacobian_chassis.leftCols<3>() = work.frame;
    for (int k = 0; k < 3; ++k)
      work.jacobian_chassis.block<1, 3>(k, 3) =
          work.point.cross(work.frame.row(k).transpose()).transpose();

    const BodyContactState& memory = start.contacts[c];
    const double gap = contact.normal.dot(pose_.position + work.point) - contact.offset;
    work.stage.tau = input.tau;
    work.stage.compression = -gap + input.tau * contact_rates(work, contact, v).z();
    work.stage.approach_speed = memory.approach_speed;
    work.stage.deflection = work.frame.topRows<2>() * memory.deflection;
  }
}

Vector3 StageSolver::contact_rates(const ContactWork& work, const BodyContact& contact,
                                   const Velocity& v) const {
  Vector3 u = work.jacobian_chassis * v.chassis;
  if (contact.leg >= 0) u += work.jacobian_joints * v.joints[static_cast<std::size_t>(contact.leg)];
  return u;
}

double StageSolver::finish_contacts(const Input& input, const Velocity& v, Output& out) const {
  double rates = 0;
  out.end.contacts.resize(contacts_.size());
  out.contacts.resize(contacts_.size());
  for (std::size_t c = 0; c < contacts_.size(); ++c) {
    const ContactWork& work = contacts_[c];
    const BodyContact& contact = (*input.contacts)[c];
    const Vector3 u = contact_rates(work, contact, v);
    const ImpactLaw::Result result = work.law->finish(work.stage, u);
    BodyContactState& end = out.end.contacts[c];
    end = input.start->contacts[c];
    end.contact = contact;
    end.deflection = work.frame.topRows<2>().transpose() * result.deflection;
    end.compression = result.compression;
    out.contacts[c] = {result.force.z(), u.z(), pose_.position + work.point};
    out.power.contact_loss += result.sliding_power + result.damping_power;
    rates += result.spring_rates;
  }
  return rates;
}

}  // namespace gurney
