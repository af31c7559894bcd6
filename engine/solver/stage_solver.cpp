#include "engine/solver/stage_solver.h"

#include <algorithm>
#include <cmath>

#include "engine/base/units.h"
#include "engine/solver/solve6.h"

namespace gurney {
namespace {

/// A stage is solved again when a direction it was built on has turned by more than this [rad].
/// The remainder is second order in the step: the prediction misses by O(tau^2) where the motion is
/// smooth.
constexpr double kGeometryTolerance = 1e-3;
constexpr int kMaxGeometryPasses = 6;

constexpr int kMaxBacktracks = 6;
constexpr int kIterationsBeforeBacktracking = 4;

}  // namespace

StageSolver::StageSolver(const Assembly& assembly, const Settings& settings)
    : assembly_(assembly),
      settings_(settings),
      inputs_(assembly.items.size()),
      v_(assembly.items.size()),
      group_of_(assembly.items.size()),
      places_(assembly.items.size()) {
  for (const Mechanism& mechanism : assembly.items) items_.emplace_back(mechanism);
  before_ = full_ = v_;
}

void StageSolver::set_input(const Input& input, std::size_t item) {
  ItemStage::Input& of_item = inputs_[item];
  of_item.start = &input.start->items[item];
  of_item.tau = input.tau;
  of_item.floor = input.floor;
  of_item.loads = input.loads;
  of_item.loads.start = &of_item.start->loads;
}

void StageSolver::update_geometry(const Input& input, const std::vector<Velocity>& v, bool first) {
  for (std::size_t i : input.island->items) items_[i].update_geometry(inputs_[i], v[i], first);
  update_contacts(input, v);
  update_joints(input, v);
}

double StageSolver::evaluate_forces(const Input& input, const std::vector<Velocity>& v) {
  for (std::size_t i : input.island->items) items_[i].begin_forces(inputs_[i], v[i]);
  for (std::size_t c = 0; c < contacts_.size(); ++c) {
    ContactWork& work = contacts_[c];
    const BodyContact::Side &a = work.contact->side, &b = work.contact->other_side;
    if (stays_apart(work, v)) {
      work.force.setZero();
      continue;
    }
    work.force = work.law->force(work.stage, contact_rates(work, v), work.slope);
    if (!work.pushes()) continue;
    items_[a.item].add_contact_force(a.caster, work.side.chassis, work.side.joints, work.force);
    if (work.contact->between_items())
      items_[b.item].add_contact_force(b.caster, work.other_side.chassis, work.other_side.joints,
                                       -work.force);
    if (work.rolls) add_rolling(input, c, v);
  }
  add_joint_forces(v);
  double residual = 0;
  for (std::size_t i : input.island->items)
    residual = larger_or_nan(residual, items_[i].end_forces(inputs_[i], v[i]));
  return residual;
}

void StageSolver::newton_step(const Input& input, std::vector<Velocity>& v) {
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
  for (std::size_t i : input.island->items) items_[i].eliminate();
  if (input.island->items.size() == 1) return single_step(input.island->items.front(), v);
  coupled_steps(*input.island, input.tau, v);
}

void StageSolver::single_step(std::size_t item, std::vector<Velocity>& v) {
  items_[item].apply(solve6(items_[item].matrix(), items_[item].right_side()), v[item]);
}

double StageSolver::geometry_error(const Island& island, const std::vector<Velocity>& v) const {
  double error = 0;
  for (std::size_t i : island.items) error = std::max(error, items_[i].geometry_error(v[i]));
  return error;
}

bool StageSolver::solve(const Input& input, Output& out) {
  const std::vector<std::size_t>& island = input.island->items;
  // Rounding of M v shows in the residual as M g tau gets small.
  double speed = 0;
  for (std::size_t i : island) {
    set_input(input, i);
    v_[i] = input.guess[i];
    speed = std::max(speed, v_[i].chassis.head<3>().norm());
  }
  const double rounding = 1e-14 * (speed + 1e-3) / (kStandardGravity * input.tau);
  const double tolerance = settings_.residual + rounding;
  out.iterations = 0;
  bool converged = false;
  for (int pass = 0; pass < kMaxGeometryPasses; ++pass) {
    update_geometry(input, v_, pass == 0);
    double residual = evaluate_forces(input, v_);
    int iteration = 0;
    for (; residual > tolerance && iteration < settings_.max_iterations; ++iteration) {
      // Full steps settle most stages in two or three; halving them is for those that cycle between pieces of a law.
      const bool may_backtrack = iteration >= kIterationsBeforeBacktracking;
      if (may_backtrack)
        for (std::size_t i : island) before_[i] = v_[i];
      newton_step(input, v_);
      double next = evaluate_forces(input, v_);
      if (may_backtrack) {
        double fraction = 1;
        for (std::size_t i : island) full_[i] = v_[i];
        for (int k = 0; k < kMaxBacktracks && !(next < residual); ++k) {
          fraction *= 0.5;
          for (std::size_t i : island) {
            v_[i].chassis = before_[i].chassis + fraction * (full_[i].chassis - before_[i].chassis);
            for (std::size_t j = 0; j < assembly_.items[i].casters.size(); ++j)
              v_[i].joints[j] =
                  before_[i].joints[j] + fraction * (full_[i].joints[j] - before_[i].joints[j]);
          }
          next = evaluate_forces(input, v_);
        }
      }
      residual = next;
      if (!std::isfinite(residual)) break;
    }
    out.iterations += iteration;
    out.residual = residual;
    converged = residual <= tolerance;
    // Directions are those of the velocity that was expected: solve again where it came out otherwise.
    if (!converged || geometry_error(*input.island, v_) < kGeometryTolerance) break;
  }
  if (std::isfinite(out.residual)) finish(input, v_, out);
  return converged;
}

void StageSolver::finish(const Input& input, const std::vector<Velocity>& v, Output& out) {
  out.end.items.resize(items_.size());
  out.items.resize(items_.size());
  for (std::size_t i : input.island->items)
    items_[i].finish(inputs_[i], v[i], out.end.items[i], out.items[i]);
  finish_contacts(input, v, out);
  finish_joints(input, out);
}

}  // namespace gurney
