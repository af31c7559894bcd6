#include "studies/page/page.h"

#include <fmt/format.h>

#include "engine/base/error.h"
#include "studies/analysis/demands.h"
#include "studies/build_info/build_info.h"
#include "studies/page/findings_html.h"
#include "studies/page/json_findings.h"
#include "studies/page/run_page.h"
#include "studies/page/study_page.h"

namespace gurney::page {
namespace {

std::string program() {
  const build_info::BuildInfo build = build_info::build_info();
  return fmt::format("Written by gurney {}, commit {}.", build.program_version, build.git_commit);
}

std::string title_of(const study::FileOverview& file) {
  return file.title.empty() ? file.job_name : file.title;
}

Document document_of(const StudyPage& page) {
  const study::StudyOverview& overview = page.overview;
  Document document{title_of(overview.file),
                    fmt::format("A study of {}: {}, {}", counted(overview.runs, "run"),
                                counted(overview.configurations.size(), "configuration"),
                                counted(overview.file.motions.size(), "record")),
                    {},
                    program(),
                    !page.unfinished.empty()};
  if (document.again) document.subtitle += ". UNFINISHED: " + page.unfinished;
  for (const auto section : {study_summary, study_design, study_outcomes, study_fragility,
                             study_demands, study_sensitivity, study_zones, study_cases,
                             study_failures, study_time_step, study_records, study_methods})
    document.sections.push_back(section(page));
  document.sections.push_back(assumptions_section(overview.file, overview.undrawn));
  findings::Table data_files{"", "Data files, as they were read", {{"", "file"}, {"", "SHA-256"}}};
  const study::StudyReader& file = page.data.file();
  if (file.has("data_files")) {
    const auto names = file.strings("data_files/name"), hashes = file.strings("data_files/sha256");
    for (std::size_t i = 0; i < names.size(); ++i) data_files.add({names[i], hashes[i]});
  }
  document.sections.push_back(provenance_section(overview.file, file.job_text(), html(data_files)));
  return document;
}

std::vector<report::SensitivityReport> sensitivities_of(const study::StudyData& data) {
  std::vector<report::SensitivityReport> reports;
  for (std::size_t i = 0; i < data.configurations().size() && reports.size() < kMaxConfigurations;
       ++i)
    for (const study::NamedDemand& demand : study::demands_named(data, i, {"peak_displacement"})) {
      report::SensitivityReport report{data.configurations()[i], {}, "", data.units()};
      try {
        report.found =
            study::study_sensitivity({&data, i}, {.demand = demand.name, .limit = "", .level = {}});
      } catch (const Error& error) {
        report.why_not = error.what();
      }
      reports.push_back(std::move(report));
      if (reports.size() == kMaxConfigurations) break;
    }
  return reports;
}

}  // namespace

StudyPage::StudyPage(const PageRequest& request)
    : path(request.file),
      job(request.job),
      unfinished(request.unfinished),
      overview(study::study_overview(path, request.assessed_by, request.units)),
      data(path, request.assessed_by, {}, request.units),
      fragilities(study::fragilities_of(data)) {
  if (overview.draws > 0) sensitivities = sensitivities_of(data);
  try {
    scene = scene_of_study(data.file(), request.job);
  } catch (const Error& error) {
    no_scene = std::string("No drawing: ") + error.what();
  }
}

std::string results_page(const PageRequest& request) {
  if (is_json(request.file)) {
    require(request.assessed_by.empty(),
            request.file + ": is JSON; limit states and hazard are for the file of a study");
    Document document = json_document(request.file);
    document.program = program();
    return html(document);
  }
  if (study::is_study_file(request.file)) return html(document_of(StudyPage(request)));
  require(
      request.assessed_by.empty(),
      request.file + ": is the file of one run; limit states and hazard are for that of a study");
  Document document = run_document(request);
  document.program = program();
  return html(document);
}

}  // namespace gurney::page
