#include <algorithm>
#include <ranges>
#include <type_traits>

#include "engine/solver/stage_solver.h"

// Newton's step of an island of several items: of those that push each other together.
namespace gurney {
void StageSolver::coupled_steps(const Island& island, double tau, std::vector<Velocity>& v) {
  // Pairs that may touch in this step and do not have equations of their own. A pair costs as much
  // either way.
  for (std::size_t i : island.items) group_of_[i] = island.items.size() > 2 ? i : island.items[0];
  const auto merge = [&](std::size_t a, std::size_t b) {
    for (std::size_t i : island.items)
      if (group_of_[i] == std::max(a, b)) group_of_[i] = std::min(a, b);
  };
  for (const JointWork& work : joints_) merge(group_of_[work.base()], group_of_[work.part()]);
  for (const ContactWork& work : contacts_) {
    if (!work.pushes() || !work.contact->between_items()) continue;
    const std::size_t a = group_of_[work.contact->side.item],
                      b = group_of_[work.contact->other_side.item];
    merge(a, b);
  }
  for (std::size_t first : island.items) {
    if (group_of_[first] != first) continue;
    group_.clear();
    for (std::size_t i : island.items)
      if (group_of_[i] == first) group_.push_back(i);
    if (group_.size() == 1 && !items_[first].keeps_joints())
      single_step(first, v);
    else
      coupled_step(group_, tau, v);
  }
}

void StageSolver::coupled_step(const std::vector<std::size_t>& group, double tau,
                               std::vector<Velocity>& v) {
  // Items that hang or stand on others come later in the scene and are eliminated first.
  system_.clear();
  for (std::size_t i : std::views::reverse(group)) {
    Place& place = places_[i];
    Eigen::Index size = 6;
    for (std::size_t j = 0; j < assembly_.items[i].casters.size(); ++j) {
      if (!items_[i].kept(static_cast<int>(j))) continue;
      place.joints[j] = size;
      size += 2;
    }
    place.block = system_.add_block(size);
  }
  system_.set_zero();
  for (std::size_t i : group) {
    const ItemStage& item = items_[i];
    const Place& place = places_[i];
    auto K = system_.block(place.block, place.block);
    auto right_side = system_.right_side(place.block);
    K.topLeftCorner<6, 6>() = item.matrix();
    right_side.head<6>() = item.right_side();
    for (std::size_t j = 0; j < assembly_.items[i].casters.size(); ++j) {
      if (!item.kept(static_cast<int>(j))) continue;
      const CasterLanes& lanes = item.lanes_of(static_cast<int>(j));
      const std::size_t lane = ItemStage::lane_of(static_cast<int>(j));
      const Eigen::Index joint = place.joints[j];
      K.block<2, 2>(joint, joint) = lanes.joints(lane);
      K.block<6, 2>(0, joint) = lanes.chassis_joints(lane);
      K.block<2, 6>(joint, 0) = lanes.joints_chassis(lane);
      right_side.segment<2>(joint) = -lanes.joint_residual(lane);
    }
  }
  for (const ContactWork& work : contacts_) {
    if (!work.contact->between_items() || !work.pushes()) continue;
    if (group_of_[work.contact->side.item] == group.front()) couple(work, tau);
  }
  for (const JointWork& work : joints_)
    if (group_of_[work.part()] == group.front()) couple(work, tau);
  // Couplings have filled the rows of guided directions again.
  for (std::size_t i : group)
    for (int dof = 0; dof < 6; ++dof) {
      if (!items_[i].constrained(dof)) continue;
      const std::size_t own = places_[i].block;
      for (std::size_t other = 0; other < system_.count(); ++other)
        if (system_.coupled(own, other)) system_.block(own, other).row(dof).setZero();
      system_.block(own, own)(dof, dof) = assembly_.items[i].total_mass;
    }
  system_.solve();
  for (std::size_t i : group) {
    const auto step = system_.right_side(places_[i].block);
    items_[i].apply(step.head<6>(), v[i]);
    for (std::size_t j = 0; j < assembly_.items[i].casters.size(); ++j)
      if (items_[i].kept(static_cast<int>(j)))
        v[i].joints[j] += step.segment<2>(places_[i].joints[j]);
  }
}

/// A contact of two items acts by u = J_a v_a - J_b v_b: beside their own blocks K has -tau J_a' D J_b and
/// -tau J_b' D J_a.
void StageSolver::couple(const ContactWork& work, double tau) {
  const BodyContact::Side &a = work.contact->side, &b = work.contact->other_side;
  const Place &pa = places_[a.item], &pb = places_[b.item];
  system_.couple(pa.block, pb.block);
  auto K_ab = system_.block(pa.block, pb.block), K_ba = system_.block(pb.block, pa.block);
  K_ab.topLeftCorner<6, 6>() -=
      slope_between(work.in_floor_axes, work.side.point, work.other_side.point);
  K_ba.topLeftCorner<6, 6>() -=
      slope_between(work.in_floor_axes, work.other_side.point, work.side.point);
  if (work.rolls) {
    const Matrix3 turning = tau * work.rolling.slope;
    K_ab.block<3, 3>(3, 3) -= turning;
    K_ba.block<3, 3>(3, 3) -= turning;
  }
  if (a.caster < 0 && b.caster < 0) return;
  const Matrix3 slope = tau * work.slope;
  const auto add = [&](Eigen::Index row, const auto& left, Eigen::Index column, const auto& right) {
    constexpr int kLeft = std::remove_cvref_t<decltype(left)>::ColsAtCompileTime;
    constexpr int kRight = std::remove_cvref_t<decltype(right)>::ColsAtCompileTime;
    K_ab.block<kLeft, kRight>(row, column) -= left.transpose() * (slope * right);
    K_ba.block<kRight, kLeft>(column, row) -= right.transpose() * (slope * left);
  };
  const auto joint = [](const Place& place, int caster) {
    return place.joints[static_cast<std::size_t>(caster)];
  };
  if (a.caster >= 0) add(joint(pa, a.caster), work.side.joints, 0, work.other_side.chassis);
  if (b.caster >= 0) add(0, work.side.chassis, joint(pb, b.caster), work.other_side.joints);
  if (a.caster >= 0 && b.caster >= 0)
    add(joint(pa, a.caster), work.side.joints, joint(pb, b.caster), work.other_side.joints);
}

/// A joint has -tau sum of dT/du d_p d_b' there.
void StageSolver::couple(const JointWork& work, double tau) {
  const std::size_t part = places_[work.part()].block, base = places_[work.base()].block;
  Matrix6 slopes = Matrix6::Zero();
  for (std::size_t r = 0; r < work.stage.rows.count; ++r) {
    const JointLaw::Row& row = work.stage.rows.rows[r];
    const Vector6 scaled = tau * work.forces[r].slope * row.part;
    slopes.noalias() += scaled * row.base.transpose();
  }
  system_.couple(part, base);
  system_.block(part, base).topLeftCorner<6, 6>() -= slopes;
  system_.block(base, part).topLeftCorner<6, 6>() -= slopes.transpose();
}

}  // namespace gurney
