#include "studies/cli/equipment_command.h"

#include <fmt/format.h>

#include "engine/base/error.h"
#include "equipment/catalogue/at_rest.h"
#include "equipment/catalogue/catalogue.h"
#include "equipment/catalogue/check_file.h"
#include "equipment/catalogue/load_item.h"
#include "studies/cli/commands.h"
#include "studies/cli/json_errors.h"
#include "studies/cli/output.h"
#include "studies/cli/process.h"
#include "studies/cli/shared_options.h"
#include "studies/figures/equipment_figure.h"
#include "studies/report/equipment_report.h"

namespace gurney::cli {
namespace {

struct ShownItem {
  std::string item, floor, brakes;
  FigureFile figure;
  std::vector<std::string> variants;
  bool json = false, assumptions = false;
};

equipment::ItemOptions item_options(const ShownItem& options,
                                    const equipment::ItemDescription& item) {
  equipment::ItemOptions result;
  if (!options.floor.empty())
    result.floor =
        equipment::load_floor_covering(find_data(equipment::DataKind::kFloor, options.floor, ""))
            .stated();
  require(options.brakes.empty() || !item.casters.empty(),
          "--brakes: " + item.name + " has no casters");
  if (!options.brakes.empty())
    for (const equipment::CasterPlace& place : item.casters)
      result.brakes.push_back(options.brakes == "on" && place.type.brake_torque > 0);
  return result;
}

int show(const ShownItem& options) {
  options.figure.check();
  const std::string file = data_file(equipment::DataKind::kItem, options.item);
  const equipment::ItemDescription item =
      equipment::load_item_description(file, options.variants).stated();
  const equipment::LoadedItem loaded = at_rest(assemble_item(item, item_options(options, item)));
  const report::EquipmentFacts facts = report::equipment_facts(item, loaded);
  options.figure.write([&] { return figures::equipment_figure(facts); }, true);
  print_findings(report::equipment_findings(facts, options.assumptions), options.json);
  return 0;
}

struct EquipmentFiles {
  std::vector<std::string> files;
  bool json = false;
};

int list(const bool& json) {
  print_findings(report::equipment_list(), json);
  return 0;
}

int check(const EquipmentFiles& options) { return check_equipment(options.files, options.json); }

}  // namespace

void add_equipment(Commands& commands) {
  Commands equipment =
      commands.below({"equipment", "List, inspect and validate equipment", "gurney equipment ls"});
  equipment.add<bool>(
      {"ls", "List items, casters, floor coverings, rooms and tethers",
       "gurney equipment ls\ngurney equipment ls --json"},
      list, [](Options& add, bool& json) { add("--json", json, "Print JSON, in SI units"); });
  equipment.add<ShownItem>(
      {"show", "Mass, inertia, support, tilt, wheel loads and resistance of an item",
       "gurney equipment show icu_bed --brakes on --figure bed.svg"},
      show, [](Options& add, ShownItem& options) {
        add.required("ITEM", options.item, "A name of the catalogue, or a .toml file");
        add("--variant", options.variants, "A variant of the item; several in order");
        add("--covering", options.floor, "A floor covering (default: smooth vinyl)");
        add("--floor", options.floor, "The earlier name of --covering")->group("");
        add("--brakes", options.brakes,
            "on: all brakes applied, off: none (default: as in the file)")
            ->check(Options::one_of({"on", "off"}));
        add("--assumptions", options.assumptions, "List every parameter in use without a source");
        add_figure_option(add, options.figure, "A figure to write: plan and two sides");
        add("--json", options.json, "Print JSON, in SI units");
      });
  equipment.add<EquipmentFiles>(
      {"check", "Validate files of items, casters, floor coverings, rooms and tethers",
       "gurney equipment check my_cart.toml my_caster.toml"},
      check, [](Options& add, EquipmentFiles& options) {
        add.required("FILE", options.files, "Files (docs/formats/equipment_file.md)");
        add("--json", options.json, "Print JSON");
      });
}

int check_equipment(const std::vector<std::string>& files, bool json) {
  int code = 0;
  findings::Section all;
  for (const std::string& file : files) {
    findings::Section of("files[]");
    of.json("file", file);
    try {
      const equipment::CheckedFile checked = equipment::check_data_file(file);
      const char* const noun = equipment::noun_of(checked.kind);
      of.json("kind", noun).json("name", checked.name).json("warnings", checked.warnings);
      if (!json) fmt::print("{}: {} '{}' is valid\n", file, noun, checked.name);
      for (const std::string& warning : checked.warnings)
        if (!json) fmt::print("  warning: {}\n", warning);
    } catch (const Error& error) {
      code = 1;
      add_errors(of, error.what());
      if (!json) print_error("{}\n", error.what());
    }
    all.add(std::move(of));
  }
  if (json) print_findings(all, true);
  return code;
}

}  // namespace gurney::cli
