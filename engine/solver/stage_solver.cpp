#include "engine/solver/stage_solver.h"

#include <algorithm>
#include <cmath>

#include "engine/base/units.h"

namespace gurney {
namespace {

/// A stage is solved again when a direction it was built on has turned by more than this [rad].
/// The remainder is second order in the step: the prediction misses by O(tau^2) where the motion is
/// smooth.
constexpr double kGeometryTolerance = 1e-3;
constexpr int kMaxGeometryPasses = 6;

/// Whether a matrix serves again: where three steps with it, which cost as much as one with a matrix of its own, are
/// expected to settle a stage.
/// @param left  part of a residual that a step with it leaves
bool serves_again(double residual, double left, double tolerance) {
  return residual * left * left * left <= tolerance;
}

constexpr int kMaxBacktracks = 6;
constexpr int kIterationsBeforeBacktracking = 4;

}  // namespace

StageSolver::StageSolver(const Assembly& assembly, const Settings& settings)
    : assembly_(assembly),
      settings_(settings),
      inputs_(assembly.items.size()),
      v_(assembly.items.size()),
      factors_(assembly.items.size()),
      block_of_(assembly.items.size()) {
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

double StageSolver::geometry_error(const Island& island, const std::vector<Velocity>& v) const {
  double error = 0;
  for (std::size_t i : island.items) error = std::max(error, items_[i].geometry_error(v[i]));
  return error;
}

void StageSolver::take(const std::vector<std::size_t>& island, double part) {
  for (std::size_t i : island) {
    v_[i].chassis = before_[i].chassis + part * (full_[i].chassis - before_[i].chassis);
    for (std::size_t j = 0; j < assembly_.items[i].casters.size(); ++j)
      v_[i].joints[j] = before_[i].joints[j] + part * (full_[i].joints[j] - before_[i].joints[j]);
  }
}

bool StageSolver::solve(const Input& input, Output& out) {
  const std::vector<std::size_t>& island = input.island->items;
  // Rounding of M v shows in the residual as M g tau gets small.
  double speed = 0;
  std::size_t blocks = island.size();  // the last item's comes first
  for (std::size_t i : island) {
    set_input(input, i);
    v_[i] = input.guess[i];
    block_of_[i] = --blocks;
    speed = std::max(speed, v_[i].chassis.head<3>().norm());
  }
  const double rounding = 1e-14 * (speed + 1e-3) / (kStandardGravity * input.tau);
  const double tolerance = settings_.residual + rounding;
  out.iterations = 0;
  bool converged = false;
  for (int pass = 0; pass < kMaxGeometryPasses; ++pass) {
    update_geometry(input, v_, pass == 0);
    double residual = evaluate_forces(input, v_);
    int iteration = 0, full_steps = 0;
    Factors& factors = factors_[island.front()];
    double left = has_factors(input) ? factors.left : 1;
    for (; residual > tolerance && iteration < settings_.max_iterations; ++iteration) {
      // Full steps settle most stages in two or three; halving them is for those that cycle between pieces of a law.
      const bool anew = !serves_again(residual, left, tolerance);
      // A step with an earlier matrix that leads nowhere is taken back as a whole.
      const int trials = !anew                                        ? 1
                         : full_steps < kIterationsBeforeBacktracking ? 0
                                                                      : kMaxBacktracks;
      if (trials > 0)
        for (std::size_t i : island) before_[i] = v_[i];
      newton_step(input, anew, v_);
      full_steps += anew;
      double next = evaluate_forces(input, v_);
      double part = anew ? 1 : 0;
      for (int k = 0; k < trials && !(next < residual); ++k) {
        if (k == 0)
          for (std::size_t i : island) full_[i] = v_[i];
        take(island, part *= 0.5);
        next = evaluate_forces(input, v_);
      }
      if (island.size() > 1) left = factors.left = next / residual;
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
