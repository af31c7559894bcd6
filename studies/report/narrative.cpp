#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/base/units.h"
#include "engine/response/settled.h"
#include "studies/explanation/events.h"
#include "studies/explanation/footprint.h"
#include "studies/explanation/words.h"
#include "studies/report/run_report.h"
#include "studies/results/names.h"

namespace gurney::report {
namespace {

using explanation::kVisible;
using explanation::length;
using findings::listed;
using findings::Section;
using findings::Texts;
using study::UnitSystem;

/// Below a title.
findings::List sentences(std::string title, Texts lines) {
  return {"", std::move(title), std::move(lines), findings::kAll, true};
}

// How far items moved, and how the run ended.

/// An item that lies on its side has no heading.
bool has_heading(const Demands& d) { return d.lies_from() < 0; }

/// Whether an angle is seen in a text with a tenth of a degree.
bool is_visible(double angle) { return std::abs(angle) / kRadiansPerDegree >= 0.05; }

/// Where it ended: `turned` is the largest turn of the run.
std::string place(const Demands& d, const UnitSystem& units) {
  std::string text = length(d.residual_displacement, units);
  if (has_heading(d) && is_visible(d.residual_yaw))
    text += " and " + units.fixed(d.residual_yaw, "rad", 1);
  return text + " from its start";
}

std::string motion(const Demands& d, const UnitSystem& units) {
  if (!(d.peak_displacement >= kVisible)) return "The item moved less than 1 mm. ";
  std::string text = fmt::format(
      "The item moved at most {} from its start (at {:.2f} s), at up to {}, on a path of {}. ",
      length(d.peak_displacement, units), d.time_of_peak_displacement,
      units.text(d.peak_velocity, "m/s"), units.text(d.path_length, "m"));
  if (has_heading(d) && is_visible(d.peak_yaw))
    text += fmt::format("It turned by up to {}. ", units.fixed(d.peak_yaw, "rad", 1));
  return text;
}

/// How far a part moved on its joint; empty where it did not.
std::string opening(const Demands& d, const UnitSystem& units) {
  std::string text;
  if (d.peak_travel >= kVisible) text = "opened by up to " + length(d.peak_travel, units);
  if (d.peak_swing >= Predictability::kLeastTilt)
    text = "swung by up to " + explanation::angle(d.peak_swing, units);
  if (d.time_of_release >= 0)
    text +=
        fmt::format("{}its latch let go at {:.2f} s", text.empty() ? "" : "; ", d.time_of_release);
  return text;
}

/// How an item left its place on what it stands on above the floor; empty where it did not.
std::string sliding(const Demands& d, const UnitSystem& units) {
  std::string text = opening(d, units);
  if (d.peak_slide >= kVisible)
    text = "slid at most " + length(d.peak_slide, units) + " where it stood";
  if (d.time_of_fall >= 0)
    text += fmt::format("{}FELL at {:.2f} s", text.empty() ? "" : " and ", d.time_of_fall);
  return text;
}

std::string lifting(const Demands& d, const UnitSystem& units) {
  if (const std::string slid = sliding(d, units); !slid.empty()) return "It " + slid + ". ";
  if (d.wheels.empty())
    return fmt::format("It tilted by up to {}. ", explanation::angle(d.peak_tilt, units));
  if (d.most_wheels_lifted == 0) return "Every wheel stayed on the floor. ";
  return fmt::format(
      "One or more wheels were off the floor for {:.3g} s in all, up to {} at once. ",
      d.lifted_time, d.most_wheels_lifted);
}

/// How the run ended: for its one item, or for all of several.
std::string ending(const Response& response, const UnitSystem& units) {
  const bool one = response.items.size() == 1;
  const std::string where =
      one ? ", " + place(response.items.front().demands, units) : std::string();
  const double end = response.end_time;
  switch (response.outcome) {
    case Outcome::kRested:
      return fmt::format("{} at rest at {:.2f} s{}.", one ? "It was" : "All items were", end,
                         where);
    case Outcome::kStillMoving:
      return fmt::format(
          "{} STILL MOVED when the settling time was over at {:.2f} s{}: residual values are not "
          "final.",
          one ? "It" : "Something", end, where);
    case Outcome::kStopped:
      return fmt::format("The run stopped at {:.2f} s as asked{}.", end, where);
    case Outcome::kOverturned:
      if (one) return fmt::format("It overturned and lay at {:.2f} s{}.", end, where);
      return fmt::format("{} of {} items overturned; the run ended at {:.2f} s.",
                         std::ranges::count_if(response.items,
                                               [](const ItemResponse& item) {
                                                 return item.demands.time_of_overturning >= 0;
                                               }),
                         response.items.size(), end);
    case Outcome::kDiverged:
    case Outcome::kUntrusted:
      break;
  }
  return {};
}

/// One line for each item that moved; the others in one.
Texts motions(const Response& response, const Texts& names, const UnitSystem& units) {
  Texts lines, still;
  for (std::size_t i = 0; i < response.items.size(); ++i) {
    const Demands& d = response.items[i].demands;
    if (!(d.peak_displacement >= kVisible)) {
      still.push_back(names.at(i));
      continue;
    }
    lines.push_back(fmt::format("{} moved at most {} (at {:.2f} s), ended {}", names.at(i),
                                length(d.peak_displacement, units), d.time_of_peak_displacement,
                                place(d, units)));
    if (d.most_wheels_lifted > 0)
      lines.back() += fmt::format("; {} of {} wheels off the floor at once, {:.3g} s in all",
                                  d.most_wheels_lifted, d.wheels.size(), d.lifted_time);
    if (const std::string slid = sliding(d, units); !slid.empty()) lines.back() += "; " + slid;
  }
  if (!still.empty()) lines.push_back("moved less than 1 mm: " + listed(still));
  return lines;
}

// Events on the way.

std::string overturning(const explanation::Overturning& of, const std::string& name,
                        const UnitSystem& units) {
  std::string text =
      fmt::format("{} {} at {:.2f} s", name, of.topples ? "TOPPLED" : "OVERTURNED", of.time);
  if (std::isfinite(of.direction)) text += ", falling " + explanation::towards(of.direction, units);
  Texts wheels;
  for (const auto& each : of.liftoffs)
    wheels.push_back(
        fmt::format("{} ({:.2f} s)", each.wheel.empty() ? "a wheel" : each.wheel, each.time));
  if (!wheels.empty())
    text += ". Wheels that had left the floor by then and not come back: " + listed(wheels);
  return text + "." + (of.half_cycle ? " " + explanation::sentence(*of.half_cycle, units) : "");
}

/// All impacts of an item with one other thing.
struct Hits {
  std::string item, other;
  int count = 0;
  double last = 0;
  const Impact* first = nullptr;
  const Impact* fastest = nullptr;
};

/// Fastest first.
std::vector<Hits> hits_of(const std::vector<Impact>& impacts, const Texts& items) {
  std::vector<Hits> all;
  for (const Impact& impact : impacts) {
    const std::string& item = items.at(impact.item);
    auto found = std::ranges::find_if(
        all, [&](const Hits& h) { return h.item == item && h.other == impact.other; });
    if (found == all.end())
      found = all.insert(all.end(), Hits{item, impact.other, 0, 0, &impact, &impact});
    ++found->count;
    found->last = impact.time;
    if (impact.approach_speed > found->fastest->approach_speed) found->fastest = &impact;
  }
  std::ranges::stable_sort(all, std::greater(),
                           [](const Hits& hits) { return hits.fastest->approach_speed; });
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

std::string hit_line(const Hits& hits, const UnitSystem& units) {
  const Impact& worst = *hits.fastest;
  const std::string when = hits.count == 1
                               ? ""
                               : fmt::format(" {} times from {:.2f} s to {:.2f} s, fastest",
                                             hits.count, hits.first->time, hits.last);
  const std::string force =
      std::isnan(worst.peak_force) ? "" : ", peak force " + units.text(worst.peak_force, "N");
  return fmt::format("{} hit {}{} at {:.2f} s with {} ({}impulse {}{})", hits.item,
                     hits.other == "floor" ? "the floor" : hits.other, when, worst.time,
                     units.text(worst.approach_speed, "m/s"), bodies(worst),
                     units.text(worst.impulse, "N s"), force);
}

void add_impacts(const Response& response, const Texts& names, const UnitSystem& units,
                 Section& all) {
  constexpr std::size_t kMost = 12;
  const std::vector<Hits> hits = hits_of(response.impacts, names);
  Texts lines;
  for (std::size_t i = 0; i < std::min(kMost, hits.size()); ++i)
    lines.push_back(hit_line(hits[i], units));
  if (hits.size() > kMost)
    lines.push_back(fmt::format("and {} more pairs, with {} at most", hits.size() - kMost,
                                units.text(hits[kMost].fastest->approach_speed, "m/s")));
  if (!lines.empty())
    all.add(sentences(fmt::format("Impacts: {}, fastest first:", response.impacts.size()), lines));
}

/// Names of the items that are in a zone in the last sample of the histories.
Texts items_in(const Zone& zone, const study::RunFacts& facts, const Response& response,
               const Texts& names) {
  using namespace explanation;
  const Polygon area = footprint(zone);
  Texts result;
  for (std::size_t i = 0; i < response.items.size(); ++i) {
    if (response.items[i].history.empty()) continue;
    const auto parts = footprint(facts.scene.items.at(i), last_finite(response.items[i].history));
    if (std::ranges::any_of(parts, [&](const Polygon& part) { return overlap(part, area); }))
      result.push_back(names[i]);
  }
  return result;
}

std::string zone_line(const Zone& zone, const ZoneOutcome& outcome, const Texts& items,
                      const UnitSystem& units) {
  const auto width = [&](double metres) { return units.fixed(metres, "m", 2); };
  if (outcome.occupied_at_end) {
    const bool blocked = !(outcome.free_width_at_end > 0);
    return fmt::format(
        "{} is {} at the end{}: {} of {}.", zone.name, blocked ? "BLOCKED" : "NARROWED",
        items.empty() ? "" : " by " + listed(items),
        blocked ? "no free width is left"
                : fmt::format("a free width of {} is left", width(outcome.free_width_at_end)),
        width(zone.width));
  }
  if (outcome.time_of_entry < 0) return zone.name + " stayed free.";
  return fmt::format(
      "{} is free at the end; it was occupied for {:.3g} s from {}, with a free width of {} left "
      "of {} at least.",
      zone.name, outcome.occupied_time,
      outcome.time_of_entry > 0 ? fmt::format("{:.2f} s on", outcome.time_of_entry)
                                : "the start on",
      width(outcome.least_free_width), width(zone.width));
}

std::string tether_line(const Tether& tether, const TetherOutcome& outcome, const std::string& item,
                        const UnitSystem& units) {
  const std::string what = fmt::format("{} of {} ", tether.name, item);
  if (outcome.time_taut < 0) return what + "stayed slack.";
  return what + fmt::format("got taut at {:.2f} s and {} (largest tension {}).", outcome.time_taut,
                            outcome.time_broken < 0
                                ? "held"
                                : fmt::format("BROKE at {:.2f} s", outcome.time_broken),
                            units.text(outcome.peak_tension, "N"));
}

// How far to trust it.

void add_predictability(const Response& response, const Texts& names, Section& all) {
  if (names.size() == 1) {
    if (const auto& only = response.items.front().predictability)
      all.say(explanation::sentence(*only) + ".");
    return;
  }
  Texts lines;
  using Verdict = Predictability::Verdict;
  for (const Verdict verdict : {Verdict::kChaotic, Verdict::kSensitive, Verdict::kPredictable}) {
    Texts alike;
    std::size_t first = 0;  // the one whose motion may be another from the earliest time on
    for (std::size_t i = 0; i < response.items.size(); ++i) {
      const auto& found = response.items[i].predictability;
      if (!found || found->verdict != verdict) continue;
      if (alike.empty() || found->horizon < response.items[first].predictability->horizon)
        first = i;
      alike.push_back(names[i]);
    }
    if (alike.empty()) continue;
    if (verdict == Verdict::kPredictable)
      lines.push_back("predictable until their peaks of displacement and tilt: " + listed(alike));
    else
      lines.push_back((alike.size() > 1 ? listed(alike) + "; first " : "") + names[first] + ": " +
                      explanation::sentence(*response.items[first].predictability));
  }
  if (!lines.empty()) all.add(sentences("Predictability", lines));
}

/// A change in percent: "+0.16 %", "-130 %", or that it is small.
std::string percent(double change) {
  const double size = std::abs(100 * change);
  if (size < 0.01) return "less than 0.01 %";
  return size < 10 ? fmt::format("{:+.2g} %", 100 * change)
                   : fmt::format("{:+.0f} %", 100 * change);
}

/// A change in percent without a sign.
std::string percent_at_most(double change) {
  const std::string text = percent(std::abs(change));
  return text.starts_with('+') ? text.substr(1) : text;
}

/// By how much half the time step changes a peak, of the items whose motion has a number.
struct StepChange {
  double largest = 0;  ///< of the peak
  std::string of;

  /// Peaks below `least` count as rest.
  void add(double peak, double at_half_step, double least, const std::string& name) {
    if (!(std::max(peak, at_half_step) >= least)) return;
    const double change = at_half_step / peak - 1;
    if (!of.empty() && std::abs(change) <= std::abs(largest)) return;
    largest = change;
    of = name;
  }

  void add_to(Texts& texts, const char* quantity, bool one_of_several) const {
    if (!of.empty())
      texts.push_back(one_of_several ? fmt::format("{}s by at most {} ({})", quantity,
                                                   percent_at_most(largest), of)
                                     : fmt::format("the {} by {}", quantity, percent(largest)));
  }
};

void add_time_step(const Response& response, const Texts& names, Section& all) {
  const Quality& quality = response.quality;
  if (quality.step_halvings > 0)  // for settings.peak_error
    all.say(fmt::format(
        "Time step: halved {} times{}; the last two changed {}.", quality.step_halvings,
        quality.step_halvings == Quality::kLargestHalvings ? ", no shorter is tried" : "",
        std::isfinite(quality.peak_change)
            ? "no judged demand by more than " + percent_at_most(quality.peak_change)
            : "an outcome"));
  StepChange displacement, tilt;
  for (std::size_t i = 0; i < response.items.size(); ++i) {
    const auto& found = response.items[i].predictability;
    if (!found || found->verdict == Predictability::Verdict::kChaotic || !found->half_step)
      continue;
    const Demands& d = response.items[i].demands;
    displacement.add(d.peak_displacement, found->half_step->peak_displacement,
                     Predictability::kLeastDisplacement, names[i]);
    tilt.add(d.peak_tilt, found->half_step->peak_tilt, Predictability::kLeastTilt, names[i]);
  }
  Texts changes;
  displacement.add_to(changes, "peak displacement", names.size() > 1);
  tilt.add_to(changes, "peak tilt", names.size() > 1);
  if (!changes.empty())
    all.say(fmt::format("Time step: half of it changes {}.", fmt::join(changes, ", ")));
}

/// Why a demand is not settled.
std::string reason(const SettledDemand& demand) {
  if (!std::isfinite(demand.step_change)) return "comes or goes";
  if (SettledDemand::kMargin * std::abs(demand.step_change) > SettledDemand::kFractions[3])
    return percent(demand.step_change);
  if (!demand.predictable()) return "by the change of mass";
  return demand.number.counts_events() ? "as many at half the step, which settles no count"
                                       : "others change by more";
}

/// ", of 45 demands: 40 within 1 % and 3 within 5 %; NOT SETTLED: ...": demands of the item and of its marked points
/// by name, those of wheels by their number.
/// Without demands that the item has in none of the runs: a fall of one that stands on the floor.
std::string settled_words(std::vector<SettledDemand> all, const EquipmentModel& model) {
  std::erase_if(all, [](const SettledDemand& each) {
    return std::isnan(each.number.value) && std::isnan(each.at_half_step) &&
           std::isnan(each.of_twin);
  });
  Texts counts, unsettled;
  for (const double fraction : SettledDemand::kFractions)
    if (const auto count = std::ranges::count(all, fraction, &SettledDemand::within); count > 0)
      counts.push_back(fmt::format("{} within {:g} %", count, 100 * fraction));
  if (counts.empty()) return fmt::format(": none of {} demands", all.size());
  std::size_t of_wheels = 0;
  for (const SettledDemand& each : all) {
    if (each.settled()) continue;
    if (each.number.of == DemandNumber::Of::kWheel) {
      ++of_wheels;
      continue;
    }
    const std::string part = study::part_of(each.number, model);
    std::string name = (part.empty() ? "" : part + ": ") + each.number.name;
    std::ranges::replace(name, '_', ' ');
    unsettled.push_back(fmt::format("{} ({})", name, reason(each)));
  }
  if (of_wheels > 0)
    unsettled.push_back(fmt::format("{} number{} of wheels", of_wheels, of_wheels == 1 ? "" : "s"));
  return fmt::format(", of {} demands: {}{}", all.size(), listed(counts),
                     unsettled.empty() ? "" : "; NOT SETTLED: " + listed(unsettled));
}

void add_settled(const study::RunFacts& facts, const Response& response, const Texts& names,
                 Section& all) {
  Texts lines;
  for (std::size_t i = 0; i < response.items.size(); ++i)
    if (const auto settled = settled_demands(response.items[i]); !settled.empty())
      lines.push_back((names.size() > 1 ? names[i] : "Settled") +
                      settled_words(settled, facts.scene.items.at(i).model));
  if (names.size() > 1 && !lines.empty())
    all.add(sentences("Settled", lines));
  else if (!lines.empty())
    all.say(lines.front() + ".");
}

}  // namespace

Section narrative(const study::RunFacts& facts, const Response& response, const UnitSystem& units) {
  Section all;
  if (is_failure(response.outcome))
    return all.say(
        fmt::format("The run {} at {:.4g} s: {}. Its results must not be used.",
                    response.outcome == Outcome::kUntrusted ? "is UNTRUSTED; it ended" : "DIVERGED",
                    response.end_time, response.cause));
  const Texts names = study::item_names(facts.scene);
  const Demands& first = response.items.front().demands;
  if (names.size() == 1) {
    all.say(motion(first, units) + lifting(first, units) + ending(response, units));
  } else {
    all.add(sentences(ending(response, units), motions(response, names, units)));
  }
  if (!response.cause.empty()) all.say(fmt::format("The run {}.", response.cause));
  for (const explanation::Overturning& each : explanation::overturnings_of(facts, response))
    all.say(overturning(each, names.at(each.item), units));
  add_impacts(response, names, units, all);
  for (std::size_t i = 0; i < response.zones.size(); ++i) {
    const Zone& zone = facts.scene.zones.at(i);
    all.say(zone_line(zone, response.zones[i], items_in(zone, facts, response, names), units));
  }
  for (std::size_t i = 0; i < response.tethers.size(); ++i) {
    const Tether& tether = facts.scene.tethers.at(i);
    all.say(tether_line(tether, response.tethers[i], names.at(tether.item), units));
  }
  add_predictability(response, names, all);
  add_time_step(response, names, all);
  add_settled(facts, response, names, all);
  return all;
}

}  // namespace gurney::report
