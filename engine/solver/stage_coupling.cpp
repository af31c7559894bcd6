#include <algorithm>
#include <cmath>
#include <ranges>
#include <type_traits>

#include "engine/solver/solve6.h"
#include "engine/solver/stage_solver.h"

// Newton's step of an island: of its item, or of all that may push or hold each other together.
namespace gurney {
namespace {

/// Stages whose lengths differ by less than this part of them begin with the same matrix.
constexpr double kLikeTau = 0.01;

}  // namespace

void StageSolver::set_matrices(const Input& input) {
  for (std::size_t i : input.island->items) items_[i].begin_matrix();
  for (ContactWork& work : contacts_) {
    if (!work.pushes()) continue;
    const Matrix3 slope = input.tau * work.slope;
    work.in_floor_axes = work.frame.transpose() * slope * work.frame;
    const auto add = [&](const BodyContact::Side& at, const Side& side) {
      items_[at.item].add_slope(slope_between(work.in_floor_axes, side.point, side.point));
      if (work.rolls) items_[at.item].add_turning_slope(input.tau * work.rolling.slope);
      if (at.caster >= 0)
        items_[at.item].add_joint_slope(at.caster, side.chassis, side.joints, slope);
    };
    add(work.contact->side, work.side);
    if (work.contact->between_items()) add(work.contact->other_side, work.other_side);
  }
  add_joint_slopes();
  for (std::size_t i : std::views::reverse(riders_))
    items_[carriers_[i]].carry_matrix(arms_[i], items_[i].matrix());
  for (const JointWork& work : joints_)
    if (within_one(work)) {
      const Matrix6 slopes = coupling(work, input.tau);
      items_[roots_[work.part()]].add_slope(slopes + slopes.transpose());
    }
  for (std::size_t i : free_) items_[i].eliminate();
}

void StageSolver::newton_step(const Input& input, bool anew, std::vector<Velocity>& v) {
  if (anew) set_matrices(input);
  for (std::size_t i : free_) items_[i].eliminate_residual();
  if (free_.size() == 1) {
    const ItemStage& item = items_[free_.front()];
    item.apply(solve6(item.matrix(), item.right_side()), v[free_.front()]);
    follow(v);
    return;
  }
  if (anew) factor(input);
  Factors& factors = factors_[free_.front()];
  for (std::size_t p = 0; p < free_.size(); ++p) {
    const ItemStage& item = items_[free_[p]];
    auto right_side = factors.system.right_side(block_of_[free_[p]]);
    right_side.head<6>() = item.right_side();
    for_kept(factors.layouts[p], [&](int j, Eigen::Index at) {
      right_side.segment<2>(at) = -item.lanes_of(j).joint_residual(ItemStage::lane_of(j));
    });
  }
  factors.system.solve();
  for (std::size_t p = 0; p < free_.size(); ++p) {
    const std::size_t i = free_[p];
    const auto step = factors.system.right_side(block_of_[i]);
    items_[i].apply(step.head<6>(), v[i]);
    for_kept(factors.layouts[p], [&](int j, Eigen::Index at) {
      v[i].joints[static_cast<std::size_t>(j)] += step.segment<2>(at);
    });
  }
  follow(v);
}

StageSolver::Layout StageSolver::layout_of(std::size_t item) const {
  Layout layout;
  for (std::size_t j = 0; j < assembly_.items[item].casters.size(); ++j) {
    if (!items_[item].kept(static_cast<int>(j))) continue;
    layout.joints[j] = layout.size;
    layout.size += 2;
  }
  return layout;
}

bool StageSolver::has_factors(const Input& input) const {
  const Factors& factors = factors_[free_.front()];
  if (free_.size() == 1 || factors.items != free_) return false;
  if (std::abs(factors.tau - input.tau) > kLikeTau * input.tau) return false;
  return std::ranges::equal(free_, factors.layouts, {},
                            [&](std::size_t i) { return layout_of(i); });
}

void StageSolver::factor(const Input& input) {
  Factors& factors = factors_[free_.front()];
  BlockSystem& system = factors.system;
  factors.items = free_;
  factors.tau = input.tau;
  factors.layouts.clear();
  for (std::size_t i : free_) factors.layouts.push_back(layout_of(i));
  // Items that hang or stand on others come later in the scene and are eliminated first.
  system.clear();
  for (std::size_t p = free_.size(); p-- > 0;) system.add_block(factors.layouts[p].size);
  system.set_zero();
  for (std::size_t p = 0; p < free_.size(); ++p) {
    const ItemStage& item = items_[free_[p]];
    const std::size_t own = block_of_[free_[p]];
    auto K = system.block(own, own);
    K.topLeftCorner<6, 6>() = item.matrix();
    for_kept(factors.layouts[p], [&](int j, Eigen::Index at) {
      const CasterLanes& lanes = item.lanes_of(j);
      const std::size_t lane = ItemStage::lane_of(j);
      K.block<2, 2>(at, at) = lanes.joints(lane);
      K.block<6, 2>(0, at) = lanes.chassis_joints(lane);
      K.block<2, 6>(at, 0) = lanes.joints_chassis(lane);
    });
  }
  for (const ContactWork& work : contacts_)
    if (work.contact->between_items() && work.pushes()) couple(work, factors);
  for (const JointWork& work : joints_) couple(work, factors);
  // Couplings have filled the rows of guided directions again.
  for (std::size_t i : free_)
    for (int dof = 0; dof < 6; ++dof) {
      if (!items_[i].constrained(dof)) continue;
      const std::size_t own = block_of_[i];
      for (std::size_t other = 0; other < system.count(); ++other)
        if (system.coupled(own, other)) system.block(own, other).row(dof).setZero();
      system.block(own, own)(dof, dof) = assembly_.items[i].total_mass;
    }
  system.factor();
}

/// A contact of two items acts by u = J_a v_a - J_b v_b: beside their own blocks K has -tau J_a' D J_b and
/// -tau J_b' D J_a.
void StageSolver::couple(const ContactWork& work, Factors& factors) {
  const BodyContact::Side &a = work.contact->side, &b = work.contact->other_side;
  const std::size_t of_a = block_of_[roots_[a.item]], of_b = block_of_[roots_[b.item]];
  const Vector3 at_a = from_root(a.item, work.side.point),
                at_b = from_root(b.item, work.other_side.point);
  factors.system.couple(of_a, of_b);
  auto K_ab = factors.system.block(of_a, of_b), K_ba = factors.system.block(of_b, of_a);
  K_ab.topLeftCorner<6, 6>() -= slope_between(work.in_floor_axes, at_a, at_b);
  K_ba.topLeftCorner<6, 6>() -= slope_between(work.in_floor_axes, at_b, at_a);
  if (work.rolls) {
    const Matrix3 turning = factors.tau * work.rolling.slope;
    K_ab.block<3, 3>(3, 3) -= turning;
    K_ba.block<3, 3>(3, 3) -= turning;
  }
  if (a.caster < 0 && b.caster < 0) return;
  const Matrix3 slope = factors.tau * work.slope;
  const auto add = [&](Eigen::Index row, const auto& left, Eigen::Index column, const auto& right) {
    constexpr int kLeft = std::remove_cvref_t<decltype(left)>::ColsAtCompileTime;
    constexpr int kRight = std::remove_cvref_t<decltype(right)>::ColsAtCompileTime;
    K_ab.block<kLeft, kRight>(row, column) -= left.transpose() * (slope * right);
    K_ba.block<kRight, kLeft>(column, row) -= right.transpose() * (slope * left);
  };
  const auto joint = [&](std::size_t block, int caster) {
    return factors.layouts[factors.items.size() - 1 - block]
        .joints[static_cast<std::size_t>(caster)];
  };
  if (a.caster >= 0)
    add(joint(of_a, a.caster), work.side.joints, 0, of_root(b.item, work.other_side.chassis));
  if (b.caster >= 0)
    add(0, of_root(a.item, work.side.chassis), joint(of_b, b.caster), work.other_side.joints);
  if (a.caster >= 0 && b.caster >= 0)
    add(joint(of_a, a.caster), work.side.joints, joint(of_b, b.caster), work.other_side.joints);
}

Matrix6 StageSolver::coupling(const JointWork& work, double tau) const {
  Matrix6 slopes = Matrix6::Zero();
  for (std::size_t r = 0; r < work.stage.rows.count; ++r) {
    const JointLaw::Row& row = work.stage.rows.rows[r];
    const Vector6 scaled = tau * work.forces[r].slope * of_root(work.part(), row.part);
    slopes.noalias() -= scaled * of_root(work.base(), row.base).transpose();
  }
  return slopes;
}

void StageSolver::couple(const JointWork& work, Factors& factors) {
  if (within_one(work)) return;
  const std::size_t part = block_of_[roots_[work.part()]], base = block_of_[roots_[work.base()]];
  const Matrix6 slopes = coupling(work, factors.tau);
  factors.system.couple(part, base);
  factors.system.block(part, base).topLeftCorner<6, 6>() += slopes;
  factors.system.block(base, part).topLeftCorner<6, 6>() += slopes.transpose();
}

}  // namespace gurney
