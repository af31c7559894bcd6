#include <fmt/format.h>

#include <set>

#include "engine/base/units.h"
#include "engine/config/document.h"
#include "equipment/catalogue/item_sheet.h"
#include "studies/analysis/study_data.h"
#include "studies/figures/equipment_figure.h"
#include "studies/figures/scene_figure.h"
#include "studies/job/job.h"
#include "studies/page/drawing.h"
#include "studies/page/study_page.h"
#include "studies/plan/study_job.h"
#include "studies/report/equipment_report.h"

namespace gurney::page {
namespace {

/// Of the kinds of items of a scene as many as these are drawn.
constexpr std::size_t kMaxDrawn = 3;

report::EquipmentFacts facts_of(const EquipmentModel& model, const Scene& scene) {
  const ContactConstants floor = contact_constants(scene, model.material, scene.floor_material);
  return {model, equipment::item_sheet(model, floor), floor, "", {}, {}, {}};
}

}  // namespace

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
    items +=
        paragraph(fmt::format("Drawn with the catalogue of today; changed since the study: {}.",
                              fmt::join(of.changed, ", ")));
  return all + items;
}

}  // namespace gurney::page
