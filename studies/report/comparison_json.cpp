#include <cmath>
#include <nlohmann/json.hpp>

#include "studies/report/comparison_report.h"
#include "studies/report/json_values.h"

namespace gurney::report {
namespace {

using Json = nlohmann::ordered_json;

/// JSON has no NaN and no infinity.
Json differences(const std::vector<study::InputDifference>& of) {
  Json list = Json::array();
  const auto value = [](const std::string& text) { return text.empty() ? Json() : Json(text); };
  for (const study::InputDifference& each : of)
    list.push_back({{"key", each.key}, {"a", value(each.a)}, {"b", value(each.b)}});
  return list;
}

Json side(const std::string& name, const study::ConfigurationView& of, std::size_t paired,
          std::size_t left_out) {
  return {{"name", name},
          {"file", of.data->file().path()},
          {"configuration", of.configuration_name()},
          {"runs_paired", paired},
          {"runs_without_partner", left_out},
          {"runs_failed", of.data->failed(of.configuration)}};
}

Json quantities(const ComparisonReport& report, study::ComparedQuantity::Kind kind) {
  Json list = Json::array();
  for (const study::ComparedQuantity& row : report.found.quantities)
    if (row.kind == kind) {
      const study::ReportUnit unit = report.units().or_else("si").of(row.units);
      list.push_back({{"name", row.name},
                      {"words", row.words},
                      {"units", unit.name},
                      {"groups", row.groups},
                      {"a", json_number(row.a / unit.in_si)},
                      {"b", json_number(row.b / unit.in_si)},
                      {"difference", json_number(row.difference / unit.in_si)},
                      {"interval", json_interval(row.interval, unit.in_si)},
                      {"p", json_number(row.p)},
                      {"p_holm", json_number(row.p_holm)}});
    }
  return list;
}

Json curve(const statistics::FragilityFit& fit, const study::CurveAudit& audit,
           const study::ReportUnit& unit) {
  Json json{{"status", text(fit.status)}, {"runs", fit.runs}, {"exceeded", fit.exceeded}};
  if (!fit.curve) json["median_between"] = json_interval(fit.median, unit.in_si);
  json["theta"] = fit.curve ? json_number(fit.curve->theta / unit.in_si) : Json();
  json["beta"] = fit.curve ? json_number(fit.curve->beta) : Json();
  json["cautions"] = study::cautions(audit, unit);
  return json;
}

const char* name_of(study::RunPairs::Group group) {
  switch (group) {
    case study::RunPairs::Group::kRecord:
      return "record";
    case study::RunPairs::Group::kDraw:
      return "draw";
    case study::RunPairs::Group::kNone:
      break;
  }
  return "none";
}

}  // namespace

std::string comparison_json(const ComparisonReport& report) {
  const study::StudyComparison& found = report.found;
  using Kind = study::ComparedQuantity::Kind;
  Json json;
  json["a"] = side(report.name_a, report.a, found.pairs.paired_a, found.pairs.left_out_a);
  json["b"] = side(report.name_b, report.b, found.pairs.paired_b, found.pairs.left_out_b);
  json["pairs"] = {{"count", found.pairs.pairs.size()},   {"level", found.pairs.level},
                   {"by_angle", found.pairs.by_angle},    {"by_draw", found.pairs.by_draw},
                   {"group", name_of(found.pairs.group)}, {"groups", found.pairs.groups},
                   {"runs_overturned", found.overturned}};
  json["inputs"] = {{"job", differences(report.inputs.job)},
                    {"assumptions", differences(report.inputs.assumptions)},
                    {"data_files", differences(report.inputs.data_files)},
                    {"program", differences(report.inputs.program)},
                    {"records_in_both", report.inputs.records_common},
                    {"records_of_a_only", report.inputs.records_of_a},
                    {"records_of_b_only", report.inputs.records_of_b},
                    {"records_changed", report.inputs.records_changed}};
  json["confidence"] = report.confidence;
  json["tests"] = {{"shares", found.tests.shares},
                   {"curves", found.tests.curves},
                   {"means", found.tests.means},
                   {"medians", found.tests.medians}};
  json["smallest_p_possible"] = json_number(found.smallest_p);
  json["shares"] = quantities(report, Kind::kShare);
  json["means"] = quantities(report, Kind::kMean);
  json["medians"] = quantities(report, Kind::kMedian);
  json["measure"] = found.measure;
  const study::ReportUnit unit = report.units().or_else("si").of(found.units);
  json["measure_units"] = unit.name;
  json["curves"] = Json::array();
  for (const study::ComparedCurves& row : found.curves)
    json["curves"].push_back({{"name", row.name},
                              {"a", curve(row.a, row.audit_a, unit)},
                              {"b", curve(row.b, row.audit_b, unit)},
                              {"likelihood_ratio", json_number(row.likelihood_ratio)},
                              {"p", json_number(row.p)},
                              {"p_holm", json_number(row.p_holm)}});
  json["not_in_both"] = found.not_common;
  return json.dump(2) + "\n";
}

}  // namespace gurney::report
