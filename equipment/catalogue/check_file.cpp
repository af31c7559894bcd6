#include "equipment/catalogue/check_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "engine/base/append_all.h"
#include "engine/base/error.h"
#include "engine/config/table.h"
#include "engine/contact/body_form.h"
#include "equipment/catalogue/load_item.h"
#include "equipment/catalogue/room_description.h"
#include "equipment/catalogue/tether_type.h"

namespace gurney::equipment {
namespace {

struct FileKind {
  const char *schema, *name, *command;
};

constexpr const char* kCheck = "gurney equipment check";
constexpr std::array kKinds = {
    FileKind{"gurney-job/1", "a job", "gurney check"},
    FileKind{"gurney-item/1", "an item", kCheck},
    FileKind{"gurney-caster/1", "a caster", kCheck},
    FileKind{"gurney-floor/1", "a floor covering", kCheck},
    FileKind{"gurney-room/1", "a room", kCheck},
    FileKind{"gurney-tether/1", "a kind of tether", kCheck},
    FileKind{"gurney-building/1", "a building",
             "gurney records floor RECORD --floor roof --building"},
    FileKind{"gurney-limit-states/1", "a list of limit states",
             "gurney fragility RESULTS --limit-states"},
    FileKind{"gurney-hazard/1", "a hazard curve", "gurney fragility RESULTS --hazard"},
    FileKind{"gurney-consequences/1", "a list of consequences",
             "gurney loss RESULTS --consequences"},
    FileKind{"gurney-hospital/1", "a hospital", "gurney hospital"}};

std::string named(const std::string& schema) {
  for (const FileKind& kind : kKinds)
    if (schema == kind.schema) return fmt::format("{} (\"{}\")", kind.name, schema);
  return "\"" + schema + "\"";
}

const FileKind* kind_of(const std::string& schema) {
  const auto kind = std::ranges::find(
      kKinds, schema, [](const FileKind& each) { return std::string(each.schema); });
  return kind == kKinds.end() ? nullptr : &*kind;
}

}  // namespace

bool holds_equipment(const std::string& file) {
  config::Document document(file);
  config::Table root = document.root();
  const FileKind* const kind = root.is_text("schema") ? kind_of(root.text("schema")) : nullptr;
  return kind != nullptr && std::string(kind->command) == kCheck;
}

void refuse_other_kind(config::Document& document, const std::string& wanted) {
  config::Table root = document.root();
  if (!root.is_text("schema")) return;
  const std::string schema = root.text("schema");
  const FileKind* const kind = kind_of(schema);
  if (kind == nullptr || schema == wanted) return;
  if (wanted.empty() && std::string(kind->command) == kCheck) return;
  throw Error(
      fmt::format("{}: schema = \"{}\": the file is {}, not {}; the command for it is: {} {}",
                  root.where("schema"), schema, kind->name,
                  wanted.empty() ? "an item, caster, floor covering, room or kind of tether "
                                   "(\"gurney-item/1\" and so on)"
                                 : named(wanted),
                  kind->command, document.path()));
}

namespace {

// Densities of what equipment is made of, as shapes full of air and as solid metal (assumptions).
constexpr double kLightest = 20, kHeaviest = 3000;  // [kg/m3]

}  // namespace

std::vector<std::string> implausible(const EquipmentModel& item) {
  std::vector<std::string> findings;
  double volume = 0;
  Vector3 low = Vector3::Constant(1e300), high = -low;
  for (const BodyShape& shape : item.shape) {
    volume += volume_of(shape);
    low = low.cwiseMin(shape.center - shape.size / 2);
    high = high.cwiseMax(shape.center + shape.size / 2);
  }
  const MassProperties chassis = chassis_with_payloads(item);
  const double density = chassis.mass / volume;
  if (!(density >= kLightest && density <= kHeaviest))
    findings.push_back(
        fmt::format("{}: {:.4g} kg in shapes of {:.4g} m3 are {:.4g} kg/m3; {:g} to {:g} is usual",
                    item.name, chassis.mass, volume, density, kLightest, kHeaviest));
  const Vector3 center = chassis.center_of_mass;
  if ((center.array() < low.array()).any() || (center.array() > high.array()).any())
    findings.push_back(
        fmt::format("{}: the centre of mass ({:.3g}, {:.3g}, {:.3g}) m lies outside the shapes",
                    item.name, center.x(), center.y(), center.z()));
  for (const Caster& caster : item.casters)
    if (caster.swivels && caster.trail == 0)
      findings.push_back(fmt::format("{}: caster '{}' swivels but has no trail to align it",
                                     item.name, caster.name));
  return findings;
}

std::vector<std::string> implausible(const CasterType& caster) {
  std::vector<std::string> findings;
  const Caster& c = caster.properties;
  if (c.tread.patch_width > c.wheel_width)
    findings.push_back(
        fmt::format("{}: the contact patch ({:g} m) is wider than the wheel ({:g} m)", caster.name,
                    c.tread.patch_width, c.wheel_width));
  if (c.wheel_axial_inertia > c.wheel_mass * c.wheel_radius * c.wheel_radius)
    findings.push_back(caster.name + ": the wheel's inertia is larger than that of a hoop");
  return findings;
}

namespace {

DataKind data_kind(const std::string& file) {
  config::Document document(file);
  refuse_other_kind(document, "");
  const std::vector<std::string> schemas = {"gurney-item/1", "gurney-caster/1", "gurney-floor/1",
                                            "gurney-room/1", "gurney-tether/1"};
  const std::size_t kind = document.root().choice("schema", schemas);
  require(document.clean(),
          fmt::format("{}:1:1: schema: must be one of \"{}\"", file, fmt::join(schemas, "\", \"")));
  return static_cast<DataKind>(kind);
}

CheckedFile check_item(const std::string& file) {
  CheckedFile result{DataKind::kItem, {}, {}};
  const auto check = [&](const std::string& variant) {
    const auto variants =
        variant.empty() ? std::vector<std::string>{} : std::vector<std::string>{variant};
    try {
      const LoadedItem item = load_item(file, {}, variants);
      if (variant.empty()) result.name = item.model.name;
      std::vector<std::string> warnings = item.warnings;
      append_all(warnings, implausible(as_rigid(item)));
      for (const LoadedContent& content : item.contents)
        append_all(warnings, implausible(content.model));
      for (std::string& warning : warnings)
        result.warnings.push_back(variant.empty() ? warning : warning + " (" + variant + ")");
    } catch (const Error& error) {
      const std::string text = error.what();
      throw Error(text.find(file) == std::string::npos ? file + ": " + text : text);
    }
  };
  check("");
  for (const std::string& variant : variant_names(file)) check(variant);
  return result;
}

}  // namespace

CheckedFile check_data_file(const std::string& file) {
  switch (data_kind(file)) {
    case DataKind::kItem:
      return check_item(file);
    case DataKind::kCaster: {
      const CasterType caster = load_caster_type(file).stated();
      return {DataKind::kCaster, caster.name, implausible(caster)};
    }
    case DataKind::kFloor:
      return {DataKind::kFloor, load_floor_covering(file).stated().name, {}};
    case DataKind::kRoom: {
      RoomNames names;
      Uncertain<RoomDescription> room;
      return {DataKind::kRoom, load_room(file, names, room), {}};
    }
    case DataKind::kTether:
    case DataKind::kBuilding:  // data_kind() refuses it: its command is another one
      break;
  }
  return {DataKind::kTether, load_tether_type(file).stated().name, {}};
}

}  // namespace gurney::equipment
