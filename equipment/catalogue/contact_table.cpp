#include "equipment/catalogue/contact_table.h"

#include <set>

#include "equipment/catalogue/catalogue.h"

namespace gurney::equipment {

using config::Range;

namespace {

/// Rolling friction length of what is round and states none.
constexpr double kRollingResistance = 0.5;  // [mm]

}  // namespace

Uncertain<ContactConstants> read_contact_constants(Quantities in, bool rolls) {
  ContactConstants fixed;
  config::Table& table = in.table();
  const bool compliant = table.has("damping_n_s_per_m"), rebounds = table.has("restitution");
  if (compliant == rebounds)
    table.note("restitution", ": must be given, or damping_n_s_per_m, not both");
  if (compliant) fixed.kind = ContactConstants::Kind::kCompliant;
  Uncertain<ContactConstants> constants(fixed);
  constants.set(&ContactConstants::friction, in.number("friction", Range::not_negative()));
  StatedQuantity rolling =
      in.length_mm("rolling_resistance_mm", Range::not_negative(), kRollingResistance);
  if (rolls && !table.has("rolling_resistance_mm")) {
    rolling.reason = "hard bodies on floors; the file states none";
    rolling.low = 0.1;
    rolling.high = 2;
  }
  constants.set(&ContactConstants::rolling_resistance, rolling);
  const std::optional<double> stiffness = compliant ? std::nullopt : std::optional(fixed.stiffness);
  constants.set(&ContactConstants::stiffness,
                in.number("stiffness_n_per_m", Range::positive(), stiffness));
  if (compliant)
    constants.set(&ContactConstants::damping,
                  in.number("damping_n_s_per_m", Range::not_negative()));
  if (rebounds)
    constants.set(&ContactConstants::restitution, in.number("restitution", Range::within(0.01, 1)));
  return constants;
}

Uncertain<ItemContact> read_item_contact(config::Table table, bool rolls) {
  ItemContact fixed;
  fixed.material = table.text("material");
  if (table.is_text("material") && fixed.material.empty())
    table.note("material", " = \"\": must be the name of a material");
  if (!rolls && table.has("rolling_resistance_mm"))
    table.note("rolling_resistance_mm", ": has no effect: only cylinders and spheres roll");
  Uncertain<ItemContact> contact(fixed);
  contact.set(&ItemContact::constants, read_contact_constants(Quantities(table), rolls));
  return contact;
}

namespace {

using config::Table;

void read_materials(Table& table, MaterialContact& contact) {
  const std::vector<std::string> names = table.texts("materials");
  if (names.size() == 2) {
    contact.one = names[0];
    contact.other = names[1];
  } else if (!table.has("materials")) {
    table.note("materials", ": missing; must be an array of 2 texts");
  } else {
    table.note("materials", ": must be an array of 2 texts");
  }
}

/// Names the subject of each assumption: `equipment-concrete/contact.friction`.
void name_assumptions(const std::string& path, const std::string& part,
                      std::vector<Assumption>& assumptions) {
  for (Assumption& each : assumptions)
    if (each.key.starts_with(path)) each.key = part + "/contact" + each.key.substr(path.size());
}

}  // namespace

ContactTable read_contacts(Table& parent) {
  ContactTable contacts;
  for (Table& table : parent.tables("contact")) {
    const std::string path =
        parent.name_of("contact") + "[" + std::to_string(contacts.stated().size()) + "]";
    MaterialContact fixed;
    read_materials(table, fixed);
    if (!fixed.one.empty() && find_contact(contacts.stated(), fixed.one, fixed.other) != nullptr)
      table.note("materials",
                 ": the pair of '" + fixed.one + "' and '" + fixed.other + "' is there already");
    const std::string part = fixed.one + "-" + fixed.other;
    Uncertain<MaterialContact> contact(fixed);
    contact.set(&MaterialContact::constants, read_contact_constants(Quantities(table), false));
    contact.add([path, part](MaterialContact& of_draw, Sampler&) {
      name_assumptions(path, part, of_draw.assumptions);
    });
    contacts.add([contact, path, part](std::vector<MaterialContact>& list, Sampler& of) {
      list.push_back(contact.sample(of.of_element(path, part)));
    });
  }
  return contacts;
}

ContactTable usual_contacts() {
  config::Document document(data_file("contacts.toml"));
  Table root = document.root();
  root.choice("schema", {"gurney-contacts/1"});
  ContactTable contacts = read_contacts(root);
  document.finish();
  return contacts;
}

const MaterialContact* find_contact(const std::vector<MaterialContact>& contacts,
                                    const std::string& one, const std::string& other) {
  for (const MaterialContact& each : contacts)
    if ((each.one == one && each.other == other) || (each.one == other && each.other == one))
      return &each;
  return nullptr;
}

std::vector<std::string> materials_in(const std::vector<MaterialContact>& contacts) {
  std::set<std::string> names;
  for (const MaterialContact& each : contacts) names.insert({each.one, each.other});
  return {names.begin(), names.end()};
}

}  // namespace gurney::equipment
