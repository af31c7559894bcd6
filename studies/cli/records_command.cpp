#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <optional>

#include "engine/base/error.h"
#include "engine/base/printable.h"
#include "engine/base/units.h"
#include "engine/config/document.h"
#include "groundmotions/formats/writers.h"
#include "groundmotions/synthetic/kinds.h"
#include "studies/cli/commands.h"
#include "studies/cli/inline_table.h"
#include "studies/cli/json_errors.h"
#include "studies/cli/output.h"
#include "studies/cli/process.h"
#include "studies/cli/record_source.h"
#include "studies/cli/shared_options.h"
#include "studies/figures/record_figures.h"
#include "studies/job/scale_reader.h"
#include "studies/render/wrapped.h"
#include "studies/report/formats.h"
#include "studies/report/record_report.h"
#include "studies/results/output_files.h"

namespace gurney::cli {
namespace {

struct InfoOptions {
  RecordSource source;
  std::vector<std::string> measures;
  bool json = false;
};

std::vector<groundmotions::Measure> measures_of(const InfoOptions& options) {
  if (options.measures.empty()) return groundmotions::common_measures();
  std::vector<groundmotions::Measure> measures;
  for (const std::string& name : options.measures)
    measures.push_back(groundmotions::parse_measure(name));
  return measures;
}

/// A file that was left out, and its errors with their places.
findings::Section left_out(const groundmotions::Refusal& refusal) {
  findings::Section of("refused[]");
  of.json("file", refusal.file).json("reason", refusal.reason);
  add_errors(of, groundmotions::text_of(refusal));
  return of;
}

int print_json(const InfoOptions& options) {
  const auto measures = measures_of(options);
  findings::Section known;
  known.json("records", findings::Texts{}).json("refused", findings::Texts{});
  std::vector<groundmotions::Refusal> refused;
  const int code = for_each_record(
      options.source, &refused,
      [&](const groundmotions::SuiteRecord& entry, const groundmotions::Record& record) {
        findings::Section of = report::record_report(record, entry.facts, measures);
        of.key = "records[]";
        known.add(std::move(of));
      });
  for (const groundmotions::Refusal& each : refused) known.add(left_out(each));
  print_findings(known, true);
  return code;
}

int info(const InfoOptions& options) {
  if (options.json) return print_json(options);
  const auto measures = measures_of(options);
  bool first = true;
  return for_each_record(
      options.source, nullptr,
      [&](const groundmotions::SuiteRecord& entry, const groundmotions::Record& record) {
        fmt::print("{}{}", first ? "" : "\n",
                   render::text(report::record_report(record, entry.facts, measures)));
        first = false;
      });
}

int list(const InfoOptions& options) {
  if (options.json) return print_json(options);
  std::size_t count = 0;
  const std::size_t width = render::table_columns();
  std::vector<groundmotions::Refusal> refused;
  const int code =
      for_each_record(options.source, &refused,
                      [&](const groundmotions::SuiteRecord&, const groundmotions::Record& record) {
                        if (count++ == 0) fmt::print("{}", report::record_table_head(width));
                        fmt::print("{}", printable(report::record_table_line(record, width)));
                        std::fflush(stdout);
                      });
  fmt::print("{} record{}", count, count == 1 ? "" : "s");
  if (!refused.empty()) fmt::print(", {} skipped", refused.size());
  fmt::print("\n");
  return code;
}

void declare(Options& add, InfoOptions& options) {
  options.source.tells_findings = false;
  add_source_options(add, options.source);
  add("--json", options.json, "Print JSON, in SI units");
}

namespace fs = std::filesystem;

struct RecordPlotOptions {
  RecordSource source;
  std::string output;
  NamedFigures figures;
  bool overwrite = false;
};

/// The files of a command for its records, each under a name of its own: all complete, or none.
class FilesOfRecords {
 public:
  explicit FilesOfRecords(bool overwrite) : files_(overwrite) {}

  bool none() const { return paths_.empty(); }

  /// @throws Error for a name that another has, and as OutputFiles
  void stage(const fs::path& path, const std::string& bytes, const groundmotions::Record& of) {
    require(std::ranges::find(paths_, path) == paths_.end(),
            path.string() + ": two records have this name");
    refuse_input_as_output(path.string(), of);
    files_.check(path.string());
    files_.stage(path.string(), bytes);
    paths_.push_back(path);
  }

