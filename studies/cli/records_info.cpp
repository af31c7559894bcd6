#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <memory>

#include "engine/base/printable.h"
#include "studies/cli/commands.h"
#include "studies/cli/print.h"
#include "studies/cli/record_source.h"
#include "studies/report/record_report.h"
#include "studies/report/record_table.h"

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

int print_json(const InfoOptions& options) {
  const auto measures = measures_of(options);
  findings::Section known;
  known.json("records", findings::Texts{});
  std::vector<groundmotions::Refusal> refused;
  const int code = for_each_record(
      options.source, &refused,
      [&](const groundmotions::SuiteRecord& entry, const groundmotions::Record& record) {
        findings::Section of = report::record_report(record, entry.facts, measures);
        of.key = "records[]";
        known.add(std::move(of));
      });
  findings::Table left_out{"refused", "", {{"file", ""}, {"reason", ""}}};
  for (const groundmotions::Refusal& each : refused) left_out.add({each.file, each.reason});
  print_findings(known.add(std::move(left_out)), true);
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
  const std::size_t width = report::table_width();
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

CLI::App* add(CLI::App& records, const char* name, const char* description,
              int (*command)(const InfoOptions&), std::function<int()>& action,
              const std::shared_ptr<InfoOptions>& options) {
  options->source.tells_findings = false;
  CLI::App* const app = records.add_subcommand(name, description);
  add_source_options(*app, options->source);
  app->add_flag("--json", options->json, "Print JSON, in SI units");
  app->callback([options, command, &action] { action = [=] { return command(*options); }; });
  return app;
}

}  // namespace

void add_records_info(CLI::App& records, std::function<int()>& action) {
  auto info_options = std::make_shared<InfoOptions>();
  add(records, "info", "Everything about records: headers, intensity measures, warnings", info,
      action, info_options)
      ->add_option("--measure", info_options->measures,
                   "Intensity measures instead of the common ones, such as PGV or \"Sa(0.3)\"; "
                   "repeatable");
  add(records, "ls", "A table with one line for each record", list, action,
      std::make_shared<InfoOptions>());
}

}  // namespace gurney::cli
