#include "equipment/catalogue/load_item.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <numbers>

#include "engine/base/append_all.h"
#include "engine/base/diagnostics.h"
#include "engine/base/units.h"
#include "engine/contact/body_form.h"
#include "equipment/catalogue/support.h"

namespace gurney::equipment {
namespace {

constexpr double kHeightTolerance = 1e-6;  // [m] mounts are stated in mm

const CasterType& type_at(const CasterPlace& place, const ItemOptions& options) {
  return options.caster ? *options.caster : place.type;
}

double base_height(const CasterPlace& place, const ItemOptions& options) {
  return type_at(place, options).properties.height - place.mount.z();
}

/// How high the base plate is above the floor [m].
double base_height(const ItemDescription& item, const ItemOptions& options) {
  if (!item.casters.empty()) return base_height(item.casters[0], options);
  double lowest = std::numeric_limits<double>::infinity();
  for (const BodyShape& shape : item.shape) lowest = std::min(lowest, shape.bottom());
  return -lowest;
}

/// `value[i]` of an option that may be empty.
template <typename T>
T option_at(const std::vector<T>& values, std::size_t i, T otherwise) {
  assert(values.empty() || i < values.size());
  return values.empty() ? otherwise : T(values[i]);
}

void check(const ItemDescription& item, const ItemOptions& options) {
  Diagnostics errors;
  for (std::size_t i = 0; i < item.casters.size(); ++i) {
    const CasterPlace& place = item.casters[i];
    const auto add = [&](const std::string& line) {
      errors.add(place.where + (place.where.empty() ? "" : ": ") + line);
    };
    const CasterType& type = type_at(place, options);
    if (option_at(options.brakes, i, place.brake_on) && type.brake_torque == 0)
      add(fmt::format("caster '{}': the brake is on, but caster {} has no brake_torque_n_m",
                      place.name, type.name));
    if (option_at(options.swivel_locks, i, place.swivel_locked) && type.swivel_lock_torque == 0)
      add(fmt::format(
          "caster '{}': the swivel is locked, but caster {} has no swivel_lock_torque_n_m",
          place.name, type.name));
    const double first = base_height(item.casters[0], options);
    const double height = base_height(place, options);
    if (!(std::abs(height - first) <= kHeightTolerance))
      add(
          fmt::format("caster '{}': its base plate would be {:.6g} mm above the floor, that of "
                      "caster '{}' {:.6g} mm: must be equal (height_mm minus z of position_mm)",
                      place.name, height * kMillimetersPerMeter, item.casters[0].name,
                      first * kMillimetersPerMeter));
  }
  errors.raise();
}

/// Numbers of a brake or a lock. Where each draw decides whether it is on, the drawn ones are listed
/// in every draw, so that all draws have the same numbers.
void add_switched(std::vector<Assumption>& list, const std::vector<Assumption>& more, bool on,
                  bool drawn) {
  for (Assumption each : more) {
    each.in_use = on;
    if (on || (drawn && !each.distribution.empty())) add_assumptions(list, {each});
  }
}

Caster make_caster(const CasterPlace& place, std::size_t i, const ItemOptions& options,
                   std::vector<Assumption>& assumptions) {
  const CasterType& type = type_at(place, options);
  add_assumptions(assumptions, type.assumptions);
  Caster caster = type.properties;
  caster.name = place.name;
  caster.mount = Vector3(place.mount.x(), place.mount.y(), caster.height);
  caster.heading = option_at(options.headings, i, place.heading);
  caster.swivels = place.swivels;
  const bool braked = option_at(options.brakes, i, place.brake_on);
  const double share = option_at(options.brake_shares, i, 1.0);
  if (braked && share > 0) {
    caster.brake_torque = share * type.brake_torque;
    caster.brake_sliding_ratio = type.brake_sliding_ratio;
  }
  add_switched(assumptions, type.brake_assumptions, braked,
               option_at(options.brakes_drawn, i, place.brake_drawn));
  const bool locked = option_at(options.swivel_locks, i, place.swivel_locked);
  if (locked) caster.swivel_lock_torque = type.swivel_lock_torque;
  add_switched(assumptions, type.lock_assumptions, locked,
               option_at(options.locks_drawn, i, place.lock_drawn));
  if (options.floor) {
    caster.tread.rolling_friction_length *= options.floor->rolling_resistance_factor;
    caster.tread.static_friction *= options.floor->friction_factor;
    caster.tread.kinetic_friction *= options.floor->friction_factor;
  }
  return caster;
}

/// The chassis (0), or part on - 1.
EquipmentModel& carrier_of(LoadedItem& loaded, std::size_t on) {
  return on == 0 ? loaded.model : loaded.parts[on - 1].model;
}

void add_payloads(const PayloadKind& kind, const ItemOptions& options, const Vector3& base,
                  LoadedItem& loaded) {
  const auto wanted = options.payloads.find(kind.name);
  const int count = wanted == options.payloads.end() ? kind.count : wanted->second;
  EquipmentModel& carrier = carrier_of(loaded, kind.on);
  for (int i = 0; i < count; ++i) {
    const Vector3 center = base + kind.position + Vector3(0, 0, (i + 0.5) * kind.size.z());
    carrier.payloads.push_back({count == 1 ? kind.name : fmt::format("{} {}", kind.name, i + 1),
                                kind.mass, center, solid_box_inertia(kind.mass, kind.size)});
  }
  if (count > 0) add_assumptions(loaded.assumptions, kind.assumptions);
}

/// Pairs of a material with all that has none of its own, and with the covering of the floor.
std::vector<MaterialPair> pairs_of(const std::string& material, const ContactConstants& constants,
                                   const ItemOptions& options) {
  std::vector<MaterialPair> pairs = {{material, "", constants}};
  if (options.floor) {
    pairs.push_back({material, options.floor->name, constants});
    pairs.back().constants.friction *= options.floor->friction_factor;
    pairs.back().constants.rolling_resistance *= options.floor->rolling_resistance_factor;
  }
  return pairs;
}

void add_contact(const ItemContact& contact, const ItemOptions& options, LoadedItem& loaded) {
  loaded.states_contact = !contact.material.empty();
  if (loaded.states_contact) loaded.model.material = contact.material;
  loaded.pairs = pairs_of(loaded.model.material, contact.constants, options);
  if (options.floor) loaded.floor_material = options.floor->name;
  add_assumptions(loaded.assumptions, contact.assumptions);
}

bool has(const std::vector<std::string>& names, const std::string& name) {
  return std::ranges::find(names, name) != names.end();
}

/// Stiffness and damping of a flexible joint whose frequency is stated, with all that hangs on it. An
/// upright mast leans against gravity: k = I (2 pi f)^2 + sum m g h, c = 2 zeta I (2 pi f), where I is
/// about the joint across its axis, the mean of both directions, and h along it upwards.
void set_frequency(const ItemDescription& item, std::size_t index, Joint& joint) {
  const PartDescription& mast = item.parts[index];
  double inertia = 0, lift = 0;
  std::vector<bool> hangs(item.parts.size());
  for (std::size_t i = index; i < item.parts.size(); ++i) {
    const PartDescription& part = item.parts[i];
    hangs[i] = i == index || (part.base > 0 && hangs[part.base - 1]);
    if (!hangs[i]) continue;
    const Vector3 from = part.center_of_mass - mast.joint.point;
    const Vector3& axis = joint.axis;
    const double across = 0.5 * (part.inertia.trace() - axis.dot(part.inertia * axis));
    const double along = axis.dot(from);
    inertia += across + part.mass * (along * along + 0.5 * (from.squaredNorm() - along * along));
    lift += part.mass * kStandardGravity * from.z();
  }
  const double rate = 2 * std::numbers::pi * mast.frequency;
  joint.stiffness = inertia * rate * rate + lift;
  joint.damping = 2 * mast.damping_ratio * inertia * rate;
}

LoadedPart load_part(const ItemDescription& item, std::size_t index, const ItemOptions& options,
                     const Vector3& base) {
  const PartDescription& part = item.parts[index];
  LoadedPart loaded;
  loaded.joint = part.joint;
  loaded.joint.base = part.base;
  loaded.joint.point += base;
  if (part.frequency > 0) set_frequency(item, index, loaded.joint);
  if (options.locked_parts ? has(*options.locked_parts, part.name) : part.locked)
    loaded.joint.latch = Joint::kFree;
  EquipmentModel& model = loaded.model;
  model.name = part.name;
  model.chassis_mass = part.mass;
  model.chassis_center_of_mass = base + part.center_of_mass;
  model.chassis_inertia = part.inertia;
  model.material = part.material;
  for (const BodyShape& shape : part.shape) model.shape.push_back(shape.moved(base));
  for (const MarkedPoint& point : part.marked_points)
    model.marked_points.push_back({point.name, base + point.position});
  return loaded;
}

/// Whether the level top of one of the shapes lies at the underside of a content, below its middle.
bool carries(const std::vector<BodyShape>& shapes, const ContentDescription& content) {
  constexpr double kSameHeight = 1e-3;  // [m] heights are stated in mm
  return std::ranges::any_of(shapes, [&](const BodyShape& shape) {
    const auto top = level_top(shape, content.position.head<2>());
    return top && std::abs(content.position.z() - *top) <= kSameHeight;
  });
}

/// The shapes of a content with the middle of their underside at the origin.
std::vector<BodyShape> standing(const std::vector<BodyShape>& shapes) {
  Vector3 low = Vector3::Constant(std::numeric_limits<double>::infinity()), high = -low;
  for (const BodyShape& shape : shapes) {
    low = low.cwiseMin(shape.center - 0.5 * shape.size);
    high = high.cwiseMax(shape.center + 0.5 * shape.size);
  }
  const Vector3 middle = 0.5 * (low + high);
  std::vector<BodyShape> moved;
  for (const BodyShape& shape : shapes)
    moved.push_back(shape.moved({-middle.x(), -middle.y(), -low.z()}));
  return moved;
}

std::string before(const std::string& where) { return where.empty() ? "" : where + ": "; }

std::string words_for(const ItemDescription& item, std::size_t carrier) {
  return carrier == 0 ? "the chassis" : "part '" + item.parts[carrier - 1].name + "'";
}

const std::vector<BodyShape>& shapes_of(const ItemDescription& item, std::size_t carrier) {
  return carrier == 0 ? item.shape : item.parts[carrier - 1].shape;
}

Eigen::AlignedBox3d bounds_of(const std::vector<BodyShape>& shapes) {
  Eigen::AlignedBox3d bounds;
  for (const BodyShape& shape : shapes)
    bounds.extend(
        Eigen::AlignedBox3d(shape.center - 0.5 * shape.size, shape.center + 0.5 * shape.size));
  return bounds;
}

/// Parts that hang on nothing, or have their mass outside of themselves: a position in another unit, or of another
/// origin. A slider or what is fixed has its joint anywhere.
/// @throws Error beyond what a boom reaches
void check_places(const ItemDescription& item, std::vector<std::string>& warnings) {
  constexpr double kUsual = 1, kOutside = 0.1, kFarthest = 5;  // [m]
  Diagnostics errors;
  for (const PartDescription& part : item.parts) {
    const Eigen::AlignedBox3d own = bounds_of(part.shape),
                              below = bounds_of(shapes_of(item, part.base));
    double gap = own.exteriorDistance(below);
    if (part.joint.kind != Joint::Kind::kSlider && part.joint.kind != Joint::Kind::kFixed)
      gap = std::max(
          {gap, own.exteriorDistance(part.joint.point), below.exteriorDistance(part.joint.point)});
    const auto judge = [&](double distance, double usual, const std::string& what) {
      const std::string line = fmt::format("{}part '{}': {}", before(part.where), part.name, what);
      if (distance > kFarthest)
        errors.add(line +
                   fmt::format(": must be within {:g} mm", kFarthest * kMillimetersPerMeter));
      else if (distance > usual)
        warnings.push_back(line + "; positions are in mm, from the underside of the base plate");
    };
    judge(gap, kUsual,
          fmt::format("its shapes, its joint and {}, which carries it, are {:.0f} mm apart",
                      words_for(item, part.base), gap * kMillimetersPerMeter));
    const double off = own.exteriorDistance(part.center_of_mass);
    judge(off, kOutside,
          fmt::format("its centre of mass is {:.0f} mm outside of its shapes",
                      off * kMillimetersPerMeter));
  }
  errors.raise();
}

LoadedContent load_content(const ItemDescription& item, const ContentDescription& content,
                           const ItemOptions& options, const Vector3& base) {
  require(carries(shapes_of(item, content.on), content),
          fmt::format("{}content '{}': no shape of {} has a level top below it at {:g} mm",
                      before(content.where), content.name, words_for(item, content.on),
                      content.position.z() * kMillimetersPerMeter));
  // Heights that a content stands at, and depths that it may overlap by, are known to 1 mm.
  constexpr double kThinnest = 2e-3;  // [m]
  const double thinnest = bounds_of(content.shape).sizes().minCoeff();
  require(
      thinnest >= kThinnest,
      fmt::format("{}content '{}': is {:.3g} mm in its smallest extent: must be {:g} mm or more",
                  before(content.where), content.name, thinnest * kMillimetersPerMeter,
                  kThinnest * kMillimetersPerMeter));
  LoadedContent loaded;
  loaded.on = content.on;
  loaded.position = base + content.position;
  loaded.yaw = content.yaw;
  EquipmentModel& model = loaded.model;
  model.name = content.name;
  model.chassis_mass = content.mass;
  model.shape = standing(content.shape);
  const MassProperties body = uniform_solid(content.mass, model.shape);
  model.chassis_center_of_mass = body.center_of_mass;
  model.chassis_inertia = body.inertia;
  model.material = content.contact.material;
  loaded.pairs = pairs_of(model.material, content.contact.constants, options);
  return loaded;
}

/// A body of an item with its shapes in item axes.
struct Body {
  std::string name;
  std::vector<BodyForm> forms;
};

Body body_of(const std::string& name, const std::vector<BodyShape>& shapes, double yaw = 0,
             const Vector3& position = Vector3::Zero()) {
  Body body{name, {}};
  const Quaternion turn(Eigen::AngleAxisd(yaw, Vector3::UnitZ()));
  for (const BodyShape& shape : shapes) {
    const BodyForm form = body_form(shape, Vector3::Zero());
    place(form, turn, position, body.forms.emplace_back(form));
  }
  return body;
}

/// How deep two bodies overlap [m].
double overlap(const Body& a, const Body& b) {
  std::vector<FacingPoint> points;
  for (const BodyForm& one : a.forms)
    for (const BodyForm& other : b.forms) form_points(one, other, Vector3::Zero(), 0, points);
  double depth = 0;
  for (const FacingPoint& point : points) depth = std::max(depth, -point.gap);
  return depth;
}

/// @throws Error where a content stands in the item or in another content, with its place.
void check_contents(const ItemDescription& item, const LoadedItem& loaded) {
  constexpr double kLeastDepth = 1e-3;  // [m] as of items of a job
  std::vector<Body> bodies = {body_of("the chassis", loaded.model.shape)};
  for (const LoadedPart& part : loaded.parts)
    bodies.push_back(body_of("part '" + part.model.name + "'", part.model.shape));
  Diagnostics errors;
  for (const LoadedContent& content : loaded.contents) {
    const std::string& name = content.model.name;
    const Body body =
        body_of("content '" + name + "'", content.model.shape, content.yaw, content.position);
    const auto described = std::ranges::find(item.contents, name, &ContentDescription::name);
    for (const Body& other : bodies)
      if (const double depth = overlap(body, other); depth > kLeastDepth)
        errors.add(fmt::format("{}{} stands {:.0f} mm deep in {}", before(described->where),
                               body.name, depth * kMillimetersPerMeter, other.name));
    bodies.push_back(body);
  }
  errors.raise();
}

}  // namespace

const ContactConstants& floor_contact(const LoadedItem& item) {
  return item.pairs.back().constants;
}

EquipmentModel as_rigid(const LoadedItem& item) {
  EquipmentModel whole = item.model;
  for (const LoadedPart& part : item.parts) {
    append_all(whole.shape, part.model.shape);
    whole.payloads.push_back({part.model.name, part.model.chassis_mass,
                              part.model.chassis_center_of_mass, part.model.chassis_inertia});
    append_all(whole.payloads, part.model.payloads);
    append_all(whole.casters, part.model.casters);
  }
  for (const LoadedContent& content : item.contents) {
    const Eigen::AngleAxisd turn(content.yaw, Vector3::UnitZ());
    whole.payloads.push_back(
        {content.model.name, content.model.chassis_mass,
         content.position + turn * content.model.chassis_center_of_mass,
         turn * content.model.chassis_inertia * turn.inverse().toRotationMatrix()});
  }
  return whole;
}

LoadedItem assemble_item(const ItemDescription& item, const ItemOptions& options) {
  check(item, options);
  LoadedItem loaded;
  loaded.assumptions = item.assumptions;
  EquipmentModel& model = loaded.model;
  const Vector3 base(0, 0, base_height(item, options));
  model.name = item.name;
  model.material = item.material;
  model.chassis_mass = item.chassis_mass;
  model.chassis_center_of_mass = base + item.chassis_center_of_mass;
  model.chassis_inertia = item.chassis_inertia;
  for (const BodyShape& shape : item.shape) model.shape.push_back(shape.moved(base));
  for (const MarkedPoint& point : item.marked_points)
    model.marked_points.push_back({point.name, base + point.position});
  for (std::size_t i = 0; i < item.parts.size(); ++i)
    loaded.parts.push_back(load_part(item, i, options, base));
  for (std::size_t i = 0; i < item.casters.size(); ++i)
    carrier_of(loaded, item.casters[i].on)
        .casters.push_back(make_caster(item.casters[i], i, options, loaded.assumptions));
  add_contact(item.contact, options, loaded);
  for (const PayloadKind& kind : item.payloads) add_payloads(kind, options, base, loaded);
  for (const ContentDescription& content : item.contents) {
    if (options.contents && !has(*options.contents, content.name)) continue;
    loaded.contents.push_back(load_content(item, content, options, base));
    add_assumptions(loaded.assumptions, content.contact.assumptions);
  }
  check_contents(item, loaded);
  if (options.floor) add_assumptions(loaded.assumptions, options.floor->assumptions);
  validate(model);
  for (const LoadedPart& part : loaded.parts) validate(part.model);
  check_places(item, loaded.warnings);
  const Stability stability = stability_of(as_rigid(loaded));
  append_all(loaded.warnings, stability.warnings);
  return loaded;
}

LoadedItem load_item(const std::string& file, const ItemOptions& options,
                     const std::vector<std::string>& variants) {
  return assemble_item(load_item_description(file, variants).stated(), options);
}

}  // namespace gurney::equipment