  void commit() {
    const SignalsHeld until_written;
    files_.commit();
    for (const fs::path& path : paths_) fmt::print("{}\n", printable(path.string()));
  }

 private:
  study::OutputFiles files_;
  std::vector<fs::path> paths_;
};

void print_warning(const std::string& warning) {
  if (!warning.empty()) print_error("warning: {}\n", warning);
}

int plot_records(const RecordPlotOptions& options) {
  const fs::path output = options.output;
  const bool one_file = names_a_file(output);
  const FigureFile file{options.figures, options.output, options.overwrite};
  if (one_file && !options.figures.format.empty())
    throw CLI::ValidationError("--figure-format",
                               "has no effect on one figure, whose format is that of its name");
  if (one_file) file.check();
  options.figures.check();
  std::optional<NewFolder> folder;
  if (!one_file) folder.emplace(output);
  FilesOfRecords files(options.overwrite);
  ShortPeriods periods(figures::kShortestPeriod);
  const int code = for_each_record(
      options.source, nullptr,
      [&](const groundmotions::SuiteRecord&, const groundmotions::Record& record) {
        require(!one_file || files.none(),
                options.output + ": one figure for several records; name a folder with -o");
        periods.take(record);
        const std::string svg = figures::record_figure(record);
        if (one_file)
          files.stage(output, file.bytes(svg), record);
        else
          files.stage(output / (file_name(record.name) + options.figures.suffix()),
                      options.figures.bytes(svg), record);
      });
  print_warning(periods.warning());
  files.commit();
  return code;
}

struct MakeOptions {
  std::string kind, output;
  std::vector<std::string> settings;
  bool list = false, overwrite = false, json = false;
};

/// All kinds, or one with its parameters.
int list_kinds(const std::string& only, bool json) {
  if (!only.empty()) groundmotions::synthetic_request(only, {});  // refuses an unknown kind
  const auto for_people = [&](const char* label) { return only.empty() ? "" : label; };
  findings::Section all;
  for (const groundmotions::SyntheticKind& kind : groundmotions::synthetic_kinds()) {
    if (!only.empty() && kind.name != only) continue;
    all.text(kind.name, kind.description);
    findings::Section of("kinds[]");
    of.json("kind", kind.name).json("description", kind.description);
    of.fact("source", for_people("source"), kind.source);
    findings::Table parameters{"parameters", "", {}};
    for (const groundmotions::SyntheticParameter& parameter : kind.parameters)
      report::add_row(parameters, {{{"key", for_people("parameter")}, parameter.key},
                                   {{"default", for_people("default"), {"g"}}, parameter.fallback},
                                   {{"meaning", for_people("meaning")}, parameter.meaning},
                                   {{"allowed", for_people("allowed")}, parameter.range.text()}});
    all.add(std::move(of.add(std::move(parameters))));
  }
  if (only.empty()) all.say("Parameters of one kind: gurney records make KIND --list");
  print_findings(all, json);
  return 0;
}

int make(const MakeOptions& options) {
  if (options.list) return list_kinds(options.kind, options.json);
  if (options.kind.empty()) throw CLI::RequiredError("KIND (`gurney records make --list`)");
  if (options.output.empty()) throw CLI::RequiredError("-o FILE.csv");
  check_csv_output(options.output, options.overwrite);
  const groundmotions::Record record =
      groundmotions::make_record(groundmotions::synthetic_request(options.kind, options.settings));
  for (const std::string& warning : record.warnings) print_error("warning: {}\n", warning);
  write_output(options.output, record_csv(record), options.overwrite);
  return 0;
}

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
  groundmotions::require_readable(record);
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
  const std::string key = "measure=";
  return read_option("--scale-to", text.starts_with(key) ? text.substr(key.size()) : text,
                     "scale_to", "measure", [](config::Table& root) {
                       auto table = root.table("scale_to");
                       return table ? study::read_scale_to(*table) : study::ScaleTo{};
                     });
}

/// Shortest period of the spectral measure [s]; 0: it is none.
double shortest_period(const groundmotions::Measure& measure) {
  const Eigen::VectorXd periods = groundmotions::spectral_periods(measure);
  return periods.size() == 0 ? 0 : periods[0];
}

int convert(const ConvertOptions& options) {
  const fs::path output = options.output;
  const bool one_file = names_a_file(output);
  require_usage(!one_file || options.format == "csv",
                options.output + ": AT2 files hold one component each; name a folder with -o");
  require_usage(!one_file || output.extension() == ".csv",
                options.output + ": must be a file that ends in .csv, or a folder");
  std::optional<study::ScaleTo> scale_to;
  if (!options.scale_to.empty()) scale_to = scale_to_of(options.scale_to);
  std::optional<NewFolder> folder;
  if (!one_file) folder.emplace(output);
  if (one_file) study::OutputFiles(options.overwrite).check(options.output);
  FilesOfRecords files(options.overwrite);
  ShortPeriods periods(scale_to ? shortest_period(scale_to->measure) : 0);
  const int code = for_each_record(
      options.source, nullptr,
      [&](const groundmotions::SuiteRecord&, const groundmotions::Record& read) {
        const groundmotions::Record record = scale_to ? study::scaled_to(read, *scale_to) : read;
        periods.take(record);
        require(!one_file || files.none(),
                options.output + ": one file for several records; name a folder with -o");
        fs::path stem =
            one_file ? fs::path(output).replace_extension() : output / file_name(record.name);
        for (const Target& target : targets(record, stem, options.format))
          files.stage(target.path, target.text, record);
      });
  print_warning(periods.warning());
  files.commit();
  return code;
}

}  // namespace

