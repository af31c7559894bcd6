#include <fmt/format.h>

#include <algorithm>

#include "studies/explanation/text.h"
#include "studies/explanation/what_if.h"
#include "studies/render/wrapped.h"
#include "studies/report/words.h"
#include "studies/statistics/bands.h"

namespace gurney::explanation {
namespace {

std::string overturned_cell(const VariantOutcome& outcome, bool replicas) {
  if (!replicas) return outcome.overturned > 0 ? "yes" : "no";
  return fmt::format("{} of {}", outcome.overturned, outcome.runs);
}

std::string row(const VariantOutcome& outcome, bool replicas, std::size_t width,
                const study::UnitSystem& units) {
  const std::string impact =
      outcome.hardest_impact > 0 ? units.number(outcome.hardest_impact, "m/s", 2) : "-";
  const std::string tilt = outcome.tilt_ratio > 1 && 2 * outcome.overturned > outcome.runs
                               ? ">100"
                               : fmt::format("{:.0f}", 100 * outcome.tilt_ratio);
  return fmt::format("  {:<{}}{:>11}{:>11}{:>11}{:>13}\n", outcome.name, width,
                     units.number(outcome.peak_displacement, "m", 3), tilt, impact,
                     overturned_cell(outcome, replicas));
}

/// "overturning", as what was prevented or not.
std::string event_of(Finding finding, const study::UnitSystem& units) {
  switch (finding) {
    case Finding::kOverturned:
      return "overturning";
    case Finding::kHit:
      return "the impact";
    case Finding::kRocked:
      return "the rocking";
    case Finding::kMoved:
    case Finding::kStill:
      break;
  }
  return fmt::format("moving by more than {}", units.text(kHarmless, "m"));
}

/// "Locking every wheel, turning it by 90 degrees and ..."
std::string clauses(const std::vector<const VariantOutcome*>& outcomes) {
  std::vector<std::string> names;
  for (const VariantOutcome* each : outcomes) {
    std::string clause = each->clause;
    if (!names.empty()) clause[0] = static_cast<char>(std::tolower(clause[0]));
    names.push_back(clause);
  }
  return report::listed(names);
}

/// What the best of those that prevent it leave.
std::string left_over(const VariantOutcome& best, const study::UnitSystem& units) {
  return fmt::format(" {} keeps it nearest to its place: it then moves by up to {}.", best.clause,
                     length_words(best.peak_displacement, units));
}

std::string of_single_runs(const WhatIf& what, const std::string& event,
                           const study::UnitSystem& units) {
  std::vector<const VariantOutcome*> good, bad;
  for (const VariantOutcome& each : what.variants)
    if (each.reason.empty()) (each.prevented() ? good : bad).push_back(&each);
  std::string text;
  if (good.empty()) text = "Nothing that was tried would have prevented " + event + ".";
  if (!good.empty()) text = clauses(good) + " would have prevented " + event + ".";
  if (good.size() > 1)
    text +=
        left_over(**std::ranges::min_element(
                      good, {}, [](const VariantOutcome* each) { return each->peak_displacement; }),
                  units);
  if (!good.empty() && !bad.empty()) text += " " + clauses(bad) + " would not.";
  return text;
}

double share(const VariantOutcome& outcome) {
  return outcome.runs == 0
             ? 1
             : static_cast<double>(outcome.happened) / static_cast<double>(outcome.runs);
}

statistics::Interval interval_of(const VariantOutcome& outcome) {
  return statistics::proportion_interval(static_cast<int>(outcome.happened),
                                         static_cast<int>(outcome.runs));
}

/// "13 of 20 replicas (0.41 to 0.85)"
std::string frequency(const VariantOutcome& outcome) {
  const statistics::Interval interval = interval_of(outcome);
  return fmt::format("{} of {} replicas ({:.2f} to {:.2f})", outcome.happened, outcome.runs,
                     interval.low, interval.high);
}

std::string of_replicas(const WhatIf& what, const std::string& event) {
  double lowest = share(what.as_it_was);
  for (const VariantOutcome& each : what.variants)
    if (each.reason.empty()) lowest = std::min(lowest, share(each));
  std::vector<std::string> names;
  const VariantOutcome* best = nullptr;
  for (const VariantOutcome& each : what.variants)
    if (each.reason.empty() && share(each) == lowest) {
      names.push_back(each.name);
      best = &each;
    }
  std::string text = fmt::format(
      "One run of a variant proves little here. As it was, {} happened "
      "in {}, in brackets the 95 % interval of its probability.",
      event, frequency(what.as_it_was));
  if (best == nullptr || lowest >= share(what.as_it_was))
    return text + " No variant made it rarer.";
  text += fmt::format(" It was rarest, {}, in: {}.", frequency(*best), report::listed(names));
  if (interval_of(*best).high >= interval_of(what.as_it_was).low)
    text += " The intervals overlap: more --replicas would tell whether that is chance.";
  return text;
}

}  // namespace

std::string conclusion(const WhatIf& what, const Explanation& of) {
  const ItemFacts& item = of.item();
  if (item.finding == Finding::kStill ||
      (item.finding == Finding::kMoved && item.peak_displacement <= kHarmless))
    return fmt::format("{} moved by less than {} and hit nothing: there is nothing to prevent.",
                       item.name, of.units.text(kHarmless, "m"));
  const std::string event = event_of(item.finding, of.units);
  return what.replicas > 1 ? of_replicas(what, event) : of_single_runs(what, event, of.units);
}

std::string text(const WhatIf& what, const Explanation& of) {
  const bool replicas = what.replicas > 1;
  std::size_t width = 12;
  for (const VariantOutcome& each : what.variants) width = std::max(width, each.name.size() + 1);
  std::string text = "\nWhat if (each variant was run)\n";
  if (replicas)
    text += fmt::format("  {} replicas of each, whose masses differ by up to 1e-6; medians\n",
                        what.replicas);
  text += fmt::format("  {:<{}}{:>11}{:>11}{:>11}{:>13}\n  {:<{}}{:>11}{:>11}{:>11}\n", "", width,
                      "farthest", "tilt", "impact", "overturned", "", width, of.units.of("m").name,
                      "% of crit.", of.units.of("m/s").name);
  text += row(what.as_it_was, replicas, width, of.units);
  std::string without;
  for (const VariantOutcome& each : what.variants) {
    if (each.reason.empty())
      text += row(each, replicas, width, of.units);
    else
      without += fmt::format("  {:<{}}  {}\n", each.name, width,
                             render::wrapped(each.reason, width + 4, width + 4));
  }
  if (!without.empty()) text += "  Not tried:\n" + without;
  return text + "\n" + render::wrapped(conclusion(what, of), 0, 0) + "\n";
}

}  // namespace gurney::explanation
