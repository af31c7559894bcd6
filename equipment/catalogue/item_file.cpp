#include "equipment/catalogue/item_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <memory>
#include <optional>
#include <utility>

#include "engine/base/diagnostics.h"
#include "engine/base/units.h"
#include "engine/config/nearest_name.h"
#include "engine/config/overlay.h"
#include "engine/config/table.h"
#include "equipment/catalogue/body_reader.h"
#include "equipment/catalogue/catalogue.h"
#include "equipment/catalogue/quantity.h"
#include "equipment/catalogue/shape_reader.h"

namespace gurney::equipment {
namespace {

using config::Range;
using config::Table;

constexpr int kMaxPayloads = 100;

/// Casters named in one item. A file is read once, and its errors are noted once.
class CasterTypes {
 public:
  /// Into the place's type. One from a file is a part of its own in a draw, with the place's name.
  void read(Table& table, Uncertain<CasterPlace>& place) {
    const bool inline_type = table.has("inline");
    if (inline_type == table.has("type"))
      table.note("type", ": must name a caster, or a table 'inline' must describe it, not both");
    if (inline_type) {
      if (auto described = table.table("inline"))
        place.set(&CasterPlace::type, read_caster_type(*described));
      return;
    }
    if (!table.has("type")) return;
    const StatedText name = Quantities(table).text("type");
    place.add(
        [type = load(table, name.text), choice = name.choice](CasterPlace& of_draw, Sampler& of) {
          of_draw.type = type->sample(of.of_part(of_draw.name));
          if (!choice.reason.empty()) add_assumptions(of_draw.type.assumptions, {choice});
        });
  }

 private:
  using Type = std::shared_ptr<const Uncertain<CasterType>>;

  Type load(Table& place, const std::string& name) {
    static const Type kNone = std::make_shared<Uncertain<CasterType>>();
    std::string file;
    try {
      file = find_data(DataKind::kCaster, name, place.document().path());
    } catch (const Error& error) {
      place.note("type", " = \"" + name + "\": " + error.what());
      return kNone;
    }
    const auto known = types_.find(file);
    if (known != types_.end()) return known->second;
    Type type = kNone;
    try {
      type = std::make_shared<Uncertain<CasterType>>(load_caster_type(file));
    } catch (const Error& error) {
      place.document().note(error);
    }
    return types_[file] = type;
  }

