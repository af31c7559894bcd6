#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <nlohmann/json.hpp>

#include "engine/base/error.h"
#include "groundmotions/synthetic/kinds.h"
#include "studies/cli/commands.h"
#include "studies/cli/records_output.h"
#include "studies/cli/standard_error.h"

namespace gurney::cli {
namespace {

struct MakeOptions {
  std::string kind, output;
  std::vector<std::string> settings;
  bool list = false, overwrite = false, json = false;
};

/// All kinds, or one with its parameters.
int list_kinds(const std::string& only) {
  bool found = only.empty();
  for (const groundmotions::SyntheticKind& kind : groundmotions::synthetic_kinds()) {
    if (!only.empty() && kind.name != only) continue;
    found = true;
    fmt::print("{:<18} {}\n", kind.name, kind.description);
    if (only.empty()) continue;
    fmt::print("{:<18} source: {}\n", "", kind.source);
    for (const groundmotions::SyntheticParameter& parameter : kind.parameters)
      fmt::print("  {:<28} {:>10g}  {}, {}\n", parameter.key, parameter.fallback, parameter.meaning,
                 parameter.range.text());
  }
  if (!found) groundmotions::synthetic_request(only, {});  // says which kinds there are
  if (only.empty()) fmt::print("\nParameters of one kind: gurney records make KIND --list\n");
  return 0;
}

int list_kinds_as_json() {
  nlohmann::ordered_json kinds = nlohmann::ordered_json::array();
  for (const groundmotions::SyntheticKind& kind : groundmotions::synthetic_kinds()) {
    nlohmann::ordered_json parameters = nlohmann::ordered_json::array();
    for (const groundmotions::SyntheticParameter& parameter : kind.parameters)
      parameters.push_back({{"key", parameter.key},
                            {"default", parameter.fallback},
                            {"meaning", parameter.meaning},
                            {"allowed", parameter.range.text()}});
    kinds.push_back({{"kind", kind.name},
                     {"description", kind.description},
                     {"source", kind.source},
                     {"parameters", parameters}});
  }
  fmt::print("{}\n", nlohmann::ordered_json{{"kinds", kinds}}.dump(2));
  return 0;
}

int make(const MakeOptions& options) {
  if (options.list) return options.json ? list_kinds_as_json() : list_kinds(options.kind);
  if (options.json) throw CLI::RequiresError("--json", "--list");
  if (options.kind.empty()) throw CLI::RequiredError("KIND (`gurney records make --list`)");
  if (options.output.empty()) throw CLI::RequiredError("-o FILE.csv");
  const groundmotions::Record record =
      groundmotions::make_record(groundmotions::synthetic_request(options.kind, options.settings));
  for (const std::string& warning : record.warnings) print_error("warning: {}\n", warning);
  write_output(options.output, record_csv(record), options.overwrite);
  return 0;
}

}  // namespace

void add_records_make(CLI::App& records, std::function<int()>& action) {
  auto options = std::make_shared<MakeOptions>();
  CLI::App* const command = records.add_subcommand(
      "make", "Generate a synthetic motion: pulses, sines, noise, AC156, stochastic ground motion");
  command->add_option("KIND", options->kind, "Kind of motion; --list shows all");
  command->add_option("KEY=VALUE", options->settings, "Parameters, such as period_s=0.5");
  command->add_option("-o,--output", options->output, "The .csv file to write");
  command->add_flag("--list", options->list, "Print the kinds, or the parameters of KIND");
  command->add_flag("--json", options->json, "With --list: all kinds and parameters as JSON");
  command->add_flag("--overwrite", options->overwrite, "Replace a file that exists");
  command->callback([options, &action] { action = [options] { return make(*options); }; });
}

}  // namespace gurney::cli
