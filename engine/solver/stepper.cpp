#include "engine/solver/stepper.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/solver/quadrature.h"

namespace gurney {
namespace {

constexpr double kLandingTolerance = 1e-10;  // [m]
/// Shorter remainders of a step are left out: rounding would be larger than the motion in them [s].
constexpr double kShortestStep = 1e-8;

constexpr int kMaxLandingTrials = 20;

constexpr double kSameContactDistance = 0.02;  // [m]

/// Steps in half a period of a contact's spring: the rebound is then within 0.3 % of its law's.
constexpr double kStepsInImpact = 32;

/// A step that no subdivision makes converge is still accepted below this residual, and counted.
constexpr double kAcceptableResidual = 1e-5;

Velocity advanced(const Velocity& v, double time, const Velocity& acceleration, std::size_t legs) {
  Velocity result;
  result.chassis = v.chassis + time * acceleration.chassis;
  for (std::size_t i = 0; i < legs; ++i)
    result.joints[i] = v.joints[i] + time * acceleration.joints[i];
  return result;
}

/// Start of the second stage: y + h (1 - gamma) k, with k = (y_first - y) / (gamma h).
void extrapolate(const State& from, double duration, const StageSolver::Output& first,
                 std::size_t legs, State& start) {
  const double time = (1 - kSdirkGamma) * duration;
  constexpr double ratio = (1 - kSdirkGamma) / kSdirkGamma;
  const auto extrapolated = [ratio](const auto& y, const auto& y1) { return y + ratio * (y1 - y); };
  const Velocity& v1 = first.end.velocity;
  start.position = from.position + time * v1.chassis.head<3>();
  start.rotation = rotated(time * v1.chassis.tail<3>(), from.rotation);
  start.velocity = advanced(from.velocity, time, first.acceleration, legs);
  for (std::size_t i = 0; i < legs; ++i) {
    const LegState& a = from.legs[i];
    const LegState& b = first.end.legs[i];
    LegState& s = start.legs[i];
    s.swivel_angle = a.swivel_angle + time * v1.joints[i][0];
    s.axle_angle = a.axle_angle + time * v1.joints[i][1];
    s.swivel_wind = extrapolated(a.swivel_wind, b.swivel_wind);
    s.axle_wind = extrapolated(a.axle_wind, b.axle_wind);
    s.tread.deflection = extrapolated(a.tread.deflection, b.tread.deflection);
    s.tread.roll_deflection = extrapolated(a.tread.roll_deflection, b.tread.roll_deflection);
    s.tread.sliding = a.tread.sliding;
    s.tread.rolling = b.tread.rolling;
  }
  start.loads.resize(from.loads.size());
  for (std::size_t i = 0; i < from.loads.size(); ++i)
    start.loads[i] = extrapolated(from.loads[i], first.end.loads[i]);
  start.contacts.resize(from.contacts.size());
  for (std::size_t c = 0; c < from.contacts.size(); ++c) {
    start.contacts[c] = from.contacts[c];
    start.contacts[c].deflection =
        extrapolated(from.contacts[c].deflection, first.end.contacts[c].deflection);
  }
}

void add_power(const EnergyAccount& power, double time, EnergyAccount& account) {
  account.work_of_floor += time * power.work_of_floor;
  account.work_of_forces += time * power.work_of_forces;
  account.work_of_fixtures += time * power.work_of_fixtures;
  account.rolling_loss += time * power.rolling_loss;
  account.sliding_loss += time * power.sliding_loss;
  account.relaxation_loss += time * power.relaxation_loss;
  account.tread_loss += time * power.tread_loss;
  account.axle_loss += time * power.axle_loss;
  account.swivel_loss += time * power.swivel_loss;
  account.damper_loss += time * power.damper_loss;
  account.contact_loss += time * power.contact_loss;
}

}  // namespace

Stepper::Stepper(const Mechanism& mechanism, const FloorMotion& floor,
                 const SimulationSettings& settings)
    : mechanism_(mechanism),
      floor_(floor),
      settings_(settings),
      solver_(mechanism, {settings.residual, settings.max_newton_iterations}) {}

void Stepper::set_contacts(const std::vector<BodyContact>& contacts, State& state) {
  contacts_ = contacts;
  if (contacts.empty() && state.contacts.empty()) return;
  const double stored = mechanism_.contact_energy(state);
  std::vector<BodyContactState> memories(contacts.size());
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    double nearest = kSameContactDistance;
    for (const BodyContactState& memory : state.contacts) {
      if (!memory.contact.same_pair(contacts[i])) continue;
      const double distance = (memory.contact.local - contacts[i].local).norm();
      if (distance >= nearest) continue;
      nearest = distance;
      memories[i] = memory;
    }
    const bool is_new = nearest == kSameContactDistance;
    memories[i].contact = contacts[i];
    const Vector3 point = state.position + mechanism_.contact_point(contacts[i], state);
    memories[i].compression = contacts[i].offset - contacts[i].normal.dot(point);
    if (is_new) memories[i].approach_speed = approach_speed(contacts[i], state);
  }
  state.contacts = std::move(memories);
  account_.contact_loss += stored - mechanism_.contact_energy(state);
}

