#include <cmath>
#include <nlohmann/json.hpp>

#include "engine/response/settled.h"
#include "studies/build_info/build_info.h"
#include "studies/report/fall.h"
#include "studies/report/half_cycle_json.h"
#include "studies/report/narrative.h"
#include "studies/report/summary.h"
#include "studies/results/columns.h"
#include "studies/results/names.h"

namespace gurney::report {
namespace {

using Json = nlohmann::ordered_json;

template <class Row>
Json object(std::span<const study::TableColumn<Row>> columns, const Row& row) {
  Json result = Json::object();
  for (const study::TableColumn<Row>& column : columns) {
    const double value = column.value(row);
    if (column.is_missing(value)) {
      result[column.name] = nullptr;
    } else if (column.whole()) {
      result[column.name] = static_cast<std::int64_t>(value);
    } else {
      result[column.name] = value;
    }
  }
  return result;
}

template <class Row, class Named>
Json named_objects(std::span<const study::TableColumn<Row>> columns, const std::vector<Row>& rows,
                   const std::vector<Named>& named) {
  Json result = Json::array();
  for (std::size_t i = 0; i < rows.size(); ++i) {
    Json entry{{"name", named.at(i).name}};
    entry.update(object(columns, rows[i]));
    result.push_back(entry);
  }
  return result;
}

Json vector(const Vector3& value) { return {value.x(), value.y(), value.z()}; }

Json predictability(const std::optional<Predictability>& of_item) {
  if (!of_item) return nullptr;
  Json result = object(study::predictability_columns(), *of_item);
  result["verdict"] = name_of(of_item->verdict);
  return result;
}

Json settled(const SettledDemand& demand) {
  const auto finite = [](double value) {
    return std::isfinite(value) ? Json(value) : Json(nullptr);
  };
  return {{"settled_to", finite(demand.within())},
          {"step_change", finite(demand.step_change)},
          {"twin_change", finite(demand.twin_change)}};
}

/// The labels of the demands, shaped as these.
Json settled(const EquipmentModel& model, const ItemResponse& item) {
  const std::vector<SettledDemand> all = settled_demands(item);
  if (all.empty()) return nullptr;
  Json demands = Json::object(), wheels = Json::array(), points = Json::array();
  for (const Caster& each : model.casters) wheels.push_back({{"name", each.name}});
  for (const MarkedPoint& each : model.marked_points) points.push_back({{"name", each.name}});
  for (const SettledDemand& each : all) {
    using Of = DemandNumber::Of;
    const DemandNumber& number = each.number;
    Json& of = number.of == Of::kItem    ? demands
               : number.of == Of::kWheel ? wheels.at(number.part)
                                         : points.at(number.part);
    of[number.name] = settled(each);
  }
  return {{"demands", demands}, {"wheels", wheels}, {"points", points}};
}

Json items(const study::RunFacts& facts, const Response& response) {
  const std::vector<std::string> names = study::item_names(facts.scene);
  Json result = Json::array();
  for (std::size_t i = 0; i < response.items.size(); ++i) {
    const ItemResponse& item = response.items[i];
    const EquipmentModel& model = facts.scene.items.at(i).model;
    result.push_back({{"name", names.at(i)},
                      {"model", model.name},
                      {"demands", object(study::demand_columns(), item.demands)},
                      {"wheels", named_objects(study::wheel_demand_columns(), item.demands.wheels,
                                               model.casters)},
                      {"points", named_objects(study::point_demand_columns(), item.demands.points,
                                               model.marked_points)},
                      {"energy", object(study::energy_columns(), item.energy)},
                      {"predictability", predictability(item.predictability)},
                      {"settled", settled(model, item)}});
  }
  return result;
}

Json impacts(const study::RunFacts& facts, const Response& response) {
  const std::vector<std::string> names = study::item_names(facts.scene);
  Json result = Json::array();
  for (const Impact& impact : response.impacts) {
    Json entry{{"item", names.at(impact.item)},
               {"body", impact.body},
               {"other", impact.other},
               {"other_body", impact.other_body}};
    entry.update(object(study::impact_columns(), impact));
    result.push_back(entry);
  }
  return result;
}

Json overturnings_of(const study::RunFacts& facts, const Response& response) {
  const std::vector<std::string> names = study::item_names(facts.scene);
  Json result = Json::array();
  for (const Fall& fall : falls(facts, response)) {
    Json liftoffs = Json::array();
    for (const Fall::Liftoff& each : fall.liftoffs)
      liftoffs.push_back({{"wheel", each.wheel}, {"time_s", each.time}});
    result.push_back({{"item", names.at(fall.item)},
                      {"time_s", fall.time},
                      {"direction_rad", fall.direction},
                      {"liftoffs", liftoffs},
                      {"floor_pulse", half_cycle_json(fall.half_cycle)}});
  }
  return result;
}

Json record(const study::RecordFacts& facts) {
  Json files = Json::array();
  for (const study::FileFacts& file : facts.files)
    files.push_back({{"name", file.name}, {"sha256", file.sha256}});
  return {{"name", facts.name},
          {"files", files},
          {"components", facts.components},
          {"processing", facts.processing},
          {"duration_s", facts.duration},
          {"time_step_s", facts.time_step},
          {"pga_m_per_s2", vector(facts.pga)},
          {"pgv_m_per_s", vector(facts.pgv)},
          {"pgd_m", vector(facts.pgd)},
          {"residual_velocity_m_per_s", vector(facts.residual_velocity)},
          {"residual_displacement_m", vector(facts.residual_displacement)}};
}

Json assumptions(const std::vector<study::AssumptionFacts>& facts) {
  Json result = Json::array();
  for (const study::AssumptionFacts& a : facts)
    result.push_back({{"key", a.key},
                      {"value", a.value},
                      {"range", a.range},
                      {"reason", a.reason},
                      {"file", a.file}});
  return result;
}

Json draw(const study::RunFacts& facts) {
  if (!facts.draw) return nullptr;
  Json parameters = Json::array();
  for (const study::DrawnFacts& each : facts.drawn)
    parameters.push_back({{"variable", each.variable},
                          {"value", each.value},
                          {"unit", each.unit},
                          {"distribution", each.distribution},
                          {"file", each.file}});
  return {{"seed", facts.draw->seed()}, {"draw", facts.draw->run()}, {"parameters", parameters}};
}

}  // namespace

std::string summary_json(const study::RunFacts& facts, const Response& response) {
  const build_info::BuildInfo build = build_info::build_info();
  Json json{{"title", facts.title},
            {"job_name", facts.job_name},
            {"job_sha256", facts.job_sha256},
            {"program_version", build.program_version},
            {"git_commit", build.git_commit},
            {"cpu_class", build.cpu_class},
            {"record", facts.record ? record(*facts.record) : Json(nullptr)},
            {"outcome", name_of(response.outcome)},
            {"cause", response.cause},
            {"narrative", narrative(facts, response)},
            {"end_time_s", response.end_time}};
  json["items"] = items(facts, response);
  json["impacts"] = impacts(facts, response);
  json["overturnings"] = overturnings_of(facts, response);
  json["zones"] = named_objects(study::zone_columns(), response.zones, facts.scene.zones);
  json["tethers"] = named_objects(study::tether_columns(), response.tethers, facts.scene.tethers);
  json["quality"] = object(study::quality_columns(), response.quality);
  json["warnings"] = facts.warnings;
  json["draw"] = draw(facts);
  json["assumptions"] = assumptions(facts.assumptions);
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace gurney::report
