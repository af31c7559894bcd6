#include <Eigen/LU>

#include "engine/solver/stage_solver.h"

// Newton's step of an island of several items.
namespace gurney {
namespace {

/// Where the unknowns of an item are in the island's system: its chassis, then its kept joints.
struct Place {
  Eigen::Index chassis = 0;
  std::array<Eigen::Index, kMaxCasters> joints{};
};

}  // namespace

void StageSolver::coupled_step(const Island& island, double tau, std::vector<Velocity>& v) {
  std::vector<Place> places(items_.size());
  Eigen::Index size = 0;
  for (std::size_t i : island.items) {
    places[i].chassis = size;
    size += 6;
    for (std::size_t j = 0; j < assembly_.items[i].casters.size(); ++j) {
      if (!items_[i].kept(static_cast<int>(j))) continue;
      places[i].joints[j] = size;
      size += 2;
    }
  }
  Eigen::MatrixXd K = Eigen::MatrixXd::Zero(size, size);
  Eigen::VectorXd right_side = Eigen::VectorXd::Zero(size);
  for (std::size_t i : island.items) {
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
    if (!work.contact->between_items()) continue;
    const BodyContact::Side &a = work.contact->side, &b = work.contact->other_side;
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
  for (std::size_t i : island.items)
    for (int dof = 0; dof < 6; ++dof) {
      if (!items_[i].constrained(dof)) continue;
      const Eigen::Index row = places[i].chassis + dof;
      K.row(row).setZero();
      K(row, row) = assembly_.items[i].total_mass;
    }
  const Eigen::VectorXd step = K.partialPivLu().solve(right_side);
  for (std::size_t i : island.items) {
    items_[i].apply(step.segment<6>(places[i].chassis), v[i]);
    for (std::size_t j = 0; j < assembly_.items[i].casters.size(); ++j)
      if (items_[i].kept(static_cast<int>(j)))
        v[i].joints[j] += step.segment<2>(places[i].joints[j]);
  }
}

}  // namespace gurney
