#include "studies/explanation/what_if.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <mutex>

#include "engine/base/append_all.h"
#include "engine/base/error.h"
#include "engine/base/parallel.h"
#include "engine/base/units.h"
#include "engine/run/overlaps.h"
#include "engine/run/run.h"
#include "engine/scene/perturbed.h"
#include "studies/explanation/explain.h"
#include "studies/explanation/words.h"
#include "studies/findings/findings.h"
#include "studies/statistics/bands.h"

namespace gurney::explanation {
namespace {

constexpr double kFarther = 0.5;  // [m]

/// Cords reach what has been moved.
void lengthen_tethers(Scene& scene) {
  for (Tether& tether : scene.tethers)
    tether.slack_length = std::max(tether.slack_length, placed_length(scene, tether));
}

/// Obstacle that the item overlaps at the start; empty: none.
std::string obstacle(const Scene& scene, std::size_t item) {
  if (scene.items.size() == 1 && scene.room.empty()) return {};
  for (const Overlap& overlap : find_overlaps(scene)) {
    const bool other = overlap.other_item >= 0;
    if (overlap.item == item)
      return other ? scene.items[static_cast<std::size_t>(overlap.other_item)].name
                   : scene.room[static_cast<std::size_t>(overlap.shape)].name;
    if (other && static_cast<std::size_t>(overlap.other_item) == item)
      return scene.items[overlap.item].name;
  }
  return {};
}

/// The variants of one item.
class Variants {
 public:
  Variants(const study::RunFacts& facts, const Explanation& of)
      : scene_(facts.scene), of_(of), item_(scene_.items.at(of.subject)) {}

  void brakes() {
    std::vector<Caster> casters;
    const auto each = [this](const Scene& scene, const auto& visit) {
      for (std::size_t i = 0; i < scene.items.size(); ++i)
        if (root_of(scene, i) == of_.subject) visit(i);
    };
    each(scene_, [&](std::size_t i) {
      const std::vector<Caster>& own = scene_.items[i].model.casters;
      append_all(casters, own);
    });
    const auto braked = [](const Caster& c) { return c.brake_torque > 0; };
    Variant& on = add("all brakes on", "Locking every wheel");
    each(on.scene, [&](std::size_t i) {
      for (Caster& caster : on.scene.items[i].model.casters)
        if (!braked(caster)) caster.brake_torque = std::numeric_limits<double>::infinity();
    });
    if (casters.empty())
      on.reason = "it has no casters";
    else if (std::ranges::all_of(casters, braked))
      on.reason = "all of its casters are braked already";
    Variant& off = add("all brakes off", "Releasing its brakes");
    each(off.scene, [&](std::size_t i) {
      for (Caster& caster : off.scene.items[i].model.casters) caster.brake_torque = 0;
    });
    if (casters.empty())
      off.reason = "it has no casters";
    else if (std::ranges::none_of(casters, braked))
      off.reason = "none of its casters is braked";
  }

  void headings() {
    for (const int angle : {90, 180, 270}) {
      Variant& turned = add(fmt::format("turned by {} deg", angle),
                            fmt::format("Turning it by {} degrees", angle));
      move(turned, Vector2::Zero(), angle * kRadiansPerDegree);
    }
  }

  void walls() {
    const bool hit = of_.hit.has_value();
    const std::string other = hit ? other_name() : "";
    const std::string farther_words = of_.units.text(kFarther, "m");
    Variant& farther = add(hit ? farther_words + " farther from " + other : "farther from walls",
                           "Standing " + farther_words + " farther from " + other);
    Variant& without = add(hit ? fmt::format("without {}", other) : "without walls",
                           fmt::format("Taking {} away", other));
    if (!hit) {
      farther.reason = without.reason =
          scene_.room.empty() ? "there is nothing in the room" : "it hit nothing hard";
      return;
    }
    const double side = of_.hit->item == of_.subject ? 1 : -1;
    Vector2 away = side * of_.hit->normal.head<2>();
    if (away.norm() < 0.1) away = -of_.direction;
    move(farther, kFarther * away.normalized(), 0);
    remove(without, other);
  }

  void center_of_mass() {
    for (const int percent : {10, 20}) {
      Variant& lower = add(fmt::format("centre of mass {} % lower", percent),
                           fmt::format("Lowering its centre of mass by {} %", percent));
      EquipmentModel& model = of(lower).model;
      const MassProperties whole = whole_item(model), rigid = chassis_with_payloads(model);
      const double down = 0.01 * percent * whole.center_of_mass.z() * whole.mass / rigid.mass;
      model.chassis_center_of_mass.z() -= down;
      for (Payload& payload : model.payloads) payload.center_of_mass.z() -= down;
      if (model.chassis_center_of_mass.z() <= 0)
        lower.reason = "the chassis would have its mass below the floor";
    }
  }

