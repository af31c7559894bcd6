#include "studies/report/pulling_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "engine/base/units.h"
#include "studies/calibration/trials/instrument_noise.h"
#include "studies/calibration/trials/setup_reader.h"
#include "studies/report/json_values.h"

namespace gurney::report {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* kNote =
    "simulated: verifies the method on signals whose input is known; reproduces no measured "
    "finding";

/// JSON has no NaN.
std::string percent(double share) {
  return std::isfinite(share) ? fmt::format("{:+.2f}", 100 * share) : "-";
}

std::string cell(const calibration::MeanAndScatter& of) {
  return fmt::format("{:>8} {:>7}", percent(of.mean),
                     std::isfinite(of.deviation) ? fmt::format("{:.2f}", 100 * of.deviation) : "-");
}

std::string bias_text(const PullingReport& report) {
  std::string text =
      "\nf_r by the paper's method minus f_r of the input, % of it: mean and standard deviation "
      "over "
      "trials\n"
      "alignment   trials      phase II         phase III         of both\n";
  for (const calibration::AlignmentBias& row : calibration::bias_by_alignment(report.trials))
    text += fmt::format("{:<11} {:>6}  {}  {}  {}\n", name_of(row.alignment), row.trials,
                        cell(row.pulled), cell(row.coasting), cell(row.mean));
  return text;
}

std::string pooled_text(const PullingReport& report) {
  const auto rows = calibration::pooled_biases(report.trials);
  if (rows.empty()) return "";
  std::string text =
      "\nCr/R of pooled trials minus that of the input, % of it: fit through the origin\n"
      "trials   both phases   phase III   of\n";
  for (const calibration::PooledBias& row : rows)
    text += fmt::format("{:>6}   {:>11}   {:>9}   {}\n", row.trials, percent(row.both),
                        percent(row.coasting), row.trials_of);
  return text;
}

std::string driven_text(const PullingReport& report) {
  std::string text;
  for (const calibration::SimulatedTrial& trial : report.trials)
    if (const auto error = calibration::driven_error(trial, report.measured))
      text += fmt::format("{:<4} {:<15} {:>10.4g} {:>11} {:>8} {:>9} {:>10.1f}   {}\n", trial.run,
                          trial.solver, 1000 * trial.time_step, percent(error->release),
                          percent(error->speed), percent(error->rest),
                          kMillimetersPerMeter * error->largest, trial.driven_by);
  if (text.empty()) return "";
  return "\nsimulated under the force of a given trial, for its duration, minus that trial: "
         "displacement and speed at release, displacement at rest, % (-: left the flooring); "
         "largest difference of the displacement\n"
         "run  solver           step (ms)  at release    speed   at rest      (mm)    trial\n" +
         text;
}

std::string fits_text(const PullingReport& report) {
  std::string text = "\ncaster      aligned   Cr/R found     input   difference (%)\n";
  for (const calibration::CasterFit& fit : calibration::fits_by_caster(report.trials))
    text += fmt::format("{:<11} {:>7}   {:>10.5f}   {:>7.5f}   {:>9}\n", fit.caster, fit.trials,
                        fit.found, fit.known, percent(fit.found / fit.known - 1));
  return text;
}

std::string theory_text(const PullingReport& report) {
  std::string text =
      "\naligned trials against the closed form: error of the displacement, % (-: left the "
      "flooring)\n"
      "run  solver           step (ms)  at release    at rest   configuration\n";
  for (const calibration::SimulatedTrial& trial : report.trials) {
    if (trial.alignment != calibration::Alignment::kAligned) continue;
    const calibration::TheoryError error = calibration::theory_error(trial);
    text += fmt::format("{:<4} {:<15} {:>10.4g} {:>11} {:>10}   {}\n", trial.run, trial.solver,
                        1000 * trial.time_step, percent(error.release), percent(error.rest),
                        trial.configuration);
  }
  return text;
}

std::string measured_text(const PullingReport& report) {
  if (report.measured.empty()) return "";
  std::string text = "\ngiven trial          origin       f_r (N)   N (N)   f_r/N     like run\n";
  std::string faults;
  for (const calibration::MeasuredTrial& each : report.measured) {
    if (!each.fault.empty()) {
      faults += "not used: " + each.fault + "\n";
      continue;
    }
    std::string runs;
    for (const calibration::SimulatedTrial& trial : report.trials)
      if (calibration::find_matching(trial, report.measured) == &each)
        runs += fmt::format("{}{}", runs.empty() ? "" : ", ", trial.run);
    const double f = calibration::mean_resistance(*each.averages),
                 n = calibration::normal_force(each.trial.setup);
    text += fmt::format(
        "{:<20} {:<10} {:>9.2f} {:>7.0f}   {:.5f}   {}\n", each.trial.name,
        calibration::names_of_origins()[static_cast<std::size_t>(each.trial.setup.origin)], f, n,
        f / n, runs.empty() ? "none" : runs);
  }
  return text + faults;
}

Json phases_json(const calibration::SimulatedTrial& trial) {
  if (!trial.phases) return {};
  return {{"start_s", trial.phases->start},
          {"release_s", trial.phases->release},
          {"stop_s", trial.phases->stop},
          {"end", name_of(trial.phases->end)}};
}

Json trial_json(const calibration::SimulatedTrial& trial) {
  const calibration::TheoryError error = calibration::theory_error(trial);
  Json json{{"run", trial.run},
            {"configuration", trial.configuration},
            {"caster", trial.trial.setup.caster},
            {"floor", trial.trial.setup.floor},
            {"alignment", name_of(trial.alignment)},
            {"solver", trial.solver},
            {"time_step_s", trial.time_step},
            {"normal_force_n", trial.theory.normal_force},
            {"resistance_known_n", trial.theory.resistance},
            {"left_flooring", trial.left_flooring},
            {"phases", phases_json(trial)}};
  if (trial.averages) {
    const calibration::Resistance found = calibration::average_method(*trial.averages);
    json["resistance_pulled_n"] = json_number(found.pulled);
    json["resistance_coasting_n"] = json_number(found.coasting);
  } else {
    json["fault"] = trial.fault;
  }
  if (trial.alignment == calibration::Alignment::kAligned) {
    json["error_at_release"] = json_number(error.release);
    json["error_at_rest"] = json_number(error.rest);
  }
  return json;
}

Json scatter(const calibration::MeanAndScatter& of) {
  return {{"mean", json_number(of.mean)}, {"standard_deviation", json_number(of.deviation)}};
}

}  // namespace

