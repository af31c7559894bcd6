#include "studies/page/page.h"

#include <fmt/format.h>

#include <set>

#include "engine/base/error.h"
#include "engine/base/units.h"
#include "engine/config/document.h"
#include "equipment/catalogue/item_sheet.h"
#include "studies/analysis/demands.h"
#include "studies/analysis/study_data.h"
#include "studies/build_info/build_info.h"
#include "studies/figures/equipment_figure.h"
#include "studies/figures/plan_figures.h"
#include "studies/job/job.h"
#include "studies/page/html.h"
#include "studies/page/json_page.h"
#include "studies/page/study_page.h"
#include "studies/plan/study_job.h"
#include "studies/report/equipment_report.h"
#include "studies/report/overview_report.h"

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
                             study_loss, study_demands, study_sensitivity, study_zones, study_cases,
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
       ++i) {
    if (data.runs_of(i).empty()) continue;
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
  }
  return reports;
}

/// Most kinds of items of a scene that are drawn.
constexpr std::size_t kMaxDrawn = 3;

report::EquipmentFacts facts_of(const EquipmentModel& model, const Scene& scene) {
  const ContactConstants floor = contact_constants(scene, model.material, scene.floor_material);
  return {model, equipment::item_sheet(model, floor), floor, "", {}, {}, {}};
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
  if (!request.consequences.empty()) {
    consequences = study::Consequences::read(request.consequences);
    losses = study::study_losses(data, *consequences, {});
  }
  try {
    scene = scene_of_study(data.file(), request.job);
  } catch (const Error& error) {
    no_scene = std::string("No drawing: ") + error.what();
  }
}

std::string results_page(const PageRequest& request) {
  if (is_json(request.file)) {
    require(request.assessed_by.empty() && request.consequences.empty(),
            request.file +
                ": is JSON; limit states, hazard and consequences are for the file of a study");
    Document document = json_document(request.file);
    document.program = program();
    return html(document);
  }
  if (study::is_study_file(request.file)) return html(document_of(StudyPage(request)));
  require(request.assessed_by.empty() && request.consequences.empty(),
          request.file +
              ": is the file of one run; limit states, hazard and consequences are for that of a "
              "study");
  Document document = run_document(request);
  document.program = program();
  return html(document);
}

Section assumptions_section(const study::FileOverview& file,
                            const std::optional<study::UndrawnRanges>& undrawn) {
  Html content = html(report::assumption_findings(file));
  if (!file.assumptions.empty())
    content = folded(
        fmt::format("{} without a source", counted(file.assumptions.size(), "parameter")), content);
  if (undrawn && undrawn->parameters() > 0)
    content += folded(fmt::format("{} with a range, which the study does not draw",
                                  counted(undrawn->parameters(), "parameter")),
                      html(report::undrawn_findings(undrawn)));
  return {"assumptions", "Assumptions", content};
}

Section provenance_section(const study::FileOverview& file, const std::string& job_text,
                           const Html& more) {
  return {"provenance", "Provenance",
          html(report::provenance_findings(file)) +
              paragraph("The same job with the same program on the same class of CPU gives the "
                        "same bytes.") +
              (more.empty() ? more : folded("Data files", more)) +
              folded("The job file", element("pre", job_text, {{"tabindex", "0"}}))};
}

JobScene scene_of_study(const study::StudyReader& file, const std::string& job,
                        std::size_t configuration) {
  const study::StudyJob study(file.job_text(), study::place_of_job(job, file.path()));
  const study::Job first = study.job(configuration, std::nullopt);
  JobScene scene{first.scene, first.settings};
  if (!file.has("data_files")) return scene;
  const auto now = study::data_files(study);
  const auto names = file.strings("data_files/name"), hashes = file.strings("data_files/sha256");
  for (std::size_t i = 0; i < names.size(); ++i)
    if (const auto found = now.find(names[i]); found != now.end() && found->second != hashes[i])
      scene.changed.push_back(names[i]);
  return scene;
}

JobScene scene_of_run(const study::Hdf5Reader& file, const std::string& job) {
  config::Document document(file.text_attribute("job_text"), study::place_of_job(job, file.path()));
  document.take("study");  // of a run that was replayed
  const study::Job read = study::read_job(document);
  return {read.scene, read.settings};
}

Html scene_drawings(const JobScene& of, const std::string& title, const study::UnitSystem& units) {
  const Scene& scene = of.scene;
  const study::ReportUnit mass = units.of("kg"), angle = units.of("rad");
  const bool alone =
      scene.items.size() == 1 && scene.room.empty() && scene.zones.empty() && scene.tethers.empty();
  Html all;
  if (!alone)
    all += html(Drawing{"scene", figures::scene_figure({.units = units}, title, scene),
                        "The scene before the motion, seen from above.",
                        fmt::format("{} on the floor{}{}.", counted(scene.items.size(), "item"),
                                    scene.room.empty() ? "" : ", in a room",
                                    scene.zones.empty() ? "" : ", with zones")});
  std::set<std::string> drawn;
  Html items;
  for (const PlacedItem& item : scene.items) {
    if (drawn.size() == kMaxDrawn || !drawn.insert(item.model.name).second) continue;
    const auto facts = facts_of(item.model, scene);
    items += html(
        Drawing{fmt::format("item-{}", drawn.size()), figures::equipment_figure(facts),
                item.model.name + ": plan and two sides.",
                fmt::format("Mass {:.4g} {}, {} casters, static tilt before overturning {:.3g} {}.",
                            facts.sheet.whole.mass / mass.in_si, mass.name,
                            item.model.casters.size(), facts.sheet.stability.tilt / angle.in_si,
                            angle.name == "deg" ? "degrees" : angle.name)});
  }
  if (!of.changed.empty())
    items += paragraph(fmt::format("Drawn with the present catalogue; changed since the study: {}.",
                                   fmt::join(of.changed, ", ")));
  return all + items;
}

}  // namespace gurney::page
