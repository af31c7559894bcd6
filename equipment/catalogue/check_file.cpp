#include "equipment/catalogue/check_file.h"

#include <fmt/format.h>

#include "engine/base/error.h"
#include "engine/config/table.h"
#include "equipment/catalogue/file_kind.h"
#include "equipment/catalogue/implausible.h"
#include "equipment/catalogue/load_item.h"
#include "equipment/catalogue/room_description.h"
#include "equipment/catalogue/tether_type.h"

namespace gurney::equipment {
namespace {

DataKind kind_of(const std::string& file) {
  config::Document document(file);
  refuse_other_kind(document, "");
  const std::vector<std::string> schemas = {"gurney-item/1", "gurney-caster/1", "gurney-floor/1",
                                            "gurney-room/1", "gurney-tether/1"};
  const std::size_t kind = document.root().choice("schema", schemas);
  require(document.clean(),
          fmt::format("{}:1:1: schema: must be one of \"{}\"", file, fmt::join(schemas, "\", \"")));
  return static_cast<DataKind>(kind);
}

void append(std::vector<std::string>& list, const std::vector<std::string>& more) {
  list.insert(list.end(), more.begin(), more.end());
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
      append(warnings, implausible(item.model));
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
  switch (kind_of(file)) {
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
    case DataKind::kBuilding:  // kind_of() refuses it: its command is another one
      break;
  }
  return {DataKind::kTether, load_tether_type(file).stated().name, {}};
}

}  // namespace gurney::equipment