std::string noise_words(const PullingReport& report) {
  if (!report.noise) return "";
  return fmt::format("synthetic noise of {:g} mm and {:g} N (standard deviations), seed {}",
                     kMillimetersPerMeter * calibration::kDisplacementNoise,
                     calibration::kForceNoise, *report.noise);
}

std::string pulling_text(const PullingReport& report) {
  std::string text = fmt::format("{}\n{} trials of {}\n{}\n", report.title, report.trials.size(),
                                 report.file, kNote);
  if (report.noise) text += noise_words(report) + "\n";
  text += bias_text(report) + pooled_text(report) + fits_text(report) + theory_text(report) +
          measured_text(report) + driven_text(report);
  for (const calibration::SimulatedTrial& trial : report.trials)
    if (!trial.averages)
      text +=
          fmt::format("excluded: run {} ({}): {}\n", trial.run, trial.configuration, trial.fault);
  return text;
}

std::string pulling_json(const PullingReport& report) {
  Json json{{"file", report.file}, {"note", kNote}};
  if (report.noise) json["noise"] = noise_words(report);
  for (const calibration::AlignmentBias& row : calibration::bias_by_alignment(report.trials))
    json["bias"].push_back({{"alignment", name_of(row.alignment)},
                            {"trials", row.trials},
                            {"pulled", scatter(row.pulled)},
                            {"coasting", scatter(row.coasting)},
                            {"both", scatter(row.mean)}});
  for (const calibration::PooledBias& row : calibration::pooled_biases(report.trials))
    json["pooled"].push_back({{"of", row.trials_of},
                              {"trials", row.trials},
                              {"both", json_number(row.both)},
                              {"coasting", json_number(row.coasting)}});
  for (const calibration::CasterFit& fit : calibration::fits_by_caster(report.trials))
    json["casters"].push_back({{"caster", fit.caster},
                               {"wheel_radius_m", fit.wheel_radius},
                               {"trials", fit.trials},
                               {"cr_over_r_found", fit.found},
                               {"cr_over_r_known", fit.known}});
  for (const calibration::SimulatedTrial& trial : report.trials) {
    Json each = trial_json(trial);
    if (const auto error = calibration::driven_error(trial, report.measured))
      each["driven_by"] = {{"trial", trial.driven_by},
                           {"error_at_release", json_number(error->release)},
                           {"error_of_speed", json_number(error->speed)},
                           {"error_at_rest", json_number(error->rest)},
                           {"largest_difference_m", json_number(error->largest)}};
    json["trials"].push_back(each);
  }
  for (const calibration::MeasuredTrial& each : report.measured)
    json["measured"].push_back(
        {{"name", each.trial.name},
         {"origin",
          calibration::names_of_origins()[static_cast<std::size_t>(each.trial.setup.origin)]},
         {"resistance_n",
          each.fault.empty() ? json_number(calibration::mean_resistance(*each.averages)) : Json()},
         {"normal_force_n", calibration::normal_force(each.trial.setup)},
         {"fault", each.fault.empty() ? Json() : Json(each.fault)}});
  return json.dump(2) + "\n";
}

}  // namespace gurney::report
