#include "engine/run/simulate.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "engine/bullet/contact_search.h"
#include "engine/record/impact_log.h"
#include "engine/record/joint_log.h"
#include "engine/record/recorder.h"
#include "engine/record/run_clock.h"
#include "engine/record/support_log.h"
#include "engine/record/tether_log.h"
#include "engine/record/zone_log.h"
#include "engine/run/start.h"
#include "engine/solver/assembly.h"
#include "engine/solver/stepper.h"

namespace gurney {
namespace {

constexpr double kNoLimit = std::numeric_limits<double>::infinity();

/// Time that all items have reached, where one could not go on.
double earliest_time(const SceneState& state) {
  return std::ranges::min(state.items, {}, &State::time).time;
}

bool trusted(const std::vector<Recorder>& recorders) {
  return std::ranges::all_of(recorders, [](const Recorder& recorder) {
    return recorder.energy_error() <= EnergyBalance::kTrusted;
  });
}

std::string miss_of(const std::string& item, const Recorder& recorder) {
  return fmt::format(
      "the energy balance of {} is off by {:.2g} of the largest energy in play, above the limit of "
      "{:g}: {}; a shorter settings.time_step_s may resolve its contacts",
      item.empty() ? "the item" : item, recorder.energy_error(), EnergyBalance::kTrusted,
      recorder.energy_error_source());
}

struct Integration {
  Response response;
  /// When the first item overturned or toppled, the balance being right; < 0: never [s].
  double trusted_until = -1;
  std::size_t first_over = 0;  ///< that item
};

/// @param parts  of each time step once an item has overturned
Integration integrate(const Scene& scene, const Assembly& assembly, const FloorMotion& floor,
                      const SimulationSettings& settings, int parts = 1) {
  const std::size_t count = assembly.items.size();
  SceneState state = start_of(scene, assembly);
  double time = 0;

  Stepper stepper(assembly, floor, settings);
  ContactSearch search(scene, assembly, settings.skip_clear_collision_passes);
  std::vector<Recorder> recorders;
  for (std::size_t i = 0; i < count; ++i) recorders.emplace_back(scene, assembly, i, state);
  ImpactLog impacts(scene, assembly);
  JointLog joints(assembly, state);
  TetherLog tethers(assembly, scene.tethers.size());
  ZoneLog zones(scene, assembly);
  SupportLog supports(scene, assembly, state);
  RunClock clock(floor, assembly.breakpoints(), settings);
  const Stepper::Observer observer = [&](const Stepper::Step& step) {
    impacts.observe(step);
    tethers.observe(step);
    joints.observe(step);
    for (std::size_t i : step.island->items) recorders[i].observe(step, impacts.impacts_of(i));
  };
  bool overturned = false;
  const auto advance = [&](double until) -> std::optional<std::string> {
    const double longest = overturned && parts > 1 ? (until - time) / parts * (1 + 1e-9) : kNoLimit;
    for (double now = time; now < until;) {
      const double stop = search.next(state, now, std::min(until, now + longest));
      stepper.board(state);
      stepper.set_contacts(search.find(state, stop - now, &stepper.riders()), state);
      if (auto cause = stepper.advance(state, stop, observer)) return cause;
      now = stop;
    }
    return std::nullopt;
  };
  const auto sample = [&] {
    for (std::size_t i = 0; i < count; ++i)
      recorders[i].sample(state, stepper.accounts()[i], clock.keeps_history());
    return time;
  };

  const auto check = [&] {
    for (std::size_t i = 0; i < count; ++i) recorders[i].check(state, stepper.accounts()[i]);
  };

  double sampled_at = sample();
  check();
  zones.observe(time, 0, state);
  double trusted_until = -1;
  std::size_t first_over = 0;
  std::vector<RunClock::ItemMotion> motions(count);
  while (clock.next(time)) {
    const double began = time;
    if (const auto cause = advance(clock.target())) {
      time = earliest_time(state);
      clock.stop(Outcome::kDiverged, *cause);
      break;
    }
    time = clock.target();
    if (clock.at_breakpoint()) stepper.change_loads(state);
    zones.observe(time, clock.target() - began, state);
    supports.observe(time, state);
    if (clock.sample_due()) sampled_at = sample();
    if (clock.check_due()) check();
    for (std::size_t i = 0; i < count; ++i) motions[i] = recorders[i].motion();
    clock.observe(time, motions);
    bool overturns = false;
    for (std::size_t i = 0; i < count; ++i) {
      if (clock.overturned_at(i) != time) continue;
      recorders[i].overturned();
      if (!overturns && !overturned) first_over = i;
      overturns = true;
    }
    if (!overturns || overturned) continue;
    overturned = true;
    check();
    if (trusted(recorders)) trusted_until = time;
  }
  if (sampled_at != time) sample();
  check();
  if (clock.outcome() != Outcome::kDiverged)
    for (std::size_t i = 0; i < count; ++i)
      if (!(recorders[i].energy_error() <= EnergyBalance::kTrusted))
        clock.stop(Outcome::kUntrusted, miss_of(scene.items[i].name, recorders[i]));

  Response response;
  response.outcome = clock.outcome();
  response.cause = clock.cause();
  response.end_time = time;
  response.quality = stepper.quality();
  response.quality.collision_passes = search.collision_passes();
  response.impacts = impacts.finish(time);
  response.tethers = tethers.outcomes();
  response.zones = zones.outcomes();
  for (std::size_t i = 0; i < count; ++i)
    recorders[i].finish(state, stepper.accounts()[i], clock.overturned_at(i), response);
  supports.finish(response.items);
  joints.finish(response.items);
  return {std::move(response), trusted_until, first_over};
}

/// Whether one item, with its parts, is all that moves.
bool is_alone(const Assembly& assembly) {
  return std::ranges::all_of(assembly.roots, [](std::size_t root) { return root == 0; });
}

}  // namespace

Response simulate(const Scene& scene, const FloorMotion& floor,
                  const SimulationSettings& settings) {
  validate(scene);
  validate(settings);
  const Assembly assembly(scene);
  Integration run = integrate(scene, assembly, floor, settings);
  if (!is_failure(run.response.outcome) || run.trusted_until < 0) return std::move(run.response);
  // The fork of a caster of 0.1 kg, whose tread strikes the floor sideways, turns by a radian in 4 ms.
  for (const int parts : {2, 4}) {
    Integration finer = integrate(scene, assembly, floor, settings, parts);
    if (!is_failure(finer.response.outcome)) return std::move(finer.response);
  }
  if (!is_alone(assembly)) {
    const PlacedItem& first = scene.items[run.first_over];
    const bool topples = first.on && first.on->kind == Support::Kind::kItem;
    run.response.cause +=
        fmt::format("; the balance is within the limit until {} {} at {:.3g} s{}", first.name,
                    topples ? "toppled" : "overturned", run.trusted_until,
                    topples ? "" : ", where settings.follow_overturning = false ends the run");
    return std::move(run.response);
  }
  // What an overturned item does on the floor is not what a study asks for, and a study that excludes
  // such runs excludes overturned ones.
  SimulationSettings until_then = settings;
  until_then.follow_overturning = false;
  Response response = integrate(scene, assembly, floor, until_then).response;
  response.cause = fmt::format(
      "ends where it overturned at {:.3g} s: what followed {}", response.end_time,
      run.response.outcome == Outcome::kDiverged ? "diverged, " + run.response.cause
                                                 : "is not trusted, " + run.response.cause);
  return response;
}

}  // namespace gurney
