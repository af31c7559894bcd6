#include "studies/cli/equipment_check.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "engine/base/error.h"
#include "engine/base/printable.h"
#include "equipment/catalogue/check_file.h"
#include "studies/cli/json_errors.h"
#include "studies/cli/standard_error.h"

namespace gurney::cli {
namespace {

const char* noun(equipment::DataKind kind) {
  switch (kind) {
    case equipment::DataKind::kItem:
      return "item";
    case equipment::DataKind::kCaster:
      return "caster";
    case equipment::DataKind::kFloor:
      return "floor covering";
    case equipment::DataKind::kRoom:
      return "room";
    case equipment::DataKind::kTether:
      return "kind of tether";
    case equipment::DataKind::kBuilding:
      break;
  }
  return "building";
}

}  // namespace

int check_equipment(const std::vector<std::string>& files, bool json) {
  int code = 0;
  nlohmann::ordered_json results = nlohmann::ordered_json::array();
  for (const std::string& file : files) {
    try {
      const equipment::CheckedFile checked = equipment::check_data_file(file);
      results.push_back({{"file", file},
                         {"kind", noun(checked.kind)},
                         {"name", checked.name},
                         {"warnings", checked.warnings}});
      if (json) continue;
      fmt::print("{}: {} '{}' is valid\n", file, noun(checked.kind), checked.name);
      for (const std::string& warning : checked.warnings) fmt::print("  warning: {}\n", warning);
    } catch (const Error& error) {
      code = 1;
      results.push_back({{"file", file}, {"errors", json_errors(error.what())}});
      if (!json) print_error("{}\n", error.what());
    }
  }
  if (json) fmt::print("{}\n", nlohmann::ordered_json{{"files", results}}.dump(2));
  return code;
}

}  // namespace gurney::cli
