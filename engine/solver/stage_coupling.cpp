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
    place.chassis = system_.size();
    Eigen::Index size = 6;
    for (std::size_t j = 0; j < assembly_.items[i].casters.size(); ++j) {
      if (!items_[i].kept(static_cast<int>(j))) continue;
      place.joints[j] = place.chassis + size;
      size += 2;
    }
    place.block = system_.add_block(size);
  }
  system_.set_zero();
  auto K = system_.matrix();
  auto right_side = system_.right_side();
  for (std::size_t i : group) {
    const ItemStage& item = items_[i];
    const Eigen::Index at = places_[i].chassis;
    K.block<6, 6>(at, at) = item.matrix();
    right_side.segment<6>(at) = item.right_side();
    for (std::size_t j = 0; j < assembly_.items[i].casters.size(); ++j) {
      if (!item.kept(static_cast<int>(j))) continue;
      const CasterLanes& lanes = item.lanes_of(static_cast<int>(j));
      const std::size_t lane = ItemStage::lane_of(static_cast<int>(j));
      const Eigen::Index joint = places_[i].joints[j];
      K.block<2, 2>(joint, joint) = lanes.joints(lane);
      K.block<6, 2>(at, joint) = lanes.chassis_joints(lane);
      K.block<2, 6>(joint, at) = lanes.joints_chassis(lane);
      right_side.segment<2>(joint) = -lanes.joint_residual(lane);
    }
  }
  for (const ContactWork& work : contacts_) {
    if (!work.contact->between_items() || !work.pushes()) continue;
    const BodyContact::Side &a = work.contact->side, &b = work.contact->other_side;
    if (group_of_[a.item] != group.front()) continue;
    // A contact of two items acts by u = J_a v_a - J_b v_b: beside their own blocks K has -tau J_a' D J_b and its
    // transpose.
    const Matrix3 slope = tau * work.slope;
    const auto couple = [&](Eigen::Index row, const auto& left, Eigen::Index column,
                            const auto& right) {
      constexpr int kLeft = std::remove_cvref_t<decltype(left)>::ColsAtCompileTime;
      constexpr int kRight = std::remove_cvref_t<decltype(right)>::ColsAtCompileTime;
      K.block<kLeft, kRight>(row, column).noalias() -= left.transpose() * (slope * right);
      K.block<kRight, kLeft>(column, row).noalias() -= right.transpose() * (slope * left);
    };
    const Place &pa = places_[a.item], &pb = places_[b.item];
    system_.couple(pa.block, pb.block);
    couple(pa.chassis, work.side.chassis, pb.chassis, work.other_side.chassis);
    if (a.caster >= 0)
      couple(pa.joints[static_cast<std::size_t>(a.caster)], work.side.joints, pb.chassis,
             work.other_side.chassis);
    if (b.caster >= 0)
      couple(pa.chassis, work.side.chassis, pb.joints[static_cast<std::size_t>(b.caster)],
             work.other_side.joints);
    if (a.caster >= 0 && b.caster >= 0)
      couple(pa.joints[static_cast<std::size_t>(a.caster)], work.side.joints,
             pb.joints[static_cast<std::size_t>(b.caster)], work.other_side.joints);
  }
  for (const JointWork& work : joints_) {
    if (group_of_[work.part()] != group.front()) continue;
    const Place &part = places_[work.part()], &base = places_[work.base()];
    system_.couple(part.block, base.block);
    // A joint has -tau sum of dT/du d_p d_b' there.
    Matrix6 slopes = Matrix6::Zero();
    for (std::size_t r = 0; r < work.stage.rows.count; ++r) {
      const JointLaw::Row& row = work.stage.rows.rows[r];
      const Vector6 scaled = tau * work.forces[r].slope * row.part;
      slopes.noalias() += scaled * row.base.transpose();
    }
    K.block<6, 6>(part.chassis, base.chassis) -= slopes;
    K.block<6, 6>(base.chassis, part.chassis) -= slopes.transpose();
  }
  // Couplings have filled the rows of guided directions again.
  for (std::size_t i : group)
    for (int dof = 0; dof < 6; ++dof) {
      if (!items_[i].constrained(dof)) continue;
      const Eigen::Index row = places_[i].chassis + dof;
      K.row(row).setZero();
      K(row, row) = assembly_.items[i].total_mass;
    }
  system_.solve();
  const auto& step = right_side;
  for (std::size_t i : group) {
    items_[i].apply(step.segment<6>(places_[i].chassis), v[i]);
    for (std::size_t j = 0; j < assembly_.items[i].casters.size(); ++j)
      if (items_[i].kept(static_cast<int>(j)))
        v[i].joints[j] += step.segment<2>(places_[i].joints[j]);
  }
}

}  // namespace gurney
