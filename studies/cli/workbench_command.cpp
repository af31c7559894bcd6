#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>

#include "engine/base/error.h"
#include "engine/base/files.h"
#include "engine/base/input_file.h"
#include "engine/base/toml_string.h"
#include "engine/config/file_snapshot.h"
#include "engine/config/table.h"
#include "equipment/catalogue/catalogue.h"
#include "equipment/catalogue/check_file.h"
#include "equipment/catalogue/data_folder.h"
#include "studies/cli/commands.h"
#include "studies/cli/output.h"
#include "studies/cli/shared_options.h"
#include "studies/playback/page.h"
#include "studies/prepare/run_job.h"
#include "studies/render/script_json.h"
#include "studies/results/output_files.h"

namespace gurney::cli {
namespace {

namespace fs = std::filesystem;
using SortedJson = nlohmann::json;

struct WorkbenchOptions {
  std::string file, output;
  bool overwrite = false;
};

constexpr const char* kGiven = R"(<script type="application/json" id="given">null</script>)";

/// The page of an installation, or that of the sources.
std::string empty_page() {
  const fs::path data = equipment::data_folder();
  for (const fs::path& page : {data / "workbench.html", data / "build/workbench/workbench.html"})
    if (is_file(page)) {
      std::string text = read_input_file(page.string());
      require(text.find(kGiven) != std::string::npos,
              page.string() + ": has no place for a job; ./dev workbench makes the page again");
      return text;
    }
  throw Error(
      (data / "workbench.html").string() +
      ": the page of the workbench is not there; ./dev workbench in the folder of the sources "
      "makes it, and an installation that follows takes it along");
}

/// What the page is filled with: a job, and the file whose place its paths are seen from.
struct Content {
  std::string text, path;
  bool edit = false;   ///< its item is opened in the editor
  std::string motion;  ///< added to the job in the page, where the shipped jobs and records are
};

constexpr const char* kShippedMotion =
    "\n[excitation.record]\nfile = \"../../groundmotions/records/synthetic_3c.csv\"\n";

std::string job_with(const std::string& item, double x, double y, const std::string& room) {
  return fmt::format(
      "schema = \"gurney-job/1\"\n\n[[item]]\nequipment = {}\nposition_m = [{:g}, {:g}]\n{}",
      toml_string(item), x, y,
      room.empty() ? "" : fmt::format("\n[room]\nfile = {}\n", toml_string(room)));
}

Content with_item(const std::string& equipment, const fs::path& folder) {
  return {job_with(equipment, 0, 0, ""), (folder / "job.toml").string(), true, kShippedMotion};
}

study::Job read_content(const Content& content) {
  config::Document document(content.text, content.path);
  return study::read_job(document);
}

/// A ventilator where it stands free, as near to the origin of the room as it can.
Content with_room(const fs::path& room) {
  constexpr int kSteps = 16;
  constexpr double kStep = 0.25;  // [m]
  std::vector<Vector2> places;
  for (int x = -kSteps; x <= kSteps; ++x)
    for (int y = -kSteps; y <= kSteps; ++y) places.emplace_back(kStep * x, kStep * y);
  std::ranges::sort(places, {}, [](const Vector2& at) { return at.norm(); });
  for (const Vector2& at : places) {
    Content content{job_with("icu_ventilator", at.x(), at.y(), room.filename().string()),
                    (room.parent_path() / "job.toml").string(), false, kShippedMotion};
    try {
      read_content(content);
      return content;
    } catch (const Error&) {
      // it stands in something
    }
  }
  throw Error(fmt::format("{}: a ventilator stands nowhere free within {:g} m of its origin",
                          room.string(), kSteps * kStep));
}

Content content_of(const std::string& file) {
  const bool is_name = !fs::path(file).has_extension() && file.find('/') == std::string::npos;
  if (is_name && !is_there(file)) {
    data_file(equipment::DataKind::kItem, file);
    return with_item(file, {});
  }
  require_job(file, "workbench");
  if (!equipment::holds_equipment(file)) {
    config::Document document(file);
    require(!file.ends_with(".json"), file + ": is JSON; the page takes jobs in TOML");
    require(!document.root().has("study"),
            file +
                ": has a table [study], many runs, which gurney run makes; the page takes a job "
                "of one run");
    return {document.text(), file, false, {}};
  }
  switch (equipment::check_data_file(file).kind) {
    case equipment::DataKind::kItem:
      return with_item(fs::path(file).filename().string(), fs::path(file).parent_path());
    case equipment::DataKind::kRoom:
      return with_room(file);
    default:
      throw Error(file + ": is neither a job nor a room nor an item");
  }
}

/// The files that a job names and the page lacks, under the names by which it finds them: the page has the
/// shipped data, and reads the job as if it lay among the shipped ones.
SortedJson files_of(const Content& content) {
  config::FileSnapshot read;
  std::map<std::string, std::string> files;
  {
    const config::FileSnapshot::Scope scope(read);
    const study::Job job = read_content(content);
    files = read.files();
    if (job.record) {
      study::motion_of(*job.record);  // throws where a file is not a record
      for (const groundmotions::RecordFile& each : job.record->files)
        files[fs::absolute(each.path).lexically_normal().string()] =
            read_input_file(each.path.string());
    }
  }
  std::string texts = content.text;
  for (const auto& [path, bytes] : read.files()) texts += bytes;
  const equipment::DataFolder data = equipment::find_data_folder();
  const fs::path shipped = fs::absolute(data.path).lexically_normal();
  const fs::path folder = fs::absolute(content.path).lexically_normal().parent_path();
  const bool among_shipped = folder == shipped / "studies" / "jobs";
  SortedJson all = SortedJson::array();
  for (const auto& [path, bytes] : files) {
    std::string name = texts.find(path) == std::string::npos
                           ? fs::path(path).lexically_relative(folder).string()
                           : path;
    if (const fs::path inside = fs::path(path).lexically_relative(shipped);
        !inside.empty() && *inside.begin() != "..") {
      const bool by_name = texts.find(inside.filename().string()) == std::string::npos;
      if (by_name || among_shipped) {
        if (data.origin != equipment::DataFolder::Origin::kEnvironment) continue;
        name = ("../.." / inside).string();
      }
    }
    const auto* const start = reinterpret_cast<const std::uint8_t*>(bytes.data());
    all.push_back({name, playback::base64({start, bytes.size()})});
  }
  return all;
}

int workbench(const WorkbenchOptions& options) {
  const std::string output =
      !options.output.empty() ? options.output
      : options.file.empty()
          ? "out/workbench.html"
          : fmt::format("out/{}_workbench.html", fs::path(options.file).stem().string());
  require_usage(output.ends_with(".html"), output + ": the page must end in .html (-o FILE.html)");
  std::error_code problem;
  if (options.output.empty()) fs::create_directory("out", problem);
  require(!problem, "out: the folder cannot be created: " + problem.message());
  study::OutputFiles(options.overwrite).check(output);
  std::string page = empty_page();
  if (!options.file.empty()) {
    const Content content = content_of(options.file);
    const SortedJson given{{"text", content.text + content.motion},
                           {"files", files_of(content)},
                           {"edit", content.edit}};
    const std::string mark = kGiven;
    const std::size_t null = mark.find("null");
    page.replace(page.find(mark) + null, 4, render::script_json(given));
  }
  write_output(output, page, options.overwrite);
  return 0;
}

}  // namespace

void add_workbench(Commands& commands) {
  commands.add<WorkbenchOptions>(
      {"workbench", "Write the page that runs jobs in a browser",
       "gurney workbench -o workbench.html\n"
       "gurney workbench my_bay.toml\n"
       "gurney workbench icu_ventilator"},
      workbench, [](Options& add, WorkbenchOptions& options) {
        add("FILE", options.file,
            "A job, a room or an item to fill it with (default: a room of an ICU)");
        add("-o,--output FILE", options.output,
            "The page (.html; default: out/<name of the file>_workbench.html)");
        add("--overwrite", options.overwrite, "Replace a page that exists");
      });
}

}  // namespace gurney::cli
