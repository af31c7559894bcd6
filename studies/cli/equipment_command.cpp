#include <CLI/CLI.hpp>
#include <memory>

#include "engine/base/error.h"
#include "equipment/catalogue/catalogue.h"
#include "equipment/catalogue/load_item.h"
#include "studies/cli/commands.h"
#include "studies/cli/equipment_check.h"
#include "studies/cli/figure_output.h"
#include "studies/cli/item_file.h"
#include "studies/cli/print.h"
#include "studies/figures/equipment_figure.h"
#include "studies/report/equipment_list.h"
#include "studies/report/equipment_report.h"

namespace gurney::cli {
namespace {

struct ShowOptions {
  std::string item, floor, brakes;
  FigureFile figure;
  std::vector<std::string> variants;
  bool json = false, assumptions = false, overwrite = false;
};

equipment::ItemOptions item_options(const ShowOptions& options,
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

int show(const ShowOptions& options) {
  options.figure.check(options.overwrite);
  const std::string file = item_file(options.item);
  const equipment::ItemDescription item =
      equipment::load_item_description(file, options.variants).stated();
  const equipment::LoadedItem loaded = assemble_item(item, item_options(options, item));
  const report::EquipmentFacts facts = report::equipment_facts(item, loaded);
  if (!options.figure.empty())
    options.figure.write(figures::equipment_figure(facts), options.overwrite, true);
  print_findings(report::equipment_findings(facts, options.assumptions), options.json);
  return 0;
}

struct CheckOptions {
  std::vector<std::string> files;
  bool json = false;
};

void add_list(CLI::App& equipment, std::function<int()>& action) {
  auto json = std::make_shared<bool>(false);
  CLI::App* const command =
      equipment.add_subcommand("ls", "List items, casters, floor coverings, rooms and tethers");
  command->add_flag("--json", *json, "Print JSON, in SI units");
  command->callback([json, &action] {
    action = [json] {
      print_findings(report::equipment_list(), *json);
      return 0;
    };
  });
}

void add_equipment_show(CLI::App& equipment, std::function<int()>& action) {
  auto options = std::make_shared<ShowOptions>();
  CLI::App* const command = equipment.add_subcommand(
      "show", "Mass, inertia, support, tilt, wheel loads and resistance of an item");
  command->add_option("ITEM", options->item, "A name of the catalogue, or a .toml file")
      ->required();
  command->add_option("--variant", options->variants, "A variant of the item; several in order");
  command->add_option("--covering", options->floor, "A floor covering (default: smooth vinyl)");
  command->add_option("--floor", options->floor, "The earlier name of --covering")->group("");
  command
      ->add_option("--brakes", options->brakes,
                   "on: all brakes applied, off: none (default: as in the file)")
      ->check(CLI::IsMember({"on", "off"}));
  command->add_flag("--assumptions", options->assumptions,
                    "List every parameter in use without a source");
  add_figure_option(*command, options->figure, "A figure to write: plan and two sides");
  command->add_flag("--json", options->json, "Print JSON, in SI units");
  command->add_flag("--overwrite", options->overwrite, "Replace a figure that exists");
  command->callback([options, &action] { action = [options] { return show(*options); }; });
}

void add_equipment_check(CLI::App& equipment, std::function<int()>& action) {
  auto options = std::make_shared<CheckOptions>();
  CLI::App* const command = equipment.add_subcommand(
      "check", "Validate files of items, casters, floor coverings, rooms and tethers");
  command->add_option("FILE", options->files, "Files (docs/formats/equipment_file.md)")->required();
  command->add_flag("--json", options->json, "Print JSON");
  command->callback([options, &action] {
    action = [options] { return check_equipment(options->files, options->json); };
  });
}

}  // namespace

void add_equipment(CLI::App& app, std::function<int()>& action) {
  CLI::App* const equipment =
      app.add_subcommand("equipment", "List, inspect and validate equipment");
  equipment->require_subcommand(1);
  add_list(*equipment, action);
  add_equipment_show(*equipment, action);
  add_equipment_check(*equipment, action);
}

}  // namespace gurney::cli
