#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>

#include "engine/base/error.h"
#include "engine/base/toml_string.h"
#include "engine/base/units.h"
#include "engine/config/document.h"
#include "engine/run/run.h"
#include "engine/scene/perturbed.h"
#include "equipment/catalogue/catalogue.h"
#include "studies/explanation/explain.h"
#include "studies/explanation/what_if.h"
#include "studies/job/job.h"
#include "studies/prepare/run_job.h"
#include "studies/workbench/answers.h"
#include "studies/workbench/as_json.h"

namespace gurney::workbench {
namespace {

study::RunFacts facts_of(const std::string& text) {
  config::Document document(text, kJob);
  const study::Job job = study::read_job(document);
  return study::prepare_run(job, study::motion_of(job)).facts;
}

/// A key of a table of the job, or of an `[[item]]`, and its value as it is written.
Json key(const char* name, const std::string& value) { return {{"key", name}, {"value", value}}; }

std::string written(const Vector3& v) {
  const auto rounded = [](double x) { return std::round(1e3 * x) / 1e3 + 0.0; };  // -0 is 0
  return fmt::format("[{:g}, {:g}, {:g}]", rounded(v.x()), rounded(v.y()), rounded(v.z()));
}

std::string table_of(const Tether& tether, const std::string& item) {
  return fmt::format(
      "[[tether]]\nname = {}\nitem = {}\npoint_m = {}\nanchor_m = {}\nslack_length_m = {:.3f}\n"
      "stiffness_n_per_m = {:g}\ndamping_n_s_per_m = {:g}\nstrength_n = {:g}\n",
      toml_string(tether.name), toml_string(item), written(tether.point), written(tether.anchor),
      tether.slack_length, tether.stiffness, tether.damping, tether.strength);
}

std::optional<bool> brakes_of(const EquipmentModel& model, const EquipmentModel& before) {
  bool changed = false, all = true, any = false;
  for (std::size_t i = 0; i < model.casters.size(); ++i) {
    const double torque = model.casters[i].brake_torque;
    changed |= torque != before.casters[i].brake_torque;
    all &= torque > 0;
    any |= torque > 0;
  }
  return changed && all == any ? std::optional(all) : std::nullopt;
}

bool same_mass(const EquipmentModel& a, const EquipmentModel& b) {
  return a.chassis_center_of_mass == b.chassis_center_of_mass;
}

/// What a job has to say for a variant; null: it cannot, or the variant does not apply.
Json changes_of(const explanation::Variant& variant, const Scene& before, std::size_t subject) {
  const Scene& after = variant.scene;
  const PlacedItem &was = before.items[subject], &is = after.items[subject];
  if (!variant.reason.empty() || after.room.size() != before.room.size() ||
      after.tethers.size() < before.tethers.size() || !same_mass(is.model, was.model))
    return nullptr;
  Json keys = Json::array(), tables = Json::array();
  if (const auto brakes = brakes_of(is.model, was.model))
    keys.push_back(key("brakes", *brakes ? "true" : "false"));
  if (is.initial.yaw != was.initial.yaw)
    keys.push_back(key("yaw_deg", fmt::format("{:.6g}", is.initial.yaw / kRadiansPerDegree)));
  if (is.initial.position != was.initial.position)
    keys.push_back(key("position_m", fmt::format("[{:.3f}, {:.3f}]", is.initial.position.x(),
                                                 is.initial.position.y())));
  for (std::size_t i = before.tethers.size(); i < after.tethers.size(); ++i) {
    const bool taken = std::ranges::any_of(
        before.tethers, [&](const Tether& each) { return each.name == after.tethers[i].name; });
    if (taken) return nullptr;
    tables.push_back(table_of(after.tethers[i], is.name));
  }
  // Keys of a place on another item are in its axes.
  if ((keys.empty() && tables.empty()) || (was.on && !keys.empty())) return nullptr;
  return {{"name", variant.name}, {"item", keys}, {"append", tables}, {"floor", nullptr}};
}

void add_coverings(Json& all, const std::string& now) {
  for (const std::string& name : equipment::catalogue_names(equipment::DataKind::kFloor)) {
    config::Document file(equipment::find_data(equipment::DataKind::kFloor, name, kJob));
    const std::string title = file.root().text("name");
    if (title != now && name != now)
      all.push_back({{"name", "floor: " + title},
                     {"item", Json::array()},
                     {"append", Json::array()},
                     {"floor", toml_string(name)}});
  }
}

}  // namespace

Json straps_answer(const std::string& text, std::size_t item) {
  config::Document document(text, kJob);
  const study::Job job = study::read_job(document);
  require(item < job.scene.items.size(), "the job has no such item");
  const PlacedItem& placed = job.scene.items[item];
  const double yaw = placed.initial.yaw;
  const Vector2 ahead(std::cos(yaw), std::sin(yaw));
  Json tables = Json::array();
  for (const double side : {1.0, -1.0})
    tables.push_back(table_of(
        explanation::strap_of(job.scene, item,
                              placed.name + (side > 0 ? ": strap ahead" : ": strap behind"),
                              side * ahead),
        placed.name));
  return {{"tables", tables}};
}

Json alternatives_answer(const std::string& text) {
  const study::RunFacts facts = facts_of(text);
  const Scene& scene = facts.scene;
  const Response response =
      run_judged(scene, facts.floor,
                 explanation::finely_stored(facts.settings, facts.floor, scene.items.size()), 1)
          .response;
  const explanation::Explanation found = explanation::explain(facts, response);
  require(!found.failed, found.cause);
  const PlacedItem& item = scene.items[found.subject];
  Json all = Json::array();
  for (const explanation::Variant& each : explanation::variants_of(facts, found))
    if (Json changes = changes_of(each, scene, found.subject); !changes.is_null())
      all.push_back(std::move(changes));
  if (std::ranges::any_of(item.model.casters, [](const Caster& each) { return each.swivels; }))
    all.push_back({{"name", "casters turned by 90 deg"},
                   {"item", {key("headings_deg", "90")}},
                   {"append", Json::array()},
                   {"floor", nullptr}});
  config::Document document(text, kJob);
  auto floor = document.root().table("floor");
  add_coverings(all, floor ? floor->text("covering", "") : "");
  const bool chaotic =
      found.predictability && found.predictability->verdict == Predictability::Verdict::kChaotic;
  return {{"subject", found.subject},
          {"subject_name", item.name},
          {"chaotic", chaotic},
          {"alternatives", all}};
}

Json outcome_answer(const std::string& text, std::size_t replica) {
  study::RunFacts facts = facts_of(text);
  facts.scene = replica_of(std::move(facts.scene), replica);
  facts.settings.history_step = 0;
  const Response response = run(facts.scene, facts.floor, facts.settings);
  require(!is_failure(response.outcome), "its run failed: " + response.cause);
  Json displacements = Json::array();
  for (const ItemResponse& item : response.items)
    displacements.push_back(item.demands.peak_displacement);
  return {{"limit_states", limit_states_of(facts, response)}, {"peak_displacement", displacements}};
}

}  // namespace gurney::workbench
