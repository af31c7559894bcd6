#include "engine/solver/loads.h"

#include <algorithm>

#include "engine/base/append_all.h"
#include "engine/solver/quadrature.h"

namespace gurney {
namespace {

Vector6 row_of(const Pose& pose, const Vector3& point, const Vector3& direction) {
  Vector6 row;
  row << direction, (pose.rotation * point).cross(direction);
  return row;
}

/// A force at its speed limit fades over this share of the limit.
constexpr double kFading = 0.05;

/// Share of the force of a load's table, at the speed of its point along its direction.
struct Share {
  double value = 1;
  double slope = 0;  ///< -d value / d speed >= 0 [s/m]
};

Share share_at(double speed_limit, double speed) {
  const double value = (1 - speed / speed_limit) / kFading;
  if (value >= 1) return {};
  if (value <= 0) return {0, 0};
  return {value, 1 / (kFading * speed_limit)};
}

double spring_energy(double stiffness, const Vector2& deflection) {
  return 0.5 * stiffness * (deflection.x() * deflection.x() + deflection.y() * deflection.y());
}

/// Steps end at releases; rounding of their times must not let blocks go a step early [s].
constexpr double kReleaseTolerance = 1e-9;

}  // namespace

void LoadsState::extrapolate(const LoadsState& first, double ratio, LoadsState& result) const {
  result = *this;
  for (std::size_t i = 0; i < weights.size(); ++i) {
    Weight& weight = result.weights[i];
    const Weight& at_first = first.weights[i];
    weight.fall += ratio * (at_first.fall - weight.fall);
    weight.speed += ratio * (at_first.speed - weight.speed);
    weight.stretch += ratio * (at_first.stretch - weight.stretch);
  }
  for (std::size_t i = 0; i < blocks.size(); ++i)
    result.blocks[i] += ratio * (first.blocks[i] - blocks[i]);
  for (std::size_t i = 0; i < springs.size(); ++i)
    result.springs[i] += ratio * (first.springs[i] - springs[i]);
}

Loads::Loads(const PlacedItem& item, const Vector3& chassis_center, double gravity)
    : strings_(loads_of<StringPotentiometer>(item.loads)) {
  for (const auto& f : loads_of<PointForce>(item.loads))
    forces_.push_back({f.point - chassis_center, f.direction.normalized(),
                       ForceTable(f.time, f.force), f.speed_limit});
  for (auto& s : strings_) {
    s.point -= chassis_center;
    s.direction.normalize();
  }
  for (const auto& w : loads_of<DropWeight>(item.loads))
    weights_.push_back({w.point - chassis_center, w.direction.normalized(), w.mass,
                        w.mass + w.pulley_inertia / (w.pulley_radius * w.pulley_radius),
                        w.mass * gravity - w.potentiometer_tension, w.drop_height, gravity,
                        w.cable_stiffness, w.cable_damping, w.potentiometer_tension});
  for (const auto& b : loads_of<Blocks>(item.loads))
    blocks_.push_back({b.point - chassis_center, b.stiffness, b.damping, b.release_time});
  for (int dof = 0; dof < 6; ++dof) {
    const Guide& guide = item.fixture.guides[dof];
    if (guide.kind == Guide::Kind::kSpring)
      springs_.push_back({dof, guide.stiffness, guide.damping});
  }
}

LoadsState Loads::initial_state() const {
  LoadsState state;
  for (const auto& w : weights_) {
    // Held by blocks, the cable carries the weight; released at once, it starts unstretched.
    const double stretch = blocks_.empty() ? 0.0 : w.force / w.stiffness;
    state.weights.push_back({.fall = 0, .speed = 0, .stretch = stretch, .landed = false});
  }
  state.blocks.assign(blocks_.size(), Vector2::Zero());
  state.springs.assign(springs_.size(), 0.0);
  return state;
}

std::vector<double> Loads::breakpoints() const {
  std::vector<double> times;
  for (const auto& f : forces_) append_all(times, f.table.times());
  for (const auto& b : blocks_) times.push_back(b.release_time);
  return times;
}

Loads::Cable Loads::cable(const Weight& w, const LoadsState::Weight& start, double u,
                          const Stage& stage) const {
  const double tau = stage.tau;
  const double pull = w.force + w.weight_mass * stage.floor_acceleration_up;
  const double speed = start.speed, stretch = start.stretch;
  const bool landed = start.landed;
  const double kappa = w.stiffness * tau + w.damping;
  // T = k (s + tau (w - u)) + c (w - u), weight: inertia (w - w0) = tau (force - T).
  const double free_speed = landed ? 0.0 : speed + tau * pull / w.inertia;
  const double factor = landed ? 1.0 : 1 / (1 + kappa * tau / w.inertia);
  const double tension = factor * (w.stiffness * stretch + kappa * (free_speed - u));
  Cable result;
  const bool taut = tension > 0;
  result.tension = taut ? tension : 0;
  result.slope = taut ? factor * kappa : 0;
  result.weight_speed = landed ? 0.0 : free_speed - tau * result.tension / w.inertia;
  result.stretch_rate = result.weight_speed - u;
  return result;
}

void Loads::evaluate(const Stage& stage, const Pose& pose, const Vector6& velocity,
                     std::vector<Row>& rows) const {
  rows.clear();
  for (const auto& f : forces_) {
    const StageMeans<double> mean = stage_means(stage.from, stage.to - stage.from,
                                                [&](double t) { return f.table.integral(t); });
    const double force = stage.first ? mean.first : mean.second;
    const Vector6 row = row_of(pose, f.point, f.direction);
    const Share share = share_at(f.speed_limit, row.dot(velocity));
    rows.push_back({row, share.value * force, share.slope * force});
  }
  for (const auto& s : strings_) rows.push_back({row_of(pose, s.point, s.direction), s.tension, 0});
  const LoadsState& state = *stage.start;
  for (std::size_t i = 0; i < weights_.size(); ++i) {
    const Vector6 row = row_of(pose, weights_[i].point, weights_[i].direction);
    const Cable c = cable(weights_[i], state.weights[i], row.dot(velocity), stage);
    rows.push_back({row, c.tension, c.slope});
  }
  for (std::size_t i = 0; i < blocks_.size(); ++i) {
    const Block& b = blocks_[i];
    if (stage.from >= b.release_time - kReleaseTolerance) continue;
    for (int axis = 0; axis < 2; ++axis) {
      const Vector6 row = row_of(pose, b.point, Vector3::Unit(axis));
      const double slope = b.stiffness * stage.tau + b.damping;
      const double deflection = state.blocks[i][axis];
      rows.push_back({row, -b.stiffness * deflection - slope * row.dot(velocity), slope});
    }
  }
  for (std::size_t i = 0; i < springs_.size(); ++i) {
    const Spring& s = springs_[i];
    const double slope = s.stiffness * stage.tau + s.damping;
    rows.push_back(
        {Vector6::Unit(s.dof), -s.stiffness * state.springs[i] - slope * velocity[s.dof], slope});
  }
}

double Loads::finish(const Stage& stage, const Pose& pose, const Vector6& velocity,
                     const std::vector<Row>& rows, EnergyAccount& power, LoadsState& end) const {
  end = *stage.start;
  double spring_rates = 0;
  for (std::size_t i = 0; i < forces_.size() + strings_.size(); ++i)
    power.work_of_forces += rows[i].force * rows[i].direction.dot(velocity);

  for (std::size_t i = 0; i < weights_.size(); ++i) {
    const Weight& w = weights_[i];
    LoadsState::Weight& state = end.weights[i];
    const double u = row_of(pose, w.point, w.direction).dot(velocity);
    const Cable c = cable(w, state, u, stage);
    const double acceleration = state.landed ? 0 : (c.weight_speed - state.speed) / stage.tau;
    power.work_of_floor += w.weight_mass * stage.floor_acceleration_up * c.weight_speed;
    power.work_of_forces += state.landed ? 0 : -w.tension_on_weight * c.weight_speed;
    state.fall += stage.tau * c.weight_speed;
    state.speed = c.weight_speed;
    // A slack cable hangs through: its stretch stays negative until it is taut again.
    state.stretch += stage.tau * c.stretch_rate;
    if (c.tension > 0) {
      power.damper_loss += (c.tension - w.stiffness * state.stretch) * c.stretch_rate;
      spring_rates += w.stiffness * c.stretch_rate * c.stretch_rate;
    }
    spring_rates += w.inertia * acceleration * acceleration;
  }
  for (std::size_t i = 0; i < blocks_.size(); ++i) {
    const Block& b = blocks_[i];
    if (stage.from >= b.release_time - kReleaseTolerance) continue;
    for (int axis = 0; axis < 2; ++axis) {
      const double u = row_of(pose, b.point, Vector3::Unit(axis)).dot(velocity);
      end.blocks[i][axis] += stage.tau * u;
      power.damper_loss += b.damping * u * u;
      spring_rates += b.stiffness * u * u;
    }
  }
  for (std::size_t i = 0; i < springs_.size(); ++i) {
    const Spring& s = springs_[i];
    const double u = velocity[s.dof];
    end.springs[i] += stage.tau * u;
    power.damper_loss += s.damping * u * u;
    spring_rates += s.stiffness * u * u;
  }
  return spring_rates;
}

void Loads::adopt_springs(const Loads& other, const LoadsState& other_state,
                          LoadsState& state) const {
  for (std::size_t i = 0; i < springs_.size(); ++i)
    for (std::size_t j = 0; j < other.springs_.size(); ++j)
      if (springs_[i].dof == other.springs_[j].dof) state.springs[i] = other_state.springs[j];
}

double Loads::stored_energy(const LoadsState& state) const {
  double energy = 0;
  for (std::size_t i = 0; i < weights_.size(); ++i) {
    const double stretch = std::max(state.weights[i].stretch, 0.0);
    energy += 0.5 * weights_[i].stiffness * stretch * stretch;
  }
  for (std::size_t i = 0; i < blocks_.size(); ++i)
    energy += spring_energy(blocks_[i].stiffness, state.blocks[i]);
  for (std::size_t i = 0; i < springs_.size(); ++i)
    energy += 0.5 * springs_[i].stiffness * state.springs[i] * state.springs[i];
  return energy;
}

double Loads::weight_energy(const LoadsState& state) const {
  double energy = 0;
  for (std::size_t i = 0; i < weights_.size(); ++i) {
    const Weight& w = weights_[i];
    const LoadsState::Weight& s = state.weights[i];
    energy += 0.5 * w.inertia * s.speed * s.speed - w.weight_mass * w.gravity * s.fall;
  }
  return energy;
}

double Loads::pull_force(double time, const Pose& pose, const Vector6& velocity) const {
  double sum = 0;
  for (const auto& f : forces_)
    sum += share_at(f.speed_limit, row_of(pose, f.point, f.direction).dot(velocity)).value *
           f.table.value(time);
  return sum;
}

double Loads::cable_tension(const LoadsState& state) const {
  double sum = 0;
  for (std::size_t i = 0; i < weights_.size(); ++i)
    sum += weights_[i].stiffness * std::max(state.weights[i].stretch, 0.0);
  return sum;
}

double Loads::penetration(const LoadsState& state) const {
  double deepest = -1;
  for (std::size_t i = 0; i < weights_.size(); ++i)
    if (!state.weights[i].landed)
      deepest = std::max(deepest, state.weights[i].fall - weights_[i].drop_height);
  return deepest;
}

double Loads::land(LoadsState& state) const {
  double lost = 0;
  for (std::size_t i = 0; i < weights_.size(); ++i) {
    const Weight& w = weights_[i];
    LoadsState::Weight& s = state.weights[i];
    if (s.landed || s.fall < w.drop_height - 1e-9) continue;
    const double stretch = std::max(s.stretch, 0.0);
    lost += 0.5 * w.inertia * s.speed * s.speed + 0.5 * w.stiffness * stretch * stretch;
    s.speed = 0;
    s.stretch = std::min(s.stretch, 0.0);  // a slack cable stays slack
    s.landed = true;
  }
  return lost;
}

double Loads::release(double time, LoadsState& state) const {
  double lost = 0;
  for (std::size_t i = 0; i < blocks_.size(); ++i) {
    if (time < blocks_[i].release_time - kReleaseTolerance) continue;
    lost += spring_energy(blocks_[i].stiffness, state.blocks[i]);
    state.blocks[i].setZero();
  }
  return lost;
}

}  // namespace gurney
