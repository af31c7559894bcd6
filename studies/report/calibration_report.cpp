#include "studies/report/calibration_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>

#include "engine/base/units.h"
#include "engine/config/nearest_name.h"
#include "studies/build_info/build_info.h"
#include "studies/calibration/trials/setup_reader.h"
#include "studies/calibration/trials/trial.h"
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
  Table table{"constants", "Constants", {}};
  for (const calibration::Constant& each : c.constants)
    add_row(table, {{{"constant", "constant"}, each.about()},
                    {"name", std::string(name_of(each.kind))},
                    {"symbol", std::string(calibration::symbol_of(each.kind))},
                    {{"unit", "unit"}, std::string(calibration::unit_of(each.kind))},
                    {"caster", each.caster},
                    {"floor", each.floor},
                    {"against", each.against},
                    {{"value", "value", kFour}, each.value},
                    {{"interval_95", "95 % interval", interval_format(kFour),
                      "confidence interval by Student's t"},
                     ends(each.interval)},
                    {{"scatter_of_logarithm",
                      "scatter",
                      {".1f", "%", 0.01},
                      "standard deviation of the logarithm between trials"},
                     each.scatter},
                    {{"", "trials"}, Value()},
                    {{"prediction_95", "95 % of one more trial", interval_format(kFour)},
                     ends(each.prediction)},
                    {"lower_bound", each.at_least},
                    {"degrees", each.degrees},
                    {"trials", each.trials}});
  return table;
}

Table trials_table(const calibration::Calibration& c) {
  Table table{"trial_files", "Trials", {}};
  for (const calibration::ReadTrial& t : c.trials)
    add_row(table,
            {{{"trial", "trial"}, t.name},
             {{"kind", "kind"}, name_in(calibration::names_of_kinds(), t.kind)},
             {{"use", "use"}, name_in(calibration::names_of_uses(), t.setup.use)},
             {{"origin", "origin"}, name_in(calibration::names_of_origins(), t.setup.origin)},
             {{"caster", "caster"}, t.setup.caster},
             {{"floor", "floor"}, t.setup.floor},
             {{"against", "against"}, t.setup.against},
             {{"mass_kg", "mass", {".5g", "kg"}}, t.setup.mass > 0 ? Value(t.setup.mass) : Value()},
             {{"sha256", "SHA-256"}, t.sha256},
             {{"file", "file"}, t.file},
             {"line", t.line == 0 ? Value() : Value(t.line)},
             {"excluded", t.excluded.empty() ? Value() : Value(t.excluded)}});
  table.most = 0;
  return table;
}

Table values_table(const calibration::Calibration& c) {
  Table table{"values", "Values of the trials, and residuals", {}};
  for (const calibration::TrialValue& v : c.values)
    add_row(table, {{{"trial", "trial"}, v.trial},
                    {{"constant", "constant"}, v.constant()},
                    {{"use", "use"}, name_in(calibration::names_of_uses(), v.setup.use)},
                    {{"value", "value", kFour}, v.value},
                    {{"standard_error", "standard error", kTwo, "of the measurement"}, v.error},
                    {"lower_bound", v.at_least},
                    {{"", "residual", kPercent, "value over the constant, less one"}, Value()},
                    {{"", "standardized", kThree,
                      "logarithm of value over constant, over its standard deviation: scatter and "
                      "error"},
                     Value()}});
  table.most = 0;
  return table;
}

Table pulls_table(const calibration::Calibration& c) {
  Table table{"pulls", "Pulls", {}};
  for (const calibration::RollingTrial& t : c.rolling) {
    const calibration::TrialAverages& a = t.averages;
    add_row(table,
            {{{"trial", "trial"}, a.name},
             {"caster", a.setup.caster},
             {"floor", a.setup.floor},
             {{"normal_force_n", "normal force", {".4g", "N"}}, calibration::normal_force(a.setup)},
             {{"pull_force_n", "pull force", {".4g", "N"}}, a.pull_force},
             {{"pull_acceleration_mps2", "a2", {".4g", "m/s2"}, "acceleration while pulled"},
              a.pull_acceleration},
             {{"coast_deceleration_mps2", "a3", {".4g", "m/s2"}, "deceleration while coasting"},
              a.coast_deceleration},
             {{"resistance_pulled_n", "f_r pulled", {".4g", "N"}}, t.resistance.pulled},
             {{"resistance_coasting_n", "f_r coasting", {".4g", "N"}}, t.resistance.coasting},
             {{"resistance_n", "f_r", {".4g", "N"}, "mean of both, weighted by their errors"},
              t.resistance.mean},
             {{"resistance_error_n", "standard error", {".4g", "N"}}, t.resistance.mean_error}});
  }
  table.most = 0;
  return table;
}