void add_records(Commands& commands) {
  Commands records =
      commands.below({"records", "Inspect, convert, generate, select and scale ground motions",
                      "gurney records ls groundmotions/records"});
  for (AddCommand* const add :
       {add_records_info, add_records_plot, add_records_convert, add_records_scale,
        add_records_select, add_records_make, add_records_floor, add_records_model})
    add(records);
}

void add_records_info(Commands& records) {
  records.add<InfoOptions>({"info", "Print peaks, durations and intensity measures of records",
                            "gurney records info groundmotions/records/synthetic_3c.csv"},
                           info, [](Options& add, InfoOptions& options) {
                             declare(add, options);
                             add.single("--measure MEASURE", options.measures,
                                        "An intensity measure instead of the common ones, such as "
                                        "PGV or \"Sa(0.3)\"; repeatable");
                           });
  records.add<InfoOptions>(
      {"ls", "List the records of files and folders",
       "gurney records ls groundmotions/records\ngurney records ls PEER_download --json"},
      list, declare);
}

void add_records_plot(Commands& commands) {
  commands.add<RecordPlotOptions>(
      {"plot", "Plot histories and response spectra of records",
       "gurney records plot groundmotions/records/synthetic_3c.csv -o record.svg"},
      plot_records, [](Options& add, RecordPlotOptions& options) {
        add_source_options(add, options.source);
        add.required("-o,--output FILE", options.output,
                     "A file (.svg, .pdf or .png), or a folder");
        add_figure_format(add, options.figures);
        add("--overwrite", options.overwrite, "Replace files that exist");
      });
}

void add_records_make(Commands& commands) {
  commands.add<MakeOptions>(
      {"make", "Generate a synthetic motion",
       "gurney records make --list\n"
       "gurney records make near_fault_pulse period_s=2 -o pulse.csv"},
      make, [](Options& add, MakeOptions& options) {
        add("KIND", options.kind, "Kind of motion; --list shows all");
        CLI::Option* const list =
            add("--list", options.list, "Print the kinds, or the parameters of KIND");
        add("KEY=VALUE", options.settings, "Parameters, such as period_s=0.5")->excludes(list);
        add("-o,--output FILE", options.output, "The .csv file to write")->excludes(list);
        add("--json", options.json, "With --list: kinds and parameters as JSON")->needs(list);
        add("--overwrite", options.overwrite, "Replace a file that exists")->excludes(list);
      });
}

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
            ->check(Options::one_of({"csv", "at2"}));
        add("--overwrite", options.overwrite, "Replace files that exist");
      });
}

}  // namespace gurney::cli
