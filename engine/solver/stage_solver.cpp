#include "engine/solver/stage_solver.h"

#include <algorithm>
#include <cmath>
#include <ranges>

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
      carriers_(assembly.items.size()),
      roots_(assembly.items.size()),
      arms_(assembly.items.size(), Vector3::Zero()),
      arms_from_root_(arms_),
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

void StageSolver::set_riders(const Input& input) {
  free_.clear();
  riders_.clear();
  for (std::size_t i : input.island->items) {
    const bool rides = input.riders && input.riders->rides(i);
    (rides ? riders_ : free_).push_back(i);
    carriers_[i] = rides ? input.riders->carrier(i) : i;
    roots_[i] = rides ? roots_[carriers_[i]] : i;
    arms_[i].setZero();
    arms_from_root_[i].setZero();
  }
}

void StageSolver::follow(std::vector<Velocity>& v) const {
  for (std::size_t i : riders_) v[i].chassis = Riders::velocity(v[carriers_[i]].chassis, arms_[i]);
}

/// T' d of a generalised direction d of an item.
Vector6 StageSolver::of_root(std::size_t item, const Vector6& direction) const {
  Vector6 d = direction;
  d.tail<3>() += arms_from_root_[item].cross(d.head<3>());
  return d;
}

ItemStage::Matrix36 StageSolver::of_root(std::size_t item, const ItemStage::Matrix36& rates) const {
  ItemStage::Matrix36 of_root;
  for (int k = 0; k < 3; ++k)
    of_root.row(k) = this->of_root(item, Vector6(rates.row(k))).transpose();
  return of_root;
}

void StageSolver::update_geometry(const Input& input, std::vector<Velocity>& v, bool first) {
  for (std::size_t i : input.island->items) {
    if (const std::size_t carrier = carriers_[i]; carrier != i) {
      arms_[i] = input.riders->arm(i, items_[carrier].pose().rotation);
      arms_from_root_[i] = arms_from_root_[carrier] + arms_[i];
      v[i].chassis = Riders::velocity(v[carrier].chassis, arms_[i]);
    }
    items_[i].update_geometry(inputs_[i], v[i], first);
  }
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
  for (std::size_t i : std::views::reverse(riders_)) {
    items_[i].end_forces(inputs_[i], v[i]);
    items_[carriers_[i]].carry_residual(arms_[i], items_[i].residual());
  }
  double residual = 0;
  for (std::size_t i : free_)
    residual = larger_or_nan(residual, items_[i].end_forces(inputs_[i], v[i]));
  return residual;
}

double StageSolver::geometry_error(const Island& island, const std::vector<Velocity>& v) const {
  double error = 0;
  for (std::size_t i : island.items) error = std::max(error, items_[i].geometry_error(v[i]));
  return error;
}

void StageSolver::take(double part) {
  for (std::size_t i : free_) {
    v_[i].chassis = before_[i].chassis + part * (full_[i].chassis - before_[i].chassis);
    for (std::size_t j = 0; j < assembly_.items[i].casters.size(); ++j)
      v_[i].joints[j] = before_[i].joints[j] + part * (full_[i].joints[j] - before_[i].joints[j]);
  }
  follow(v_);
}

bool StageSolver::solve(const Input& input, Output& out) {
  set_riders(input);
  // Rounding of M v shows in the residual as M g tau gets small.
  double speed = 0;
  std::size_t blocks = free_.size();  // the last item's comes first
  for (std::size_t i : riders_) {
    set_input(input, i);
    v_[i] = input.guess[i];
  }
  for (std::size_t i : free_) {
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
    Factors& factors = factors_[free_.front()];
    double left = has_factors(input) ? factors.left : 1;
    for (; residual > tolerance && iteration < settings_.max_iterations; ++iteration) {
      // Full steps settle most stages in two or three; halving them is for those that cycle between pieces of a law.
      const bool anew = !serves_again(residual, left, tolerance);
      // A step with an earlier matrix that leads nowhere is taken back as a whole.
      const int trials = !anew                                        ? 1
                         : full_steps < kIterationsBeforeBacktracking ? 0
                                                                      : kMaxBacktracks;
      if (trials > 0)
        for (std::size_t i : free_) before_[i] = v_[i];
      newton_step(input, anew, v_);
      full_steps += anew;
      double next = evaluate_forces(input, v_);
      double part = anew ? 1 : 0;
      for (int k = 0; k < trials && !(next < residual); ++k) {
        if (k == 0)
          for (std::size_t i : free_) full_[i] = v_[i];
        take(part *= 0.5);
        next = evaluate_forces(input, v_);
      }
      if (free_.size() > 1) left = factors.left = next / residual;
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
  out.holding.resize(items_.size());
  for (std::size_t i : riders_) {
    // The carrier's work on a body that rides is work of neighbours.
    out.holding[i] = items_[i].residual() / input.tau;
    const double given = out.holding[i].dot(v[i].chassis);
    out.items[i].power.work_of_neighbours += given;
    out.items[carriers_[i]].power.work_of_neighbours -= given;
  }
  finish_contacts(input, v, out);
  finish_joints(input, out);
}

}  // namespace gurney
