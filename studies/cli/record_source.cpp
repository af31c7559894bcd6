#include "studies/cli/record_source.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <optional>

#include "engine/base/error.h"
#include "engine/base/printable.h"
#include "engine/config/document.h"
#include "engine/config/table.h"
#include "groundmotions/measures/response_spectrum.h"
#include "groundmotions/processing/pipeline.h"
#include "groundmotions/record/acceleration_unit.h"
#include "studies/cli/inline_table.h"
#include "studies/cli/process.h"
#include "studies/report/record_report.h"

namespace gurney::cli {
namespace {

std::vector<groundmotions::ProcessingStep> steps_of(const RecordSource& source) {
  std::vector<groundmotions::ProcessingStep> steps;
  for (const std::string& text : source.steps)
    steps.push_back(read_option("--step", text, "processing[0]", "step", [](config::Table& root) {
                      return groundmotions::read_processing_steps(root);
                    }).at(0));
  return steps;
}

/// One line on stderr that is written over; nothing unless it is a terminal.
class ProgressLine {
 public:
  ~ProgressLine() { clear(); }
  void show(const std::string& what, std::size_t done, std::size_t all) {
    if (!isatty(2) || all < 2) return;
    write_error(fmt::format("\r\x1b[K{} {} of {}", printable(what), done + 1, all));
    shown_ = true;
  }
  void clear() {
    if (shown_) write_error("\r\x1b[K");
    shown_ = false;
  }

 private:
  bool shown_ = false;
};

}  // namespace

void add_source_options(Options& add, RecordSource& source) {
  add.required("PATH", source.paths,
               "Record files, folders, patterns (\"recs/*.AT2\"), lists of records, PEER "
               "_SearchResults.csv");
  add("--unit UNIT", source.options.unit,
      fmt::format("Unit of files that do not state it: {}", groundmotions::kAccelerationUnits));
  add("--time-step", source.options.time_step, "Time step of files that do not state it [s]");
  add("--count", source.options.si_per_count,
      "Acceleration of one count in files of raw counts [m/s2]");
  add("--columns", source.options.columns,
      "Columns of plain tables: samples, or names from time, h1, h2, vertical, skip");
  add.single(
      "--step STEP", source.steps,
      "A processing step, such as --step \"high_pass corner_hz=0.1\"; repeatable, applied in "
      "their order (docs/formats/processing.md)");
}

void ShortPeriods::take(const groundmotions::Record& record) {
  ++records_;
  if (groundmotions::short_period_warning(record.time_step(), shortest_).empty()) return;
  ++coarse_;
  time_step_ = std::max(time_step_, record.time_step());
}

std::string ShortPeriods::warning() const {
  if (coarse_ == 0) return {};
  const std::string what = groundmotions::short_period_warning(time_step_, shortest_);
  return records_ == 1 ? what : fmt::format("{} of {} records: {}", coarse_, records_, what);
}

int for_each_record(const RecordSource& source, std::vector<groundmotions::Refusal>* refused,
                    const std::function<void(const groundmotions::SuiteRecord&,
                                             const groundmotions::Record&)>& use) {
  const auto steps = steps_of(source);
  ProgressLine progress;
  const std::vector<std::filesystem::path> paths(source.paths.begin(), source.paths.end());
  const groundmotions::Suite suite = groundmotions::read_suite(
      paths, source.options,
      [&](std::size_t done, std::size_t all) { progress.show("reading file", done, all); });
  std::vector<groundmotions::Refusal> left_out = suite.refused;
  std::size_t used = 0;
  bool named = false;
  const auto is_named = [&](const std::string& file) {
    return std::ranges::find(source.paths, file) != source.paths.end();
  };
  for (std::size_t i = 0; i < suite.records.size(); ++i) {
    const groundmotions::SuiteRecord& entry = suite.records[i];
    progress.show("record", i, suite.records.size());
    std::optional<groundmotions::Record> record;
    try {
      record = groundmotions::processed(groundmotions::read_record(entry), steps);
    } catch (const Error& error) {
      left_out.push_back({entry.name, error.what()});
      for (const groundmotions::RecordFile& file : entry.files)
        named = named || is_named(file.path.string());
      continue;
    }
    progress.clear();
    if (source.tells_findings)
      for (const std::string& finding : report::record_findings(*record))
        print_error("warning: {}: {}\n", record->name, finding);
    use(entry, *record);
    ++used;
  }
  progress.clear();
  for (const groundmotions::Refusal& refusal : left_out)
    print_error("{}\n", groundmotions::text_of(refusal));
  for (const std::string& note : suite.notes) print_error("note: {}\n", note);
  for (const std::string& warning : suite.warnings) print_error("warning: {}\n", warning);
  for (const groundmotions::Refusal& refusal : suite.refused)
    named = named || is_named(refusal.file);
  if (refused) *refused = std::move(left_out);
  return used == 0 || named ? 1 : 0;
}

}  // namespace gurney::cli
