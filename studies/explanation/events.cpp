#include "studies/explanation/events.h"

#include <algorithm>
#include <functional>
#include <limits>
#include <map>
#include <tuple>

#include "engine/base/units.h"
#include "studies/findings/findings.h"
#include "studies/results/names.h"

namespace gurney::explanation {
namespace {

constexpr double kTipped = 0.5 * kRadiansPerDegree;

bool lifted(const Sample& sample, std::size_t caster) {
  return sample.wheels[caster].mode == WheelMode::kLifted;
}

std::size_t casters_off(const EquipmentModel& item, const Sample& sample) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < item.casters.size(); ++i) count += lifted(sample, i);
  return count;
}

/// The lift of the samples first <= k < end. A caster is off from its first lifted sample to the
/// first that is not.
Lift lift_of(const EquipmentModel& item, std::span<const Sample> history, std::size_t first,
             std::size_t end) {
  const auto time_of = [&](std::size_t k) { return history[std::min(k, history.size() - 1)].time; };
  Lift lift;
  lift.from = time_of(first);
  lift.until = time_of(end);
  lift.landed = end < history.size();
  std::vector<double> off_since(item.casters.size(), -1);
  for (std::size_t k = first; k < end; ++k) {
    lift.most = std::max(lift.most, casters_off(item, history[k]));
    for (std::size_t i = 0; i < item.casters.size(); ++i) {
      if (!lifted(history[k], i)) {
        off_since[i] = -1;
        continue;
      }
      if (off_since[i] < 0) off_since[i] = history[k].time;
      if (std::ranges::find(lift.casters, i) == lift.casters.end()) lift.casters.push_back(i);
      const double off = time_of(k + 1) - off_since[i];
      if (off > lift.longest) std::tie(lift.longest, lift.longest_caster) = std::tuple(off, i);
    }
  }
  for (std::size_t k = first; k < end; ++k)
    if (casters_off(item, history[k]) == lift.casters.size())
      lift.together += time_of(k + 1) - history[k].time;
  return lift;
}

std::string casters_text(const EquipmentModel& item, const std::vector<std::size_t>& casters) {
  std::vector<std::string> names;
  for (const std::size_t caster : casters) names.push_back(caster_words(item, caster));
  return findings::listed(names);
}

/// Samples until the item has overturned.
std::span<const Sample> upright(const ItemResponse& item) {
  const double fall = item.demands.lies_from();
  if (fall < 0) return item.history;
  const auto end = std::ranges::upper_bound(item.history, fall, {}, &Sample::time);
  return {item.history.begin(), end};
}

void add_lifts(const std::string& name, const EquipmentModel& model, const ItemResponse& item,
               std::vector<Event>& events) {
  const bool overturned = item.demands.lies_from() >= 0;
  for (const Lift& lift : stated_lifts(lifts_of(model, upright(item)), overturned)) {
    const std::string casters = casters_text(model, lift.casters);
    events.push_back({lift.from, EventKind::kLiftOff, name, casters,
                      lift.landed ? lift.until : std::numeric_limits<double>::quiet_NaN(), true,
                      Uplift{lift.casters.size(), lift.most, lift.together, lift.longest,
                             caster_words(model, lift.longest_caster), overturned}});
    if (lift.landed) events.push_back({lift.until, EventKind::kLanded, name, casters, 0, true});
  }
}

/// First sample in which a braked caster turns against its brake.
Skid first_turn(const EquipmentModel& model, const std::vector<Sample>& history) {
  for (const Sample& sample : history)
    for (std::size_t i = 0; i < model.casters.size(); ++i)
      if (model.casters[i].brake_torque > 0 && sample.wheels[i].mode == WheelMode::kRolls)
        return {sample.time, i};
  return {};
}

void add_brakes(const std::string& name, const EquipmentModel& model,
                const std::vector<Sample>& history, std::vector<Event>& events) {
  const Skid skid = first_skid(model, history), turn = first_turn(model, history);
  if (skid.time >= 0)
    events.push_back(
        {skid.time, EventKind::kGripExceeded, name, caster_words(model, skid.caster), 0, true});
  if (turn.time >= 0)
    events.push_back(
        {turn.time, EventKind::kBrakeTurned, name, caster_words(model, turn.caster), 0, true});
}

void add_tipping(const std::string& name, const std::vector<Sample>& history,
                 std::vector<Event>& events) {
  const auto tipped =
      std::ranges::find_if(history, [](const Sample& s) { return s.tilt >= kTipped; });
  if (tipped != history.end())
    events.push_back({tipped->time, EventKind::kTipped, name, "", tipped->tilt, true});
}

void add_item(const std::string& name, const EquipmentModel& model, const ItemResponse& item,
              bool is_part, std::vector<Event>& events) {
  const Demands& d = item.demands;
  if (d.time_of_release >= 0)
    events.push_back({d.time_of_release, EventKind::kReleased, name, "", 0});
  if (is_part) return;  // it moves with its item
  if (const double onset = onset_of_motion(item.history); onset >= 0)
    events.push_back({onset, EventKind::kMoved, name, "", 0, true});
  add_brakes(name, model, item.history, events);
  if (model.casters.empty())
    add_tipping(name, item.history, events);
  else
    add_lifts(name, model, item, events);
  if (d.time_of_fall >= 0) events.push_back({d.time_of_fall, EventKind::kFell, name, "", 0});
  for (const auto& [time, kind] : {std::pair{d.time_of_toppling, EventKind::kToppled},
                                   {d.time_of_overturning, EventKind::kOverturned}})
    if (time >= 0) events.push_back({time, kind, name, "", d.direction_of_overturning});
  if (d.peak_displacement >= kVisible)
    events.push_back(
        {d.time_of_peak_displacement, EventKind::kPeakDisplacement, name, "", d.peak_displacement});
  if (d.peak_tilt >= kTipped && d.lies_from() < 0)
    events.push_back({d.time_of_peak_tilt, EventKind::kPeakTilt, name, "", d.peak_tilt});
}

