#include <fmt/format.h>

#include <filesystem>
#include <map>
#include <optional>
#include <string>

#include "engine/base/error.h"
#include "engine/base/printable.h"
#include "equipment/catalogue/load_item.h"
#include "studies/analysis/overview.h"
#include "studies/calibration/pulling/trial_job.h"
#include "studies/cli/commands.h"
#include "studies/cli/output.h"
#include "studies/cli/process.h"
#include "studies/cli/shared_options.h"
#include "studies/exports/export.h"
#include "studies/exports/item_bodies.h"
#include "studies/playback/gltf.h"
#include "studies/results/output_files.h"

namespace gurney::cli {
namespace {

namespace fs = std::filesystem;

struct ExportOptions {
  std::string file, format, folder, method, consequences;
  std::vector<std::string> variants;
  std::optional<std::uint64_t> noise;
  study::ExportChoice choice;
  study::AssessmentRequest assessed_by;
  study::UnitSystem units;
  bool overwrite = false;
};

/// Formats of items, not of results.
bool is_of_item(const std::string& format) { return format == "mjcf" || format == "urdf"; }

/// Formats whose FILE is not a results file.
bool is_of_input(const std::string& format) { return is_of_item(format) || format == "job"; }

/// The format that a program reads, where its name stands instead. @return empty: no such program
std::string format_for(const std::string& program) {
  static const std::map<std::string, const char*> kFormats = {
      {"openquake", "nrml"}, {"simcenter", "pelicun"}, {"paraview", "xdmf"},
      {"blender", "gltf"},   {"mujoco", "mjcf"},       {"ros", "urdf"}};
  const auto found = kFormats.find(program);
  return found == kFormats.end()
             ? std::string()
             : fmt::format("{}: the format for it is {}", program, found->second);
}

void check_choice(const ExportOptions& options) {
  const bool fits = options.format == "pelicun" || options.format == "nrml";
  const auto refuse = [&](const char* option, const std::string& value, bool allowed) {
    require_usage(value.empty() || allowed,
                  fmt::format("{} cannot be combined with --to {}, which exports everything",
                              option, options.format));
  };
  refuse("--measure", options.choice.measure, fits);
  refuse("--limit", options.choice.limit, fits);
  refuse("--limit-states", options.assessed_by.limit_states_file, fits);
  if (!options.assessed_by.limit_states.empty())
    refuse("--limit-state", options.assessed_by.limit_states.front(), fits);
  if (!options.choice.configurations.empty())
    refuse("--configuration", options.choice.configurations.front(),
           options.format != "csv" && options.format != "trials" && options.format != "xdmf" &&
               options.format != "gltf" && !is_of_input(options.format));
  require_usage(!options.noise || options.format == "trials", "--noise is for --to trials");
  require_usage(!options.choice.separate || fits, "--separate is for --to pelicun and --to nrml");
  require_usage(options.method.empty() || fits, "--method is for --to pelicun and --to nrml");
  require_usage(options.consequences.empty() || options.format == "pelicun",
                "--consequences is for --to pelicun");
  require_usage(!options.choice.discrete || options.format == "nrml",
                "--discrete is for --to nrml");
  require_usage(
      !options.units.chosen() || options.format == "csv",
      fmt::format("--units is for --to csv; --to {} has the units of its format", options.format));
  require_usage(options.variants.empty() || is_of_item(options.format),
                "--variant is for items: --to mjcf and --to urdf");
}

void write_item(const ExportOptions& options, const study::TakeFile& take) {
  const equipment::LoadedItem loaded = equipment::load_item(
      data_file(equipment::DataKind::kItem, options.file), {}, options.variants);
  std::vector<study::PartBody> parts;
  for (const equipment::LoadedPart& part : loaded.parts) {
    parts.push_back(
        {part.model.name, part.joint, chassis_with_payloads(part.model), part.model.shape});
    for (const Caster& caster : part.model.casters)
      parts.back().casters.push_back({{}, {}, caster, {}, {}});
  }
  for (const equipment::LoadedContent& content : loaded.contents)
    parts.push_back({content.model.name,
                     {},
                     chassis_with_payloads(content.model),
                     content.model.shape,
                     content.pairs.front().constants.friction,
                     content.pairs.front().constants.rolling_resistance,
                     content.yaw,
                     content.position});
  const study::ItemBodies item = study::item_bodies(loaded.model, std::move(parts));
  const std::string name = study::plain_identifier(fs::path(options.file).stem().string(), "item");
  if (options.format == "mjcf")
    take(name + ".xml", mjcf_text(item));
  else
    take(name + ".urdf", urdf_text(item));
}

std::vector<std::string> write(const ExportOptions& options, const study::TakeFile& take) {
  if (is_of_item(options.format)) {
    write_item(options, take);
    return {};
  }
  if (options.format == "job") return calibration::export_trial_job(options.file, take);
  if (options.format == "csv") {
    study::export_tables(options.file, take, options.units);
    return {};
  }
  if (options.format == "xdmf") {
    study::export_xdmf(
        options.file, study::plain_identifier(fs::path(options.file).stem().string(), "run"), take);
    return {};
  }
  if (options.format == "gltf") {
    const std::string name = study::plain_identifier(fs::path(options.file).stem().string(), "run");
    take(name + ".gltf", playback::gltf(playback::read_recorded_run(options.file)));
    return {};
  }
  require(study::is_study_file(options.file),
          fmt::format("{}: is the file of one run; --to {} needs that of a study", options.file,
                      options.format));
  if (options.format == "trials") {
    calibration::export_trials(options.file, options.noise, take);
    return {};
  }
  const study::StudyData data(options.file, options.assessed_by);
  study::ExportChoice choice = options.choice;
  choice.method = curve_method(options.method);
  std::optional<study::Consequences> consequences;
  if (!options.consequences.empty())
    choice.consequences = &consequences.emplace(study::Consequences::read(options.consequences));
  if (options.format == "pelicun") return study::export_pelicun(data, choice, take);
  if (options.format == "nrml") return study::export_nrml(data, choice, take);
  study::export_responses(data, choice, take);
  return {};
}

int export_command(const ExportOptions& options) {
  check_choice(options);
  if (!is_of_input(options.format)) study::is_study_file(options.file);
  const fs::path file = options.file;
  const fs::path folder = options.folder.empty()
                              ? file.parent_path() / (file.stem().string() + "_" + options.format)
                              : fs::path(options.folder);
  const NewFolder created(folder);
  study::OutputFiles files(options.overwrite);
  std::string written;
  const std::vector<std::string> left_out =
      write(options, [&](const std::string& name, std::string_view bytes) {
        const std::string path = (folder / name).string();
        files.check(path);
        files.stage(path, bytes);
        written += "wrote    " + path + "\n";
      });
  files.commit();
  fmt::print("{}", printable(written));
  for (const std::string& each : left_out) print_error("omitted {}\n", each);
  return 0;
}

}  // namespace

void add_export(Commands& commands) {
  commands.add<ExportOptions>(
      {"export", "Export results and items to the formats of other programs",
       "gurney export ventilator.h5 --to csv\n"
       "gurney export icu_ventilator --to mjcf\n"
       "gurney export ventilator.h5 --to pelicun -o pelicun"},
      export_command, [](Options& add, ExportOptions& options) {
        add.required(
            "FILE", options.file,
            "The results file; for mjcf and urdf an item: its name or .toml file; for job a "
            "file or folder of trials");
        add.required(
               "--to FORMAT", options.format,
               "csv: every table; pelicun: fragility for the Damage and Loss Model Library; "
               "nrml: fragility for OpenQuake; response-csv: demands run by run; trials: pulling "
               "tests as files of trials, marked synthetic; xdmf: one run's moving shapes for "
               "ParaView; "
               "gltf: the same, animated, for Blender and others; mjcf, urdf: an item for MuJoCo, "
               "for "
               "ROS and others; job: measured pulls as a job under their measured force")
            ->check(format_for)
            ->check(Options::one_of({"csv", "pelicun", "nrml", "response-csv", "trials", "xdmf",
                                     "gltf", "mjcf", "urdf", "job"}));
        add("-o,--output FOLDER", options.folder,
            "Folder for the files (default: FILE_FORMAT beside FILE)");
        add.single("--configuration,--configurations", options.choice.configurations,
                   "These configurations only, a list apart by commas (default: all)");
        add("--measure MEASURE", options.choice.measure,
            "Intensity measure of the curves (default: the study's own)");
        add_limit_state_options(add, options.assessed_by);
        add("--limit", options.choice.limit, "This limit state only (default: all)");
        add_units_option(add, options.units, "SI; of csv alone");
        add("--separate", options.choice.separate,
            "pelicun, nrml: a component for each limit state; by default those of one "
            "quantity are the ordered damage states of one component");
        add_method_option(add, options.method);
        add("--consequences FILE", options.consequences,
            "pelicun: write consequence_repair.csv too, with costs and times of this file");
        add("--discrete", options.choice.discrete,
            "nrml: probabilities at 100 intensities, not parameters");
        add("--variant", options.variants, "mjcf, urdf: a variant of the item; several in order");
        add("--noise", options.noise,
            "trials: add synthetic noise of the instruments, of this seed");
        add("--overwrite", options.overwrite, "Replace files that exist");
      });
}

}  // namespace gurney::cli
