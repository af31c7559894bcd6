#include <algorithm>
#include <ranges>
#include <utility>

#include "engine/solver/stage_solver.h"

// Newton's step of an island of several items: of those that push each other together.
namespace gurney {
namespace {

/// x of a x = b by LU with partial pivoting in place: Eigen's would allocate in each step.
void solve_in_place(Eigen::Map<Eigen::MatrixXd> a, Eigen::Map<Eigen::VectorXd> x) {
  const Eigen::Index size = a.rows();
  for (Eigen::Index k = 0; k < size; ++k) {
    const Eigen::Index below = size - k - 1;
    Eigen::Index pivot = 0;
    a.col(k).tail(below + 1).cwiseAbs().maxCoeff(&pivot);
    if (pivot != 0) {
      a.row(k).swap(a.row(k + pivot));
      std::swap(x[k], x[k + pivot]);
    }
    if (a(k, k) != 0) a.col(k).tail(below) /= a(k, k);
    for (Eigen::Index j = k + 1; j < size; ++j)
      if (a(k, j) != 0) a.col(j).tail(below) -= a(k, j) * a.col(k).tail(below);
    x.tail(below) -= x[k] * a.col(k).tail(below);
  }
  for (Eigen::Index k = size - 1; k >= 0; --k) {
    x[k] /= a(k, k);
    x.head(k) -= x[k] * a.col(k).head(k);
  }
}

}  // namespace

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
  std::vector<Place>& places = places_;
  Eigen::Index size = 0;
  // What hangs or stands on others comes later in the scene and is eliminated first: then most of the matrix stays zero.
  for (std::size_t i : std::views::reverse(group)) {
    places[i].chassis = size;
    size += 6;
    for (std::size_t j = 0; j < assembly_.items[i].casters.size(); ++j) {
      if (!items_[i].kept(static_cast<int>(j))) continue;
      places[i].joints[j] = size;
      size += 2;
    }
  }
  const auto unknowns = static_cast<std::size_t>(size);
  matrix_.assign(unknowns * unknowns, 0.0);
  right_side_.resize(unknowns);
  Eigen::Map<Eigen::MatrixXd> K(matrix_.data(), size, size);
  Eigen::Map<Eigen::VectorXd> right_side(right_side_.data(), size);
  for (std::size_t i : group) {
    const ItemStage& item = items_[i];
    const Eigen::Index at = places[i].chassis;
    K.block<6, 6>(at, at) = item.matrix();
    right_side.segment<6>(at) = item.right_side();
    for (std::size_t j = 0; j < assembly_.items[i].casters.size(); ++j) {
      if (!item.kept(static_cast<int>(j))) continue;
      const CasterLanes& lanes = item.lanes_of(static_cast<int>(j));
      const std::size_t lane = ItemStage::lane_of(static_cast<int>(j));
      const Eigen::Index joint = places[i].joints[j];
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
    const Matrix3 slope = tau * work.slope;
    const auto couple = [&](Eigen::Index row, const auto& left, Eigen::Index column,
                            const auto& right) {
      K.block(row, column, left.cols(), right.cols()) -= left.transpose() * slope * right;
      K.block(column, row, right.cols(), left.cols()) -= right.transpose() * slope * left;
    };
    const Place &pa = places[a.item], &pb = places[b.item];
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
    const Eigen::Index part = places[work.part()].chassis, base = places[work.base()].chassis;
    for (std::size_t r = 0; r < work.stage.rows.count; ++r) {
      const JointLaw::Row& row = work.stage.rows.rows[r];
      const double slope = tau * work.forces[r].slope;
      K.block<6, 6>(part, base) -= slope * row.part * row.base.transpose();
      K.block<6, 6>(base, part) -= slope * row.base * row.part.transpose();
    }
  }
  for (std::size_t i : group)
    for (int dof = 0; dof < 6; ++dof) {
      if (!items_[i].constrained(dof)) continue;
      const Eigen::Index row = places[i].chassis + dof;
      K.row(row).setZero();
      K(row, row) = assembly_.items[i].total_mass;
    }
  solve_in_place(K, right_side);
  const auto& step = right_side;
  for (std::size_t i : group) {
    items_[i].apply(step.segment<6>(places[i].chassis), v[i]);
    for (std::size_t j = 0; j < assembly_.items[i].casters.size(); ++j)
      if (items_[i].kept(static_cast<int>(j)))
        v[i].joints[j] += step.segment<2>(places[i].joints[j]);
  }
}

}  // namespace gurney