  std::map<std::string, Type> types_;
};

Uncertain<CasterPlace> read_place(Table table, std::size_t index, CasterTypes& types) {
  CasterPlace fixed;
  fixed.name = table.text("name", fmt::format("caster {}", index + 1));
  fixed.where = table.where("position_mm");
  fixed.swivels = table.boolean("swivels", true);
  Quantities in(table);
  const StatedQuantity heading = in.angle_deg("heading_deg", Range::any(), 0.0);
  fixed.stated_heading = heading.si(heading.value);
  const QuantityList brake = in.flag("brake", false), lock = in.flag("swivel_lock", false);
  fixed.brake_drawn = brake.quantities.front().uncertainty.has_value();
  fixed.lock_drawn = lock.quantities.front().uncertainty.has_value();
  Uncertain<CasterPlace> place(std::move(fixed));
  types.read(table, place);
  place.set(&CasterPlace::mount, in.vector_mm("position_mm", Range::any()));
  place.set(&CasterPlace::heading, heading);
  place.set(&CasterPlace::brake_on, brake);
  place.set(&CasterPlace::swivel_locked, lock);
  const CasterPlace& stated = place.stated();
  if (!stated.swivels && (stated.swivel_locked || table.is_table("swivel_lock")))
    table.note("swivel_lock", ": has no effect: the caster does not swivel (swivels = false)");
  return place;
}

/// Which bodies the casters carry, once the parts are known.
void read_bases(Table& table, Uncertain<ItemDescription>& item) {
  std::vector<std::size_t> bases;
  for (Table& place : table.tables("caster"))
    bases.push_back(read_carrier(place, "on", item.stated().parts));
  if (!bases.empty() && std::ranges::find(bases, std::size_t{0}) == bases.end())
    table.note("caster", ": all are on parts; one at least must be on the chassis");
  item.add([bases](ItemDescription& of_draw, Sampler&) {
    for (std::size_t i = 0; i < bases.size(); ++i) of_draw.casters[i].on = bases[i];
  });
}

Uncertain<PayloadKind> read_payload(Table table, const std::vector<PartDescription>& parts) {
  PayloadKind fixed;
  fixed.name = table.text("name");
  fixed.on = read_carrier(table, "on", parts);
  fixed.count = table.integer("count", 0, kMaxPayloads, 0);
  Uncertain<PayloadKind> payload(std::move(fixed));
  Quantities in(table);
  payload.set(&PayloadKind::mass, in.number("mass_kg", Range::positive()));
  payload.set(&PayloadKind::size, in.vector_mm("size_mm", Range::positive()));
  payload.set(&PayloadKind::position, in.vector_mm("position_mm", Range::any()));
  return payload;
}

/// Names must differ, so that jobs and results can distinguish the parts.
template <typename Part>
void check_names(const std::vector<Part>& parts, const std::string& key, Table& table) {
  for (std::size_t i = 1; i < parts.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (parts[i].name == parts[j].name)
        table.note(key, fmt::format("[{}].name = \"{}\": must differ from the name of {}[{}]", i,
                                    parts[i].name, key, j));
}

}  // namespace

Uncertain<ItemDescription> read_item(Table table) {
  ItemDescription fixed;
  fixed.file = table.document().path();
  fixed.name = table.text("name");
  fixed.description = table.text("description", "");
  auto chassis = table.table("chassis");
  if (chassis) fixed.material = chassis->text("material", "");
  if (!chassis && !table.has("chassis"))
    table.note("chassis", ": missing; must be a table [" + table.name_of("chassis") + "]");
  Uncertain<ItemDescription> item(std::move(fixed));
  const ItemDescription& stated = item.stated();
  if (chassis) {
    Quantities in(*chassis);
    read_body(in,
              BodyMembers<ItemDescription>{&ItemDescription::chassis_mass,
                                           &ItemDescription::chassis_center_of_mass,
                                           &ItemDescription::chassis_inertia},
              item);
  }
  read_shape(table, &ItemDescription::shape, item);

  CasterTypes types;
  for (Table& place : table.tables("caster"))
    item.append(&ItemDescription::casters, read_place(place, stated.casters.size(), types));
  if (stated.casters.size() > EquipmentModel::kMaxCasters)
    table.note("caster", fmt::format(": {} casters; must be 0 to {} tables [[caster]]",
                                     stated.casters.size(), EquipmentModel::kMaxCasters));
  if (auto contact = table.table("contact"))
    item.set(&ItemDescription::contact,
             read_item_contact(*contact,
                               has_round_shape(table) ||
                                   std::ranges::any_of(table.tables("part"), has_round_shape)));
  else if (!table.has("contact") && stated.casters.empty())
    table.note("contact", ": missing; an item without casters needs a table [" +
                              table.name_of("contact") + "], how it meets the floor");
  read_marked_points(table, &ItemDescription::marked_points, item);
  for (Table& part : table.tables("part"))
    item.append(&ItemDescription::parts, read_part(part, stated.parts));
  read_bases(table, item);
  for (Table& payload : table.tables("payload"))
    item.append(&ItemDescription::payloads, read_payload(payload, stated.parts));
  for (Table& content : table.tables("content"))
    item.append(&ItemDescription::contents, read_content(content, stated.parts));
  check_names(stated.casters, "caster", table);
  check_names(stated.payloads, "payload", table);
  check_names(stated.marked_points, "marked_point", table);
  check_names(stated.parts, "part", table);
  check_names(stated.contents, "content", table);
  return item;
}

namespace {

using config::Document;
using config::Node;

Uncertain<ItemDescription> read(Document& document, const std::string& remark,
                                Diagnostics& errors) {
  document.root().choice("schema", {"gurney-item/1"});
  Uncertain<ItemDescription> item = read_item(document.root());
  try {
    document.finish();
  } catch (const Error& error) {
    errors.add_new(error.what(), remark);
  }
  return item;
}

/// The item with these variants over it, in their order.
Uncertain<ItemDescription> read_changed(const Node& tree, const Document& origin,
                                        const std::vector<const Node*>& variants,
                                        Diagnostics& errors) {
  Node changed = tree;
  Document notes(Node(), origin);
  std::string names;
  for (const Node* variant : variants) {
    config::overlay(changed, *variant, "variant." + variant->key, notes);
    names += (names.empty() ? "'" : ", '") + variant->key + "'";
  }
  const std::string remark = " (variant " + names + ")";
  try {
    notes.finish();
  } catch (const Error& error) {
    errors.add_new(error.what());
  }
  Document document(std::move(changed), origin);
  return read(document, remark, errors);
}

/// A table [variant.NAME] and the variants that it extends.
struct Variant {
  Node changes;
  std::vector<std::string> bases;
};

std::vector<std::string> names_of(const std::vector<Variant>& variants) {
  std::vector<std::string> names;
  for (const Variant& variant : variants) names.push_back(variant.changes.key);
  return names;
}

/// Adds a variant behind those that it extends, each once.
/// @param begun  names of what is there already, or is being added
void add_chain(const std::vector<Variant>& known, const std::string& name,
               std::vector<std::string>& begun, std::vector<const Node*>& chain) {
  if (std::ranges::find(begun, name) != begun.end()) return;
  begun.push_back(name);
  for (const Variant& variant : known) {
    if (variant.changes.key != name) continue;
    for (const std::string& base : variant.bases) add_chain(known, base, begun, chain);
    chain.push_back(&variant.changes);
  }
}

/// Tables that are laid over the item for these variants, in order.
std::vector<const Node*> chain_of(const std::vector<Variant>& known,
                                  const std::vector<std::string>& names) {
  std::vector<const Node*> chain;
  std::vector<std::string> begun;
  for (const std::string& name : names) add_chain(known, name, begun, chain);
  return chain;
}

/// Takes the key `extends` out of a variant.
std::vector<std::string> take_bases(Node& variant, Document& document) {
  std::vector<std::string> bases;
  std::erase_if(variant.elements, [&](const Node& each) {
    if (each.key != "extends") return false;
    const std::vector<Node> stated =
        each.kind == Node::Kind::kArray ? each.elements : std::vector<Node>{each};
    for (const Node& base : stated)
      if (base.kind == Node::Kind::kText)
        bases.push_back(base.text);
      else
        document.note(base.place, "variant." + variant.key + ".extends = " + describe(base) +
                                      ": must be the name of a variant, or an array of names");
    return true;
  });
  return bases;
}

/// Notes bases that are not there, and variants that extend each other.
void check_bases(const std::vector<Variant>& variants, Document& document) {
  for (const Variant& variant : variants) {
    const std::string& name = variant.changes.key;
    for (const std::string& base : variant.bases) {
      const std::string unknown = unknown_variant({base}, names_of(variants));
      std::vector<std::string> begun;
      std::vector<const Node*> chain;
      add_chain(variants, base, begun, chain);
      if (!unknown.empty())
        document.note(variant.changes.key_place, "variant." + name + ".extends: " + unknown);
      else if (std::ranges::find(begun, name) != begun.end())
        document.note(variant.changes.key_place,
                      "variant." + name + ".extends = \"" + base +
                          "\": must not extend itself, by others either");
    }
  }
}

/// Takes the tables [variant.NAME] from a document and leaves those that are tables.
std::vector<Variant> take_variants(Document& document) {
  const std::optional<Node> taken = document.take("variant");
  if (!taken) return {};
  if (taken->kind != Node::Kind::kTable) {
    document.note(taken->place,
                  "variant = " + describe(*taken) + ": must be tables [variant.NAME]");
    return {};
  }
  std::vector<Variant> variants;
  for (Node each : taken->elements)
    if (each.kind == Node::Kind::kTable) {
      std::vector<std::string> bases = take_bases(each, document);
      variants.push_back({std::move(each), std::move(bases)});
    } else {
      document.note(each.place, "variant." + each.key + " = " + describe(each) +
                                    ": must be a table [variant." + each.key + "]");
    }
  check_bases(variants, document);
  return variants;
}

}  // namespace

std::vector<std::string> variant_names(const std::string& item_file) {
  Document document(item_file);
  return names_of(take_variants(document));
}

std::string unknown_variant(const std::vector<std::string>& wanted,
                            const std::vector<std::string>& known) {
  for (const std::string& name : wanted)
    if (std::find(known.begin(), known.end(), name) == known.end())
      return "the item has no variant '" + name + "'" + config::suggestion(name, known);
  return "";
}

Uncertain<ItemDescription> load_item_description(const std::string& file,
                                                 const std::vector<std::string>& variants) {
  Document document(file);
  const std::vector<Variant> known = take_variants(document);
  const std::string unknown = unknown_variant(variants, names_of(known));
  require(unknown.empty(), file + ": " + unknown);

  const Node tree = document.tree();
  Diagnostics errors;  // of several readings of one file, each line once
  Uncertain<ItemDescription> item = read(document, "", errors);
  for (const std::string& name : names_of(known))
    read_changed(tree, document, chain_of(known, {name}), errors);
  const std::vector<const Node*> selected = chain_of(known, variants);
  if (!selected.empty()) item = read_changed(tree, document, selected, errors);
  errors.raise();
  item.add(
      [names = names_of(known)](ItemDescription& of_draw, Sampler&) { of_draw.variants = names; });
  return item;
}

}  // namespace gurney::equipment