void Stepper::change_loads(State& state) {
  if (!mechanism_.loads.empty())
    account_.damper_loss += mechanism_.loads.release(state.time, state.loads);
  acceleration_known_ = false;
}

double Stepper::approach_speed(const BodyContact& contact, const State& state) const {
  return std::max(0.0, -contact.normal.dot(mechanism_.contact_velocity(contact, state)));
}

double Stepper::longest_step(const State& state, double remaining) const {
  double longest = remaining;
  const auto count = static_cast<double>(contacts_.size());
  for (const BodyContactState& memory : state.contacts) {
    const double rate =
        memory.contact.normal.dot(mechanism_.contact_velocity(memory.contact, state));
    const double gap = -memory.compression;
    const Vector3 arm = mechanism_.contact_point(memory.contact, state);
    const Vector3 turn = acceleration_.chassis.tail<3>().cross(arm);
    const double change =
        gap < 0 ? remaining * memory.contact.normal.dot(acceleration_.chassis.head<3>() + turn) : 0;
    if (std::max(std::abs(rate), std::abs(change)) < ImpactLaw::kLeastApproach) continue;
    if (gap > 0 && gap > -2 * rate * remaining) continue;  // does not touch in this time
    const double stiffness = mechanism_.law_of(memory.contact).impact_stiffness() * count;
    const double duration =
        std::numbers::pi * std::sqrt(mechanism_.effective_mass(memory.contact, state) / stiffness);
    const double until_touch = gap > 0 ? gap / -rate : 0;
    longest = std::min(longest, std::max(duration / kStepsInImpact, 0.8 * until_touch));
  }
  return longest;
}

bool Stepper::attempt(const State& from, double duration) {
  const std::size_t legs = mechanism_.legs.size();
  const double tau = kSdirkGamma * duration;
  StageSolver::Input input;
  input.tau = tau;
  input.loads = {tau, from.time, from.time + duration, true, &from.loads};

  Vector3 floor_first = Vector3::Zero();
  floor_second_.setZero();
  if (!floor_.at_rest() && from.time < floor_.duration()) {
    const Vector3 v0 = floor_.velocity_at(from.time);
    const Vector3 v1 = floor_.velocity_at(from.time + 2 * tau);
    const Vector3 v2 = floor_.velocity_at(from.time + duration);
    floor_first = (v1 - v0) / (2 * tau);
    floor_second_ = ((v2 - v0) / duration - (1 - kSdirkGamma) * floor_first) / kSdirkGamma;
  }

  input.start = &from;
  input.floor_acceleration = floor_first;
  input.loads.floor_acceleration_up = floor_first.z();
  input.guess =
      acceleration_known_ ? advanced(from.velocity, tau, acceleration_, legs) : from.velocity;
  input.contacts = &contacts_;
  const bool first_converged = solver_.solve(input, first_);
  quality_.newton_iterations += first_.iterations;
  if (!std::isfinite(first_.residual)) return false;

  extrapolate(from, duration, first_, legs, between_);
  input.start = &between_;
  input.floor_acceleration = floor_second_;
  input.loads.floor_acceleration_up = floor_second_.z();
  input.guess = advanced(between_.velocity, tau, first_.acceleration, legs);
  input.loads.start = &between_.loads;
  input.loads.first = false;
  const bool second_converged = solver_.solve(input, second_);
  quality_.newton_iterations += second_.iterations;
  second_.end.time = from.time + duration;
  return first_converged && second_converged && std::isfinite(second_.residual);
}

