#include "studies/report/pulling_report.h"

#include <fmt/format.h>

#include "engine/base/units.h"
#include "studies/calibration/trials/setup_reader.h"
#include "studies/calibration/trials/trial.h"

namespace gurney::report {
namespace {

using findings::Format;
using findings::Section;
using findings::Table;
using findings::Value;

constexpr const char* kNote =
    "simulated: verifies the method on signals whose input is known; reproduces no measured "
    "finding";

const Format kPercent{"+.2f", "%", 0.01}, kScatter{".2f", "%", 0.01},
    kMilliseconds{".4g", "ms", 1e-3};

Table bias_table(const PullingReport& report) {
  Table table{"bias",
              "f_r by the paper's method minus f_r of the input, % of it: mean and standard "
              "deviation over trials",
              {{"alignment", "alignment"},
               {"trials", "trials"},
               {"pulled.mean", "phase II", kPercent},
               {"pulled.standard_deviation", "+-", kScatter},
               {"coasting.mean", "phase III", kPercent},
               {"coasting.standard_deviation", "+-", kScatter},
               {"both.mean", "of both", kPercent},
               {"both.standard_deviation", "+-", kScatter}}};
  for (const calibration::AlignmentBias& row : calibration::bias_by_alignment(report.trials))
    table.add({name_of(row.alignment), row.trials, row.pulled.mean, row.pulled.deviation,
               row.coasting.mean, row.coasting.deviation, row.mean.mean, row.mean.deviation});
  return table;
}

Table pooled_table(const PullingReport& report) {
  Table table{"pooled",
              "Cr/R of pooled trials minus that of the input, % of it: fit through the origin",
              {{"trials", "trials"},
               {"both", "both phases", kPercent},
               {"coasting", "phase III", kPercent},
               {"of", "of"}}};
  for (const calibration::PooledBias& row : calibration::pooled_biases(report.trials))
    table.add({row.trials, row.both, row.coasting, row.trials_of});
  return table;
}

Table casters_table(const PullingReport& report) {
  Table table{"casters",
              "Cr/R of aligned trials",
              {{"caster", "caster"},
               {"wheel_radius_m", ""},
               {"trials", "aligned"},
               {"cr_over_r_found", "Cr/R found", {".5f"}},
               {"cr_over_r_known", "input", {".5f"}},
               {"", "difference", kPercent}}};
  for (const calibration::CasterFit& fit : calibration::fits_by_caster(report.trials))
    table.add({fit.caster, fit.wheel_radius, fit.trials, fit.found, fit.known,
               fit.found / fit.known - 1});
  return table;
}

bool is_aligned(const calibration::SimulatedTrial& trial) {
  return trial.alignment == calibration::Alignment::kAligned;
}

/// Every trial, for programs.
Table trials_table(const PullingReport& report) {
  Table table{"trials", "", {}};
  for (const char* key : {"run",
                          "configuration",
                          "caster",
                          "floor",
                          "alignment",
                          "solver",
                          "time_step_s",
                          "normal_force_n",
                          "resistance_known_n",
                          "left_flooring",
                          "phases.start_s",
                          "phases.release_s",
                          "phases.stop_s",
                          "phases.end",
                          "resistance_pulled_n",
                          "resistance_coasting_n",
                          "fault",
                          "error_at_release",
                          "error_at_rest",
                          "driven_by.trial",
                          "driven_by.error_at_release",
                          "driven_by.error_of_speed",
                          "driven_by.error_at_rest",
                          "driven_by.largest_difference_m"})
    table.columns.push_back({key, ""});
  for (const calibration::SimulatedTrial& trial : report.trials) {
    std::vector<findings::Cell> row{trial.run,
                                    trial.configuration,
                                    trial.trial.setup.caster,
                                    trial.trial.setup.floor,
                                    name_of(trial.alignment),
                                    trial.solver,
                                    trial.time_step,
                                    trial.theory.normal_force,
                                    trial.theory.resistance,
                                    trial.left_flooring};
    const auto add = [&](bool is_there, std::initializer_list<Value> values) {
      for (const Value& each : values) row.emplace_back(is_there ? each : Value());
    };
    const calibration::Phases phases = trial.phases.value_or(calibration::Phases{});
    add(trial.phases.has_value(), {phases.start, phases.release, phases.stop, name_of(phases.end)});
    const bool found = trial.averages.has_value();
    const calibration::Resistance resistance =
        found ? calibration::average_method(*trial.averages) : calibration::Resistance{};
    add(found, {resistance.pulled, resistance.coasting});
    add(!found, {trial.fault});
    const calibration::TheoryError error = calibration::theory_error(trial);
    add(is_aligned(trial), {error.release, error.rest});
    const auto driven = calibration::driven_error(trial, report.measured);
    const auto of = driven.value_or(calibration::DrivenError{});
    add(driven.has_value(), {trial.driven_by, of.release, of.speed, of.rest, of.largest});
    table.add(std::move(row));
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
               {"", "at release", kPercent},
               {"", "at rest", kPercent},
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
              {{"", "run"},
               {"", "solver"},
               {"", "step", kMilliseconds},
               {"", "at release", kPercent},
               {"", "speed", kPercent},
               {"", "at rest", kPercent},
               {"", "largest", {".1f", "mm", 1e-3}},
               {"", "trial"}}};
  for (const calibration::SimulatedTrial& trial : report.trials)
    if (const auto error = calibration::driven_error(trial, report.measured))
      table.add({trial.run, trial.solver, trial.time_step, error->release, error->speed,
                 error->rest, error->largest, trial.driven_by});
  return table;
}

Table measured_table(const PullingReport& report) {
  Table table{"measured",
              "given trials",
              {{"name", "given trial"},
               {"origin", "origin"},
               {"resistance_n", "f_r", {".2f", "N"}},
               {"normal_force_n", "N", {".0f", "N"}},
               {"", "f_r/N", {".5f"}},
               {"", "like run"},
               {"fault", ""}}};
  for (const calibration::MeasuredTrial& each : report.measured) {
    findings::Texts runs;
    for (const calibration::SimulatedTrial& trial : report.trials)
      if (calibration::find_matching(trial, report.measured) == &each)
        runs.push_back(std::to_string(trial.run));
    const double n = calibration::normal_force(each.trial.setup);
    const Value f =
        each.fault.empty() ? Value(calibration::mean_resistance(*each.averages)) : Value();
    table.add({each.trial.name,
               calibration::names_of_origins()[static_cast<std::size_t>(each.trial.setup.origin)],
               f, n, each.fault.empty() ? Value(std::get<double>(f) / n) : Value(),
               !each.fault.empty() ? "not used"
               : runs.empty()      ? "none"
                                   : fmt::format("{}", fmt::join(runs, ", ")),
               each.fault.empty() ? Value() : Value(each.fault)});
  }
  return table;
}

}  // namespace

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
