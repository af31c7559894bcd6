#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "studies/figures/pulling_figures.h"
#include "studies/page/calibration_facts.h"
#include "studies/page/drawing.h"
#include "studies/page/json_pages.h"
#include "studies/page/study_page.h"
#include "studies/page/table.h"

namespace gurney::page {
namespace {

const study::ReportUnit kPlain{"", 1}, kPercent{"%", 0.01};

using Constants = std::vector<FittedConstant>;

std::vector<std::string> cautions_of(const JsonValue& all, const Constants& constants) {
  std::vector<std::string> texts;
  if (const std::size_t simulated = all.count("simulated"); simulated > 0)
    texts.push_back(fmt::format("SIMULATED: {} of {} are not measured, but computed.", simulated,
                                counted(all.count("trials"), "trial")));
  for (const FittedConstant& each : constants) {
    if (each.lower_bound)
      texts.push_back(each.about +
                      " is a lower bound: with all wheels locked they do not break away at once.");
    else if (!each.interval.bounded())
      texts.push_back(each.about + " comes from one trial, which gives no interval.");
  }
  for (const JsonValue& each : all.objects("outliers"))
    texts.push_back(fmt::format("{} does not go with the others of {} (p {:.2g}); it is kept.",
                                each.text("trial"), each.text("constant"),
                                each.number("p_adjusted")));
  for (const JsonValue& each : all.objects("validation"))
    if (!each.flag("inside"))
      texts.push_back(
          fmt::format("{}, kept for validation, is outside the 95 % interval of its "
                      "prediction.",
                      each.text("trial")));
  if (all.objects("validation").empty())
    texts.emplace_back(
        "No trial is reserved for validation: the accuracy of predictions is unknown.");
  return texts;
}

Table constants_table(const Constants& constants) {
  Table table{"Constants",
              {{"Constant"},
               {"Value", true},
               {"Unit"},
               {"95 % interval", false, "confidence interval by Student's t"},
               {"Scatter (%)", true, "standard deviation of the logarithm between trials"},
               {"Trials", true},
               {"95 % of one more trial"}}};
  for (const FittedConstant& each : constants)
    table.rows.push_back({each.about, Cell(each.value, kPlain, 4), each.unit, each.interval.text(),
                          Cell(each.scatter, kPercent, 2), Cell(each.used),
                          each.prediction.text()});
  return table;
}

Section summary(const JsonValue& all, const Constants& constants) {
  const std::size_t excluded = all.objects("left_out").size();
  Html content = facts({{"Trials", fmt::format("{}, {} excluded", all.count("trials"), excluded)},
                        {"Read from", all.text("source")},
                        {"Constants", std::to_string(constants.size())},
                        {"Caster files", std::to_string(all.objects("caster_files").size())}});
  if (const auto cautions = cautions_of(all, constants); !cautions.empty())
    content += element("div", element("h3", "Cautions") + list(cautions), {{"class", "cautions"}});
  return {"summary", "At a glance", content + html(constants_table(constants))};
}

Section trials(const JsonValue& all) {
  Table table{"Trials",
              {{"Trial"},
               {"Kind"},
               {"Use"},
               {"Origin"},
               {"Caster"},
               {"Floor"},
               {"Against"},
               {"Mass (kg)", true},
               {"Excluded"}}};
  Table files{"Files of the trials", {{"File"}, {"SHA-256"}}};
  for (const JsonValue& each : all.objects("trial_files")) {
    table.rows.push_back({each.text("trial"), each.text("kind"), each.text("use"),
                          each.text("origin"), each.text("caster"), each.text("floor"),
                          each.text("against"), Cell(each.number("mass_kg"), kPlain, 5),
                          each.text("excluded")});
    if (const std::string hash = each.text("sha256"); !hash.empty())
      if (files.rows.empty() || files.rows.back()[0].text != each.text("file"))
        files.rows.push_back({each.text("file"), hash});
  }
  Html content = html(table);
  if (!files.rows.empty()) content += folded("Files, as they were read", html(files));
  return {"trials", "What was measured", content};
}

Html load_drawing(const JsonValue& all, const Constants& constants) {
  std::vector<figures::LoadLine> lines;
  const std::vector<JsonValue> pulls = all.objects("pulls");
  for (const FittedConstant& each : constants) {
    if (each.name != "rolling_resistance") continue;
    figures::LoadLine line{
        fmt::format("{} on {}: Cr/R {:.4g}", each.caster, each.floor, each.value),
        each.value,
        {each.interval.low, each.interval.high},
        {each.prediction.low, each.prediction.high},
        {},
        {}};
    for (const JsonValue& pull : pulls) {
      if (pull.text("caster") != each.caster || pull.text("floor") != each.floor) continue;
      line.load.push_back(pull.number("normal_force_n"));
      line.resistance.push_back(pull.number("resistance_n"));
    }
    lines.push_back(line);
  }
  if (pulls.empty() || lines.empty()) return {};
  return html(Drawing{"loads", figures::load_figure({.width = 480}, lines),
                      "Rolling resistance of the pulls, and the fitted lines f_r = (Cr/R) N.",
                      "Marks are pulls for calibration; lines start at the origin. The numbers are "
                      "in the table of pulls below."});
}

Html residual_drawing(const Constants& constants) {
  std::vector<figures::ResidualRow> rows;
  for (const FittedConstant& each : constants) {
    const auto over = [&](const Ends& ends) {
      return figures::Range{ends.low / each.value, ends.high / each.value};
    };
    rows.push_back({each.about, {}, over(each.interval), over(each.prediction)});
    for (const FittedTrial& trial : each.trials)
      rows.back().trials.push_back(
          {trial.value / each.value, trial.error / each.value, trial.validation});
  }
  return html(Drawing{"residuals", figures::residual_figure({.width = 480}, rows),
                      "Values of the single trials against the constants.",
                      "One row for each constant. The numbers are in the table of residuals."});
}

Section fit(const JsonValue& all, const Constants& constants) {
  Table table{
      "Values of the trials, and residuals",
      {{"Trial"},
       {"Constant"},
       {"Use"},
       {"Value", true},
       {"Standard error", true, "of the measurement"},
       {"Residual (%)", true, "value over the constant, less one"},
       {"Standardized", true,
        "logarithm of value over constant, over its standard deviation: scatter and error"}}};
  for (const FittedConstant& each : constants)
    for (const FittedTrial& trial : each.trials)
      table.rows.push_back({trial.trial, each.about,
                            trial.validation ? "validation" : "calibration",
                            Cell(trial.value, kPlain, 4), Cell(trial.error, kPlain, 2),
                            Cell(trial.value / each.value - 1, kPercent, 3),
                            Cell(each.standardised(trial), kPlain, 3)});
  Table pulls{"Pulls",
              {{"Trial"},
               {"Normal force (N)", true},
               {"Pull force (N)", true},
               {"a2 (m/s2)", true, "acceleration while pulled"},
               {"a3 (m/s2)", true, "deceleration while coasting"},
               {"f_r pulled (N)", true},
               {"f_r coasting (N)", true},
               {"f_r (N)", true, "mean of both, weighted by their errors"},
               {"Standard error (N)", true}}};
  for (const JsonValue& each : all.objects("pulls")) {
    std::vector<Cell> cells{each.text("trial")};
    for (const char* key :
         {"normal_force_n", "pull_force_n", "pull_acceleration_mps2", "coast_deceleration_mps2",
          "resistance_pulled_n", "resistance_coasting_n", "resistance_n", "resistance_error_n"})
      cells.emplace_back(each.number(key), kPlain, 4);
    pulls.rows.push_back(cells);
  }
  return {"fit", "Fit",
          element("div", load_drawing(all, constants) + residual_drawing(constants),
                  {{"class", "figures"}}) +
              html(table) + html(pulls)};
}

std::string verdict(const JsonValue& test, const Ends& ends) {
  constexpr double kClear = 0.05;
  const double supposed = test.number("supposed");
  if (test.number("p_adjusted") < kClear) return fmt::format("differs from {:.3g}", supposed);
  return ends.low <= supposed && supposed <= ends.high
             ? fmt::format("no difference from {:.3g} seen", supposed)
             : "unclear, as one of several tests";
}

Section diagnostics(const JsonValue& all) {
  Table tests{"Does rolling resistance depend on it?",
              {{"On"},
               {"Estimated"},
               {"Estimate", true},
               {"95 % interval"},
               {"Supposed", true, "by f_r = (Cr / R) N"},
               {"p", true},
               {"p of all tests", true, "adjusted for their number (Holm 1979)"},
               {"Result"}}};
  for (const JsonValue& each : all.objects("tests")) {
    const Ends ends = ends_in(each, "interval_95");
    tests.rows.push_back(
        {each.text("name"), each.text("quantity"), Cell(each.number("estimate"), kPlain, 3),
         ends.text(), Cell(each.number("supposed"), kPlain, 3), Cell(each.number("p"), kPlain, 2),
         Cell(each.number("p_adjusted"), kPlain, 2), verdict(each, ends)});
  }
  Table crosswise{"Crosswise pulls",
                  {{"Trial"},
                   {"mu w (mm)", true},
                   {"mu w/4 + T/N (mm)", true, "scrub and swivel friction together"},
                   {"Standard error (mm)", true},
                   {"Cr/R", true},
                   {"Correlation with Cr/R", true},
                   {"Misfit (mm)", true, "root mean square of the residuals of displacement"}}};
  const study::ReportUnit mm{"mm", 0.001};
  for (const JsonValue& each : all.objects("crosswise"))
    crosswise.rows.push_back({each.text("trial"),
                              Cell(each.number("friction_times_width_m"), mm, 3),
                              Cell(each.number("swivel_torque_over_load_m"), mm, 4),
                              Cell(each.number("swivel_torque_over_load_error_m"), mm, 1),
                              Cell(each.number("rolling_resistance"), kPlain, 4),
                              Cell(each.number("correlation_with_rolling_resistance"), kPlain, 2),
                              Cell(each.number("misfit_m"), mm, 2)});
  Html content;
  if (!tests.rows.empty())
    content += html(tests) + paragraph("A large p is no proof: look at the interval.");
  if (!crosswise.rows.empty())
    content += html(crosswise) + paragraph(
                                     "Only the sum of scrub and swivel friction is "
                                     "identifiable at one load.");
  return {"diagnostics", "Diagnostics", content};
}

Section validation(const JsonValue& all) {
  Table table{"Trials that were not used for the estimates",
              {{"Trial"},
               {"Constant"},
               {"Measured", true},
               {"Predicted", true},
               {"95 % interval"},
               {"Misfit (%)", true},
               {"Inside"}}};
  for (const JsonValue& each : all.objects("validation"))
    table.rows.push_back(
        {each.text("trial"), each.text("constant"), Cell(each.number("measured"), kPlain, 4),
         Cell(each.number("predicted"), kPlain, 4), ends_in(each, "prediction_95").text(),
         Cell(each.number("misfit"), kPercent, 3), each.flag("inside") ? "yes" : "NO"});
  return {"validation", "Validation", html(table) + list(all.texts("validation_without_constant"))};
}

Section caster_files(const JsonValue& all) {
  Html content = html(
      Table{"What a caster file takes from the constants",
            {{"Constant"}, {"Key"}, {"Value there"}},
            {{"Cr/R", "tread.rolling_resistance_mm",
              "times the radius of the wheel; the scatter is its lognormal distribution"},
             {"mu_s, mu_k", "tread.static_friction, tread.kinetic_friction",
              "as they are; without a distribution, as mu_s must not be below mu_k in any draw"},
             {"swivel torque over N", "tread.patch_width_mm",
              "4 (torque over N less T/N) / mu_s, with the swivel friction T of the base"},
             {"Cr/R at start, e", "none", "e belongs into [contact] of the item"}}});
  for (const JsonValue& each : all.objects("caster_files")) {
    std::string keys;
    for (const std::string& key : each.texts("calibrated"))
      keys += (keys.empty() ? "" : ", ") + key;
    content += element("h3", each.text("file")) +
               paragraph("From trials: " + keys + ". All else is that of the base.") +
               folded("The file", element("pre", each.text("text"), {{"tabindex", "0"}}));
  }
  return {"casters", "Caster files", content + list(all.texts("without_caster_file"))};
}

Section methods() {
  return {
      "methods", "Methods",
      element("p",
              "The logarithm of a trial's value is the sum of the constant's logarithm, a "
              "scatter between trials and the error of the measurement. The estimate is by "
              "least squares weighted with both variances, the scatter by Paule & Mandel (1982, "
              "J. Res. Natl. Bur. Stand. 87, 377-385), the interval by Student's t with the "
              "covariance of Knapp & Hartung (2003, Statistics in Medicine 22, 2693-2710). "
              "Rolling resistance of a pull is that of Xu, Ma & Kurata (2022, 5th SPONSE "
              "workshop): from the force and the accelerations while pulled and while coasting.",
              {{"class", "methods"}})};
}

}  // namespace

Document calibration_document(const JsonValue& all) {
  const Constants constants = constants_in(all);
  return {"Calibration of casters",
          fmt::format("{} from {}", counted(constants.size(), "constant"),
                      counted(all.count("trials"), "trial")),
          {summary(all, constants),
           trials(all),
           fit(all, constants),
           diagnostics(all),
           validation(all),
           caster_files(all),
           methods(),
           {"provenance", "Provenance",
            facts({{"Program that computed", "gurney " + all.text("program_version")},
                   {"Commit", all.text("git_commit")},
                   {"Trials from", all.text("source")}})}},
          {}};
}

}  // namespace gurney::page
