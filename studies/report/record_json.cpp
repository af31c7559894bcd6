#include <nlohmann/json.hpp>

#include "engine/base/units.h"
#include "groundmotions/measures/integrate.h"
#include "groundmotions/measures/summary.h"
#include "studies/report/record_report.h"

namespace gurney::report {
namespace {

using Json = nlohmann::ordered_json;

Json measures_json(const groundmotions::Summary& summary) {
  Json result = Json::object();
  for (const groundmotions::SummaryRow& row : summary.rows) {
    Json values = Json::object();
    for (const auto& [name, value] : row.values) values[name] = value;
    result[row.name] = {{"unit", row.unit}, {"definition", row.definition}, {"values", values}};
  }
  return result;
}

Json component_json(const groundmotions::Component& component) {
  const groundmotions::EndMotion end =
      groundmotions::end_motion(component.time_step, component.acceleration);
  Json header = Json::object();
  for (const auto& [name, value] : component.header) header[name] = value;
  return {{"name", component.name},
          {"file", component.file},
          {"format", component.format},
          {"unit", component.unit},
          {"sha256", component.sha256},
          {"azimuth_deg",
           component.azimuth ? Json(*component.azimuth / kRadiansPerDegree) : Json(nullptr)},
          {"header", header},
          {"residual_velocity_m_per_s", end.velocity},
          {"residual_displacement_m", end.displacement}};
}

}  // namespace

std::string record_json(const groundmotions::Record& record, const std::vector<RecordFact>& facts,
                        const std::vector<groundmotions::Measure>& wanted) {
  Json components = Json::object();
  for (const groundmotions::Direction direction : groundmotions::kDirections)
    if (record[direction]) components[name_of(direction)] = component_json(*record[direction]);
  const groundmotions::Summary measures = summary(record, wanted);
  Json result = {{"name", record.name},
                 {"samples", record.samples()},
                 {"time_step_s", record.time_step()},
                 {"components", components},
                 {"measures", measures_json(measures)}};
  Json known = Json::object();
  for (const auto& [name, value] : facts) known[name] = value;
  result["facts"] = known;
  result["processing"] = record.processing;
  std::vector<std::string> findings = record_findings(record);
  findings.insert(findings.end(), measures.warnings.begin(), measures.warnings.end());
  result["warnings"] = findings;
  return result.dump(2);
}

std::string records_json(const std::vector<std::string>& records,
                         const std::vector<std::pair<std::string, std::string>>& refused) {
  Json list = Json::array(), left_out = Json::array();
  for (const std::string& record : records) list.push_back(Json::parse(record));
  for (const auto& [file, reason] : refused)
    left_out.push_back({{"file", file}, {"reason", reason}});
  return Json{{"records", list}, {"refused", left_out}}.dump(2) + "\n";
}

}  // namespace gurney::report
