#include <functional>
#include <nlohmann/json.hpp>

#include "engine/base/units.h"
#include "groundmotions/measures/measure.h"
#include "groundmotions/processing/integrate.h"
#include "studies/report/record_report.h"

namespace gurney {
namespace {

using Json = nlohmann::ordered_json;

Json measures(const std::function<double(const Measure&)>& value) {
  Json result = Json::object();
  for (const Measure& measure : usual_measures())
    result[name_of(measure)] = {{"value", value(measure)}, {"unit", unit_of(measure)}};
  return result;
}

Json component_json(const Component& component) {
  const EndMotion end = end_motion(component.time_step, component.acceleration);
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
          {"measures", measures([&](const Measure& measure) {
             return value_of(measure, component.time_step, component.acceleration);
           })},
          {"residual_velocity_m_per_s", end.velocity},
          {"residual_displacement_m", end.displacement}};
}

}  // namespace

std::string record_json(const Record& record, const std::vector<RecordFact>& facts) {
  Json components = Json::object();
  for (const Direction direction : kDirections)
    if (record[direction]) components[name_of(direction)] = component_json(*record[direction]);
  Json result = {{"name", record.name},
                 {"samples", record.samples()},
                 {"time_step_s", record.time_step()},
                 {"components", components}};
  if (record[Direction::kH1] && record[Direction::kH2])
    result["rotd50"] = measures(
        [&](const Measure& measure) { return value_of(measure, Combination::kRotD50, record); });
  Json known = Json::object();
  for (const auto& [name, value] : facts) known[name] = value;
  result["facts"] = known;
  result["processing"] = record.processing;
  result["warnings"] = record_findings(record);
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

}  // namespace gurney
