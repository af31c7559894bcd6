#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <optional>

#include "engine/base/error.h"
#include "engine/base/units.h"
#include "engine/config/document.h"
#include "groundmotions/formats/writers.h"
#include "studies/cli/commands.h"
#include "studies/cli/inline_table.h"
#include "studies/cli/output.h"
#include "studies/cli/process.h"
#include "studies/cli/record_source.h"
#include "studies/job/scale_reader.h"
#include "studies/results/output_files.h"

namespace gurney::cli {
namespace {

namespace fs = std::filesystem;

struct ConvertOptions {
  RecordSource source;
  std::string scale_to;  ///< empty: not scaled
  std::string output, format = "csv";
  bool overwrite = false;
};

struct Target {
  fs::path path;
  std::string text;
};

/// The name that a reader of AT2 files understands: an azimuth, UP, or the place.
std::string at2_name(const groundmotions::Component& component,
                     groundmotions::Direction direction) {
  if (direction == groundmotions::Direction::kVertical) return "UP";
  if (!component.azimuth) return direction == groundmotions::Direction::kH1 ? "H1" : "H2";
  return fmt::format("{:03.0f}", *component.azimuth / kRadiansPerDegree);
}

std::vector<Target> targets(const groundmotions::Record& record, const fs::path& stem,
                            const std::string& format) {
  if (format == "csv") return {{stem.string() + ".csv", record_csv(record)}};
  std::vector<Target> files;
  for (const groundmotions::Direction direction : groundmotions::kDirections) {
    if (!record[direction]) continue;
    groundmotions::Component component = *record[direction];
    component.name = at2_name(component, direction);
    files.push_back({fmt::format("{}_{}.AT2", stem.string(), component.name),
                     groundmotions::at2_text(component, "Converted by Gurney: " + record.name,
                                             fs::path(component.file).filename().string())});
  }
  return files;
}

/// As in a job; the measure may stand first without its key.
study::ScaleTo scale_to_of(const std::string& text) {
  try {
    std::vector<std::string> words = words_of(text);
    require(!words.empty(), "--scale-to needs a measure, such as Sa(1.0)");
    if (words[0].starts_with("measure=")) words[0].erase(0, words[0].find('=') + 1);
    config::Document document("scale_to = " + inline_table("measure", words) + "\n", "--scale-to");
    config::Table root = document.root();
    auto table = root.table("scale_to");
    const auto request = table ? study::read_scale_to(*table) : study::ScaleTo{};
    document.finish();
    return request;
  } catch (const Error& error) {
    throw Error(option_error("--scale-to", text, "scale_to", error.what()));
  }
}

int convert(const ConvertOptions& options) {
  const fs::path output = options.output;
  const bool one_file = names_a_file(output);
  require(!one_file || options.format == "csv",
          options.output + ": AT2 files hold one component each; name a folder with -o");
  require(!one_file || output.extension() == ".csv",
          options.output + ": must be a file that ends in .csv, or a folder");
  std::optional<study::ScaleTo> scale_to;
  if (!options.scale_to.empty()) scale_to = scale_to_of(options.scale_to);
  std::optional<NewFolder> folder;
  if (!one_file) folder.emplace(output);
  study::OutputFiles files(options.overwrite);
  std::vector<fs::path> written;
  const int code = for_each_record(
      options.source, nullptr,
      [&](const groundmotions::SuiteRecord&, const groundmotions::Record& read) {
        const groundmotions::Record record = scale_to ? study::scaled_to(read, *scale_to) : read;
        require(!one_file || written.empty(),
                options.output + ": one file for several records; name a folder with -o");
        fs::path stem =
            one_file ? fs::path(output).replace_extension() : output / file_name(record.name);
        for (const Target& target : targets(record, stem, options.format)) {
          require(std::ranges::find(written, target.path) == written.end(),
                  fmt::format("{}: two records have this name", target.path.string()));
          refuse_input_as_output(target.path.string(), record);
          files.check(target.path.string());
          files.stage(target.path.string(), target.text);
          written.push_back(target.path);
        }
      });
  const SignalsHeld until_written;
  files.commit();
  for (const fs::path& path : written) fmt::print("{}\n", path.string());
  return code;
}

}  // namespace

void add_records_convert(Commands& commands) {
  commands.add<ConvertOptions>(
      {"convert", "Write records as Gurney's CSV or as AT2, processed on the way",
       "gurney records convert groundmotions/records/synthetic_3c.csv -o filtered.csv \\\n"
       "  --step \"band_pass corners_hz=[0.1,25]\""},
      convert, [](Options& add, ConvertOptions& options) {
        add_source_options(add, options.source);
        add.required("-o,--output FILE", options.output, "A .csv file, or a folder");
        add("--scale-to", options.scale_to,
            "Scale each record, after its steps, such as \"Sa(1.0) component=RotD50 "
            "value=0.6 unit=g vertical=kept\" (keys of scale_to in docs/formats/job_file.md)");
        add("--format FORMAT", options.format, "csv or at2 (one file for each component)")
            ->check(CLI::IsMember({"csv", "at2"}));
        add("--overwrite", options.overwrite, "Replace files that exist");
      });
}

}  // namespace gurney::cli
