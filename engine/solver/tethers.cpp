#include "engine/solver/tethers.h"

#include <algorithm>

namespace gurney {
namespace {

bool broken(const State& state, std::size_t i) { return (state.broken_tethers >> i & 1u) != 0; }

/// A cord nearer than this to its break, in stretch, breaks: events are located more closely [m].
constexpr double kBreakDistance = 1e-9;

}  // namespace

Tethers::Tethers(const Scene& scene, std::size_t item, const Vector3& chassis_center) {
  for (std::size_t i = 0; i < scene.tethers.size(); ++i) {
    if (scene.tethers[i].item != item || scene.tethers[i].anchor_item) continue;
    tethers_.push_back(scene.tethers[i]);
    tethers_.back().point -= chassis_center;
    indices_.push_back(i);
  }
}

double Tethers::stretch(const Tether& tether, const State& state) const {
  const Vector3 point = state.position + state.rotation * tether.point;
  return (tether.anchor - point).norm() - tether.slack_length;
}

Tethers::Pull Tethers::pull(const Tether& tether, double tau, const State& start, const Pose& pose,
                            const Vector6& velocity) const {
  const Vector3 arm = pose.rotation * tether.point;
  const Vector3 direction = (tether.anchor - pose.position - arm).normalized();
  Pull pull;
  pull.row << direction, arm.cross(direction);
  pull.rate = -pull.row.dot(velocity);
  const double stretched = stretch(tether, start) + tau * pull.rate;
  pull.force = cord_force(tether, stretched, pull.rate, tau);
  return pull;
}

Loads::Row Tethers::slack_pull(const Tether& tether, const Pose& pose) const {
  const Vector3 arm = pose.rotation * tether.point;
  const Vector3 direction = slack_direction(tether.anchor - pose.position - arm);
  Vector6 row;
  row << direction, arm.cross(direction);
  return {row, tether.slack_pull, 0};
}

void Tethers::evaluate(double tau, const State& start, const Pose& pose, const Vector6& velocity,
                       std::vector<Loads::Row>& rows) const {
  for (std::size_t i = 0; i < tethers_.size(); ++i) {
    if (broken(start, i)) continue;
    const Pull p = pull(tethers_[i], tau, start, pose, velocity);
    rows.push_back({p.row, p.force.sum(), p.force.slope});
    if (tethers_[i].slack_pull > 0) rows.push_back(slack_pull(tethers_[i], pose));
  }
}

double Tethers::finish(double tau, const State& start, const Pose& pose, const Vector6& velocity,
                       EnergyAccount& power) const {
  double rates = 0;
  for (std::size_t i = 0; i < tethers_.size(); ++i) {
    if (broken(start, i)) continue;
    const Pull p = pull(tethers_[i], tau, start, pose, velocity);
    power.damper_loss += p.force.damping * p.rate;
    if (tethers_[i].slack_pull > 0)
      power.work_of_forces +=
          tethers_[i].slack_pull * slack_pull(tethers_[i], pose).direction.dot(velocity);
    if (p.force.elastic > 0) rates += tethers_[i].stiffness * p.rate * p.rate;
  }
  return rates;
}

double Tethers::past_strength(std::size_t i, const State& state) const {
  return (tension(i, state) - tethers_[i].strength) / tethers_[i].stiffness;
}

double Tethers::past_strength(const State& state) const {
  double farthest = -1;
  for (std::size_t i = 0; i < tethers_.size(); ++i)
    if (!broken(state, i)) farthest = std::max(farthest, past_strength(i, state));
  return farthest;
}

double Tethers::break_overstressed(State& state) const {
  double lost = 0;
  for (std::size_t i = 0; i < tethers_.size(); ++i) {
    if (broken(state, i) || past_strength(i, state) < -kBreakDistance) continue;
    const double s = std::max(stretch(tethers_[i], state), 0.0);
    lost += 0.5 * tethers_[i].stiffness * s * s;
    state.broken_tethers |= 1u << i;
  }
  return lost;
}

double Tethers::stored_energy(const State& state) const {
  double energy = 0;
  for (std::size_t i = 0; i < tethers_.size(); ++i) {
    const double s = std::max(stretch(tethers_[i], state), 0.0);
    if (!broken(state, i)) energy += 0.5 * tethers_[i].stiffness * s * s;
  }
  return energy;
}

double Tethers::tension(std::size_t i, const State& state) const {
  return pull(tethers_[i], 0, state, state.pose(), state.velocity.chassis).force.sum();
}

}  // namespace gurney
