#include <cmath>
#include <nlohmann/json.hpp>

#include "engine/base/units.h"
#include "studies/report/json_values.h"
#include "studies/report/overview_report.h"
#include "studies/report/scale_factors_json.h"

namespace gurney::report {
namespace {

using Json = nlohmann::ordered_json;

Json head(const study::FileOverview& file, const char* filetype) {
  Json motions = Json::array(), assumptions = Json::array();
  for (const auto& each : file.motions)
    motions.push_back({{"name", each.name}, {"files", each.files}, {"warnings", each.warnings}});
  for (const auto& each : file.assumptions)
    assumptions.push_back({{"key", each.key},
                           {"value", each.value},
                           {"range", each.range},
                           {"reason", each.reason},
                           {"file", each.file}});
  return {{"file", file.path},
          {"filetype", filetype},
          {"title", file.title},
          {"program_version", file.program_version},
          {"git_commit", file.git_commit},
          {"compiler", file.compiler},
          {"cpu_class", file.cpu_class},
          {"job_name", file.job_name},
          {"job_sha256", file.job_sha256},
          {"seed", file.seed.empty() ? Json(nullptr) : Json(file.seed)},
          {"records", motions},
          {"warnings", file.warnings},
          {"assumptions", assumptions},
          {"energy_closure", json_number(file.energy_closure)}};
}

Json counts(const study::StudyOverview& overview) {
  Json result = Json::array();
  for (const study::LevelCounts& each : overview.counts) {
    Json exceeded = Json::object();
    for (std::size_t i = 0; i < overview.states.size(); ++i)
      exceeded[overview.states[i].name] = each.exceeded[i];
    result.push_back({{"configuration", each.configuration},
                      {"level", each.level},
                      {"runs", each.runs},
                      {"overturned", each.overturned},
                      {"failed", each.failed},
                      {"exceeded", exceeded}});
  }
  return result;
}

Json distributions(const std::vector<study::StepDistribution>& all, const char* name) {
  Json rows = Json::array();
  for (const study::StepDistribution& each : all) {
    const bool bounded = each.of.pairs > 1;
    rows.push_back({{name, each.name},
                    {"records", each.of.pairs},
                    {"mean_at_step", each.of.mean_a},
                    {"mean_at_half_step", each.of.mean_b},
                    {"difference", each.of.difference},
                    {"low", bounded ? Json(each.of.interval.low) : Json(nullptr)},
                    {"high", bounded ? Json(each.of.interval.high) : Json(nullptr)},
                    {"p", each.of.p_permutation}});
  }
  return rows;
}

Json step_check(const study::StepCheck& of) {
  Json demands = Json::array(), states = Json::array();
  for (const study::StepChange& each : of.changes) {
    const bool any = each.compared > 0;
    demands.push_back(
        {{"demand", each.demand},
         {"point", each.point.empty() ? Json(nullptr) : Json(each.point)},
         {"compared", each.compared},
         {"share_within_1_percent", any ? Json(each.within_1_percent) : Json(nullptr)},
         {"share_within_5_percent", any ? Json(each.within_5_percent) : Json(nullptr)},
         {"median_relative_change", any ? Json(each.median) : Json(nullptr)},
         {"largest_relative_change", any ? Json(each.largest) : Json(nullptr)},
         {"largest_in_run", each.largest > 0 ? Json(each.largest_run) : Json(nullptr)}});
  }
  for (const study::StateChange& each : of.states)
    states.push_back({{"limit_state", each.state}, {"changed_runs", each.runs}});
  Json json = {{"runs", of.runs},
               {"failed", of.failed},
               {"demands", demands},
               {"limit_states", states},
               {"not_compared", of.unjudged}};
  if (of.chaotic)
    json["chaotic"] = {{"runs", of.chaotic->runs},
                       {"ln_demands", distributions(of.chaotic->demands, "demand")},
                       {"limit_states", distributions(of.chaotic->states, "limit_state")}};
  return json;
}

}  // namespace

std::string overview_json(const study::StudyOverview& overview) {
  Json result = head(overview.file, "gurney-study");
  Json factors = Json::array(), angles = Json::array(), states = Json::array(),
       failures = Json::array();
  for (const auto& each : overview.factors)
    factors.push_back({{"name", each.name}, {"levels", each.levels}});
  for (const double angle : overview.angles) angles.push_back(angle / kRadiansPerDegree);
  for (const study::LimitState& each : overview.states)
    states.push_back({{"name", each.name}, {"words", each.words}, {"origin", each.origin}});
  for (const study::FailedRun& each : overview.failures)
    failures.push_back({{"run", each.run}, {"cause", each.cause}, {"replay", each.command}});
  result["energy_closure_run"] = overview.energy_closure_run;
  result["factors"] = factors;
  result["configurations"] = overview.configurations;
  result["angles_deg"] = angles;
  result["intensity_measure"] = overview.measure;
  result["levels"] = overview.levels;
  if (overview.factors_on_records.any())
    result["scale_factors"] = scale_factors_json(overview.factors_on_records);
  result["draws"] = overview.draws;
  result["replicas"] = overview.replicas;
  result["ranges_not_drawn"] = overview.undrawn ? Json(overview.undrawn->lines()) : Json(nullptr);
  result["demands_not_in_file"] = overview.missing_demands;
  result["runs"] = overview.runs;
  result["overturned"] = overview.overturned;
  result["failed"] = overview.failed;
  result["untrusted"] = overview.untrusted;
  result["warned"] = overview.warned;
  result["limit_states"] = states;
  result["counts"] = counts(overview);
  result["failures"] = failures;
  result["step_check"] = overview.step_check ? step_check(*overview.step_check) : Json(nullptr);
  return result.dump(2) + "\n";
}

std::string overview_json(const study::RunOverview& overview, const study::UnitSystem& chosen) {
  const study::UnitSystem units = chosen.or_else("si");
  const auto in = [&](double value, const char* si) {
    return json_number(value / units.of(si).in_si);
  };
  Json result = head(overview.file, "gurney-results");
  Json items = Json::array();
  for (const auto& each : overview.items)
    items.push_back(
        {{"name", each.name},
         {"model", each.model},
         {"peak_displacement", in(each.peak_displacement, "m")},
         {"residual_displacement", in(each.residual_displacement, "m")},
         {"peak_velocity", in(each.peak_velocity, "m/s")},
         {"peak_tilt", in(each.peak_tilt, "rad")},
         {"time_of_overturning",
          each.time_of_overturning < 0 ? Json(nullptr) : Json(each.time_of_overturning)}});
  result["outcome"] = overview.outcome;
  result["cause"] = overview.cause;
  result["end_time"] = overview.end_time;
  result["items"] = items;
  if (chosen.chosen())
    result["units"] = {{"peak_displacement", units.of("m").name},
                       {"residual_displacement", units.of("m").name},
                       {"peak_velocity", units.of("m/s").name},
                       {"peak_tilt", units.of("rad").name}};
  return result.dump(2) + "\n";
}

}  // namespace gurney::report
