#include "studies/explanation/explain.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "engine/base/units.h"
#include "equipment/catalogue/support.h"
#include "studies/explanation/events.h"
#include "studies/results/names.h"

namespace gurney::explanation {
namespace {

/// Mass of an item with its parts and all that stands on it [kg].
double carried_mass(const Scene& scene, std::size_t item) {
  if (carrier_of(scene, item) != item) return whole_item(scene.items[item].model).mass;
  double mass = 0;
  for (std::size_t i = 0; i < scene.items.size(); ++i)
    if (carrier_of(scene, i) == item) mass += whole_item(scene.items[i].model).mass;
  return mass;
}

/// Whether parts of an item have casters, whose grip and support are not those of its chassis.
bool stands_on_parts(const Scene& scene, std::size_t item) {
  for (std::size_t i = item + 1; i < scene.items.size(); ++i)
    if (!scene.items[i].model.casters.empty() && root_of(scene, i) == item) return true;
  return false;
}

ItemFacts item_facts(const study::RunFacts& facts, const Response& response, std::size_t index) {
  const ItemResponse& item = response.items[index];
  const EquipmentModel& model = facts.scene.items.at(index).model;
  const Demands& d = item.demands;
  const bool is_part = joint_of(facts.scene, index).has_value();
  const bool on_parts = stands_on_parts(facts.scene, index);
  const double own_mass = whole_item(model).mass, mass = carried_mass(facts.scene, index);
  ItemFacts result{.name = study::item_names(facts.scene).at(index),
                   .has_casters = !model.casters.empty(),
                   .on_floor = carrier_of(facts.scene, index) == index && !on_parts,
                   .is_part = is_part,
                   .stands_on_parts = on_parts,
                   .mass = mass,
                   .carries = mass > own_mass,
                   .height_of_center_of_mass = whole_item(model).center_of_mass.z(),
                   .peak_displacement = d.peak_displacement,
                   .time_of_peak_displacement = d.time_of_peak_displacement,
                   .residual_displacement = d.residual_displacement,
                   .peak_velocity = d.peak_velocity,
                   .peak_travel = std::fmax(0, d.peak_travel),  // which may be no number
                   .peak_swing = std::fmax(0, d.peak_swing),
                   .stop_speed = std::fmax(0, d.largest_stop_speed),
                   .tilt = {},
                   .grip = {},
                   .first_lifted = {},
                   .first_skidded = {}};
  if (!is_part && !result.stands_on_parts)
    result.tilt = tilt_margin(model, item.history, until_overturned(item));
  if (result.on_floor)
    result.grip = grip_margin(facts, index, result.mass, item.history, until_overturned(item));
  result.finding = finding_of(response, index, result.tilt.ratio());
  if (const auto lifts = lifts_of(model, item.history); !lifts.empty()) {
    result.first_lifted = caster_words(model, lifts.front().casters.front());
    result.time_of_lift = lifts.front().from;
    const double fall = d.lies_from() < 0 ? response.end_time : d.lies_from();
    result.uplifts = static_cast<std::size_t>(
        std::ranges::count_if(lifts, [&](const Lift& lift) { return lift.from <= fall; }));
  }
  if (const Skid skid = first_skid(model, item.history); skid.time >= 0) {
    result.first_skidded = caster_words(model, skid.caster);
    result.time_of_skid = skid.time;
  }
  return result;
}

/// Item of the worst finding; of several the first to overturn, the hardest hit, the farthest moved. A part
/// moves with its item, which comes first.
std::size_t subject_of(const std::vector<ItemFacts>& items, const Response& response) {
  const auto severity = [&](std::size_t i) {
    const Impact* hit = hardest_impact(response, i);
    switch (items[i].finding) {
      case Finding::kOverturned:
      case Finding::kToppled:
        return -response.items[i].demands.lies_from();
      case Finding::kHit:
        return hit->approach_speed;
      case Finding::kRocked:
        return items[i].tilt.ratio();
      default:
        return items[i].is_part ? -1 : items[i].peak_displacement;
    }
  };
  std::size_t worst = 0;
  for (std::size_t i = 1; i < items.size(); ++i) {
    const auto here = std::pair(items[i].finding, severity(i));
    if (here > std::pair(items[worst].finding, severity(worst))) worst = i;
  }
  return worst;
}

/// The last sample before `time` for which `still` holds; without one, the start.
template <class Still>
double last_before(const std::vector<Sample>& history, double time, Still still) {
  double last = 0;
  for (const Sample& sample : history)
    if (sample.time < time && still(sample)) last = sample.time;
  return last;
}

const Sample& sample_before(const std::vector<Sample>& history, double time) {
  auto found = std::ranges::lower_bound(history, time, {}, &Sample::time);
  return found == history.begin() ? *found : *std::prev(found);
}

Vector2 unit(const Vector2& v) { return v.norm() > 0 ? Vector2(v.normalized()) : Vector2::Zero(); }

/// Since when the item has moved along `direction` without a stop.
double swing_start(const std::vector<Sample>& history, double time, const Vector2& direction) {
  return last_before(history, time,
                     [&](const Sample& s) { return direction.dot(s.velocity.head<2>()) <= 0; });
}

/// When and in which direction the worst happened.
void find_worst(const Response& response, Explanation& result) {
  const ItemResponse& item = response.items[result.subject];
  const Demands& d = item.demands;
  switch (result.item().finding) {
    case Finding::kOverturned:
    case Finding::kToppled:
      result.worst_time = d.lies_from();
      result.direction = {std::cos(d.direction_of_overturning),
                          std::sin(d.direction_of_overturning)};
      if (const Impact* const hit = hardest_impact(response, result.subject, result.worst_time);
          hit != nullptr && hit->approach_speed >= kHit)
        result.hit = *hit;
      return;
    case Finding::kHit: {
      result.hit = *hardest_impact(response, result.subject);
      result.worst_time = result.hit->time;
      if (item.history.empty()) return;
      const Sample& before = sample_before(item.history, result.worst_time);
      result.direction = unit(before.velocity.head<2>());
      result.swing_start = swing_start(item.history, before.time, result.direction);
      return;
    }
    case Finding::kRocked: {
      result.worst_time = result.item().tilt.time;
      const Sample& then = sample_before(item.history, result.worst_time);
      result.direction = unit((then.orientation * Vector3::UnitZ()).head<2>());
      result.swing_start = last_before(item.history, result.worst_time, [](const Sample& s) {
        return s.tilt < 1 * kRadiansPerDegree;
      });
      return;
    }
    case Finding::kMoved: {
      result.worst_time = d.time_of_peak_displacement;
      if (item.history.empty()) return;
      const Sample& then = sample_before(item.history, result.worst_time);
      result.direction = unit(then.displacement.head<2>());
      result.swing_start = swing_start(item.history, then.time, result.direction);
      return;
    }
    case Finding::kStill:
      return;
  }
}

/// Finds the half cycle that drove the worst; of an overturning the one that every report of the run names.
void find_pulse(const study::RunFacts& facts, const Response& response, Explanation& result) {
  if (result.direction.isZero()) return;
  if (!lies(result.item().finding)) {
    result.pulse =
        driving_half_cycle(facts.floor, -result.direction, result.swing_start, result.worst_time);
    return;
  }
  for (const Overturning& each : overturnings_of(facts, response)) {
    if (each.item != result.subject) continue;
    result.swing_start = each.start;
    result.pulse = each.half_cycle;
  }
}

Tracks tracks_of(const study::RunFacts& facts, const ItemResponse& item, const Explanation& of) {
  Tracks tracks;
  const EquipmentModel& model = facts.scene.items.at(of.subject).model;
  const Vector2 along = of.direction.isZero() ? Vector2::UnitX() : of.direction;
  const double until = until_overturned(item);
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  for (const Sample& sample : item.history) {
    const Grip grip = sample.time > until || !of.item().on_floor
                          ? Grip{kNone, kNone}
                          : grip_of(facts, of.subject, of.item().mass, sample);
    tracks.time.push_back(sample.time);
    tracks.floor.push_back(along.dot(facts.floor.acceleration_at(sample.time).head<2>()));
    tracks.displacement.push_back(sample.displacement.head<2>().norm());
    tracks.tilt.push_back(sample.tilt);
    tracks.critical.push_back(
        of.item().is_part || of.item().stands_on_parts ? kNone : critical_tilt(model, sample));
    tracks.demand.push_back(grip.demand);
    tracks.grip.push_back(grip.grip);
    tracks.energy.push_back(sample.energy);
  }
  return tracks;
}

double resolution_of(const std::vector<Sample>& history) {
  double largest = 0;
  for (std::size_t i = 1; i + 1 < history.size(); ++i)
    largest = std::max(largest, history[i].time - history[i - 1].time);
  return largest;
}

Stage stage_at(const std::string& name, double time, const std::vector<Sample>& history) {
  constexpr double kSame = 1e-9;  // [s]
  const auto after = std::ranges::upper_bound(history, time + kSame, {}, &Sample::time);
  const Sample& sample = after == history.begin() ? history.front() : *std::prev(after);
  const EnergyAccount& e = sample.energy;
  const double at_start = history.front().energy.weight_energy;
  return {.name = name,
          .time = time,
          .kinetic = e.kinetic,
          .potential = e.gravitational,
          .elastic = e.elastic,
          .floor_work = e.work_of_floor,
          .other_work = e.work() - e.work_of_floor - e.weight_energy + at_start,
          .friction = e.sliding_loss + e.relaxation_loss + e.tread_loss,
          .rolling = e.rolling_loss + e.axle_loss + e.swivel_loss,
          .impacts = e.contact_loss,
          .other_loss = e.damper_loss + e.numerical_loss};
}

const char* stage_name(EventKind kind) {
  switch (kind) {
    case EventKind::kMoved:
      return "slides or rolls";
    case EventKind::kGripExceeded:
      return "brakes skid";
    case EventKind::kLiftOff:
      return "casters lift";
    case EventKind::kTipped:
      return "tips";
    case EventKind::kImpact:
      return "first impact";
    case EventKind::kReleased:
      return "latch lets go";
    case EventKind::kFell:
      return "falls";
    case EventKind::kPeakDisplacement:
      return "farthest";
    case EventKind::kPeakTilt:
      return "largest tilt";
    case EventKind::kToppled:
      return "toppled";
    case EventKind::kOverturned:
      return "overturned";
    default:
      return nullptr;
  }
}

/// The energy balance of the explained item at the start, at the first of each kind of event up to
/// the worst, at the worst and at the end; of the sample at or before each.
std::vector<Stage> stages_of(const Explanation& of, const ItemResponse& item) {
  const std::vector<Sample>& history = item.history;
  if (history.empty()) return {};
  std::vector<Stage> stages{stage_at("start", history.front().time, history)};
  for (const Event& event : of.events) {
    const char* const name = stage_name(event.kind);
    if (name == nullptr || event.item != of.item().name) continue;
    if (std::ranges::find(stages, name, &Stage::name) != stages.end()) continue;
    stages.push_back(stage_at(name, event.time, history));
  }
  if (of.hit && of.hit->time > stages.back().time)
    stages.push_back(stage_at("hardest impact", of.hit->time, history));
  std::ranges::stable_sort(stages, {}, &Stage::time);
  stages.push_back(stage_at("end", of.end_time, history));
  const double at_rest = stages.front().elastic;
  for (Stage& stage : stages) stage.elastic -= at_rest;
  return stages;
}

constexpr double kTilts = 0.1 * kRadiansPerDegree;

/// Where the item leans to, item axes, from the front anticlockwise [rad].
double direction_of(const Sample& sample) {
  const Vector3 down = sample.orientation.conjugate() * -Vector3::UnitZ();
  return std::atan2(down.y(), down.x());
}

/// Most horizontal force of a caster that carries N.
double grip_of(const Caster& caster, double normal) {
  const double most = caster.tread.static_friction * normal;
  if (caster.brake_torque > 0) return std::min(most, caster.brake_torque / caster.wheel_radius);
  const double torque = caster.tread.rolling_friction_length * normal + caster.axle.coulomb;
  return std::min(most, torque / caster.wheel_radius);
}

}  // namespace

double until_overturned(const ItemResponse& item) {
  const double fall = item.demands.lies_from();
  return fall >= 0 ? fall : std::numeric_limits<double>::infinity();
}

const Impact* hardest_impact(const Response& response, std::size_t item, double until) {
  const Impact* hardest = nullptr;
  for (const Impact& impact : response.impacts) {
    if (impact.item != item && impact.other_item != static_cast<int>(item)) continue;
    if (impact.other == "floor" || impact.time > until) continue;
    if (hardest == nullptr || impact.approach_speed > hardest->approach_speed) hardest = &impact;
  }
  return hardest;
}

Finding finding_of(const Response& response, std::size_t item, double tilt_ratio) {
  const Demands& d = response.items.at(item).demands;
  if (d.time_of_overturning >= 0) return Finding::kOverturned;
  if (d.time_of_toppling >= 0) return Finding::kToppled;
  const Impact* const hit = hardest_impact(response, item);
  if (hit != nullptr && hit->approach_speed >= kHit) return Finding::kHit;
  if (tilt_ratio >= kRocks) return Finding::kRocked;
  return d.peak_displacement >= kVisible ? Finding::kMoved : Finding::kStill;
}

RunOptions finely_stored(RunOptions settings, const FloorMotion& floor, std::size_t items) {
  constexpr double kMaxSamples = 40'000, kAfter = 10;  // [-], [s]
  const double length = settings.duration > 0 ? settings.duration : floor.duration() + kAfter;
  const double samples = static_cast<double>(items) * length / settings.time_step;
  const long asked = std::max(1L, std::lround(settings.history_step / settings.time_step));
  auto every = static_cast<long>(std::max(1.0, std::ceil(samples / kMaxSamples)));
  if (settings.history_step > 0) {
    every = std::min(every, asked);
    while (asked % every != 0) ++every;
  }
  settings.history_step = settings.time_step * static_cast<double>(every);
  return settings;
}

Explanation explain(const study::RunFacts& facts, const Response& response) {
  Explanation result{.title = facts.title.empty() ? facts.job_name : facts.title,
                     .record = facts.record ? facts.record->name : "",
                     .outcome = name_of(response.outcome),
                     .cause = response.cause,
                     .failed = is_failure(response.outcome),
                     .end_time = response.end_time,
                     .items = {},
                     .hit = {},
                     .events = {},
                     .pulse = {},
                     .stages = {},
                     .tracks = {},
                     .predictability = {}};
  if (result.failed) return result;
  for (std::size_t i = 0; i < response.items.size(); ++i)
    result.items.push_back(item_facts(facts, response, i));
  result.subject = subject_of(result.items, response);
  const ItemResponse& item = response.items[result.subject];
  result.resolution = resolution_of(item.history);
  result.events = events_of(facts, response);
  find_worst(response, result);
  find_pulse(facts, response, result);
  result.stages = stages_of(result, item);
  result.tracks = tracks_of(facts, item, result);
  result.predictability = item.predictability;
  return result;
}

const char* name_of(Finding finding) {
  constexpr std::array kNames{"still", "moved", "rocked", "hit", "toppled", "overturned"};
  return kNames.at(static_cast<std::size_t>(finding));
}

const char* name_of(EventKind kind) {
  constexpr const char* kNames[] = {"moved",        "grip_exceeded",
                                    "brake_turned", "lift_off",
                                    "landed",       "tipped",
                                    "impact",       "taut",
                                    "unplugged",    "released",
                                    "fell",         "toppled",
                                    "zone",         "peak_displacement",
                                    "peak_tilt",    "overturned",
                                    "end"};
  return kNames[static_cast<int>(kind)];
}

double critical_tilt(const EquipmentModel& item, const Sample& sample) {
  if (!(sample.tilt >= kTilts)) return std::numeric_limits<double>::quiet_NaN();
  EquipmentModel now = item;
  for (std::size_t i = 0; i < now.casters.size(); ++i)
    now.casters[i].heading = sample.wheels[i].swivel_angle;
  const Vector3 center = whole_item(now).center_of_mass;
  const double reach =
      equipment::reach_towards(equipment::supports_of(now, equipment::Swivels::kAsPlaced),
                               center.head<2>(), direction_of(sample));
  return std::atan2(std::max(reach, 0.0), center.z());
}

TiltMargin tilt_margin(const EquipmentModel& item, const std::vector<Sample>& history,
                       double until) {
  TiltMargin margin;
  double largest = 0;
  for (const Sample& sample : history) {
    if (sample.time > until) break;
    const double critical = critical_tilt(item, sample);
    if (std::isnan(critical)) continue;
    const double ratio =
        critical > 0 ? sample.tilt / critical : std::numeric_limits<double>::infinity();
    if (ratio > 1 && margin.time_passed < 0) margin.time_passed = sample.time;
    if (ratio <= largest) continue;
    largest = ratio;
    margin.tilt = sample.tilt;
    margin.critical = critical;
    margin.time = sample.time;
    margin.direction = direction_of(sample);
  }
  return margin;
}

Grip grip_of(const study::RunFacts& facts, std::size_t item, double mass, const Sample& sample) {
  const Scene& scene = facts.scene;
  const EquipmentModel& model = scene.items.at(item).model;
  const Vector3 floor = facts.floor.acceleration_at(sample.time);
  Grip result{mass * floor.head<2>().norm(), 0};
  for (std::size_t i = 0; i < model.casters.size(); ++i)
    result.grip += grip_of(model.casters[i], sample.wheels[i].normal_force);
  if (model.casters.empty())
    result.grip = contact_constants(scene, model.material, scene.floor_material).friction * mass *
                  std::max(scene.gravity + floor.z(), 0.0);
  return result;
}

GripMargin grip_margin(const study::RunFacts& facts, std::size_t item, double mass,
                       const std::vector<Sample>& history, double until) {
  GripMargin margin;
  for (const Caster& caster : facts.scene.items.at(item).model.casters)
    (caster.brake_torque > 0 ? margin.braked : margin.rolls) = true;
  double smallest = std::numeric_limits<double>::infinity();
  for (const Sample& sample : history) {
    if (sample.time > until) break;
    const Grip now = grip_of(facts, item, mass, sample);
    margin.peak_demand = std::max(margin.peak_demand, now.demand);
    if (now.demand > now.grip && margin.time_exceeded < 0) margin.time_exceeded = sample.time;
    if (now.grip - now.demand >= smallest) continue;
    smallest = now.grip - now.demand;
    margin.demand = now.demand;
    margin.grip = now.grip;
    margin.time = sample.time;
  }
  return margin;
}

}  // namespace gurney::explanation
