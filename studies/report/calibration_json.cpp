#include <cmath>
#include <nlohmann/json.hpp>

#include "studies/build_info/build_info.h"
#include "studies/calibration/trials/setup_reader.h"
#include "studies/report/calibration_report.h"
#include "studies/report/json_values.h"

namespace gurney::report {
namespace {

using Json = nlohmann::ordered_json;

Json constant_json(const calibration::Constant& c) {
  return {{"name", name_of(c.kind)},
          {"constant", c.about()},
          {"symbol", calibration::symbol_of(c.kind)},
          {"unit", calibration::unit_of(c.kind)},
          {"caster", c.caster},
          {"floor", c.floor},
          {"against", c.against},
          {"value", json_number(c.value)},
          {"lower_bound", c.at_least},
          {"interval_95", json_interval(c.interval)},
          {"scatter_of_logarithm", json_number(c.scatter)},
          {"degrees", c.degrees},
          {"prediction_95", json_interval(c.prediction)},
          {"trials", c.trials}};
}

template <typename Choice>
const std::string& name_in(const std::vector<std::string>& names, Choice choice) {
  return names.at(static_cast<std::size_t>(choice));
}

Json trial_json(const calibration::ReadTrial& t) {
  return {{"trial", t.name},
          {"file", t.file},
          {"line", t.line == 0 ? Json() : Json(t.line)},
          {"sha256", t.sha256},
          {"kind", name_in(calibration::names_of_kinds(), t.kind)},
          {"use", name_in(calibration::names_of_uses(), t.setup.use)},
          {"origin", name_in(calibration::names_of_origins(), t.setup.origin)},
          {"caster", t.setup.caster},
          {"floor", t.setup.floor},
          {"against", t.setup.against},
          {"mass_kg", t.setup.mass > 0 ? Json(t.setup.mass) : Json()},
          {"excluded", t.excluded.empty() ? Json() : Json(t.excluded)}};
}

Json value_json(const calibration::TrialValue& v) {
  return {{"trial", v.trial},
          {"constant", v.constant()},
          {"use", name_in(calibration::names_of_uses(), v.setup.use)},
          {"value", json_number(v.value)},
          {"standard_error", json_number(v.error)},
          {"lower_bound", v.at_least}};
}

Json test_json(const calibration::RollingTest& t) {
  return {{"name", t.name},
          {"quantity", t.quantity},
          {"estimate", json_number(t.estimate)},
          {"interval_95", json_interval(t.interval)},
          {"supposed", t.supposed},
          {"p", json_number(t.p)},
          {"p_adjusted", json_number(t.p_adjusted)},
          {"p_no_influence", t.p_without ? json_number(*t.p_without) : Json()},
          {"trials", t.trials}};
}

Json rolling_json(const calibration::RollingTrial& t) {
  const calibration::TrialAverages& a = t.averages;
  return {{"trial", a.name},
          {"caster", a.setup.caster},
          {"floor", a.setup.floor},
          {"normal_force_n", calibration::normal_force(a.setup)},
          {"pull_force_n", a.pull_force},
          {"pull_acceleration_mps2", a.pull_acceleration},
          {"coast_deceleration_mps2", a.coast_deceleration},
          {"resistance_pulled_n", t.resistance.pulled},
          {"resistance_coasting_n", t.resistance.coasting},
          {"resistance_n", t.resistance.mean},
          {"resistance_error_n", t.resistance.mean_error}};
}

Json crosswise_json(const calibration::CrosswiseFit& f) {
  return {{"trial", f.trial},
          {"rolling_resistance", f.resistance},
          {"friction_times_width_m", f.friction_times_width},
          {"swivel_torque_over_load_m", f.torque_length},
          {"swivel_torque_over_load_error_m", f.torque_length_error},
          {"correlation_with_rolling_resistance", f.correlation},
          {"misfit_m", f.misfit}};
}

template <typename Rows, typename Make>
Json list(const Rows& rows, Make make) {
  Json json = Json::array();
  for (const auto& row : rows) json.push_back(make(row));
  return json;
}

}  // namespace

std::string calibration_json(const calibration::Calibration& c,
                             const std::vector<calibration::CasterFile>& casters,
                             const std::vector<std::string>& without) {
  const build_info::BuildInfo build = build_info::build_info();
  const Json json{
      {"schema", "gurney-calibration/1"},
      {"program_version", build.program_version},
      {"git_commit", build.git_commit},
      {"source", c.source},
      {"trials", c.read},
      {"simulated", c.simulated},
      {"trial_files", list(c.trials, trial_json)},
      {"constants", list(c.constants, constant_json)},
      {"values", list(c.values, value_json)},
      {"tests", list(c.tests, test_json)},
      {"pulls", list(c.rolling, rolling_json)},
      {"crosswise", list(c.crosswise, crosswise_json)},
      {"outliers", list(c.outliers,
                        [](const calibration::Outlier& o) {
                          return Json{{"trial", o.trial},
                                      {"constant", o.constant},
                                      {"value", o.value},
                                      {"p_adjusted", o.p}};
                        })},
      {"validation", list(c.predictions,
                          [](const calibration::Prediction& p) {
                            return Json{{"trial", p.trial},
                                        {"constant", p.constant},
                                        {"measured", p.measured},
                                        {"predicted", p.predicted},
                                        {"prediction_95", json_interval(p.interval)},
                                        {"misfit", p.misfit()},
                                        {"inside", p.inside()}};
                          })},
      {"validation_without_constant", c.unpredicted},
      {"left_out", list(c.left_out,
                        [](const calibration::TrialFault& f) {
                          return Json{{"file", f.file}, {"line", f.line}, {"reason", f.reason}};
                        })},
      {"caster_files",
       list(casters,
            [](const calibration::CasterFile& f) {
              return Json{{"file", f.name}, {"calibrated", f.calibrated}, {"text", f.text}};
            })},
      {"without_caster_file", without}};
  return json.dump(2) + "\n";
}

}  // namespace gurney::report