  void tethers() {
    const auto holds = [this](const Tether& tether) {
      return root_of(scene_, tether.item) == of_.subject ||
             (tether.anchor_item && root_of(scene_, *tether.anchor_item) == of_.subject);
    };
    const bool tethered = std::ranges::any_of(scene_.tethers, holds);
    Variant& without = add("without its cords", "Taking its cords away");
    std::erase_if(without.scene.tethers, holds);
    if (!tethered) without.reason = "nothing ties it to the room";
    Variant& straps = add("with two straps", "Holding it with two straps");
    if (of_.direction.isZero()) {
      straps.reason = "it did not move in any direction";
      return;
    }
    straps.scene.tethers.push_back(strap_of(scene_, of_.subject, "strap ahead", of_.direction));
    straps.scene.tethers.push_back(strap_of(scene_, of_.subject, "strap behind", -of_.direction));
  }

  std::vector<Variant> all() && { return std::move(variants_); }

 private:
  Variant& add(const std::string& name, const std::string& clause) {
    variants_.reserve(16);  // references into it stay
    return variants_.emplace_back(Variant{name, clause, scene_, {}});
  }

  PlacedItem& of(Variant& variant) const { return variant.scene.items[of_.subject]; }

  /// The item, or what carries it, with all that hangs and stands on that.
  void move(Variant& variant, const Vector2& by, double turn) const {
    const std::size_t carrier = carrier_of(variant.scene, of_.subject);
    const InitialMotion from = variant.scene.items[carrier].initial;
    move_item(variant.scene, carrier, from.position + Vector3(by.x(), by.y(), 0), from.yaw + turn);
    lengthen_tethers(variant.scene);
    if (const std::string in = obstacle(variant.scene, of_.subject); !in.empty())
      variant.reason = "it would stand in " + in;
  }

  std::string other_name() const {
    return of_.hit->item == of_.subject ? of_.hit->other : of_.items.at(of_.hit->item).name;
  }

  void remove(Variant& variant, const std::string& other) const {
    const auto erased =
        std::erase_if(variant.scene.room, [&](const RoomShape& s) { return s.name == other; });
    if (erased == 0) variant.reason = other + " is an item, not a part of the room";
  }