Table tests_table(const calibration::Calibration& c) {
  Table table{"tests", "Does rolling resistance depend on it?", {}};
  for (const calibration::RollingTest& t : c.tests)
    add_row(table,
            {{{"name", "on"}, t.name},
             {{"quantity", "estimated"}, t.quantity},
             {{"estimate", "estimate", kThree}, t.estimate},
             {{"interval_95", "95 % interval", interval_format(kFour)}, ends(t.interval)},
             {{"supposed", "supposed", kThree, "by f_r = (Cr / R) N"}, t.supposed},
             {{"p", "p", kTwo}, t.p},
             {{"p_adjusted", "p of all tests", kTwo, "adjusted for their number (Holm 1979)"},
              t.p_adjusted},
             {{"p_no_influence", "p of no influence", kTwo}, t.p_without},
             {"trials", t.trials},
             {{"", "result"}, Value()}});
  return table;
}

Table crosswise_table(const calibration::Calibration& c) {
  Table table{"crosswise", "Crosswise pulls", {}};
  for (const calibration::CrosswiseFit& f : c.crosswise)
    add_row(
        table,
        {{{"trial", "trial"}, f.trial},
         {{"friction_times_width_m", "mu w", millimetres(".3g")}, f.friction_times_width},
         {{"swivel_torque_over_load_m", "mu w/4 + T/N", millimetres(".4g"),
           "scrub and swivel friction together"},
          f.torque_length},
         {{"swivel_torque_over_load_error_m", "standard error", millimetres(".1g")},
          f.torque_length_error},
         {{"rolling_resistance", "Cr/R", kFour}, f.resistance},
         {{"correlation_with_rolling_resistance", "correlation with Cr/R", kTwo}, f.correlation},
         {{"misfit_m", "misfit", millimetres(".2g"),
           "root mean square of the residuals of displacement"},
          f.misfit}});
  return table;
}

