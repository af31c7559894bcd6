#include "studies/job/items_reader.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <numbers>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "engine/base/append_all.h"
#include "engine/base/names.h"
#include "engine/base/units.h"
#include "engine/config/nearest_name.h"
#include "engine/config/table.h"
#include "engine/scene/loads.h"
#include "equipment/catalogue/load_item.h"
#include "equipment/catalogue/quantity.h"
#include "equipment/catalogue/uncertainty.h"
#include "studies/job/caster_options.h"
#include "studies/job/job_parts.h"

namespace gurney::study {
namespace {

using config::Range;
using config::Table;

constexpr int kMaxPayloads = 100;

std::optional<equipment::Uncertain<equipment::ItemDescription>> read_description(Table& item) {
  std::vector<std::string> variants = item.texts("variant", true);  // []: as it is
  if (item.has("equipment") == item.has("inline")) {
    item.note("equipment", item.has("inline")
                               ? ": must not be given beside [item.inline]"
                               : ": missing; must name an item of the catalogue or its file, or "
                                 "[item.inline] must describe it");
    return {};
  }
  if (auto table = item.table("inline")) {
    if (!variants.empty())
      item.note("variant", ": only an item with a file of its own has variants");
    return equipment::read_item(*table);
  }
  return load_named(item, "equipment", equipment::DataKind::kItem, [&](const std::string& file) {
    const std::string unknown =
        equipment::unknown_variant(variants, equipment::variant_names(file));
    if (!unknown.empty()) {
      item.note("variant", ": " + unknown);
      variants.clear();
    }
    return equipment::load_item_description(file, variants);
  });
}

/// The caster named in the job at every place; in a draw each place is a part of its own.
void read_casters(Table& item, equipment::Uncertain<JobItem>& result) {
  auto type =
      load_named(item, "casters", equipment::DataKind::kCaster, equipment::load_caster_type);
  if (!type) return;
  result.add([type = *std::move(type)](JobItem& of_draw, equipment::Sampler& of) {
    for (equipment::CasterPlace& place : of_draw.description.casters)
      place.type = type.sample(of.of_part(place.name));
  });
}

void note_keys_of_casters(Table& item, const equipment::ItemDescription& description) {
  for (const char* key : {"casters", "headings_deg", "brakes", "brake_share", "swivel_locks"})
    if (item.has(key)) {
      item.note(key, ": " + description.name + " has no casters");
      item.set_aside(key);
    }
}

std::map<std::string, int> read_payloads(Table& item,
                                         const equipment::ItemDescription& description) {
  std::map<std::string, int> counts;
  auto table = item.table("payloads");
  if (!table) return counts;
  const std::vector<std::string> known = names_of(description.payloads);
  for (const std::string& name : table->keys()) {
    counts[name] = table->integer(name, 0, kMaxPayloads);
    if (std::find(known.begin(), known.end(), name) == known.end())
      table->note(
          name, ": " + description.name + " has no such payload" + config::suggestion(name, known));
  }
  return counts;
}

/// A list of names of parts or contents of the item; empty without the key.
template <class Part>
std::optional<std::vector<std::string>> read_known(Table& item, const char* key,
                                                   const std::vector<Part>& parts,
                                                   const equipment::ItemDescription& description) {
  if (!item.has(key)) return {};
  const std::vector<std::string> known = names_of(parts);
  std::vector<std::string> names = item.texts(key, true);
  for (auto name = names.begin(); name != names.end(); ++name)
    if (std::ranges::find(known, *name) == known.end())
      item.note(key, fmt::format(" = \"{}\": {} has none of this name{}", *name, description.name,
                                 config::suggestion(*name, known)));
    else if (std::find(names.begin(), name, *name) != name)
      item.note(key, fmt::format(" = \"{}\": stands twice", *name));
  return names;
}

/// Names of the parts that are locked: a lock holds q, which hinges and sliders have.
std::optional<std::vector<std::string>> read_locked(Table& item,
                                                    const equipment::ItemDescription& description) {
  const auto names = read_known(item, "locked_parts", description.parts, description);
  for (const equipment::PartDescription& part : description.parts)
    if (names && std::ranges::count(*names, part.name) > 0 &&
        part.joint.kind != Joint::Kind::kHinge && part.joint.kind != Joint::Kind::kSlider)
      item.note("locked_parts",
                fmt::format(" = \"{}\": its joint is \"{}\"; must be \"hinge\" or \"slider\"",
                            part.name, equipment::name_of(part.joint.kind)));
  return names;
}

/// Notes keys that describe an item: they stand in its file.
void note_keys_of_file(Table& item) {
  const std::vector<std::string> given = item.keys();
  for (const char* key : {"mass_kg", "center_of_mass_mm", "inertia_box_mm", "inertia_kg_m2",
                          "chassis", "shape", "part"}) {
    if (std::ranges::find(given, key) == given.end()) continue;
    item.note(key, ": unknown key; it belongs to the item's file, or to [item.inline]");
    item.set_aside(key);
  }
}

/// A table [item] or [[item]] of a job. Errors are noted in the document; then the description
/// and options are not for use.
/// @param remarks  on options that reach no caster, or not all
equipment::Uncertain<JobItem> read_job_item(Table& item, Remarks& remarks) {
  note_keys_of_file(item);
  equipment::Uncertain<JobItem> result;
  equipment::Quantities in(item);
  result.set([](JobItem& of_draw) -> Vector3& { return of_draw.initial.position; },
             in.plane("position_m", Range::any()));
  result.set([](JobItem& of_draw) -> double& { return of_draw.initial.yaw; },
             in.angle_deg("yaw_deg", Range::any(), 0.0));
  item.has("on");  // is read when all items and the room are placed
  std::optional<equipment::Uncertain<equipment::ItemDescription>> found = read_description(item);
  const bool described = found.has_value();
  if (described) result.set(&JobItem::description, *std::move(found));
  read_casters(item, result);
  if (!described) {
    for (const char* key : {"headings_deg", "brakes", "brake_share", "swivel_locks", "payloads",
                            "locked_parts", "contents"})
      item.set_aside(key);
    return result;
  }
  const equipment::ItemDescription& description = result.stated().description;
  if (description.casters.empty())
    note_keys_of_casters(item, description);
  else
    read_caster_options(in, result, remarks);
  result.add([counts = read_payloads(item, description), locked = read_locked(item, description),
              contents = read_known(item, "contents", description.contents, description)](
                 JobItem& of_draw, equipment::Sampler&) {
    of_draw.options.payloads = counts;
    of_draw.options.locked_parts = locked;
    of_draw.options.contents = contents;
  });
  return result;
}

/// Each reader notes errors in its table's document.

using config::Range;
using config::Table;

/// Point and direction of a load.
template <typename Load>
void read_line(equipment::Quantities& in, equipment::Uncertain<Load>& load) {
  load.set(&Load::point, in.vector("point_m", Range::any()));
  load.set(&Load::direction, in.vector("direction", Range::any()));
  load.add(in.table().document(),
           [spot = in.table().spot("direction")](Load& of_draw, equipment::Sampler& of) {
             Vector3& direction = of_draw.direction;
             if (!(direction.norm() > 0)) {
               of.error(spot, " = [0, 0, 0]: must have a length");
               direction = Vector3::UnitX();
             }
             direction.normalize();
           });
}

void read_constant_force(equipment::Quantities& in, const Range& allowed,
                         equipment::Uncertain<PointForce>& load) {
  const equipment::StatedQuantity force = in.number("force_n", allowed);
  const equipment::StatedQuantity from = in.number("from_s", Range::not_negative(), 0.0);
  const equipment::StatedQuantity until = in.number("until_s", Range::more_than(from.value));
  load.add([force, from, until](PointForce& of_draw, equipment::Sampler& of) {
    const double newton = of(force), begin = of(from);
    of.check_drawn(until, Range::more_than(begin));
    of_draw.force = {newton, newton};
    of_draw.time = {begin, of(until)};
  });
  if (in.table().has("time_s"))
    in.table().note("time_s", ": must go with an array force_n; a constant force has until_s");
}

void read_force_table(Table& table, const Range& allowed, equipment::Uncertain<PointForce>& load) {
  const std::vector<double> force = table.numbers("force_n", allowed);
  const std::vector<double> time = table.numbers("time_s", Range::any(), force.size());
  if (force.size() < 2) table.note("force_n", ": must have 2 or more values");
  for (std::size_t i = 1; i < time.size(); ++i)
    if (!(time[i] > time[i - 1])) {
      table.note("time_s", fmt::format("[{}] = {}: must be more than the time before it, {}", i,
                                       time[i], time[i - 1]));
      break;
    }
  for (const char* key : {"from_s", "until_s"})
    if (table.has(key)) table.note(key, ": must go with a constant force_n, not with a table");
  load.add([force, time](PointForce& of_draw, equipment::Sampler&) {
    of_draw.force = force;
    of_draw.time = time;
  });
}

equipment::Uncertain<PointForce> read_force(Table table, std::size_t index) {
  equipment::Quantities in(table);
  PointForce fixed;
  fixed.name = table.text("name", fmt::format("force {}", index + 1));
  equipment::Uncertain<PointForce> load(std::move(fixed));
  read_line(in, load);
  const bool limited = table.has("speed_limit_m_per_s");
  if (limited)
    load.set(&PointForce::speed_limit, in.number("speed_limit_m_per_s", Range::positive()));
  for (const char* key : {"time_s", "from_s", "until_s"}) table.has(key);
  const Range allowed = limited ? Range::not_negative() : Range::any();
  if (table.is_array("force_n"))
    read_force_table(table, allowed, load);
  else
    read_constant_force(in, allowed, load);
  return load;
}

equipment::Uncertain<DropWeight> read_drop_weight(equipment::Quantities in) {
  const DropWeight usual;
  equipment::Uncertain<DropWeight> load;
  read_line(in, load);
  load.set(&DropWeight::mass, in.number("mass_kg", Range::positive()));
  load.set(&DropWeight::drop_height, in.number("drop_height_m", Range::positive()));
  load.set(&DropWeight::pulley_inertia,
           in.number("pulley_inertia_kg_m2", Range::not_negative(), usual.pulley_inertia));
  load.set(&DropWeight::pulley_radius,
           in.number("pulley_radius_m", Range::positive(), usual.pulley_radius));
  load.set(
      &DropWeight::potentiometer_tension,
      in.number("potentiometer_tension_n", Range::not_negative(), usual.potentiometer_tension));
  load.set(&DropWeight::cable_stiffness,
           in.number("cable_stiffness_n_per_m", Range::positive(), usual.cable_stiffness));
  load.set(&DropWeight::cable_damping,
           in.number("cable_damping_n_s_per_m", Range::not_negative(), usual.cable_damping));
  return load;
}

equipment::Uncertain<StringPotentiometer> read_string_potentiometer(equipment::Quantities in) {
  equipment::Uncertain<StringPotentiometer> load;
  read_line(in, load);
  load.set(&StringPotentiometer::tension, in.number("tension_n", Range::not_negative()));
  return load;
}

equipment::Uncertain<Blocks> read_blocks(equipment::Quantities in) {
  const Blocks usual;
  equipment::Uncertain<Blocks> load;
  load.set(&Blocks::point, in.vector("point_m", Range::any()));
  load.set(&Blocks::stiffness, in.number("stiffness_n_per_m", Range::positive(), usual.stiffness));
  load.set(&Blocks::damping, in.number("damping_n_s_per_m", Range::not_negative(), usual.damping));
  load.set(&Blocks::release_time, in.number("release_time_s", Range::positive()));
  return load;
}

equipment::Uncertain<Guide> read_guide(Table& fixture, const std::string& key, bool translation) {
  Guide fixed;
  if (!fixture.is_table(key)) {
    static const std::vector<std::string> kKinds = {"free", "held"};
    fixed.kind = static_cast<Guide::Kind>(fixture.choice(key, kKinds, 0));
    return equipment::Uncertain<Guide>(fixed);
  }
  Table table = *fixture.table(key);
  const bool spring = translation && table.has("stiffness_n_per_m");
  if (translation && spring == table.has("velocity_m_per_s"))
    table.note("velocity_m_per_s", ": must be given, or stiffness_n_per_m, not both");
  fixed.kind = spring ? Guide::Kind::kSpring : Guide::Kind::kVelocity;
  equipment::Uncertain<Guide> guide(fixed);
  equipment::Quantities in(table);
  if (spring) {
    guide.set(&Guide::stiffness, in.number("stiffness_n_per_m", Range::not_negative()));
    guide.set(&Guide::damping, in.number("damping_n_s_per_m", Range::not_negative(), 0.0));
  } else if (translation) {
    guide.set(&Guide::velocity, in.number("velocity_m_per_s", Range::any(), 0.0));
  } else {
    guide.set(&Guide::velocity, in.angle_deg("velocity_deg_per_s", Range::any()));
  }
  return guide;
}

std::vector<Load>& loads_of_item(PlacedItem& item) { return item.loads; }

/// A member of the initial motion.
template <class Value>
auto initial(Value InitialMotion::*member) {
  return [member](PlacedItem& item) -> Value& { return item.initial.*member; };
}

/// The forces, drop weights, string potentiometers and blocks of a table [item] or [excitation],
/// after those that the item has.
void read_loads(Table& table, equipment::Uncertain<PlacedItem>& item) {
  std::size_t forces = loads_of<PointForce>(item.stated().loads).size();
  for (Table& force : table.tables("force"))
    item.append(loads_of_item, read_force(force, forces++));
  for (Table& weight : table.tables("drop_weight"))
    item.append(loads_of_item, read_drop_weight(equipment::Quantities(weight)));
  for (Table& string : table.tables("string_potentiometer"))
    item.append(loads_of_item, read_string_potentiometer(equipment::Quantities(string)));
  for (Table& blocks : table.tables("blocks"))
    item.append(loads_of_item, read_blocks(equipment::Quantities(blocks)));
}

/// The tables `fixture` and `initial` of an item or a job.
void read_fixture(Table& fixture, equipment::Uncertain<PlacedItem>& item) {
  static constexpr std::array kDegreesOfFreedom = {"x", "y", "z", "roll", "pitch", "yaw"};
  for (std::size_t i = 0; i < kDegreesOfFreedom.size(); ++i)
    item.set([i](PlacedItem& of_draw) -> Guide& { return of_draw.fixture.guides[i]; },
             read_guide(fixture, kDegreesOfFreedom[i], i < 3));
}

void read_initial(Table& table, equipment::Uncertain<PlacedItem>& item) {
  equipment::Quantities in(table);
  item.set(initial(&InitialMotion::velocity),
           in.vector("velocity_m_per_s", Range::any(), Vector3::Zero()));
  item.set(initial(&InitialMotion::yaw_rate),
           in.angle_deg("yaw_rate_deg_per_s", Range::any(), 0.0));
  item.add([roll = table.boolean("wheels_roll", InitialMotion().wheels_roll)](
               PlacedItem& of_draw, equipment::Sampler&) { of_draw.initial.wheels_roll = roll; });
}

using config::Table;

std::vector<Table> item_tables(Table& root) {
  if (root.is_array("item")) {
    const std::size_t errors = root.document().errors();
    std::vector<Table> tables = root.tables("item");
    if (tables.empty() && root.document().errors() == errors)
      root.note("item", ": must be tables [[item]], 1 or more");
    return tables;
  }
  if (auto table = root.table("item")) return {*table};
  if (!root.has("item"))
    root.note("item", ": missing; must be a table [item], or tables [[item]] for several");
  return {};
}

/// The equipment's name in the catalogue, or that of its file.
std::string equipment_name(Table& item) {
  if (item.is_table("inline")) {
    Table table = *item.table("inline");
    return table.is_text("name") ? table.text("name") : "item";
  }
  return item.is_text("equipment") ? std::filesystem::path(item.text("equipment")).stem().string()
                                   : "item";
}

/// Stated names come first: one formed from the equipment's avoids them.
std::vector<std::string> read_names(std::vector<Table>& items, equipment::UniqueNames& names) {
  std::vector<std::string> result(items.size());
  for (std::size_t i = 0; i < items.size(); ++i) {
    if (!items[i].has("name")) continue;
    names.take(items[i], result[i] = items[i].text("name"));
    if (result[i].find('/') != std::string::npos)
      items[i].note("name",
                    fmt::format(" = \"{}\": must have no '/', which stands between an item and "
                                "its parts and contents",
                                result[i]));
  }
  for (std::size_t i = 0; i < items.size(); ++i) {
    if (items[i].has("name")) continue;
    const std::string base = equipment_name(items[i]);
    result[i] = base;
    for (int number = 2; names.has(result[i]); ++number)
      result[i] = fmt::format("{} {}", base, number);
    names.take(items[i], result[i]);
  }
  return result;
}

/// Reads the loads on the item, its fixture and its motion at the start.
void read_acting(Table& item, equipment::Uncertain<PlacedItem>& acting) {
  read_loads(item, acting);
  if (auto fixture = item.table("fixture")) read_fixture(*fixture, acting);
  if (auto initial = item.table("initial")) read_initial(*initial, acting);
}

/// Notes each of these keys that is there: a job of several items has it with one of them.
void note_without_item(Table& table, const std::vector<const char*>& keys, const char* form) {
  for (const char* key : keys)
    if (table.has(key))
      table.note(key, fmt::format(": must be with one of the items, {} below its [[item]]",
                                  fmt::format(fmt::runtime(form), key)));
}

/// Notes a table that both the job and its item have.
void note_twice(Table& root, Table& item, const char* key) {
  if (root.has(key) && item.has(key))
    root.note(key, fmt::format(": must not be given beside item.{}", key));
}

/// Facts of one item's table that a step needs.
struct ItemStep {
  std::size_t index = 0;
  bool several = false;
  config::Spot description{};
  Remarks remarks{};
};

bool has_a_place(const std::string& line, const equipment::ItemDescription& description) {
  const auto begins_with = [&](const auto& part) {
    return !part.where.empty() && line.starts_with(part.where);
  };
  return std::ranges::any_of(description.casters, begins_with) ||
         std::ranges::any_of(description.contents, begins_with);
}

/// Errors in how an item is put together: at its casters, else where the job names it.
void note_lines(const Error& error, const equipment::ItemDescription& description,
                const config::Spot& spot, equipment::Sampler& of) {
  std::istringstream lines(error.what());
  for (std::string line; std::getline(lines, line);)
    if (has_a_place(line, description))
      of.error(Error(line));
    else
      of.error(spot, ": " + line);
}

void place(JobItem item, const ItemStep& step, JobParts& job, equipment::Sampler& of) {
  PlacedItem& placed = job.scene.items[step.index];
  append_all(job.warnings, step.remarks.warnings);
  item.options.floor = job.covering;
  try {
    equipment::LoadedItem loaded = assemble_item(item.description, item.options);
    if (loaded.states_contact)
      for (const MaterialPair& pair : loaded.pairs)
        job.item_contacts[step.index].push_back(pair.constants);
    placed.model = std::move(loaded.model);
    JobParts::Unfolded& unfolded = job.unfolded[step.index];
    unfolded.parts = std::move(loaded.parts);
    unfolded.contents = std::move(loaded.contents);
    for (const std::string& warning : loaded.warnings)
      job.warnings.push_back(step.several ? placed.name + ": " + warning : warning);
    add_assumptions(job.assumptions, loaded.assumptions);
  } catch (const Error& error) {
    note_lines(error, item.description, step.description, of);
  }
}

void read_one(Table& table, ItemStep step, JobReading& job) {
  config::Document& document = table.document();
  const std::size_t errors = document.errors();
  const equipment::Uncertain<JobItem> item = read_job_item(table, step.remarks);
  step.description = description_spot(table);
  equipment::Uncertain<PlacedItem> acting;
  read_acting(table, acting);
  const bool complete = document.errors() == errors;
  job.add(document, [item, acting, step, complete](JobParts& of_draw, equipment::Sampler& of) {
    PlacedItem& placed = of_draw.scene.items[step.index];
    const equipment::Sampler own =
        step.several ? of.of_element(fmt::format("item[{}]", step.index), placed.name) : of;
    JobItem sampled = item.sample(own);
    placed.initial = sampled.initial;
    acting.apply(placed, own);
    append_all(of_draw.without_effect, step.remarks.without_effect);
    if (complete) place(std::move(sampled), step, of_draw, of);
  });
}

}  // namespace

std::vector<Table> read_items(Table& root, equipment::UniqueNames& names, JobReading& job) {
  std::vector<Table> tables = item_tables(root);
  job.add([item_names = read_names(tables, names)](JobParts& of_draw, equipment::Sampler&) {
    of_draw.scene.items.resize(std::max<std::size_t>(1, item_names.size()));
    of_draw.item_contacts.resize(of_draw.scene.items.size());
    of_draw.unfolded.resize(of_draw.scene.items.size());
    for (std::size_t i = 0; i < item_names.size(); ++i) of_draw.scene.items[i].name = item_names[i];
  });
  const std::size_t errors = root.document().errors();
  const bool several = root.is_array("item");
  for (std::size_t i = 0; i < tables.size(); ++i)
    read_one(tables[i], {.index = i, .several = several}, job);
  if (tables.size() == 1)
    for (const char* key : {"fixture", "initial"}) note_twice(root, tables.front(), key);
  return root.document().errors() == errors ? tables : std::vector<Table>{};
}

void unfold_items(JobReading& job) {
  job.add([](JobParts& of_draw, equipment::Sampler&) {
    Scene& scene = of_draw.scene;
    const std::size_t count = of_draw.unfolded.size();
    of_draw.owners.clear();
    for (std::size_t i = 0; i < count; ++i) of_draw.owners.push_back(i);
    const auto add = [&](std::size_t owner, const EquipmentModel& model) -> PlacedItem& {
      PlacedItem& added = scene.items.emplace_back();
      added.name = scene.items[owner].name + "/" + model.name;
      added.model = model;
      of_draw.owners.push_back(owner);
      return added;
    };
    for (std::size_t i = 0; i < count; ++i) {
      JobParts::Unfolded& unfolded = of_draw.unfolded[i];
      unfolded.first = scene.items.size();
      const auto body = [&](std::size_t number) {
        return number == 0 ? i : unfolded.first + number - 1;
      };
      for (const equipment::LoadedPart& part : unfolded.parts) {
        Joint joint = part.joint;
        joint.base = body(joint.base);
        joint.part = scene.items.size();
        add(i, part.model);
        scene.joints.push_back(joint);
        of_draw.item_contacts.push_back(of_draw.item_contacts[i]);
      }
      for (const equipment::LoadedContent& content : unfolded.contents) {
        add(i, content.model).on =
            Support{Support::Kind::kItem, body(content.on), content.position.z()};
        std::vector<ContactConstants>& own = of_draw.item_contacts.emplace_back();
        for (const MaterialPair& pair : content.pairs) own.push_back(pair.constants);
      }
    }
  });
}

void place_unfolded(JobReading& job) {
  job.add([](JobParts& of_draw, equipment::Sampler&) {
    Scene& scene = of_draw.scene;
    for (std::size_t i = 0; i < of_draw.unfolded.size(); ++i) {
      const PlacedItem& owner = scene.items[i];
      std::size_t next = of_draw.unfolded[i].first;
      for (std::size_t k = 0; k < of_draw.unfolded[i].parts.size(); ++k)
        scene.items[next++].initial = owner.initial;
      for (const equipment::LoadedContent& content : of_draw.unfolded[i].contents) {
        PlacedItem& placed = scene.items[next++];
        placed.initial = owner.initial;
        const Eigen::Rotation2Dd turn(owner.initial.yaw);
        const Vector2 from = turn * content.position.head<2>();
        placed.initial.position.head<2>() += from;
        placed.initial.yaw += content.yaw;
        // InitialMotion states the velocity of the chassis' centre of mass.
        const Vector2 arm =
            from - turn * chassis_with_payloads(owner.model).center_of_mass.head<2>();
        placed.initial.velocity += Vector3(-arm.y(), arm.x(), 0) * owner.initial.yaw_rate;
        if (owner.on) placed.on->height = content.position.z() + owner.on->height;
      }
    }
  });
}

void read_acting_at_top(Table& root, JobReading& job) {
  const bool several = job.stated().unfolded.size() > 1;
  equipment::Uncertain<PlacedItem> only;
  if (auto excitation = root.table("excitation")) {
    read_loads(*excitation, only);
    if (several)
      note_without_item(*excitation, {"force", "drop_weight", "string_potentiometer", "blocks"},
                        "[[item.{}]]");
  }
  if (auto fixture = root.table("fixture")) read_fixture(*fixture, only);
  if (auto initial = root.table("initial")) read_initial(*initial, only);
  if (several) {
    note_without_item(root, {"fixture", "initial"}, "[item.{}]");
    return;
  }
  job.add([only](JobParts& of_draw, equipment::Sampler& of) {
    only.apply(of_draw.scene.items.front(), of);
  });
}

}  // namespace gurney::study
