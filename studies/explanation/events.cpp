#include "studies/explanation/events.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "engine/base/units.h"
#include "studies/explanation/caster_words.h"
#include "studies/report/words.h"
#include "studies/study/results/names.h"

namespace gurney::explanation {
namespace {

constexpr double kTipped = 0.5 * kRadiansPerDegree;

bool lifted(const Sample& sample, std::size_t caster) {
  return sample.wheels[caster].mode == WheelMode::kLifted;
}

std::string casters_text(const EquipmentModel& item, const std::vector<std::size_t>& casters) {
  std::vector<std::string> names;
  for (const std::size_t caster : casters) names.push_back(caster_words(item, caster));
  return report::listed(names);
}

/// The first lift, the longest, and the last before it overturned.
void add_lifts(const std::string& name, const EquipmentModel& model, const ItemResponse& item,
               std::vector<Event>& events) {
  const double fall = item.demands.time_of_overturning;
  std::vector<Lift> lifts = lifts_of(model, item.history);
  if (fall >= 0) std::erase_if(lifts, [&](const Lift& lift) { return lift.from > fall; });
  if (lifts.empty()) return;
  const std::size_t longest = static_cast<std::size_t>(
      std::ranges::max_element(lifts, {}, [](const Lift& l) { return l.until - l.from; }) -
      lifts.begin());
  for (std::size_t i = 0; i < lifts.size(); ++i) {
    if (i != 0 && i != longest && (fall < 0 || i + 1 != lifts.size())) continue;
    const std::string casters = casters_text(model, lifts[i].casters);
    const bool back = lifts[i].landed && (fall < 0 || lifts[i].until < fall);
    events.push_back({lifts[i].from, EventKind::kLiftOff, name, casters,
                      back ? lifts[i].until : std::numeric_limits<double>::quiet_NaN(), true});
    if (back) events.push_back({lifts[i].until, EventKind::kLanded, name, casters, 0, true});
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
              std::vector<Event>& events) {
  const Demands& d = item.demands;
  if (const double onset = onset_of_motion(item.history); onset >= 0)
    events.push_back({onset, EventKind::kMoved, name, "", 0, true});
  add_brakes(name, model, item.history, events);
  if (model.casters.empty())
    add_tipping(name, item.history, events);
  else
    add_lifts(name, model, item, events);
  if (d.time_of_overturning >= 0)
    events.push_back(
        {d.time_of_overturning, EventKind::kOverturned, name, "", d.direction_of_overturning});
  if (d.peak_displacement >= kVisible)
    events.push_back(
        {d.time_of_peak_displacement, EventKind::kPeakDisplacement, name, "", d.peak_displacement});
  if (d.peak_tilt >= kTipped && d.time_of_overturning < 0)
    events.push_back({d.time_of_peak_tilt, EventKind::kPeakTilt, name, "", d.peak_tilt});
}

std::string hit_text(const Impact& impact) {
  const std::string what = impact.other == "floor" ? "the floor" : impact.other;
  return impact.body == "chassis" ? what : what + " (" + impact.body + ")";
}

/// Of each pair the first impact and the fastest.
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

std::vector<Lift> lifts_of(const EquipmentModel& item, const std::vector<Sample>& history) {
  std::vector<Lift> lifts;
  bool before = false;
  for (const Sample& sample : history) {
    bool now = false;
    for (std::size_t i = 0; i < item.casters.size(); ++i) {
      if (!lifted(sample, i)) continue;
      if (!before && !now) lifts.push_back({sample.time, sample.time, false, {}});
      now = true;
      auto& casters = lifts.back().casters;
      if (std::ranges::find(casters, i) == casters.end()) casters.push_back(i);
    }
    if (before || now) lifts.back().until = sample.time;
    if (before && !now) lifts.back().landed = true;
    before = now;
  }
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
    add_item(names.at(i), facts.scene.items.at(i).model, response.items[i], events);
  add_impacts(response, names, events);
  add_places(facts, response, names, events);
  std::ranges::stable_sort(events, {}, &Event::time);
  events.push_back({response.end_time, EventKind::kEnd, "", name_of(response.outcome)});
  return events;
}

}  // namespace gurney::explanation