Table outliers_table(const calibration::Calibration& c) {
  Table table{"outliers", "Outliers (kept: examine the trial, then decide)", {}};
  for (const calibration::Outlier& o : c.outliers)
    add_row(table, {{{"trial", "trial"}, o.trial},
                    {{"constant", "constant"}, o.constant},
                    {{"value", "value", kFour}, o.value},
                    {{"p_adjusted", "p", kTwo}, o.p}});
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
  Table table{"left_out", "", json_columns({"file", "line", "reason"})};
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

/// Whether the names are one with a slip of the pen; pu_100 and pu_125, which differ in digits, are two.
bool look_alike(const std::string& a, const std::string& b) {
  const auto digits = [](std::string name) {
    std::erase_if(name, [](char c) { return c < '0' || c > '9'; });
    return name;
  };
  constexpr std::size_t kLettersForASlip = 5;  // of a shorter name a slip makes another word
  return digits(a) == digits(b) &&
         config::edit_distance(a, b) <=
             static_cast<int>(std::min(a.size(), b.size()) / kLettersForASlip);
}

/// Pairs of casters, or of floors, that look alike.
void add_alike(const Table& trials, const char* column, Texts& texts) {
  std::map<std::string, int> names;
  for (std::size_t i = 0; i < trials.rows.size(); ++i) ++names[text_in(trials, i, column)];
  for (auto a = names.begin(); a != names.end(); ++a)
    for (auto b = std::next(a); b != names.end(); ++b)
      if (look_alike(a->first, b->first))
        texts.push_back(fmt::format(
            "{0} '{1}' ({2} of {5} trials) and {0} '{3}' ({4}) are taken as two: are they one?",
            column, a->first, a->second, b->first, b->second, trials.rows.size()));
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
  for (const char* column : {"caster", "floor"})
    add_alike(*find<Table>(all, "trial_files"), column, texts);
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

constexpr const char* kNote =
    "simulated: verifies the method on signals whose input is known; reproduces no measured "
    "finding";

const Format kBias{"+.2f", "%", 0.01}, kSpread{".2f", "%", 0.01}, kMilliseconds{".4g", "ms", 1e-3};

Table bias_table(const PullingReport& report) {
  Table table{"bias",
              "f_r by the paper's method minus f_r of the input, % of it: mean and standard "
              "deviation over trials",
              {}};
  for (const calibration::AlignmentBias& row : calibration::bias_by_alignment(report.trials))
    add_row(table, {{{"alignment", "alignment"}, name_of(row.alignment)},
                    {{"trials", "trials"}, row.trials},
                    {{"pulled.mean", "phase II", kBias}, row.pulled.mean},
                    {{"pulled.standard_deviation", "+-", kSpread}, row.pulled.deviation},
                    {{"coasting.mean", "phase III", kBias}, row.coasting.mean},
                    {{"coasting.standard_deviation", "+-", kSpread}, row.coasting.deviation},
                    {{"both.mean", "of both", kBias}, row.mean.mean},
                    {{"both.standard_deviation", "+-", kSpread}, row.mean.deviation}});
  return table;
}

Table pooled_table(const PullingReport& report) {
  Table table{"pooled",
              "Cr/R of pooled trials minus that of the input, % of it: fit through the origin",
              {}};
  for (const calibration::PooledBias& row : calibration::pooled_biases(report.trials))
    add_row(table, {{{"trials", "trials"}, row.trials},
                    {{"both", "both phases", kBias}, row.both},
                    {{"coasting", "phase III", kBias}, row.coasting},
                    {{"of", "of"}, row.trials_of}});
  return table;
}

Table casters_table(const PullingReport& report) {
  Table table{"casters", "Cr/R of aligned trials", {}};
  for (const calibration::CasterFit& fit : calibration::fits_by_caster(report.trials))
    add_row(table, {{{"caster", "caster"}, fit.caster},
                    {"wheel_radius_m", fit.wheel_radius},
                    {{"trials", "aligned"}, fit.trials},
                    {{"cr_over_r_found", "Cr/R found", {".5f"}}, fit.found},
                    {{"cr_over_r_known", "input", {".5f"}}, fit.known},
                    {{"", "difference", kBias}, fit.found / fit.known - 1}});
  return table;
}

bool is_aligned(const calibration::SimulatedTrial& trial) {
  return trial.alignment == calibration::Alignment::kAligned;
}

/// Every trial, for programs.
Table trials_table(const PullingReport& report) {
  Table table{"trials", "", {}};
  const auto known = [](bool is_there, const Value& value) { return is_there ? value : Value(); };
  for (const calibration::SimulatedTrial& trial : report.trials) {
    const bool phased = trial.phases.has_value(), found = trial.averages.has_value(),
               aligned = is_aligned(trial);
    const calibration::Phases phases = trial.phases.value_or(calibration::Phases{});
    const calibration::Resistance resistance =
        found ? calibration::average_method(*trial.averages) : calibration::Resistance{};
    const calibration::TheoryError error = calibration::theory_error(trial);
    const auto found_driven = calibration::driven_error(trial, report.measured);
    const bool driven = found_driven.has_value();
    const auto of = found_driven.value_or(calibration::DrivenError{});
    add_row(table, {{"run", trial.run},
                    {"configuration", trial.configuration},
                    {"caster", trial.trial.setup.caster},
                    {"floor", trial.trial.setup.floor},
                    {"alignment", name_of(trial.alignment)},
                    {"solver", trial.solver},
                    {"time_step_s", trial.time_step},
                    {"normal_force_n", trial.theory.normal_force},
                    {"resistance_known_n", trial.theory.resistance},
                    {"left_flooring", trial.left_flooring},
                    {"phases.start_s", known(phased, phases.start)},
                    {"phases.release_s", known(phased, phases.release)},
                    {"phases.stop_s", known(phased, phases.stop)},
                    {"phases.end", known(phased, name_of(phases.end))},
                    {"resistance_pulled_n", known(found, resistance.pulled)},
                    {"resistance_coasting_n", known(found, resistance.coasting)},
                    {"fault", known(!found, trial.fault)},
                    {"error_at_release", known(aligned, error.release)},
                    {"error_at_rest", known(aligned, error.rest)},
                    {"driven_by.trial", known(driven, trial.driven_by)},
                    {"driven_by.error_at_release", known(driven, of.release)},
                    {"driven_by.error_of_speed", known(driven, of.speed)},
                    {"driven_by.error_at_rest", known(driven, of.rest)},
                    {"driven_by.largest_difference_m", known(driven, of.largest)}});
  }
  return table;
}

Table theory_table(const PullingReport& report) {
  Table table{"",
              "aligned trials against the closed form: error of the displacement (-: left the "
              "flooring)",
              {{"", "run"},
               {"", "solver"},
               {"", "step", kMilliseconds},
               {"", "at release", kBias},
               {"", "at rest", kBias},
               {"", "configuration"}}};
  for (const calibration::SimulatedTrial& trial : report.trials) {
    if (!is_aligned(trial)) continue;
    const calibration::TheoryError error = calibration::theory_error(trial);
    table.add(
        {trial.run, trial.solver, trial.time_step, error.release, error.rest, trial.configuration});
  }
  return table;
}

Table driven_table(const PullingReport& report) {
  Table table{"",
              "simulated under the force of a given trial, for its duration, minus that trial: "
              "displacement and speed at release, displacement at rest (-: left the flooring); "
              "largest difference of the displacement",
              {}};
  for (const calibration::SimulatedTrial& trial : report.trials)
    if (const auto error = calibration::driven_error(trial, report.measured))
      add_row(table, {{{"", "run"}, trial.run},
                      {{"", "solver"}, trial.solver},
                      {{"", "step", kMilliseconds}, trial.time_step},
                      {{"", "at release", kBias}, error->release},
                      {{"", "speed", kBias}, error->speed},
                      {{"", "at rest", kBias}, error->rest},
                      {{"", "largest", {".1f", "mm", 1e-3}}, error->largest},
                      {{"", "trial"}, trial.driven_by}});
  return table;
}

Table measured_table(const PullingReport& report) {
  Table table{"measured", "given trials", {}};
  for (const calibration::MeasuredTrial& each : report.measured) {
    findings::Texts runs;
    for (const calibration::SimulatedTrial& trial : report.trials)
      if (calibration::find_matching(trial, report.measured) == &each)
        runs.push_back(std::to_string(trial.run));
    const double n = calibration::normal_force(each.trial.setup);
    const Value f =
        each.fault.empty() ? Value(calibration::mean_resistance(*each.averages)) : Value();
    add_row(
        table,
        {{{"name", "given trial"}, each.trial.name},
         {{"origin", "origin"},
          calibration::names_of_origins()[static_cast<std::size_t>(each.trial.setup.origin)]},
         {{"resistance_n", "f_r", {".2f", "N"}}, f},
         {{"normal_force_n", "N", {".0f", "N"}}, n},
         {{"", "f_r/N", {".5f"}}, each.fault.empty() ? Value(std::get<double>(f) / n) : Value()},
         {{"", "like run"},
          !each.fault.empty() ? "not used"
          : runs.empty()      ? "none"
                              : fmt::format("{}", fmt::join(runs, ", "))},
         {"fault", each.fault.empty() ? Value() : Value(each.fault)}});
  }
  return table;
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
  Texts without_kinetic;
  for (const calibration::TrialFault& f : c.without_kinetic) without_kinetic.push_back(f.text());
  trials.list("trials_without_kinetic_friction", "Without mu_k", without_kinetic);
  fit.add(values_table(c)).add(pulls_table(c));
  diagnostics.add(tests_table(c)).add(crosswise_table(c)).add(outliers_table(c));
  validation.add(validation_table(c));
  validation.list("validation_without_constant", "Without a constant", c.unpredicted);
  Table written{"caster_files", "Files", {}};
  for (const calibration::CasterFile& f : casters)
    add_row(written, {{{"file", "file"}, f.name},
                      {{"calibrated", "keys from trials"}, f.calibrated},
                      {"text", f.text}});
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

std::string noise_words(const PullingReport& report) {
  if (!report.noise) return "";
  return fmt::format("synthetic noise of {:g} mm and {:g} N (standard deviations), seed {}",
                     kMillimetersPerMeter * calibration::kDisplacementNoise,
                     calibration::kForceNoise, *report.noise);
}

Section pulling_findings(const PullingReport& report) {
  Section all("", report.title);
  all.json("file", report.file).json("note", kNote);
  all.say(fmt::format("{} trials of {}", report.trials.size(), report.file)).say(kNote);
  if (report.noise) all.json("noise", noise_words(report)).say(noise_words(report));
  all.add(bias_table(report)).add(pooled_table(report)).add(casters_table(report));
  all.add(trials_table(report)).add(theory_table(report));
  all.add(measured_table(report)).add(driven_table(report));
  for (const calibration::MeasuredTrial& each : report.measured)
    if (!each.fault.empty()) all.say("not used: " + each.fault);
  for (const calibration::SimulatedTrial& trial : report.trials)
    if (!trial.averages)
      all.say(
          fmt::format("excluded: run {} ({}): {}", trial.run, trial.configuration, trial.fault));
  return all;
}

}  // namespace gurney::report
