#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "studies/report/fall.h"
#include "studies/report/footprint.h"
#include "studies/report/narrative.h"
#include "studies/report/words.h"
#include "studies/results/names.h"

namespace gurney::report {
namespace {

using study::UnitSystem;

/// All impacts of an item with one other thing.
struct Hits {
  std::string item, other;
  int count = 0;
  double last = 0;
  const Impact* first = nullptr;
  const Impact* fastest = nullptr;
};

/// Fastest first.
std::vector<Hits> hits_of(const std::vector<Impact>& impacts,
                          const std::vector<std::string>& items) {
  std::vector<Hits> all;
  for (const Impact& impact : impacts) {
    const std::string& item = items.at(impact.item);
    auto found = std::find_if(all.begin(), all.end(), [&](const Hits& h) {
      return h.item == item && h.other == impact.other;
    });
    if (found == all.end())
      found = all.insert(all.end(), Hits{item, impact.other, 0, 0, &impact, &impact});
    ++found->count;
    found->last = impact.time;
    if (impact.approach_speed > found->fastest->approach_speed) found->fastest = &impact;
  }
  std::stable_sort(all.begin(), all.end(), [](const Hits& a, const Hits& b) {
    return a.fastest->approach_speed > b.fastest->approach_speed;
  });
  return all;
}

/// "front right on rear left", where it is not chassis on chassis.
std::string bodies(const Impact& impact) {
  const std::string chassis = "chassis";
  if (impact.body == chassis && (impact.other_body.empty() || impact.other_body == chassis))
    return {};
  return impact.other_body.empty() ? impact.body + ", "
                                   : fmt::format("{} on {}, ", impact.body, impact.other_body);
}

std::string sentence(const Hits& hits, const UnitSystem& units) {
  const Impact& worst = *hits.fastest;
  const std::string other = hits.other == "floor" ? "the floor" : hits.other;
  const std::string when = hits.count == 1
                               ? ""
                               : fmt::format(" {} times from {:.2f} s to {:.2f} s, fastest",
                                             hits.count, hits.first->time, hits.last);
  const std::string force =
      std::isnan(worst.peak_force) ? "" : ", peak force " + units.text(worst.peak_force, "N");
  return fmt::format("  {} hit {}{} at {:.2f} s with {} ({}impulse {}{})\n", hits.item, other, when,
                     worst.time, units.text(worst.approach_speed, "m/s"), bodies(worst),
                     units.text(worst.impulse, "N s"), force);
}

std::string liftoff_text(const std::vector<Fall::Liftoff>& liftoffs) {
  if (liftoffs.empty()) return {};
  std::vector<std::string> wheels;
  for (const Fall::Liftoff& l : liftoffs)
    wheels.push_back(fmt::format("{} ({:.2f} s)", l.wheel.empty() ? "a wheel" : l.wheel, l.time));
  return fmt::format(" Wheels that had left the floor by then and not come back: {}.",
                     listed(wheels));
}

/// Names of the items that are in a zone in the last sample of the histories.
std::vector<std::string> items_in(const Zone& zone, const study::RunFacts& facts,
                                  const Response& response) {
  const std::vector<std::string> names = study::item_names(facts.scene);
  const Polygon area = footprint(zone);
  std::vector<std::string> result;
  for (std::size_t i = 0; i < response.items.size(); ++i) {
    if (response.items[i].history.empty()) continue;
    const auto parts = footprint(facts.scene.items.at(i), last_finite(response.items[i].history));
    if (std::any_of(parts.begin(), parts.end(),
                    [&](const Polygon& part) { return overlap(part, area); }))
      result.push_back(names[i]);
  }
  return result;
}

}  // namespace

std::string narrative_of_impacts(const Response& response, const std::vector<std::string>& items,
                                 const UnitSystem& units) {
  constexpr std::size_t kMax = 12;
  if (response.impacts.empty()) return {};
  const std::vector<Hits> hits = hits_of(response.impacts, items);
  std::string text = fmt::format("Impacts: {}, fastest first:\n", response.impacts.size());
  for (std::size_t i = 0; i < std::min(kMax, hits.size()); ++i) text += sentence(hits[i], units);
  if (hits.size() > kMax)
    text += fmt::format("  and {} more pairs, with {} at most\n", hits.size() - kMax,
                        units.text(hits[kMax].fastest->approach_speed, "m/s"));
  return text;
}

std::string narrative_of_falls(const study::RunFacts& facts, const Response& response,
                               const UnitSystem& units) {
  const std::vector<std::string> names = study::item_names(facts.scene);
  std::string text;
  for (const Fall& fall : falls(facts, response)) {
    text += fmt::format("{} OVERTURNED at {:.2f} s", names.at(fall.item), fall.time);
    if (std::isfinite(fall.direction)) text += ", falling " + towards(fall.direction, units);
    text += "." + liftoff_text(fall.liftoffs);
    if (fall.half_cycle) text += " " + sentence(*fall.half_cycle, units);
    text += "\n";
  }
  return text;
}

std::string narrative_of_zones(const study::RunFacts& facts, const Response& response,
                               const UnitSystem& units) {
  const auto width = [&](double metres) { return units.fixed(metres, "m", 2); };
  std::string text;
  for (std::size_t i = 0; i < response.zones.size(); ++i) {
    const ZoneOutcome& outcome = response.zones[i];
    const Zone& zone = facts.scene.zones.at(i);
    text += zone.name;
    if (outcome.occupied_at_end) {
      const std::string by = listed(items_in(zone, facts, response));
      text += fmt::format(
          " is {} at the end{}: ", outcome.free_width_at_end > 0 ? "NARROWED" : "BLOCKED",
          by.empty() ? "" : " by " + by);
      text += outcome.free_width_at_end > 0
                  ? fmt::format("a free width of {} is left of {}",
                                width(outcome.free_width_at_end), width(zone.width))
                  : fmt::format("no free width is left of {}", width(zone.width));
    } else if (outcome.time_of_entry >= 0) {
      text += fmt::format(
          " is free at the end; it was occupied for {:.3g} s from {}, with a free width of {} left "
          "of {} at least",
          outcome.occupied_time,
          outcome.time_of_entry > 0 ? fmt::format("{:.2f} s on", outcome.time_of_entry)
                                    : "the start on",
          width(outcome.least_free_width), width(zone.width));
    } else {
      text += " stayed free";
    }
    text += ".\n";
  }
  return text;
}

std::string narrative_of_tethers(const study::RunFacts& facts, const Response& response,
                                 const UnitSystem& units) {
  const std::vector<std::string> names = study::item_names(facts.scene);
  std::string text;
  for (std::size_t i = 0; i < response.tethers.size(); ++i) {
    const TetherOutcome& outcome = response.tethers[i];
    const Tether& tether = facts.scene.tethers.at(i);
    text += fmt::format("{} of {} ", tether.name, names.at(tether.item));
    if (outcome.time_taut < 0) {
      text += "stayed slack";
    } else {
      text += fmt::format("got taut at {:.2f} s and ", outcome.time_taut);
      text +=
          outcome.time_broken < 0 ? "held" : fmt::format("BROKE at {:.2f} s", outcome.time_broken);
      text += fmt::format(" (largest tension {})", units.text(outcome.peak_tension, "N"));
    }
    text += ".\n";
  }
  return text;
}

}  // namespace gurney::report
