#include "engine/record/impact_log.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/solver/quadrature.h"

namespace gurney {

ImpactLog::ImpactLog(const Scene& scene, const Assembly& assembly)
    : assembly_(assembly), others_{"floor"} {
  for (const PlacedItem& item : scene.items) {
    items_.push_back(item.name);
    std::vector<std::string>& names = wheels_.emplace_back();
    for (std::size_t i = 0; i < item.model.casters.size(); ++i) {
      const std::string& name = item.model.casters[i].name;
      names.push_back(name.empty() ? "wheel " + std::to_string(i) : name);
    }
  }
  for (const RoomShape& shape : scene.room) others_.push_back(shape.name);
}

ImpactLog::Key ImpactLog::key_of(const BodyContact& c) {
  const bool items = c.between_items();
  return {static_cast<int>(c.side.item), c.side.caster, c.other,
          items ? static_cast<int>(c.other_side.item) : -1, items ? c.other_side.caster : -1};
}

bool ImpactLog::in_island(const Key& key, const Island& island) const {
  return std::binary_search(island.items.begin(), island.items.end(),
                            static_cast<std::size_t>(key[0]));
}

void ImpactLog::begin(Pair& pair, const BodyContact& contact, const PairStep& now) {
  pair.in_impact = true;
  pair.impact = impacts_.size();
  pair.quiet_since = now.begins;
  Impact impact;
  impact.time = now.begins;
  const BodyContact::Side &a = contact.side, &b = contact.other_side;
  const auto name_of = [&](const BodyContact::Side& side) {
    return side.caster < 0 ? "chassis" : wheels_[side.item][static_cast<std::size_t>(side.caster)];
  };
  impact.item = a.item;
  impact.wheel = a.caster;
  impact.body = name_of(a);
  if (contact.between_items()) {
    impact.other_item = static_cast<int>(b.item);
    impact.other = items_[b.item];
    impact.other_body = name_of(b);
  } else {
    impact.other = others_[static_cast<std::size_t>(contact.other)];
  }
  impact.point = now.point;
  impact.normal = contact.normal;
  impact.approach_speed = now.approach;
  impact.peak_force =
      assembly_.laws.of(contact).compliant() ? 0 : std::numeric_limits<double>::quiet_NaN();
  impacts_.push_back(impact);
}

ImpactLog::Pair& ImpactLog::pair_of(const Key& key) {
  const auto known = std::ranges::lower_bound(pairs_, key, {}, &std::pair<Key, Pair>::first);
  if (known != pairs_.end() && known->first == key) return known->second;
  return pairs_.emplace(known, key, Pair())->second;
}

ImpactLog::PairStep& ImpactLog::step_of(const Key& key) {
  const auto known = std::ranges::find(steps_, key, &std::pair<Key, PairStep>::first);
  return known != steps_.end() ? known->second : steps_.emplace_back(key, PairStep()).second;
}

void ImpactLog::observe(const Stepper::Step& step) {
  const auto& before = step.from->contacts;
  const auto& after = step.to->contacts;
  if (before.empty() && pairs_.empty()) return;
  steps_.clear();
  for (std::size_t c = step.island->first_contact; c < step.island->end_contact; ++c) {
    const BodyContact& contact = after[c].contact;
    const Key key = key_of(contact);
    PairStep& now = step_of(key);
    now.contact = &contact;
    const auto& first = step.first->contacts[c];
    const auto& end = step.end->contacts[c];
    now.first_force += first.normal_force;
    now.force += end.normal_force;
    if (end.normal_force > 0) now.fastest = std::max(now.fastest, std::abs(end.normal_speed));
    const double d0 = before[c].compression, d1 = after[c].compression;
    const double crossing = step.time + (d0 * d1 < 0 ? step.duration * d0 / (d0 - d1) : 0.0);
    if (first.normal_force > 0 || end.normal_force > 0) {
      if (d0 <= 0 || !pair_of(key).touches) {
        now.approach = std::max(now.approach, before[c].approach_speed);
        if (crossing < now.begins) {
          now.begins = crossing;
          now.point = end.point;
        }
      }
    }
    if (first.normal_force > 0 || d0 > 0)
      now.ends = std::max(now.ends, d1 < 0 ? crossing : step.time);
  }
  for (const auto& [key, pair] : pairs_)
    if (in_island(key, *step.island) &&
        std::ranges::find(steps_, key, &std::pair<Key, PairStep>::first) == steps_.end())
      step_of(key).ends = step.time;
  // Impacts that begin in one step are listed by their pair.
  std::ranges::sort(steps_, {}, &std::pair<Key, PairStep>::first);
  for (auto& [key, now] : steps_) {
    Pair& pair = pair_of(key);
    if (!pair.in_impact && now.approach > kSlowestImpact) begin(pair, *now.contact, now);
    pair.touches = now.force > 0;
    if (!pair.in_impact) continue;
    Impact& impact = impacts_[pair.impact];
    impact.approach_speed = std::max(impact.approach_speed, now.approach);
    impact.impulse +=
        step.duration * ((1 - kSdirkGamma) * now.first_force + kSdirkGamma * now.force);
    if (!std::isnan(impact.peak_force))
      impact.peak_force = std::max({impact.peak_force, now.first_force, now.force});
    if (!pair.touches) {
      impact.duration = std::max(0.0, now.ends - impact.time);
      pair.in_impact = false;
    } else if (now.fastest > kSlowestImpact / 2) {
      pair.quiet_since = step.time + step.duration;
    } else if (step.time + step.duration - pair.quiet_since > kQuietTime) {
      impact.duration = pair.quiet_since - impact.time;
      pair.in_impact = false;
    }
  }
  std::erase_if(pairs_, [](const auto& each) { return !each.second.touches; });
}

ImpactLog::Kinds ImpactLog::impacts_of(std::size_t item) const {
  Kinds kinds;
  const int index = static_cast<int>(item);
  for (const auto& [key, pair] : pairs_) {
    if (!pair.in_impact || (key[0] != index && key[3] != index)) continue;
    const bool restitution = std::isnan(impacts_[pair.impact].peak_force);
    kinds.restitution |= restitution;
    kinds.compliant |= !restitution;
  }
  return kinds;
}

std::vector<Impact> ImpactLog::finish(double time) const {
  std::vector<Impact> impacts = impacts_;
  for (const auto& [key, pair] : pairs_)
    if (pair.in_impact) impacts[pair.impact].duration = time - impacts[pair.impact].time;
  std::stable_sort(impacts.begin(), impacts.end(),
                   [](const Impact& a, const Impact& b) { return a.time < b.time; });
  return impacts;
}

}  // namespace gurney