  const Scene& scene_;
  const Explanation& of_;
  const PlacedItem& item_;
  std::vector<Variant> variants_;
};

/// Outcome of one run.
struct RunOutcome {
  std::string failure;
  double peak_displacement = 0, tilt_ratio = 0, hardest_impact = 0;
  bool overturned = false, happened = false;
};

bool happened(const RunOutcome& run, Finding finding) {
  switch (finding) {
    case Finding::kOverturned:
    case Finding::kToppled:
      return run.overturned;
    case Finding::kHit:
      return run.overturned || run.hardest_impact >= kHit;
    case Finding::kRocked:
      return run.overturned || run.tilt_ratio >= kRocks;
    case Finding::kMoved:
    case Finding::kStill:
      break;
  }
  return run.overturned || run.peak_displacement > kHarmless;
}

RunOutcome outcome_of(const study::RunFacts& facts, const Scene& scene, const Explanation& of) {
  RunOutcome result;
  Response response;
  try {
    response = gurney::run(scene, facts.floor,
                           finely_stored(facts.settings, facts.floor, scene.items.size()));
    if (is_failure(response.outcome)) result.failure = "its run failed: " + response.cause;
  } catch (const Error& error) {
    result.failure = error.what();
  }
  if (!result.failure.empty()) return result;
  const ItemResponse& item = response.items.at(of.subject);
  const Impact* const hit = hardest_impact(response, of.subject);
  result.peak_displacement = item.demands.peak_displacement;
  result.tilt_ratio =
      tilt_margin(scene.items.at(of.subject).model, item.history, until_overturned(item)).ratio();
  result.hardest_impact = hit == nullptr ? 0 : hit->approach_speed;
  result.overturned = item.demands.lies_from() >= 0;
  result.happened = happened(result, of.item().finding);
  return result;
}

/// Median; of an even number the mean of the middle two.
double median(std::vector<double> values) {
  if (values.empty()) return 0;
  std::ranges::sort(values);
  const std::size_t half = values.size() / 2;
  return values.size() % 2 == 1 ? values[half] : (values[half - 1] + values[half]) / 2;
}

VariantOutcome summed_up(const Variant& variant, const std::vector<RunOutcome>& runs) {
  VariantOutcome result{.name = variant.name, .clause = variant.clause, .reason = variant.reason};
  std::vector<double> displacements, ratios, impacts;
  for (const RunOutcome& run : runs) {
    if (!run.failure.empty()) {
      ++result.failed;
      continue;
    }
    ++result.runs;
    result.overturned += run.overturned;
    result.happened += run.happened;
    displacements.push_back(run.peak_displacement);
    ratios.push_back(run.tilt_ratio);
    impacts.push_back(run.hardest_impact);
  }
  result.peak_displacement = median(displacements);
  result.tilt_ratio = median(ratios);
  result.hardest_impact = median(impacts);
  if (result.reason.empty() && result.runs == 0 && !runs.empty())
    result.reason = runs.front().failure;
  return result;
}

/// "overturning", as what was prevented or not.
std::string event_of(Finding finding, const study::UnitSystem& units) {
  switch (finding) {
    case Finding::kOverturned:
      return "overturning";
    case Finding::kToppled:
      return "toppling";
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
  return findings::listed(names);
}

/// Motion that remains with the best of the preventing variants.
std::string left_over(const VariantOutcome& best, const study::UnitSystem& units) {
  return fmt::format(" {} keeps it nearest to its place: it then moves by up to {}.", best.clause,
                     length(best.peak_displacement, units));
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
  text += fmt::format(" It was rarest, {}, in: {}.", frequency(*best), findings::listed(names));
  if (interval_of(*best).high >= interval_of(what.as_it_was).low)
    text += " The intervals overlap: more --replicas would tell whether that is chance.";
  return text;
}

}  // namespace

Tether strap_of(const Scene& scene, std::size_t item, const std::string& name,
                const Vector2& towards) {
  constexpr double kOutside = 0.3, kSlack = 0.02, kStiffness = 5e4, kDamping = 500;
  const PlacedItem& placed = scene.items[item];
  double reach = 0;
  for (const BodyShape& box : placed.model.shape)
    reach = std::max(reach, (box.center.cwiseAbs() + box.size / 2).head<2>().norm());
  Tether strap;
  strap.name = name;
  strap.item = item;
  strap.point = whole_item(placed.model).center_of_mass;
  const Vector3 from = placed_point(scene, item, strap.point);
  strap.anchor = from;
  strap.anchor.head<2>() += (reach + kOutside) * towards;
  strap.slack_length = (strap.anchor - from).norm() + kSlack;
  strap.stiffness = kStiffness;
  strap.damping = kDamping;
  return strap;
}

std::vector<Variant> variants_of(const study::RunFacts& facts, const Explanation& of) {
  Variants variants(facts, of);
  variants.brakes();
  variants.headings();
  variants.walls();
  variants.center_of_mass();
  variants.tethers();
  return std::move(variants).all();
}

WhatIf what_if(const study::RunFacts& facts, const Explanation& of, std::size_t replicas,
               int threads, const std::function<void(std::size_t, std::size_t)>& progress) {
  std::vector<Variant> variants{{"as it was", "", facts.scene, {}}};
  for (Variant& variant : variants_of(facts, of)) variants.push_back(std::move(variant));
  std::vector<std::vector<RunOutcome>> runs(variants.size());
  std::vector<std::pair<std::size_t, std::size_t>> tasks;
  for (std::size_t i = 0; i < variants.size(); ++i) {
    if (!variants[i].reason.empty()) continue;
    runs[i].resize(replicas);
    for (std::size_t k = 0; k < replicas; ++k) tasks.emplace_back(i, k);
  }
  std::mutex reports;
  std::size_t finished = 0;
  parallel_for(tasks.size(), threads, [&](std::size_t t) {
    const auto [i, k] = tasks[t];
    runs[i][k] = outcome_of(facts, replica_of(variants[i].scene, k), of);
    if (!progress) return;
    const std::scoped_lock lock(reports);
    progress(++finished, tasks.size());
  });
  WhatIf result{.replicas = replicas, .as_it_was = summed_up(variants[0], runs[0]), .variants = {}};
  for (std::size_t i = 1; i < variants.size(); ++i)
    result.variants.push_back(summed_up(variants[i], runs[i]));
  return result;
}

std::string conclusion(const WhatIf& what, const Explanation& of) {
  const ItemFacts& item = of.item();
  if (item.finding == Finding::kStill ||
      (item.finding == Finding::kMoved && item.peak_displacement <= kHarmless))
    return fmt::format("{} moved by less than {} and hit nothing: there is nothing to prevent.",
                       item.name, of.units.text(kHarmless, "m"));
  const std::string event = event_of(item.finding, of.units);
  return what.replicas > 1 ? of_replicas(what, event) : of_single_runs(what, event, of.units);
}

}  // namespace gurney::explanation
