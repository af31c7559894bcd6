#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <memory>

#include "engine/base/error.h"
#include "engine/base/files.h"
#include "engine/base/printable.h"
#include "engine/base/shell_word.h"
#include "equipment/catalogue/catalogue.h"
#include "studies/cli/commands.h"
#include "studies/cli/new_suite.h"
#include "studies/results/output_files.h"
#include "studies/templates/templates.h"

namespace gurney::cli {
namespace {

namespace fs = std::filesystem;

struct NewOptions {
  std::string kind, name, records, unit;
  templates::Wishes wishes;
};

/// A path as the new file has to name it; a name of the catalogue stays.
/// @throws Error with `option` if there is no such file or name
std::string seen_from(const fs::path& file, const std::string& option, equipment::DataKind kind,
                      const std::string& name) {
  std::string found;
  try {
    found = equipment::find_data(kind, name, "");
  } catch (const Error& error) {
    throw Error(fmt::format("{} {}: {}", option, name, error.what()));
  }
  if (name.find('/') == std::string::npos && fs::path(name).extension() != ".toml") return name;
  return fs::absolute(found).lexically_proximate(fs::absolute(file).parent_path()).string();
}

std::string next_command(const NewOptions& options, const fs::path& file) {
  const std::string path = shell_word(file.string());
  if (options.kind == "job") return "gurney run " + path;
  if (options.kind == "study") return "gurney check " + path;
  if (options.kind == "calibration") return "gurney calibrate " + path;
  return "gurney equipment check " + path;
}

void write_trials(const fs::path& folder) {
  require(!is_there(folder), folder.string() + ": exists already");
  std::error_code problem;
  fs::create_directory(folder, problem);
  require(!problem, folder.string() + ": cannot be created: " + problem.message());
  study::OutputFiles files(false);
  // Three pulls that differ as those of a laboratory do.
  int number = 1;
  for (const double resistance : {0.0194, 0.0200, 0.0206})
    files.stage((folder / fmt::format("pull_{}.csv", number++)).string(),
                templates::pull_text(resistance));
  files.commit();
}

/// @returns what it says of records; empty: nothing
std::string write_file(const NewOptions& options, const fs::path& file) {
  templates::Wishes wishes = options.wishes;
  wishes.name = file.stem().string();
  using equipment::DataKind;
  const auto look_up = [&](const std::string& option, DataKind kind, std::string& name) {
    if (!name.empty()) name = seen_from(file, option, kind, name);
  };
  look_up("--item", DataKind::kItem, wishes.item);
  look_up("--caster", DataKind::kCaster, wishes.caster);
  look_up("--room", DataKind::kRoom, wishes.room);
  require(options.records.empty() || options.kind == "study",
          "--from is for a study: gurney new study NAME --from FOLDER");
  std::string records;
  if (!options.records.empty()) records = use_records(options.records, options.unit, file, wishes);
  require(!is_there(file), file.string() + ": exists already");
  study::OutputFiles files(false);
  files.check(file.string());
  files.stage(file.string(), templates::file_text(options.kind, wishes));
  files.commit();
  return records;
}

int new_command(const NewOptions& options) {
  fs::path file = options.name;
  std::string records;
  if (options.kind == "calibration") {
    write_trials(file);
  } else {
    if (file.extension() != ".toml") file += ".toml";
    records = write_file(options, file);
  }
  if (!records.empty()) fmt::print("records  {}\n", records);
  fmt::print("written  {}\nnext     {}\n", printable(file.string()), next_command(options, file));
  return 0;
}

}  // namespace

void add_new(CLI::App& app, std::function<int()>& action) {
  auto options = std::make_shared<NewOptions>();
  CLI::App* const command =
      app.add_subcommand("new", "Write a commented file to begin with, which runs as it is");
  command->add_option("KIND", options->kind, "job, item, caster, room, study or calibration")
      ->required()
      ->check(CLI::IsMember(templates::kinds()));
  command->add_option("NAME", options->name, "NAME.toml is written; of a calibration a folder")
      ->required();
  command->add_option("--item", options->wishes.item,
                      "Of a job or study: an item of the catalogue, or its file");
  command->add_option("--room", options->wishes.room,
                      "Of a job: a room of the catalogue, or its file");
  command->add_option("--caster", options->wishes.caster,
                      "Of an item: a caster of the catalogue, or its file");
  command->add_option("--from", options->records,
                      "Of a study: a folder of records, such as a PEER download");
  command->add_option("--unit", options->unit, "Unit of records that do not state theirs");
  command->callback([options, &action] { action = [options] { return new_command(*options); }; });
}

}  // namespace gurney::cli
