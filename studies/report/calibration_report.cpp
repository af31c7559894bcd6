#include "studies/report/calibration_report.h"

#include <fmt/format.h>

#include <cmath>
#include <filesystem>

#include "studies/build_info/build_info.h"
#include "studies/calibration/trials/setup_reader.h"
#include "studies/report/formats.h"

namespace gurney::report {
namespace {

using namespace findings;

const Format kFour{".4g"}, kThree{".3g"}, kTwo{".2g"}, kPercent{".3g", "%", 0.01};

Format millimetres(const char* digits) { return {digits, "mm", 1e-3}; }

template <typename Choice>
const std::string& name_in(const Texts& names, Choice choice) {
  return names.at(static_cast<std::size_t>(choice));
}

Table constants_table(const calibration::Calibration& c) {
  Table table{"constants",
              "Constants",
              {{"constant", "constant"},
               {"name", ""},
               {"symbol", ""},
               {"unit", "unit"},
               {"caster", ""},
               {"floor", ""},
               {"against", ""},
               {"value", "value", kFour},
               {"interval_95", "95 % interval", interval_format(kFour),
                "confidence interval by Student's t"},
               {"scatter_of_logarithm",
                "scatter",
                {".1f", "%", 0.01},
                "standard deviation of the logarithm between trials"},
               {"", "trials"},
               {"prediction_95", "95 % of one more trial", interval_format(kFour)},
               {"lower_bound", ""},
               {"degrees", ""},
               {"trials", ""}}};
  for (const calibration::Constant& each : c.constants)
    table.add({each.about(), std::string(name_of(each.kind)),
               std::string(calibration::symbol_of(each.kind)),
               std::string(calibration::unit_of(each.kind)), each.caster, each.floor, each.against,
               each.value, ends(each.interval), each.scatter, Value(), ends(each.prediction),
               each.at_least, each.degrees, each.trials});
  return table;
}

Table trials_table(const calibration::Calibration& c) {
  Table table{"trial_files",
              "Trials",
              {{"trial", "trial"},
               {"kind", "kind"},
               {"use", "use"},
               {"origin", "origin"},
               {"caster", "caster"},
               {"floor", "floor"},
               {"against", "against"},
               {"mass_kg", "mass", {".5g", "kg"}},
               {"sha256", "SHA-256"},
               {"file", "file"},
               {"line", ""},
               {"excluded", "excluded"}}};
  for (const calibration::ReadTrial& t : c.trials)
    table.add({t.name, name_in(calibration::names_of_kinds(), t.kind),
               name_in(calibration::names_of_uses(), t.setup.use),
               name_in(calibration::names_of_origins(), t.setup.origin), t.setup.caster,
               t.setup.floor, t.setup.against, t.setup.mass > 0 ? Value(t.setup.mass) : Value(),
               t.sha256, t.file, t.line == 0 ? Value() : Value(t.line),
               t.excluded.empty() ? Value() : Value(t.excluded)});
  table.most = 0;
  return table;
}

Table values_table(const calibration::Calibration& c) {
  Table table{"values",
              "Values of the trials, and residuals",
              {{"trial", "trial"},
               {"constant", "constant"},
               {"use", "use"},
               {"value", "value", kFour},
               {"standard_error", "standard error", kTwo, "of the measurement"},
               {"lower_bound", ""},
               {"", "residual", kPercent, "value over the constant, less one"},
               {"", "standardized", kThree,
                "logarithm of value over constant, over its standard deviation: scatter and "
                "error"}}};
  for (const calibration::TrialValue& v : c.values)
    table.add({v.trial, v.constant(), name_in(calibration::names_of_uses(), v.setup.use), v.value,
               v.error, v.at_least, Value(), Value()});
  table.most = 0;
  return table;
}

Table pulls_table(const calibration::Calibration& c) {
  Table table{"pulls",
              "Pulls",
              {{"trial", "trial"},
               {"caster", ""},
               {"floor", ""},
               {"normal_force_n", "normal force", {".4g", "N"}},
               {"pull_force_n", "pull force", {".4g", "N"}},
               {"pull_acceleration_mps2", "a2", {".4g", "m/s2"}, "acceleration while pulled"},
               {"coast_deceleration_mps2", "a3", {".4g", "m/s2"}, "deceleration while coasting"},
               {"resistance_pulled_n", "f_r pulled", {".4g", "N"}},
               {"resistance_coasting_n", "f_r coasting", {".4g", "N"}},
               {"resistance_n", "f_r", {".4g", "N"}, "mean of both, weighted by their errors"},
               {"resistance_error_n", "standard error", {".4g", "N"}}}};
  for (const calibration::RollingTrial& t : c.rolling) {
    const calibration::TrialAverages& a = t.averages;
    table.add({a.name, a.setup.caster, a.setup.floor, calibration::normal_force(a.setup),
               a.pull_force, a.pull_acceleration, a.coast_deceleration, t.resistance.pulled,
               t.resistance.coasting, t.resistance.mean, t.resistance.mean_error});
  }
  table.most = 0;
  return table;
}

Table tests_table(const calibration::Calibration& c) {
  Table table{"tests",
              "Does rolling resistance depend on it?",
              {{"name", "on"},
               {"quantity", "estimated"},
               {"estimate", "estimate", kThree},
               {"interval_95", "95 % interval", interval_format(kFour)},
               {"supposed", "supposed", kThree, "by f_r = (Cr / R) N"},
               {"p", "p", kTwo},
               {"p_adjusted", "p of all tests", kTwo, "adjusted for their number (Holm 1979)"},
               {"p_no_influence", "p of no influence", kTwo},
               {"trials", ""},
               {"", "result"}}};
  for (const calibration::RollingTest& t : c.tests)
    table.add({t.name, t.quantity, t.estimate, ends(t.interval), t.supposed, t.p, t.p_adjusted,
               t.p_without, t.trials, Value()});
  return table;
}

Table crosswise_table(const calibration::Calibration& c) {
  Table table{"crosswise",
              "Crosswise pulls",
              {{"trial", "trial"},
               {"friction_times_width_m", "mu w", millimetres(".3g")},
               {"swivel_torque_over_load_m", "mu w/4 + T/N", millimetres(".4g"),
                "scrub and swivel friction together"},
               {"swivel_torque_over_load_error_m", "standard error", millimetres(".1g")},
               {"rolling_resistance", "Cr/R", kFour},
               {"correlation_with_rolling_resistance", "correlation with Cr/R", kTwo},
               {"misfit_m", "misfit", millimetres(".2g"),
                "root mean square of the residuals of displacement"}}};
  for (const calibration::CrosswiseFit& f : c.crosswise)
    table.add({f.trial, f.friction_times_width, f.torque_length, f.torque_length_error,
               f.resistance, f.correlation, f.misfit});
  return table;
}

Table outliers_table(const calibration::Calibration& c) {
  Table table{"outliers",
              "Outliers (kept: examine the trial, then decide)",
              {{"trial", "trial"},
               {"constant", "constant"},
               {"value", "value", kFour},
               {"p_adjusted", "p", kTwo}}};
  for (const calibration::Outlier& o : c.outliers) table.add({o.trial, o.constant, o.value, o.p});
  return table;
}

Table validation_table(const calibration::Calibration& c) {
  Table table{"validation",
              "Trials that were not used for the estimates",
              {{"trial", "trial"},
               {"constant", "constant"},
               {"measured", "measured", kFour},
               {"predicted", "predicted", kFour},
               {"prediction_95", "95 % interval", interval_format(kFour)},
               {"misfit", "misfit", {"+.1f", "%", 0.01}},
               {"inside", "inside"}}};
  for (const calibration::Prediction& p : c.predictions)
    table.add(
        {p.trial, p.constant, p.measured, p.predicted, ends(p.interval), p.misfit(), p.inside()});
  return table;
}

Table excluded_table(const calibration::Calibration& c) {
  Table table{"left_out", "", {{"file", ""}, {"line", ""}, {"reason", ""}}};
  for (const calibration::TrialFault& f : c.left_out) table.add({f.file, f.line, f.reason});
  return table;
}

// Conclusions.

std::string result_of(const Table& tests, std::size_t row) {
  constexpr double kClear = 0.05;
  const double supposed = number_in(tests, row, "supposed");
  const auto& interval = std::get<Numbers>(value_in(tests, row, "interval_95"));
  if (number_in(tests, row, "p_adjusted") < kClear)
    return fmt::format("differs from {:.3g}", supposed);
  return interval[0] <= supposed && supposed <= interval[1]
             ? fmt::format("no difference from {:.3g} seen", supposed)
             : "unclear, as one of several tests";
}

/// Value over constant, and that in standard deviations.
void add_residuals(const Table& constants, Table& values) {
  for (std::size_t i = 0; i < constants.rows.size(); ++i)
    for (std::size_t k = 0; k < values.rows.size(); ++k) {
      if (text_in(constants, i, "constant") != text_in(values, k, "constant") ||
          std::get<bool>(value_in(constants, i, "lower_bound")) !=
              std::get<bool>(value_in(values, k, "lower_bound")))
        continue;
      const double value = number_in(values, k, "value"),
                   ratio = value / number_in(constants, i, "value"),
                   error = number_in(values, k, "standard_error") / value;
      auto& row = values.rows[k];
      row[row.size() - 2] = ratio - 1;
      row.back() =
          std::log(ratio) / std::hypot(number_in(constants, i, "scatter_of_logarithm"), error);
    }
}

Texts excluded_of(const Section& all) {
  const Table& table = *find<Table>(all, "left_out");
  Texts lines;
  for (std::size_t i = 0; i < table.rows.size(); ++i)
    lines.push_back(calibration::TrialFault{
        text_in(table, i, "file"),
        static_cast<int>(std::get<std::int64_t>(value_in(table, i, "line"))),
        text_in(table, i, "reason")}
                        .text());
  return lines;
}

/// "5 of 6 within their 95 % interval"; empty without predictions.
std::string success_of(const Section& all) {
  const Table& table = *find<Table>(all, "validation");
  std::size_t inside = 0;
  for (std::size_t i = 0; i < table.rows.size(); ++i)
    inside += std::get<bool>(value_in(table, i, "inside"));
  return table.rows.empty()
             ? ""
             : fmt::format("{} of {} within their 95 % interval.", inside, table.rows.size());
}

Texts cautions_of(const Section& all) {
  Texts texts;
  if (const std::string simulated = text_of(all, "simulated"); simulated != "0")
    texts.push_back(fmt::format("SIMULATED: {} of {} trials are not measured, but computed.",
                                simulated, text_of(all, "trials")));
  const Table& left_out = *find<Table>(all, "left_out");
  Texts names;
  for (std::size_t i = 0; i < left_out.rows.size(); ++i)
    names.push_back(std::filesystem::path(text_in(left_out, i, "file")).filename().string());
  if (!names.empty())
    texts.push_back(fmt::format("EXCLUDED, with the reason below: {} of {} trials ({}).",
                                names.size(), text_of(all, "trials"), fmt::join(names, ", ")));
  const Table& constants = *find<Table>(all, "constants");
  for (std::size_t i = 0; i < constants.rows.size(); ++i) {
    const std::string& about = text_in(constants, i, "constant");
    const auto& interval = std::get<Numbers>(value_in(constants, i, "interval_95"));
    if (std::get<bool>(value_in(constants, i, "lower_bound")))
      texts.push_back(about +
                      " is a lower bound: with all wheels locked they do not break away at once. "
                      "Lock one axle.");
    else if (!std::isfinite(interval[0]) || !std::isfinite(interval[1]))
      texts.push_back(about + " comes from one trial, which gives no interval.");
  }
  const Table& outliers = *find<Table>(all, "outliers");
  for (std::size_t i = 0; i < outliers.rows.size(); ++i)
    texts.push_back(fmt::format("{} does not go with the others of {} (p {:.2g}); it is kept.",
                                text_in(outliers, i, "trial"), text_in(outliers, i, "constant"),
                                number_in(outliers, i, "p_adjusted")));
  const Table& predictions = *find<Table>(all, "validation");
  for (std::size_t i = 0; i < predictions.rows.size(); ++i)
    if (!std::get<bool>(value_in(predictions, i, "inside")))
      texts.push_back(text_in(predictions, i, "trial") +
                      ", kept for validation, is outside the 95 % interval of its prediction.");
  if (predictions.rows.empty())
    texts.emplace_back(
        "No trial is reserved for validation: the accuracy of predictions is unknown.");
  if (find<Table>(all, "tests")->rows.empty() && !find<Table>(all, "pulls")->rows.empty())
    texts.emplace_back("Too few trials to test what rolling resistance depends on.");
  return texts;
}

}  // namespace

Section calibration_facts(const calibration::Calibration& c,
                          const std::vector<calibration::CasterFile>& casters,
                          const std::vector<std::string>& without) {
  Section all("", "Calibration of casters"), glance("", "At a glance"),
      trials("", "What was measured"), fit("", "Fit"), diagnostics("", "Diagnostics"),
      validation("", "Validation"), files("", "Caster files"), provenance("", "Provenance");
  all.json("schema", "gurney-calibration/1");
  glance.fact("trials", "trials", c.read).json("simulated", c.simulated);
  glance.fact("source", "read from", c.source).add(constants_table(c));
  trials.add(trials_table(c)).add(excluded_table(c));
  fit.add(values_table(c)).add(pulls_table(c));
  diagnostics.add(tests_table(c)).add(crosswise_table(c)).add(outliers_table(c));
  validation.add(validation_table(c));
  validation.list("validation_without_constant", "Without a constant", c.unpredicted);
  Table written{"caster_files",
                "Files",
                {{"file", "file"}, {"calibrated", "keys from trials"}, {"text", ""}}};
  for (const calibration::CasterFile& f : casters) written.add({f.name, f.calibrated, f.text});
  files.add(std::move(written)).list("without_caster_file", "No caster file for", without);
  const build_info::BuildInfo build = build_info::build_info();
  provenance.fact("program_version", "gurney", build.program_version);
  provenance.fact("git_commit", "commit", build.git_commit);
  for (Section* each : {&glance, &trials, &fit, &diagnostics, &validation, &files, &provenance})
    all.add(std::move(*each));
  return all;
}

Section example_of_calibration_facts() {
  calibration::Calibration one;
  one.trials.resize(1);
  one.values.resize(1);
  one.constants.resize(1);
  one.rolling.resize(1);
  one.tests.resize(1);
  one.crosswise.resize(1);
  one.outliers.resize(1);
  one.predictions.resize(1);
  one.left_out.resize(1);
  return calibration_facts(one, {{}});
}

Section calibration_findings(Section all) {
  Table &constants = find<Table>(all, "constants"), &tests = find<Table>(all, "tests");
  for (auto& row : constants.rows) row[row.size() - 5] = std::get<Texts>(row.back().value).size();
  for (std::size_t row = 0; row < tests.rows.size(); ++row)
    tests.rows[row].back() = result_of(tests, row);
  add_residuals(constants, find<Table>(all, "values"));
  List cautions{"", kCautions, cautions_of(all), kAll, true};
  const Texts excluded = excluded_of(all);
  const std::string success = success_of(all);
  const bool tested = !tests.rows.empty(), crosswise = !find<Table>(all, "crosswise").rows.empty();
  for (Part& part : all.parts) {
    auto* const section = std::get_if<Section>(&part);
    if (section == nullptr) continue;
    if (section->title == "At a glance") section->parts.insert(section->parts.end() - 1, cautions);
    if (section->title == "What was measured") section->list("", "Excluded", excluded);
    if (section->title == "Validation") section->say(success);
    if (section->title != "Diagnostics") continue;
    section->say(tested ? "A large p is no proof: look at the interval." : "");
    section->say(crosswise ? "Of a crosswise pull only the sum of scrub and swivel friction is "
                             "identifiable at one load."
                           : "");
  }
  return all;
}

}  // namespace gurney::report
