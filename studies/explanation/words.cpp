#include "studies/explanation/words.h"

#include <fmt/format.h>

#include <cmath>

#include "engine/base/units.h"
#include "studies/explanation/events.h"

namespace gurney::explanation {
namespace {

using study::UnitSystem;

/// Which of eight directions is nearest, anticlockwise from 0.
std::size_t octant(double direction) {
  const long nearest = std::lround(direction / (45 * kRadiansPerDegree));
  return static_cast<std::size_t>(((nearest % 8) + 8) % 8);
}

double angle_of(const Vector2& direction) { return std::atan2(direction.y(), direction.x()); }

/// Casters come and go: what one of them does is not what all do.
std::string uplift_text(const Event& event) {
  const bool back = std::isfinite(event.value);
  const Uplift& of = *event.uplift;
  const std::string end = of.overturned ? "until it overturned" : "to the end of the run";
  if (of.casters == 1)
    return fmt::format("off the floor {}: {}", back ? fmt::format("for {:.3g} s", of.longest) : end,
                       event.part);
  std::string text = fmt::format("one or more casters off the floor {}, up to {} at once",
                                 back ? fmt::format("until {:.3f} s", event.value) : end, of.most);
  if (of.together > 0) text += fmt::format(", all {} for {:.3g} s", of.casters, of.together);
  return text + fmt::format("; a single caster for {:.3g} s at most ({}): {}", of.longest,
                            of.longest_of, event.part);
}

/// Blow of a part against a stop of its joint; empty: it met none, or only leant on it.
std::string met_a_stop(const ItemFacts& item, const UnitSystem& units) {
  constexpr double kMet = 0.005;  // [m/s] what two decimals show
  return item.stop_speed >= kMet
             ? fmt::format(", and met its stop with {}", units.fixed(item.stop_speed, "m/s", 2))
             : "";
}

}  // namespace

std::string length(double metres, const UnitSystem& units) {
  if (units.chosen()) return units.text(metres, "m");
  return metres < 1 ? fmt::format("{:.{}f} mm", 1000 * metres, metres < 0.01 ? 2 : 0)
                    : fmt::format("{:.2f} m", metres);
}

std::string angle(double radians, const UnitSystem& units) {
  if (units.chosen()) return units.text(radians, "rad");
  const double value = radians / kRadiansPerDegree;
  return fmt::format("{:.{}f} deg", value, value < 10 ? 1 : 0);
}

std::string towards(double direction, const UnitSystem& units) {
  constexpr const char* kNames[] = {"towards +x",        "between +x and +y", "towards +y",
                                    "between -x and +y", "towards -x",        "between -x and -y",
                                    "towards -y",        "between +x and -y"};
  const std::string from_x =
      units.of("rad").name == "deg"
          ? fmt::format("{:.0f} deg", std::round(direction / kRadiansPerDegree) + 0.0)
          : units.fixed(direction, "rad", 0);
  return fmt::format("{} ({} from the x axis)", kNames[octant(direction)], from_x);
}

std::string side_of(double direction) {
  constexpr const char* kNames[] = {"front", "front left", "left",  "rear left",
                                    "rear",  "rear right", "right", "front right"};
  return kNames[octant(direction)];
}

std::string sentence(const HalfCycle& of, const UnitSystem& units) {
  const double peak = of.peak_acceleration;
  const std::string up_to =
      units.chosen() ? units.text(peak, "m/s2") + " ("
                     : fmt::format("{:.3g} m/s2 ({:.2f} g, ", peak, peak / kStandardGravity);
  return fmt::format(
      "A half cycle of the floor's motion {} drove it, opposite to the motion of the item, from "
      "{:.2f} s to {:.2f} s: {:.2f} s long, up to {}at {:.2f} s) and {}; it changed the floor's "
      "velocity by {}.",
      towards(angle_of(of.direction), units), of.start, of.end, of.end - of.start, up_to,
      of.time_of_peak, units.text(of.peak_velocity, "m/s"), units.text(of.velocity_change, "m/s"));
}

std::string sentence(const Predictability& of) {
  const std::string change = "a change of mass by one part in a billion";
  if (of.time_of_peaks == 0) return "Predictable: the item stays where it is";
  const double growth = of.amplification_at_peaks;
  const std::string grows =
      fmt::format("{} {} until the peaks of displacement and tilt at {:.2f} s", change,
                  growth < 1     ? fmt::format("shrinks to {:.2g} of its size", growth)
                  : growth < 100 ? fmt::format("grows {:.2g}-fold", growth)
                                 : fmt::format("grows {:.0f}-fold", growth),
                  of.time_of_peaks);
  switch (of.verdict) {
    case Predictability::Verdict::kPredictable:
      return "Predictable: " + grows +
             (of.horizon > of.time_of_peaks
                  ? fmt::format("; from {:.2f} s on the motion is sensitive", of.horizon)
                  : "");
    case Predictability::Verdict::kSensitive:
      return fmt::format(
          "SENSITIVE: {}; from {:.2f} s on an error of 0.1 % may change the motion by its own size",
          grows, of.horizon);
    case Predictability::Verdict::kChaotic:
      break;
  }
  return fmt::format(
      "CHAOTIC: {} leads to another motion before the peaks at {:.2f} s. They are those of one run "
      "among many; study.replicas gives their distribution",
      change, of.time_of_peaks);
}

bool moved_on_joint(const ItemFacts& item) {
  return item.peak_travel >= kVisible || item.peak_swing >= Predictability::kLeastTilt;
}

std::string stayed(const ItemFacts& item, const UnitSystem& units) {
  if (!moved_on_joint(item))
    return item.name + " did nothing: it moved less than 1 mm and hardly tilted.";
  return fmt::format("{} moved on its joint by up to {}{}.", item.name,
                     item.peak_travel >= kVisible ? length(item.peak_travel, units)
                                                  : angle(item.peak_swing, units),
                     met_a_stop(item, units));
}

std::string sentence(const Event& event, const UnitSystem& units) {
  switch (event.kind) {
    case EventKind::kMoved:
      return "starts to slide or roll";
    case EventKind::kGripExceeded:
      return fmt::format("the braked caster {} skids: its grip is exceeded", event.part);
    case EventKind::kBrakeTurned:
      return fmt::format("the caster {} turns against its brake", event.part);
    case EventKind::kLiftOff:
      return uplift_text(event);
    case EventKind::kLanded:
      return "all casters are back on the floor";
    case EventKind::kTipped:
      return fmt::format("tips ({})", angle(event.value, units));
    case EventKind::kImpact:
      return fmt::format("hits {} with {}", event.part, units.fixed(event.value, "m/s", 2));
    case EventKind::kTaut:
      return fmt::format("{} gets taut (up to {})", event.part, units.fixed(event.value, "N", 0));
    case EventKind::kUnplugged:
      return fmt::format("{} breaks or unplugs", event.part);
    case EventKind::kReleased:
      return "its latch lets go";
    case EventKind::kFell:
      return "FALLS from what it stood on";
    case EventKind::kZone:
      return fmt::format("an item enters the zone {}", event.part);
    case EventKind::kPeakDisplacement:
      return fmt::format("farthest from its start, {}", length(event.value, units));
    case EventKind::kPeakTilt:
      return fmt::format("largest tilt, {}", angle(event.value, units));
    case EventKind::kToppled:
    case EventKind::kOverturned: {
      const std::string what = event.kind == EventKind::kToppled ? "TOPPLES" : "OVERTURNS";
      return std::isfinite(event.value) ? what + " " + towards(event.value, units) : what;
    }
    case EventKind::kEnd:
      break;
  }
  if (event.part == name_of(Outcome::kRested)) return "all is at rest";
  if (event.part == name_of(Outcome::kOverturned)) return "the run ends";
  if (event.part == name_of(Outcome::kStopped)) return "the run ends, as asked";
  return "the run ends; something still moves";
}

std::string headline(const Explanation& of) {
  if (of.failed)
    return fmt::format("The run failed at {:.4g} s: {}. There is nothing to explain.", of.end_time,
                       of.cause);
  const ItemFacts& item = of.item();
  switch (item.finding) {
    case Finding::kOverturned:
    case Finding::kToppled:
      return fmt::format("{} {} at {:.2f} s, {}.", item.name, name_of(item.finding), of.worst_time,
                         towards(angle_of(of.direction), of.units));
    case Finding::kHit: {
      const std::string other =
          of.hit->item == of.subject ? of.hit->other : of.items.at(of.hit->item).name;
      return fmt::format("{} moved up to {} and hit {} with {} at {:.2f} s.", item.name,
                         length(item.peak_displacement, of.units), other,
                         of.units.fixed(of.hit->approach_speed, "m/s", 2), of.hit->time);
    }
    case Finding::kRocked:
      return fmt::format("{} rocked and did not overturn: its tilt reached {:.0f} % of critical.",
                         item.name, 100 * item.tilt.ratio());
    case Finding::kMoved: {
      const std::string stop = met_a_stop(item, of.units);
      return fmt::format("{} moved up to {} (at {:.2f} s){}.", item.name,
                         length(item.peak_displacement, of.units), item.time_of_peak_displacement,
                         stop.empty() ? " and hit nothing" : stop);
    }
    case Finding::kStill:
      break;
  }
  const auto moved = std::ranges::find_if(of.items, moved_on_joint);
  if (of.items.size() == 1 || moved != of.items.end())
    return stayed(moved != of.items.end() ? *moved : item, of.units);
  return "No item did anything: each moved less than 1 mm and hardly tilted.";
}

}  // namespace gurney::explanation