std::string hit_text(const Impact& impact) {
  const std::string what = impact.other == "floor" ? "the floor" : impact.other;
  return impact.body == "chassis" ? what : what + " (" + impact.body + ")";
}

/// First and fastest impact of each pair.
void add_impacts(const Response& response, const std::vector<std::string>& names,
                 std::vector<Event>& events) {
  std::map<std::pair<std::size_t, std::string>, std::pair<const Impact*, const Impact*>> pairs;
  for (const Impact& impact : response.impacts) {
    auto& [first, fastest] = pairs[{impact.item, impact.other}];
    if (first == nullptr) first = fastest = &impact;
    if (impact.approach_speed > fastest->approach_speed) fastest = &impact;
  }
  for (const auto& [pair, hits] : pairs)
    for (const Impact* hit : {hits.first, hits.second == hits.first ? nullptr : hits.second})
      if (hit != nullptr)
        events.push_back({hit->time, EventKind::kImpact, names.at(hit->item), hit_text(*hit),
                          hit->approach_speed});
}

void add_places(const study::RunFacts& facts, const Response& response,
                const std::vector<std::string>& names, std::vector<Event>& events) {
  for (std::size_t i = 0; i < response.tethers.size(); ++i) {
    const TetherOutcome& tether = response.tethers[i];
    const auto& [name, item] =
        std::pair(facts.scene.tethers.at(i).name, names.at(facts.scene.tethers[i].item));
    if (tether.time_taut >= 0)
      events.push_back({tether.time_taut, EventKind::kTaut, item, name, tether.peak_tension});
    if (tether.time_broken >= 0)
      events.push_back({tether.time_broken, EventKind::kUnplugged, item, name});
  }
  for (std::size_t i = 0; i < response.zones.size(); ++i)
    if (response.zones[i].time_of_entry > 0)
      events.push_back(
          {response.zones[i].time_of_entry, EventKind::kZone, "", facts.scene.zones.at(i).name});
}

}  // namespace

std::string place_of(const EquipmentModel& item, std::size_t caster) {
  constexpr double kMiddle = 0.02;  // [m]
  Vector3 middle = Vector3::Zero();
  for (const Caster& each : item.casters)
    middle += each.mount / static_cast<double>(item.casters.size());
  const Vector3 from = item.casters.at(caster).mount - middle;
  const std::string along = from.x() > kMiddle ? "front" : from.x() < -kMiddle ? "rear" : "";
  const std::string across = from.y() > kMiddle ? "left" : from.y() < -kMiddle ? "right" : "";
  if (along.empty() && across.empty()) return "middle";
  return along + (along.empty() || across.empty() ? "" : " ") + across;
}

std::string caster_words(const EquipmentModel& item, std::size_t caster) {
  const std::string& name = item.casters.at(caster).name;
  const std::string place = place_of(item, caster);
  if (name.empty()) return place + " caster";
  return name.find(place) != std::string::npos ? name : name + " (" + place + ")";
}

std::vector<Lift> lifts_of(const EquipmentModel& item, std::span<const Sample> history) {
  std::vector<Lift> lifts;
  for (std::size_t k = 0; k < history.size();) {
    if (casters_off(item, history[k]) == 0) {
      ++k;
      continue;
    }
    std::size_t end = k;
    while (end < history.size() && casters_off(item, history[end]) > 0) ++end;
    lifts.push_back(lift_of(item, history, k, end));
    k = end;
  }
  return lifts;
}

std::vector<Lift> stated_lifts(std::vector<Lift> lifts, bool overturned) {
  if (lifts.size() <= kStatedLifts) return lifts;
  const auto others = lifts.begin() + 1, last = lifts.end() - (overturned ? 1 : 0);
  std::ranges::stable_sort(others, last, std::greater{},
                           [](const Lift& lift) { return lift.until - lift.from; });
  lifts.erase(others + (kStatedLifts - (overturned ? 2 : 1)), last);
  std::ranges::sort(lifts, {}, &Lift::from);
  return lifts;
}

double onset_of_motion(const std::vector<Sample>& history) {
  constexpr double kSlow = 1e-3;  // [m/s]
  double onset = history.empty() ? -1 : history.front().time;
  for (const Sample& sample : history) {
    if (sample.velocity.head<2>().norm() < kSlow) onset = sample.time;
    if (sample.displacement.head<2>().norm() >= kVisible) return onset;
  }
  return -1;
}

Skid first_skid(const EquipmentModel& item, const std::vector<Sample>& history) {
  for (const Sample& sample : history)
    for (std::size_t i = 0; i < item.casters.size(); ++i)
      if (item.casters[i].brake_torque > 0 && sample.wheels[i].mode == WheelMode::kSkids)
        return {sample.time, i};
  return {};
}

std::vector<Event> events_of(const study::RunFacts& facts, const Response& response) {
  const std::vector<std::string> names = study::item_names(facts.scene);
  std::vector<Event> events;
  for (std::size_t i = 0; i < response.items.size(); ++i)
    add_item(names.at(i), facts.scene.items.at(i).model, response.items[i],
             joint_of(facts.scene, i).has_value(), events);
  add_impacts(response, names, events);
  add_places(facts, response, names, events);
  std::ranges::stable_sort(events, {}, &Event::time);
  events.push_back({response.end_time, EventKind::kEnd, "", name_of(response.outcome)});
  return events;
}

}  // namespace gurney::explanation
