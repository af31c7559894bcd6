#include "studies/explanation/json.h"

#include <nlohmann/json.hpp>

#include "engine/base/printable.h"
#include "studies/explanation/text.h"
#include "studies/report/half_cycle_json.h"
#include "studies/report/json_values.h"

namespace gurney::explanation {
namespace {

using Json = nlohmann::ordered_json;
using report::json_number;

Json time_or_null(double time) { return time < 0 ? Json(nullptr) : Json(time); }
Json text_or_null(const std::string& text) {
  return text.empty() ? Json(nullptr) : Json(printable(text));
}

Json tilt(const TiltMargin& margin) {
  if (margin.tilt <= 0) return nullptr;
  return {{"tilt_rad", margin.tilt},
          {"critical_rad", margin.critical},
          {"ratio", json_number(margin.ratio())},
          {"time_s", margin.time},
          {"direction_rad", margin.direction},
          {"time_passed_s", time_or_null(margin.time_passed)}};
}

Json grip(const GripMargin& margin) {
  return {{"demand_n", margin.demand},
          {"grip_n", margin.grip},
          {"time_s", margin.time},
          {"time_exceeded_s", time_or_null(margin.time_exceeded)},
          {"peak_demand_n", margin.peak_demand},
          {"braked", margin.braked}};
}

Json item(const ItemFacts& facts) {
  return {{"name", printable(facts.name)},
          {"finding", name_of(facts.finding)},
          {"mass_kg", facts.mass},
          {"height_of_center_of_mass_m", facts.height_of_center_of_mass},
          {"peak_displacement_m", facts.peak_displacement},
          {"time_of_peak_displacement_s", facts.time_of_peak_displacement},
          {"residual_displacement_m", facts.residual_displacement},
          {"peak_velocity_m_per_s", facts.peak_velocity},
          {"tilt", tilt(facts.tilt)},
          {"grip", grip(facts.grip)},
          {"first_caster_lifted", text_or_null(facts.first_lifted)},
          {"time_of_lift_s", time_or_null(facts.time_of_lift)},
          {"first_braked_caster_skidded", text_or_null(facts.first_skidded)},
          {"time_of_skid_s", time_or_null(facts.time_of_skid)}};
}

Json uplift(const std::optional<Uplift>& of) {
  if (!of) return nullptr;
  return {{"casters", of->casters},
          {"most_at_once", of->most},
          {"together_s", of->together},
          {"longest_of_one_s", of->longest},
          {"longest_of", printable(of->longest_of)}};
}

Json events(const Explanation& of) {
  Json list = Json::array();
  for (const Event& event : of.events)
    list.push_back({{"time_s", event.time},
                    {"kind", name_of(event.kind)},
                    {"item", text_or_null(event.item)},
                    {"part", text_or_null(event.part)},
                    {"value", json_number(event.value)},
                    {"resolution_s", event.sampled ? Json(of.resolution) : Json(nullptr)},
                    {"uplift", uplift(event.uplift)},
                    {"text", printable(words_of(event, false, of.units))}});
  return list;
}

Json energy(const std::vector<Stage>& stages) {
  Json list = Json::array();
  for (const Stage& s : stages)
    list.push_back({{"stage", s.name},
                    {"time_s", s.time},
                    {"kinetic_j", s.kinetic},
                    {"potential_j", s.potential},
                    {"elastic_j", s.elastic},
                    {"work_of_floor_j", s.floor_work},
                    {"work_of_others_j", s.other_work},
                    {"friction_j", s.friction},
                    {"rolling_j", s.rolling},
                    {"impacts_j", s.impacts},
                    {"other_loss_j", s.other_loss}});
  return list;
}

Json outcome(const VariantOutcome& of) {
  if (!of.reason.empty()) return {{"name", printable(of.name)}, {"reason", printable(of.reason)}};
  return {{"name", printable(of.name)},
          {"peak_displacement_m", of.peak_displacement},
          {"tilt_ratio", json_number(of.tilt_ratio)},
          {"hardest_impact_m_per_s", of.hardest_impact},
          {"runs", of.runs},
          {"failed", of.failed},
          {"overturned", of.overturned},
          {"happened", of.happened}};
}

Json what_if_json(const WhatIf& what, const Explanation& of) {
  Json variants = Json::array();
  for (const VariantOutcome& each : what.variants) variants.push_back(outcome(each));
  return {{"replicas", what.replicas},
          {"as_it_was", outcome(what.as_it_was)},
          {"variants", variants},
          {"conclusion", printable(conclusion(what, of))}};
}

}  // namespace

std::string json(const Explanation& of, const WhatIf* what) {
  Json result{{"title", printable(of.title)},
              {"record", text_or_null(of.record)},
              {"outcome", of.outcome},
              {"cause", text_or_null(of.cause)},
              {"end_time_s", of.end_time},
              {"headline", printable(headline(of))},
              {"resolution_s", of.resolution},
              {"item", nullptr},
              {"finding", nullptr},
              {"time_s", nullptr},
              {"predictability", nullptr},
              {"events", events(of)},
              {"pulse", report::half_cycle_json(of.pulse)},
              {"items", Json::array()},
              {"energy", energy(of.stages)},
              {"what_if", nullptr}};
  if (!of.failed) {
    result["item"] = printable(of.item().name);
    result["finding"] = name_of(of.item().finding);
    result["time_s"] = of.worst_time;
  }
  if (of.predictability) result["predictability"] = name_of(of.predictability->verdict);
  for (const ItemFacts& each : of.items) result["items"].push_back(item(each));
  if (what != nullptr) result["what_if"] = what_if_json(*what, of);
  return result.dump(2) + "\n";
}

}  // namespace gurney::explanation
