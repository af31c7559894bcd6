#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <string>

#include "engine/base/error.h"
#include "engine/base/files.h"
#include "engine/base/printable.h"
#include "engine/base/shell_word.h"
#include "engine/base/toml_string.h"
#include "engine/base/units.h"
#include "equipment/catalogue/catalogue.h"
#include "groundmotions/scaling/scale.h"
#include "groundmotions/suites/suite.h"
#include "studies/cli/commands.h"
#include "studies/render/wrapped.h"
#include "studies/results/output_files.h"
#include "studies/templates/templates.h"

namespace gurney::cli {
namespace {

namespace fs = std::filesystem;
using groundmotions::Direction;

using Components = std::array<bool, 3>;

/// A record that can be read.
struct Found {
  std::string name;
  std::vector<std::string> files;
  Components components = {};
  double factor = 0;  ///< that brings it to the highest level of the template
};

struct Readable {
  std::vector<Found> records;
  std::vector<std::string> refused;
};

/// The highest level of the template, as PGA of the larger horizontal.
constexpr double kHighestLevel = 1 * kStandardGravity;  // [m/s2]

double factor_of(const groundmotions::Record& record) {
  double peak = 0;
  for (const Direction direction : {Direction::kH1, Direction::kH2})
    if (record[direction])
      peak = std::max(peak, record[direction]->acceleration.cwiseAbs().maxCoeff());
  return peak > 0 ? kHighestLevel / peak : 0;
}

Readable readable(const groundmotions::Suite& suite) {
  Readable found;
  for (const groundmotions::Refusal& refusal : suite.refused)
    found.refused.push_back(text_of(refusal));
  for (const groundmotions::SuiteRecord& entry : suite.records) try {
      const groundmotions::Record record = groundmotions::read_record(entry);
      Found one{.name = entry.name, .files = {}, .components = {}, .factor = factor_of(record)};
      for (const Direction direction : groundmotions::kDirections)
        one.components[static_cast<std::size_t>(direction)] = record[direction].has_value();
      for (const groundmotions::RecordFile& file : entry.files) one.files.push_back(file.path);
      found.records.push_back(std::move(one));
    } catch (const Error& error) {
      found.refused.emplace_back(error.what());
    }
  return found;
}

std::string lacking(const Found& record, const Components& wanted) {
  std::vector<const char*> names;
  for (const Direction direction : groundmotions::kDirections) {
    const auto i = static_cast<std::size_t>(direction);
    if (wanted[i] && !record.components[i]) names.push_back(name_of(direction));
  }
  return fmt::format("{}", fmt::join(names, " and "));
}

/// All three components, or both horizontals, if more than half of the records have them; else
/// what all have.
Components components_for(const std::vector<Found>& records) {
  for (const Components& wanted : {Components{true, true, true}, Components{true, true, false}}) {
    const auto complete = std::ranges::count_if(
        records, [&](const Found& record) { return lacking(record, wanted).empty(); });
    if (2 * complete > std::ssize(records)) return wanted;
  }
  Components common = {true, true, true};
  for (const Found& record : records)
    for (std::size_t i = 0; i < 3; ++i) common[i] = common[i] && record.components[i];
  return common;
}

/// Why a record is not in the study; empty: it is.
std::string unfit(const Found& record, const Components& wanted) {
  if (const std::string missing = lacking(record, wanted); !missing.empty())
    return "it has no " + missing;
  if (record.factor > groundmotions::kDubiousFactor)
    return fmt::format("the highest level needs a factor of {:.3g}, more than {:g}", record.factor,
                       groundmotions::kDubiousFactor);
  return {};
}

/// @throws Error for a path that no TOML can have
std::string seen_from(const fs::path& file, const fs::path& path) {
  std::string seen = fs::absolute(path).lexically_normal().lexically_proximate(
      fs::absolute(file).lexically_normal().parent_path());
  require(printable(seen) == seen, seen +
                                       ": a job cannot name it; must be UTF-8 without control "
                                       "characters");
  return seen;
}

std::string comment(const std::string& text) {
  std::string lines = "# " + render::wrapped(text, 2, 2);
  for (std::size_t at = lines.find("\n  "); at != std::string::npos;
       at = lines.find("\n  ", at + 3))
    lines.replace(at, 3, "\n# ");
  return lines + "\n";
}

/// Lets a study run over the records found in a folder: the folder, or the files of it that can be
/// read. All three components are used if more than half of the records have them, else both
/// horizontals, else what all have. Records that lack one of these, or that need a factor above
/// kDubiousFactor for the highest level, are left out: their files stay as comments.
/// @param unit  of files that do not state theirs; empty: all do
/// @param file  the job that will name them
/// @returns `3 of 5 records; the file states why the others are excluded`
/// @throws Error if there are no records, with the reasons
std::string use_records(const fs::path& folder, const std::string& unit, const fs::path& file,
                        templates::Wishes& wishes) {
  groundmotions::ReadOptions options;
  options.unit = unit;
  const Readable found = readable(groundmotions::read_suite({folder}, options));
  require(!found.records.empty(), fmt::format("{}: no record can be read\n{}", folder.string(),
                                              fmt::join(found.refused, "\n")));
  const Components wanted = components_for(found.records);
  std::vector<std::string> names, left_out;
  std::string files, spare;
  for (const Found& record : found.records) {
    const std::string reason = unfit(record, wanted);
    if (reason.empty()) names.push_back(record.name);
    if (!reason.empty()) left_out.push_back(record.name + ": " + reason);
    for (const std::string& each : record.files)
      (reason.empty() ? files : spare) +=
          fmt::format("  {}{},\n", reason.empty() ? "" : "# ", toml_string(seen_from(file, each)));
  }
  require(
      !names.empty(),
      fmt::format("{}: no record is fit for the study, whose levels reach {:g} g\n{}\nfor weak "
                  "records: gurney new study NAME, then name them in its suite and lower its "
                  "levels",
                  folder.string(), kHighestLevel / kStandardGravity, fmt::join(left_out, "\n")));
  std::string text = comment(fmt::format("{} records: {}", names.size(), fmt::join(names, ", ")));
  for (const std::string& reason : found.refused) text += comment("excluded: " + reason);
  for (const std::string& reason : left_out) text += comment("excluded: " + reason);
  if (found.refused.empty() && left_out.empty())
    text += fmt::format("suite = {}\n", toml_string(seen_from(file, folder)));
  else
    text += "suite = [\n" + files + spare + "]\n";
  if (!unit.empty()) text += fmt::format("unit = {}\n", toml_string(unit));
  const auto [x, y, z] = wanted;
  if (!x || !y || !z)
    text += fmt::format("use = \"{}{}{}\"  # components that every record has\n", x ? "x" : "",
                        y ? "y" : "", z ? "z" : "");
  wishes.suite = text;
  if (!x || !y) wishes.component = x ? "h1" : y ? "h2" : "vertical";
  std::string answer = fmt::format("{} records", names.size());
  if (!found.refused.empty())
    answer = fmt::format("{} of {} records; {} states why the others are excluded{}", names.size(),
                         found.records.size() + found.refused.size(), file.string(),
                         unit.empty() ? " (no unit in them: --unit g)" : "");
  for (const std::string& reason : left_out) answer += "\n         excluded: " + reason;
  for (const Found& record : found.records)
    if (const std::string missing = lacking(record, {true, true, true});
        !missing.empty() && !(x && y && z) && unfit(record, wanted).empty())
      answer += fmt::format("\n         {} has no {}", record.name, missing);
  return answer;
}

namespace fs = std::filesystem;

struct NewOptions {
  std::string kind, name, records, unit;
  std::vector<std::string> record;
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

/// Lines of [excitation.record] for the files of one record.
/// @throws Error for files that cannot be read
std::string record_lines(const std::vector<std::string>& names, const std::string& unit,
                         const fs::path& file) {
  std::vector<groundmotions::RecordFile> files;
  std::vector<std::string> paths;
  for (const std::string& name : names) {
    files.push_back({.path = name});
    paths.push_back(toml_string(seen_from(file, name)));
  }
  groundmotions::ReadOptions options;
  options.unit = unit;
  const groundmotions::Record record = groundmotions::read_record(files, options);
  std::string use, text = fmt::format("file = [{}]\n", fmt::join(paths, ", "));
  for (const Direction direction : groundmotions::kDirections)
    if (record[direction]) use += "xyz"[static_cast<std::size_t>(direction)];
  if (!unit.empty()) text += fmt::format("unit = {}\n", toml_string(unit));
  if (use.size() < 3) text += fmt::format("use = \"{}\"  # components that it has\n", use);
  return text;
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
  require(options.record.empty() || options.kind == "job",
          "--record is for a job: gurney new job NAME --record FILE...");
  if (!options.record.empty()) wishes.record = record_lines(options.record, options.unit, file);
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
  require(file.has_filename(), "NAME \"" + options.name + "\": must be the name of a file");
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

void add_new(Commands& commands) {
  commands.add<NewOptions>(
      {"new", "Write a commented file to begin with, which runs as it is",
       "gurney new job first --record H1.AT2 H2.AT2 UP.AT2\n"
       "gurney new item my_cart\n"
       "gurney new study fragility --from PEER_download --item my_cart.toml"},
      new_command, [](Options& add, NewOptions& options) {
        add.required("KIND", options.kind, "job, item, caster, room, study or calibration")
            ->check(Options::one_of(templates::kinds()));
        add.required("NAME", options.name, "NAME.toml is written; of a calibration a folder");
        add("--item", options.wishes.item,
            "Of a job or study: an item of the catalogue, or its file");
        add("--room", options.wishes.room, "Of a job: a room of the catalogue, or its file");
        add("--caster", options.wishes.caster,
            "Of an item: a caster of the catalogue, or its file");
        add("--record FILE", options.record, "Of a job: the files of one record");
        add("--from FOLDER", options.records,
            "Of a study: a folder of records, such as a PEER download");
        add("--unit UNIT", options.unit, "Unit of records that do not state theirs");
      });
}

}  // namespace gurney::cli
