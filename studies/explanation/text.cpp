#include "studies/explanation/text.h"

#include <fmt/format.h>

#include <cmath>

#include "engine/base/units.h"
#include "studies/render/wrapped.h"
#include "studies/report/words.h"

namespace gurney::explanation {
namespace {

using study::UnitSystem;

std::string degrees(double angle, const UnitSystem& units) {
  if (units.chosen()) return units.text(angle, "rad");
  const double value = angle / kRadiansPerDegree;
  return fmt::format("{:.{}f} deg", value, value < 10 ? 1 : 0);
}

/// "front left" for a direction of the item.
std::string side_of(double direction) {
  constexpr const char* kNames[] = {"front", "front left", "left",  "rear left",
                                    "rear",  "rear right", "right", "front right"};
  const long octant = std::lround(direction / (45 * kRadiansPerDegree));
  return kNames[((octant % 8) + 8) % 8];
}

double angle_of(const Vector2& direction) { return std::atan2(direction.y(), direction.x()); }

bool belongs(const Event& event, const Explanation& of) {
  const bool of_subject = event.item.empty() || event.item == of.item().name;
  return of_subject || event.kind == EventKind::kOverturned || event.kind == EventKind::kImpact;
}

TextPart events_part(const Explanation& of) {
  constexpr std::size_t kMost = 40;
  TextPart part{"What happened", {}};
  std::size_t more = 0;
  for (const Event& event : of.events) {
    if (!belongs(event, of)) continue;
    if (part.lines.size() >= kMost && event.kind != EventKind::kEnd)
      ++more;
    else
      part.lines.push_back(
          {fmt::format("{:8.3f} s  ", event.time), words_of(event, of.items.size() > 1, of.units)});
  }
  if (more > 0) part.lines.push_back({"", fmt::format("{} more events: --json lists them", more)});
  if (of.resolution > 0)
    part.lines.push_back(
        {"", fmt::format("Moving off, brakes, lift-off, landing and tipping are found in samples "
                         "{:g} ms apart; other times are those of the time steps.",
                         1000 * of.resolution)});
  return part;
}

std::string pulse_text(const Explanation& of) {
  if (of.record.empty()) return "The floor is at rest: the item was pushed, or set in motion.";
  if (!of.pulse)
    return "The floor's velocity against the motion did not rise before it: no single pulse of the "
           "floor drove it.";
  return report::sentence(*of.pulse, of.units);
}

std::string tilt_text(const ItemFacts& item, const UnitSystem& units) {
  const TiltMargin& tilt = item.tilt;
  if (tilt.tilt <= 0) return "It hardly tilted (less than 0.1 deg).";
  if (item.finding == Finding::kOverturned && tilt.time_passed >= 0)
    return fmt::format(
        "Its tilt passed the critical angle at {:.2f} s, leaning to its {}: there its centre of "
        "mass, {} up, is above the edge of its support.",
        tilt.time_passed, side_of(tilt.direction),
        units.fixed(item.height_of_center_of_mass, "m", 2));
  std::string text = fmt::format(
      "Tilt: nearest to the edge at {:.2f} s, {} to its {} of a critical {}: {:.0f} % of it.",
      tilt.time, degrees(tilt.tilt, units), side_of(tilt.direction), degrees(tilt.critical, units),
      100 * tilt.ratio());
  if (tilt.time_passed >= 0) text += " It was past the edge and the floor brought it back.";
  return text;
}

/// What keeps an item in its place on the floor.
const char* grip_words(const ItemFacts& item) {
  if (!item.has_casters) return "friction on the floor";
  if (!item.grip.braked) return "the rolling resistance of its casters (no brake is on)";
  return item.grip.rolls ? "its brakes and the rolling resistance of its free casters"
                         : "its brakes, which are on at every caster,";
}

std::string grip_text(const ItemFacts& item, bool floor, const UnitSystem& units) {
  const auto force = [&](double newtons) { return units.fixed(newtons, "N", 0); };
  const GripMargin& grip = item.grip;
  if (!floor) return {};
  const char* const what = grip_words(item);
  if (grip.time_exceeded < 0)
    return fmt::format(
        "Grip: holding it on the moving floor took {} at most, and {} could always give "
        "more; the margin was smallest at {:.2f} s ({} of {}).",
        force(grip.peak_demand), what, grip.time, force(grip.demand), force(grip.grip));
  return fmt::format(
      "Grip: holding it on the moving floor takes its mass ({}) times the floor's "
      "acceleration. {} first could not give that at {:.2f} s; worst at {:.2f} s, {} against {}.",
      units.fixed(item.mass, "kg", 0),
      std::string(1, static_cast<char>(std::toupper(what[0]))) + (what + 1), grip.time_exceeded,
      grip.time, force(grip.demand), force(grip.grip));
}

std::string first_caster_text(const ItemFacts& item) {
  std::string text;
  if (!item.first_lifted.empty())
    text += fmt::format("First caster off the floor: {}, at {:.3f} s. ", item.first_lifted,
                        item.time_of_lift);
  if (!item.first_skidded.empty())
    text += fmt::format("First braked caster to skid: {}, at {:.3f} s.", item.first_skidded,
                        item.time_of_skid);
  return text;
}

TextPart margins_part(const Explanation& of) {
  const ItemFacts& item = of.item();
  TextPart part{"Margins", {}};
  for (const std::string& words :
       {tilt_text(item, of.units), grip_text(item, !of.record.empty(), of.units),
        first_caster_text(item)})
    if (!words.empty()) part.lines.push_back({"", words});
  return part;
}

/// Two decimals; what is rounded to nothing has no sign.
std::string cell(double energy) {
  return fmt::format("{:>9.2f}", std::abs(energy) < 0.005 ? 0.0 : energy);
}

TextPart energy_part(const Explanation& of) {
  const study::ReportUnit unit = of.units.of("J");
  const auto in = [&](double energy) { return cell(energy / unit.in_si); };
  TextPart part{
      fmt::format("Energy of {} since the start [{}]", of.item().name, unit.name), {}, true};
  part.lines.push_back(
      {"", fmt::format("{:<16}{:>8}{:>9}{:>9}{:>9}{:>9}{:>9}{:>9}{:>9}{:>9}", "", "time", "floor",
                       "loads", "kinetic", "height", "friction", "rolling", "impacts", "other")});
  for (const Stage& s : of.stages)
    part.lines.push_back({"", fmt::format("{:<16}{:>8.2f}", s.name, s.time) + in(s.floor_work) +
                                  in(s.other_work) + in(s.kinetic) + in(s.potential) +
                                  in(s.friction) + in(s.rolling) + in(s.impacts) +
                                  in(s.elastic + s.other_loss)});
  return part;
}

TextPart energy_key() {
  return {"",
          {{"",
            "floor: work of the floor's motion on the item; loads: work of pushes, cords and "
            "neighbours; height: weight times the rise of the centre of mass; friction: sliding "
            "and damping of the treads; rolling: rolling resistance, bearings and brakes; other: "
            "springs and dampers. Floor and loads together are the sum of the other columns."}}};
}

TextPart others_part(const Explanation& of) {
  TextPart part{"The other items", {}};
  for (std::size_t i = 0; i < of.items.size(); ++i) {
    if (i == of.subject) continue;
    const ItemFacts& item = of.items[i];
    if (item.finding == Finding::kStill)
      part.lines.push_back(
          {"", item.name + " did nothing: it moved less than 1 mm and hardly tilted."});
    else
      part.lines.push_back(
          {"", fmt::format("{}: {}; moved up to {}, tilt up to {:.0f} % of critical.", item.name,
                           name_of(item.finding), length_words(item.peak_displacement, of.units),
                           100 * item.tilt.ratio())});
  }
  return part;
}

std::string trust_text(const Explanation& of) {
  if (!of.predictability) return {};
  switch (of.predictability->verdict) {
    case Predictability::Verdict::kPredictable:
      return {};
    case Predictability::Verdict::kSensitive:
      return "SENSITIVE: small errors of mass or friction change these times and sizes noticeably.";
    case Predictability::Verdict::kChaotic:
      break;
  }
  return "CHAOTIC: a change of mass by one part in a billion leads to another motion. This "
         "explains "
         "one run among many.";
}

/// Casters come and go: what one of them does is not what all do.
std::string uplift_text(const Event& event) {
  const bool back = std::isfinite(event.value);
  const Uplift& of = *event.uplift;
  if (of.casters == 1)
    return fmt::format("off the floor {}: {}",
                       back ? fmt::format("for {:.3g} s", of.longest) : "for good", event.part);
  std::string text =
      fmt::format("one or more casters off the floor {}, up to {} at once",
                  back ? fmt::format("until {:.3f} s", event.value) : "to the end", of.most);
  if (of.together > 0) text += fmt::format(", all {} for {:.3g} s", of.casters, of.together);
  return text + fmt::format("; a single caster for {:.3g} s at most ({}): {}", of.longest,
                            of.longest_of, event.part);
}

}  // namespace

std::string length_words(double metres, const UnitSystem& units) {
  if (units.chosen()) return units.text(metres, "m");
  return metres < 0.1 ? fmt::format("{:.{}f} mm", 1000 * metres, metres < 0.01 ? 1 : 0)
                      : fmt::format("{:.2f} m", metres);
}

std::string words_of(const Event& event, bool name_item, const UnitSystem& units) {
  const std::string who = name_item && !event.item.empty() ? event.item + ": " : "";
  switch (event.kind) {
    case EventKind::kMoved:
      return who + "starts to slide or roll";
    case EventKind::kGripExceeded:
      return who + fmt::format("the braked caster {} skids: its grip is exceeded", event.part);
    case EventKind::kBrakeTurned:
      return who + fmt::format("the caster {} turns against its brake", event.part);
    case EventKind::kLiftOff:
      return who + uplift_text(event);
    case EventKind::kLanded:
      return who + "all casters are back on the floor";
    case EventKind::kTipped:
      return who + fmt::format("tips ({})", degrees(event.value, units));
    case EventKind::kImpact:
      return who + fmt::format("hits {} with {}", event.part, units.fixed(event.value, "m/s", 2));
    case EventKind::kTaut:
      return who +
             fmt::format("{} gets taut (up to {})", event.part, units.fixed(event.value, "N", 0));
    case EventKind::kUnplugged:
      return who + fmt::format("{} breaks or unplugs", event.part);
    case EventKind::kZone:
      return fmt::format("an item enters the zone {}", event.part);
    case EventKind::kPeakDisplacement:
      return who + fmt::format("farthest from its start, {}", length_words(event.value, units));
    case EventKind::kPeakTilt:
      return who + fmt::format("largest tilt, {}", degrees(event.value, units));
    case EventKind::kOverturned:
      return who + "OVERTURNS" +
             (std::isfinite(event.value) ? " " + report::towards(event.value, units) : "");
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
      return fmt::format("{} overturned at {:.2f} s, {}.", item.name, of.worst_time,
                         report::towards(angle_of(of.direction), of.units));
    case Finding::kHit: {
      const std::string other =
          of.hit->item == of.subject ? of.hit->other : of.items.at(of.hit->item).name;
      return fmt::format("{} moved up to {} and hit {} with {} at {:.2f} s.", item.name,
                         length_words(item.peak_displacement, of.units), other,
                         of.units.fixed(of.hit->approach_speed, "m/s", 2), of.hit->time);
    }
    case Finding::kRocked:
      return fmt::format("{} rocked and did not overturn: its tilt reached {:.0f} % of critical.",
                         item.name, 100 * item.tilt.ratio());
    case Finding::kMoved:
      return fmt::format("{} moved up to {} (at {:.2f} s) and hit nothing.", item.name,
                         length_words(item.peak_displacement, of.units),
                         item.time_of_peak_displacement);
    case Finding::kStill:
      break;
  }
  return of.items.size() == 1
             ? item.name + " did nothing: it moved less than 1 mm and hardly tilted."
             : "No item did anything: each moved less than 1 mm and hardly tilted.";
}

std::vector<TextPart> parts_of(const Explanation& of) {
  if (of.failed) return {};
  std::vector<TextPart> parts{events_part(of)};
  if (of.item().finding != Finding::kStill)
    parts.push_back({"What drove it", {{"", pulse_text(of)}}});
  parts.push_back(margins_part(of));
  parts.push_back(energy_part(of));
  parts.push_back(energy_key());
  if (of.items.size() > 1) parts.push_back(others_part(of));
  if (const std::string trust = trust_text(of); !trust.empty())
    parts.push_back({"How far to trust it", {{"", trust}}});
  return parts;
}

std::string text(const Explanation& of) {
  std::string result = render::wrapped(headline(of), 0, 0) + "\n";
  for (const TextPart& part : parts_of(of)) {
    if (!part.heading.empty()) result += "\n" + part.heading + "\n";
    for (const auto& [label, words] : part.lines) {
      const std::size_t hang = 2 + label.size();
      result += "  " + label + (part.table ? words : render::wrapped(words, hang, hang)) + "\n";
    }
  }
  return result;
}

}  // namespace gurney::explanation