void Stepper::accept(State& state, double duration, const Observer& observer) {
  add_power(first_.power, (1 - kSdirkGamma) * duration, account_);
  add_power(second_.power, kSdirkGamma * duration, account_);
  const double tau = kSdirkGamma * duration;
  account_.numerical_loss += 0.5 * tau * tau * (second_.spring_rates - first_.spring_rates);
  quality_.largest_residual =
      std::max({quality_.largest_residual, first_.residual, second_.residual});
  ++quality_.steps;
  acceleration_ = second_.acceleration;
  acceleration_known_ = true;
  if (observer) observer({&state, &second_.end, &first_, &second_, floor_second_, duration});
  std::swap(state, second_.end);
}

std::optional<double> Stepper::locate_landing(const State& from, double duration) {
  double low = 0, high = duration;
  double at_low = mechanism_.loads.penetration(from.loads);
  double at_high = mechanism_.loads.penetration(second_.end.loads);
  double trial = duration;
  for (int i = 0; i < kMaxLandingTrials && high - low > 1e-15; ++i) {
    trial = low + (high - low) * at_low / (at_low - at_high);
    if (!attempt(from, trial)) return std::nullopt;
    const double here = mechanism_.loads.penetration(second_.end.loads);
    if (std::abs(here) < kLandingTolerance) break;
    if (here < 0) {
      low = trial;
      at_low = here;
    } else {
      high = trial;
      at_high = here;
    }
  }
  return trial;
}

std::optional<std::string> Stepper::advance_smoothly(State& state, double time, int depth,
                                                     const Observer& observer) {
  double duration = time - state.time;
  const bool converged = attempt(state, duration);
  if (!converged) {
    if (depth < settings_.max_subdivisions) {
      if (depth == 0) ++quality_.subdivided_steps;
      acceleration_known_ = false;
      const double middle = state.time + 0.5 * duration;
      if (auto cause = advance_smoothly(state, middle, depth + 1, observer)) return cause;
      return advance_smoothly(state, time, depth + 1, observer);
    }
    const bool finite = std::isfinite(first_.residual) && std::isfinite(second_.residual);
    const double residual = std::max(first_.residual, second_.residual);
    if (!finite || residual > kAcceptableResidual)
      return fmt::format("the contact solve did not converge at {:.6g} s, residual {:.3g}",
                         state.time, finite ? residual : std::nan(""));
    ++quality_.unconverged_steps;
  }
  if (!mechanism_.loads.empty() &&
      mechanism_.loads.penetration(second_.end.loads) > kLandingTolerance) {
    const std::optional<double> landing = locate_landing(state, duration);
    if (!landing) return "the landing of a drop weight could not be located";
    duration = *landing;
    ++quality_.event_steps;
    accept(state, duration, observer);
    account_.damper_loss += mechanism_.loads.land(state.loads);
    acceleration_known_ = false;
    if (time - state.time < kShortestStep) {
      state.time = time;
      return std::nullopt;
    }
    return advance_smoothly(state, time, depth, observer);
  }
  accept(state, duration, observer);
  state.time = time;
  return std::nullopt;
}

std::optional<std::string> Stepper::advance(State& state, double time, const Observer& observer) {
  std::optional<std::string> cause;
  while (!cause && state.time < time) {
    for (BodyContactState& memory : state.contacts)
      if (memory.compression <= 0) memory.approach_speed = approach_speed(memory.contact, state);
    const double remaining = time - state.time;
    const double step = longest_step(state, remaining);
    const double parts = std::ceil(remaining / step);
    if (parts >= 2) ++quality_.event_steps;
    cause = advance_smoothly(state, parts < 2 ? time : state.time + remaining / parts, 0, observer);
  }
  if (!cause && !state.position.allFinite()) cause = "the position is not finite";
  return cause;
}

}  // namespace gurney
