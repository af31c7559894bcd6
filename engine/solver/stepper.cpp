#include "engine/solver/stepper.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/solver/quadrature.h"

namespace gurney {
namespace {

constexpr double kEventDistance =
    1e-10;  // of a weight from its floor, of a latch or a tether from its release [m]
/// Shorter remainders of a step are left out: rounding would be larger than the motion in them [s].
constexpr double kShortestStep = 1e-8;

constexpr int kMaxEventTrials = 20;

/// An event nearer to the start or end of a step than this fraction of it is left there.
constexpr double kEventTolerance = 1e-3;

/// Passes that find the time of an event and the floor's mean acceleration until then.
constexpr int kEventPasses = 4;

/// A step that no subdivision makes converge is still accepted below this residual, and counted.
constexpr double kAcceptableResidual = 1e-5;

void set_advanced(const Velocity& v, double time, const Velocity& acceleration, std::size_t casters,
                  Velocity& result) {
  result.chassis = v.chassis + time * acceleration.chassis;
  for (std::size_t i = 0; i < casters; ++i)
    result.joints[i] = v.joints[i] + time * acceleration.joints[i];
}

template <typename T>
T extrapolated(const T& y, const T& y_first) {
  return y + kSdirkExtrapolation * (y_first - y);
}

/// Start of the second stage: y + h (1 - gamma) k, with k = (y_first - y) / (gamma h).
void extrapolate_item(const State& from, const State& end, const Velocity& acceleration,
                      double duration, std::size_t casters, State& start) {
  const double time = (1 - kSdirkGamma) * duration;
  const Velocity& v1 = end.velocity;
  start.position = from.position + time * v1.chassis.head<3>();
  start.rotation = rotated(time * v1.chassis.tail<3>(), from.rotation);
  set_advanced(from.velocity, time, acceleration, casters, start.velocity);
  for (std::size_t i = 0; i < casters; ++i) {
    const CasterState& a = from.casters[i];
    const CasterState& b = end.casters[i];
    CasterState& s = start.casters[i];
    s.swivel_angle = a.swivel_angle + time * v1.joints[i][0];
    s.axle_angle = a.axle_angle + time * v1.joints[i][1];
    s.swivel_wind = extrapolated(a.swivel_wind, b.swivel_wind);
    s.axle_wind = extrapolated(a.axle_wind, b.axle_wind);
    s.tread.deflection = extrapolated(a.tread.deflection, b.tread.deflection);
    s.tread.roll_deflection = extrapolated(a.tread.roll_deflection, b.tread.roll_deflection);
    s.tread.sliding = a.tread.sliding;
    s.tread.rolling = b.tread.rolling;
    s.axle_slips = a.axle_slips;
  }
  start.broken_tethers = from.broken_tethers;
  if (!from.loads.empty()) from.loads.extrapolate(end.loads, kSdirkExtrapolation, start.loads);
}

void add_power(const EnergyAccount& power, double time, EnergyAccount& account) {
  account.work_of_floor += time * power.work_of_floor;
  account.work_of_forces += time * power.work_of_forces;
  account.work_of_fixtures += time * power.work_of_fixtures;
  account.work_of_neighbours += time * power.work_of_neighbours;
  account.rolling_loss += time * power.rolling_loss;
  account.sliding_loss += time * power.sliding_loss;
  account.relaxation_loss += time * power.relaxation_loss;
  account.tread_loss += time * power.tread_loss;
  account.axle_loss += time * power.axle_loss;
  account.swivel_loss += time * power.swivel_loss;
  account.damper_loss += time * power.damper_loss;
  account.contact_loss += time * power.contact_loss;
  account.numerical_loss += time * power.numerical_loss;
}

}  // namespace

Stepper::Stepper(const Assembly& assembly, const FloorMotion& floor,
                 const SimulationSettings& settings)
    : assembly_(assembly),
      floor_(floor),
      settings_(settings),
      solver_(assembly, {settings.residual, settings.max_newton_iterations}),
      contacts_of_(assembly.items.size()),
      riders_(assembly, settings.merge_held_bodies),
      predictions_(assembly.items.size()),
      reversals_(assembly, settings.time_step),
      crossings_(assembly),
      control_(assembly, settings),
      accounts_(assembly.items.size()) {
  input_.guess.resize(assembly.items.size());
  between_.items.resize(assembly.items.size());
  input_.riders = &riders_;
  islands_.update(contacts_, assembly, riders_);
}

void Stepper::change_loads(SceneState& state) {
  for (std::size_t i = 0; i < state.items.size(); ++i) {
    State& item = state.items[i];
    const Loads& loads = assembly_.items[i].loads;
    if (!loads.empty()) accounts_[i].damper_loss += loads.release(item.time, item.loads);
    predictions_[i].known = false;
  }
}

void Stepper::extrapolate(const Island& island, const SceneState& from, double duration) {
  for (std::size_t i : island.items)
    extrapolate_item(from.items[i], first_.end.items[i], first_.items[i].acceleration, duration,
                     assembly_.items[i].casters.size(), between_.items[i]);
  between_.joints.resize(from.joints.size());
  for (std::size_t j : island.joints) {
    JointState& joint = between_.joints[j] = from.joints[j];
    joint.coordinate = extrapolated(joint.coordinate, first_.end.joints[j].coordinate);
    joint.wind = extrapolated(joint.wind, first_.end.joints[j].wind);
  }
  between_.contacts.resize(from.contacts.size());
  for (std::size_t c = island.first_contact; c < island.end_contact; ++c) {
    between_.contacts[c] = from.contacts[c];
    between_.contacts[c].compression =
        extrapolated(from.contacts[c].compression, first_.end.contacts[c].compression);
    between_.contacts[c].deflection =
        extrapolated(from.contacts[c].deflection, first_.end.contacts[c].deflection);
    between_.contacts[c].lead = extrapolated(from.contacts[c].lead, first_.end.contacts[c].lead);
  }
}

bool Stepper::attempt(const Island& island, const SceneState& from, double duration) {
  const double tau = kSdirkGamma * duration;
  const double time = from.items[island.items.front()].time;
  input_.island = &island;
  input_.tau = tau;
  input_.loads = {tau, time, time + duration, true, nullptr};

  // SDIRK2: both stages are implicit and of length gamma h, the second from y + (1 - gamma) h k_1.
  const auto [floor_first, floor_second] = floor_stages(floor_, assembly_.gravity, time, duration);
  floor_second_ = floor_second;

  input_.start = &from;
  input_.floor = floor_first;
  input_.loads.floor_acceleration_up = floor_first.acceleration.z();
  for (std::size_t i : island.items) {
    const Velocity& v = from.items[i].velocity;
    if (predictions_[i].known)
      set_advanced(v, tau, predictions_[i].acceleration, assembly_.items[i].casters.size(),
                   input_.guess[i]);
    else
      input_.guess[i] = v;
  }
  const bool first_converged = solver_.solve(input_, first_);
  quality_.newton_iterations += first_.iterations;
  if (!std::isfinite(first_.residual)) return false;

  extrapolate(island, from, duration);
  input_.start = &between_;
  input_.floor = floor_second_;
  input_.loads.floor_acceleration_up = floor_second_.acceleration.z();
  for (std::size_t i : island.items)
    set_advanced(between_.items[i].velocity, tau, first_.items[i].acceleration,
                 assembly_.items[i].casters.size(), input_.guess[i]);
  input_.loads.first = false;
  const bool second_converged = solver_.solve(input_, second_);
  quality_.newton_iterations += second_.iterations;
  if (!std::isfinite(second_.residual)) return false;
  for (std::size_t i : island.items) second_.end.items[i].time = time + duration;
  return first_converged && second_converged;
}

void Stepper::accept(const Island& island, SceneState& state, double duration,
                     const Observer& observer) {
  const double tau = kSdirkGamma * duration;
  const double time = state.items[island.items.front()].time;
  for (std::size_t i : island.items) {
    const ItemStage::Output &first = first_.items[i], &second = second_.items[i];
    // Powers are integrated by the weights of the method, 1 - gamma and gamma.
    add_power(first.power, (1 - kSdirkGamma) * duration, accounts_[i]);
    add_power(second.power, kSdirkGamma * duration, accounts_[i]);
    accounts_[i].numerical_loss += 0.5 * tau * tau * (second.spring_rates - first.spring_rates);
    // The first guess of the next step.
    predictions_[i] = {second.acceleration, floor_second_.acceleration, true};
    crossings_.observe(i, assembly_.items[i].casters.size(), duration, first, second,
                       floor_second_.acceleration.z());
    const Tethers& tethers = assembly_.items[i].tethers;
    const double lost = tethers.empty() ? 0 : tethers.break_overstressed(second_.end.items[i]);
    accounts_[i].damper_loss += lost;
    if (lost > 0) predictions_[i].known = false;  // its acceleration jumps
  }
  for (std::size_t i : island.items)
    if (riders_.rides(i)) {
      riders_.place(i, second_.end.items[riders_.carrier(i)], second_.end.items[i]);
      riders_.hold(i, second_.holding[i]);
    }
  for (std::size_t j : island.joints) {
    const JointLaw& law = assembly_.joints[j];
    if (law.releases() && !riders_.rests(j))
      accounts_[law.joint().part].damper_loss +=
          law.work_latch(assembly_.joint_rate(j, second_.end), second_.end.joints[j]);
  }
  quality_.largest_residual =
      std::max({quality_.largest_residual, first_.residual, second_.residual});
  ++quality_.steps;
  if (observer)
    observer({&island, time, duration, &state, &second_.end, &first_, &second_, floor_second_});
  for (std::size_t i : island.items) state.items[i] = second_.end.items[i];
  for (std::size_t j : island.joints) state.joints[j] = second_.end.joints[j];
  for (std::size_t c = island.first_contact; c < island.end_contact; ++c)
    std::swap(state.contacts[c], second_.end.contacts[c]);
}

double Stepper::past_event(const Island& island, const SceneState& state) const {
  double farthest = -1;
  for (std::size_t i : island.items) {
    const Mechanism& item = assembly_.items[i];
    if (!item.loads.empty())
      farthest = std::max(farthest, item.loads.penetration(state.items[i].loads));
    if (!item.tethers.empty())
      farthest = std::max(farthest, item.tethers.past_strength(state.items[i]));
  }
  for (std::size_t j : island.joints)
    farthest = std::max(farthest, assembly_.joints[j].past_release(state.joints[j]));
  return farthest;
}

std::optional<double> Stepper::locate_event(const Island& island, const SceneState& from,
                                            double duration) {
  const double start = from.items[island.items.front()].time;
  double low = 0, high = duration;
  double at_low = past_event(island, from);
  double at_high = past_event(island, second_.end);
  if (!(at_low < 0)) return std::nullopt;  // the event lies before the step
  double trial = duration;
  for (int i = 0; i < kMaxEventTrials && high - low > 1e-15; ++i) {
    // Regula falsi on the step's length: the step ends at the event, and no law changes inside it.
    trial = low + (high - low) * at_low / (at_low - at_high);
    trial = (start + trial) - start;  // what is between the times at its ends
    if (!attempt(island, from, trial)) return std::nullopt;
    const double here = past_event(island, second_.end);
    if (std::abs(here) < kEventDistance) break;
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

std::optional<std::string> Stepper::advance_smoothly(const Island& island, SceneState& state,
                                                     double time, int depth,
                                                     const Observer& observer) {
  const double from = state.items[island.items.front()].time;
  double duration = time - from;
  const bool converged = attempt(island, state, duration);
  if (converged && free_riders(island, state)) return std::nullopt;
  if (control_.on() &&
      control_.rejects({island, duration, converged, state, predictions_, first_, second_})) {
    ++quality_.rejected_steps;
    return std::nullopt;
  }
  if (!converged) {
    if (depth < settings_.max_subdivisions) {
      if (depth == 0) ++quality_.subdivided_steps;
      // Halves start from the velocity itself: the prediction may have led astray.
      for (std::size_t i : island.items) predictions_[i].known = false;
      const double middle = from + 0.5 * duration;
      if (auto cause = advance_smoothly(island, state, middle, depth + 1, observer)) return cause;
      return advance_smoothly(island, state, time, depth + 1, observer);
    }
    const bool finite = std::isfinite(first_.residual) && std::isfinite(second_.residual);
    const double residual = std::max(first_.residual, second_.residual);
    if (!finite || residual > kAcceptableResidual)
      return fmt::format("the contact solve did not converge at {:.6g} s, residual {:.3g}", from,
                         finite ? residual : std::nan(""));
    ++quality_.unconverged_steps;
  }
  const bool at_event = past_event(island, second_.end) > kEventDistance;
  if (at_event) {
    const std::optional<double> event = locate_event(island, state, duration);
    if (!event)
      return "the time of a landing drop weight, a released latch or a broken tether was not found";
    duration = *event;
    ++quality_.event_steps;
  }
  accept(island, state, duration, observer);
  for (std::size_t i : island.items) {
    if (!assembly_.items[i].loads.empty())
      accounts_[i].damper_loss += assembly_.items[i].loads.land(state.items[i].loads);
    if (at_event) predictions_[i].known = false;
  }
  if (at_event && time - from - duration >= kShortestStep)
    return advance_smoothly(island, state, time, depth, observer);
  for (std::size_t i : island.items) state.items[i].time = time;
  return std::nullopt;
}

double Stepper::end_of_step(const Island& island, const SceneState& state, double latest) {
  const double time = state.items[island.items.front()].time;
  const double longest = latest - time;
  reversals_.collect(island, state, predictions_);
  const bool crosses =
      crossings_.near(island, longest) &&
      std::ranges::all_of(island.items, [&](std::size_t i) { return predictions_[i].known; });
  if (reversals_.none() && !crosses) return latest;
  double until = longest;
  for (int i = 0; i < kEventPasses; ++i) {
    const Vector3 change = apparent_floor_velocity(floor_, assembly_.gravity, time + until) -
                           apparent_floor_velocity(floor_, assembly_.gravity, time);
    const Vector3 floor = change / until;
    // The time depends on the floor's mean acceleration until then, which depends on the time.
    const double reversal = reversals_.first(floor);
    until = longest;
    if (reversal > kEventTolerance * longest) until = std::min(until, reversal);
    if (crosses) until = std::min(until, crossings_.first(island, floor.z(), longest));
  }
  if (until > (1 - kEventTolerance) * longest) return latest;
  ++quality_.event_steps;
  return time + until;
}

std::optional<std::string> Stepper::advance_island(const Island& island, SceneState& state,
                                                   double time, const Observer& observer) {
  const State& front = state.items[island.items.front()];
  while (front.time < time) {
    observe_approach(island, state);
    const double remaining = time - front.time;
    double parts = std::ceil(remaining / longest_step(island, state, remaining));
    if (parts >= 2) ++quality_.event_steps;
    parts = std::max(parts, std::ceil(remaining / control_.longest(island)));
    const double latest = parts < 2 ? time : front.time + remaining / parts;
    const double stop = end_of_step(island, state, latest);
    if (auto cause = advance_smoothly(island, state, stop, 0, observer)) return cause;
  }
  for (std::size_t i : island.items)
    if (!state.items[i].position.allFinite()) return "the position is not finite";
  return std::nullopt;
}

std::optional<std::string> Stepper::advance(SceneState& state, double time,
                                            const Observer& observer) {
  for (const Island& island : islands_.all())
    if (auto cause = advance_island(island, state, time, observer)) return cause;
  return std::nullopt;
}

}  // namespace gurney
