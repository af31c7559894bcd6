#include "equipment/catalogue/item_parts.h"

#include <fmt/format.h>

#include <algorithm>

#include "engine/base/units.h"
#include "engine/config/nearest_name.h"
#include "equipment/catalogue/body_reader.h"
#include "equipment/catalogue/shape_reader.h"

namespace gurney::equipment {
namespace {

using config::Range;
using config::Table;
using JointKind = Joint::Kind;

const std::vector<std::string> kJointKinds = {"fixed", "hinge", "slider", "ball", "flexible"};

/// Names of the quantities of a joint in its free direction: in N and m, or in N m and angles.
struct Keys {
  const char *stiffness, *damping, *friction, *latch, *stop_stiffness, *rest, *lower, *upper;
};
constexpr Keys kSliderKeys = {
    "stiffness_n_per_m",      "damping_n_s_per_m", "friction_n", "latch_n",
    "stop_stiffness_n_per_m", "rest_mm",           "lower_mm",   "upper_mm"};
constexpr Keys kTurningKeys = {"stiffness_n_m_per_rad",
                               "damping_n_m_s_per_rad",
                               "friction_n_m",
                               "latch_n_m",
                               "stop_stiffness_n_m_per_rad",
                               "rest_deg",
                               "lower_deg",
                               "upper_deg"};

/// A member of the joint of a part.
auto joint(double Joint::*member) {
  return [member](PartDescription& part) -> double& { return part.joint.*member; };
}

constexpr double kDoorStopStiffness = 1e4;  // [N m/rad]

/// Stops, friction, latch and rest of a hinge or a slider.
void read_coordinate(Quantities& in, bool slides, Uncertain<PartDescription>& part) {
  const Keys& keys = slides ? kSliderKeys : kTurningKeys;
  Table& table = in.table();
  const auto place = [&](const char* key, const Range& range, double Joint::*member) {
    if (!table.has(key)) return;
    part.set(joint(member), slides ? in.length_mm(key, range) : in.angle_deg(key, range));
  };
  const auto errors = table.document().errors();
  place(keys.lower, Range::within(-1e6, 0), &Joint::lower);
  place(keys.upper, Range::not_negative(), &Joint::upper);
  place(keys.rest, Range::any(), &Joint::rest);
  if (table.has(keys.rest) && !table.has(keys.stiffness))
    table.note(keys.rest, fmt::format(": must go with {}", keys.stiffness));
  part.set(joint(&Joint::friction), in.number(keys.friction, Range::not_negative(), 0.0));
  if (table.document().errors() == errors && part.stated().joint.lower == 0 &&
      part.stated().joint.upper == 0)
    table.note(keys.upper,
               fmt::format(
                   " = 0: leaves no way between the stops, as {} = 0; a part that does not move is "
                   "\"fixed\", or locked",
                   keys.lower));
  const bool stops = table.has(keys.lower) || table.has(keys.upper);
  for (const char* key : {keys.stop_stiffness, "stop_restitution"})
    if (!stops && table.has(key)) {
      table.note(key, fmt::format(": must go with {} or {}", keys.lower, keys.upper));
      table.set_aside(key);
    }
  if (stops) {
    part.set(joint(&Joint::stop_stiffness),
             in.number(keys.stop_stiffness, Range::positive(),
                       slides ? Joint().stop_stiffness : kDoorStopStiffness));
    part.set(joint(&Joint::restitution),
             in.number("stop_restitution", Range::within(0.01, 1), Joint().restitution));
  }
  part.set(joint(&Joint::latch), in.number(keys.latch, Range::not_negative(), 0.0));
  const bool catches = table.boolean("relatches", false);
  if (catches && !(part.stated().joint.latch > 0))
    table.note("relatches", fmt::format(": must go with {} > 0", keys.latch));
  part.add([catches, locked = table.boolean("locked", false)](PartDescription& of_draw, Sampler&) {
    of_draw.joint.relatches = catches;
    of_draw.locked = locked;
  });
}

/// Spring and damper; of a flexible joint its frequency and damping ratio in their place.
void read_spring(Quantities& in, JointKind kind, Uncertain<PartDescription>& part) {
  const Keys& keys = kind == JointKind::kSlider ? kSliderKeys : kTurningKeys;
  Table& table = in.table();
  if (kind == JointKind::kFlexible) {
    if (table.has("frequency_hz") == table.has(keys.stiffness))
      table.note("frequency_hz", fmt::format(": must be given, or {}, not both", keys.stiffness));
    if (table.has("frequency_hz")) {
      part.set(&PartDescription::frequency, in.number("frequency_hz", Range::positive()));
      part.set(&PartDescription::damping_ratio,
               in.number("damping_ratio", Range::within(0, 1).open_above()));
      return;
    }
  }
  part.set(joint(&Joint::stiffness), in.number(keys.stiffness, Range::not_negative(), 0.0));
  part.set(joint(&Joint::damping), in.number(keys.damping, Range::not_negative(), 0.0));
}

Vector3 axis_of_joint(Table& table, JointKind kind) {
  if (kind == JointKind::kFixed || kind == JointKind::kBall) return Vector3::UnitZ();
  std::optional<Vector3> usual;
  if (kind == JointKind::kFlexible) usual = Vector3::UnitZ();
  return read_axis(table, usual);
}

/// A body's name, `item/NAME` in results; "chassis" is what others stand on.
std::string read_name(Table& table) {
  const std::string name = table.text("name");
  if (table.has("name") &&
      (name.empty() || name == "chassis" || name.find_first_of("/\n\r\t") != std::string::npos))
    table.note("name", ": must not be empty or \"chassis\", or have a '/' or a line break");
  return name;
}

}  // namespace

const std::string& name_of(JointKind kind) { return kJointKinds[static_cast<std::size_t>(kind)]; }

std::size_t read_carrier(Table& table, const std::string& key,
                         const std::vector<PartDescription>& parts) {
  const std::string name = table.text(key, "chassis");
  std::vector<std::string> known = {"chassis"};
  for (const PartDescription& part : parts) known.push_back(part.name);
  const auto found = std::ranges::find(known, name);
  if (found != known.end()) return static_cast<std::size_t>(found - known.begin());
  table.note(key, fmt::format(" = \"{}\": must be \"chassis\" or a part before this one{}", name,
                              config::suggestion(name, known)));
  return 0;
}

Uncertain<PartDescription> read_part(Table table, const std::vector<PartDescription>& before) {
  PartDescription fixed;
  fixed.name = read_name(table);
  fixed.where = table.where("position_mm");
  fixed.base = read_carrier(table, "on", before);
  const auto errors = table.document().errors();
  const auto kind = static_cast<JointKind>(table.choice("joint", kJointKinds));
  if (table.document().errors() > errors)  // keys of a joint of unknown kind
    for (const std::string& key : table.keys()) table.set_aside(key);
  fixed.joint.kind = kind;
  fixed.joint.name = fixed.name;
  fixed.joint.axis = axis_of_joint(table, kind);
  fixed.material = table.text("material", "");
  Uncertain<PartDescription> part(std::move(fixed));
  Quantities in(table);
  read_body(in,
            BodyMembers<PartDescription>{&PartDescription::mass, &PartDescription::center_of_mass,
                                         &PartDescription::inertia},
            part);
  part.set([](PartDescription& of_draw) -> Vector3& { return of_draw.joint.point; },
           in.vector_mm("position_mm", Range::any()));
  if (kind != JointKind::kFixed) read_spring(in, kind, part);
  if (kind == JointKind::kHinge || kind == JointKind::kSlider)
    read_coordinate(in, kind == JointKind::kSlider, part);
  read_shape(table, &PartDescription::shape, part);
  read_marked_points(table, &PartDescription::marked_points, part);
  return part;
}

Uncertain<ContentDescription> read_content(Table table, const std::vector<PartDescription>& parts) {
  ContentDescription fixed;
  fixed.name = read_name(table);
  if (std::ranges::find(parts, fixed.name, &PartDescription::name) != parts.end())
    table.note("name", fmt::format(" = \"{}\": must differ from the names of parts", fixed.name));
  fixed.where = table.where("position_mm");
  fixed.on = read_carrier(table, "on", parts);
  Uncertain<ContentDescription> content(std::move(fixed));
  Quantities in(table);
  content.set(&ContentDescription::position, in.vector_mm("position_mm", Range::any()));
  content.set(&ContentDescription::yaw, in.angle_deg("yaw_deg", Range::any(), 0.0));
  content.set(&ContentDescription::mass, in.number("mass_kg", Range::positive()));
  content.add([solids = read_solid(table, false)](ContentDescription& of_draw, Sampler& of) {
    of_draw.shape = solids.sample(of);
  });
  if (auto contact = table.table("contact"))
    content.set(&ContentDescription::contact, read_item_contact(*contact, is_round(table)));
  else
    table.note("contact", ": missing; a content needs a table [" + table.name_of("contact") +
                              "], how it meets what it stands on");
  return content;
}

}  // namespace gurney::equipment
