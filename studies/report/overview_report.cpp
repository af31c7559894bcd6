#include "studies/report/overview_report.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>

#include "engine/base/units.h"
#include "studies/report/formats.h"
#include "studies/report/study_report.h"

namespace gurney::report {
namespace {

using findings::Format;
using findings::List;
using findings::Section;
using findings::Table;
using findings::Texts;
using findings::Value;

constexpr std::size_t kMaxLines = 20;

Section records(const study::FileOverview& file) {
  Section all;
  Table table{"records", "", json_columns({"name", "files", "warnings"})};
  List lines{"", fmt::format("{} records", file.motions.size()), {}, kMaxLines};
  for (const auto& motion : file.motions) {
    table.add({motion.name, motion.files, motion.warnings});
    std::string line = motion.name + (motion.files.empty() ? ", synthetic" : "");
    for (const std::string& each : motion.files) line += "\n" + each;
    for (const std::string& each : motion.warnings) line += "\nwarning: " + each;
    lines.lines.push_back(line);
  }
  all.add(std::move(table));
  if (lines.lines.empty()) return all.text("records", "none, the floor is at rest");
  return all.add(std::move(lines));
}

void add_energy(const study::FileOverview& file, const std::string& worst, Section& all) {
  all.fact("energy_closure", "energy closes within", file.energy_closure, {".2g"},
           "a fraction of the energy in play" + worst);
}

Section distributions(const char* key, const char* name, bool ratios,
                      const std::vector<study::StepDistribution>& of) {
  Section all;
  const Format number{".3g"}, ends_of = interval_format(number);
  Table table{key, "", {}};
  for (const study::StepDistribution& each : of) {
    const auto& interval = each.of.interval;
    const bool bounded = each.of.pairs > 1;
    const auto bound = [&](double value) { return bounded ? Value(value) : Value(); };
    add_row(table,
            {{{name, ratios ? "demand" : "limit state"}, each.name},
             {{"records", "records"}, each.of.pairs},
             {{"mean_at_step", ratios ? "" : "P at the step", number}, each.of.mean_a},
             {{"mean_at_half_step", ratios ? "" : "P at half of it", number}, each.of.mean_b},
             {{"difference", ratios ? "" : "difference", number}, each.of.difference},
             {{"", ratios ? "median at half the step over that at the step" : "", number},
              std::exp(each.of.difference)},
             {{"", "95 % interval", ends_of},
              !bounded ? Value()
              : ratios ? Value(findings::Numbers{std::exp(interval.low), std::exp(interval.high)})
                       : ends(interval)},
             {"low", bound(interval.low)},
             {"high", bound(interval.high)},
             {"p", each.of.p_permutation}});
  }
  return all.add(std::move(table));
}

Section chaotic_steps(const study::ChaoticStepCheck& of) {
  Section all{"chaotic",
              fmt::format("{} of them are of chaotic cases, whose replicas part: no step gives "
                          "them a number, so distributions are compared, by records",
                          of.runs)};
  all.json("runs", of.runs);
  all.add(distributions("ln_demands", "demand", true, of.demands));
  return all.add(distributions("limit_states", "limit_state", false, of.states));
}

}  // namespace

findings::Section provenance_findings(const study::FileOverview& file, const std::string& what) {
  Section all;
  all.fact("file", "file", file.path, {}, what)
      .fact("program_version", "gurney", file.program_version);
  all.fact("git_commit", "commit", file.git_commit).fact("compiler", "compiler", file.compiler);
  all.fact("cpu_class", "CPU class", file.cpu_class).fact("job_name", "job", file.job_name);
  all.fact("job_sha256", "SHA-256 of the job", file.job_sha256);
  return all.fact("seed", "seed", file.seed.empty() ? Value() : Value(file.seed));
}

findings::Section undrawn_findings(const std::optional<study::UndrawnRanges>& undrawn) {
  Section all;
  if (!undrawn || undrawn->parameters() == 0) {
    all.json("ranges_not_drawn", undrawn ? Value(Texts{}) : Value());
    return all.text("uncertainties not propagated", undrawn ? "none" : "not stated in this file");
  }
  return all.list("ranges_not_drawn",
                  "uncertainties not propagated, parameters with a range that keep their values",
                  undrawn->lines());
}

findings::Section assumption_findings(const study::FileOverview& file) {
  Section all;
  Table table{"assumptions",
              fmt::format("{} parameter{} without a source, with a value, a range in which it may "
                          "lie, and the reason for both",
                          file.assumptions.size(), file.assumptions.size() == 1 ? "" : "s"),
              {}};
  for (const auto& each : file.assumptions)
    add_row(table, {{{"key", "parameter"}, each.key},
                    {{"value", "value"}, each.value},
                    {{"range", "range"}, each.range},
                    {{"reason", "reason"}, each.reason},
                    {{"file", "data file"}, each.file}});
  table.most = 0;
  all.add(std::move(table));
  return all.say(file.assumptions.empty() ? "Every parameter has a source." : "");
}

findings::Section design_findings(const study::StudyOverview& overview) {
  Section all;
  Table factors{"factors", "", {{"name", ""}, {"levels", ""}}},
      states{"limit_states", "", json_columns({"name", "words", "origin"})};
  for (const auto& each : overview.factors) {
    factors.add({each.name, each.levels});
    all.text("factor " + each.name, each.levels);
  }
  all.json("configurations", overview.configurations);
  all.text("configurations", overview.configurations.size());
  const study::ReportUnit turn = overview.units.of("rad");
  all.fact("angles_deg", "angles", overview.angles,
           {"g", turn.name, turn.in_si, kRadiansPerDegree});
  all.json("intensity_measure", overview.measure);
  all.fact("levels", overview.measure.empty() ? "records" : "intensity, " + overview.measure,
           overview.levels);
  all.json("suite_by_level", overview.suite_by_level);
  if (overview.suite_by_level) all.text("records", "a suite for each level");
  if (overview.factors_on_records.any())
    all.add(scale_factor_findings(overview.factors_on_records));
  all.json("draws", overview.draws).json("replicas", overview.replicas);
  all.text("draws", overview.draws > 0 ? fmt::format("{} of each record", overview.draws)
                                       : "none: every parameter has its value");
  if (overview.replicas > 1)
    all.text("replicas", fmt::format("{} of each draw", overview.replicas));
  for (const study::LimitState& each : overview.states) {
    states.add({each.name, each.words, each.origin});
    all.text("limit state " + each.name,
             each.words + (each.origin.empty() ? "" : " (" + each.origin + ")"));
  }
  return all.add(std::move(factors)).add(std::move(states));
}

findings::Table share_findings(const study::StudyOverview& overview) {
  Table table{"counts",
              "share of the runs that exceed a limit state; failed runs are not counted",
              {{"configuration", ""},
               {"", "configuration"},
               {"level", overview.measure.empty() ? "records" : overview.measure},
               {"runs", "runs"},
               {"overturned", "any overturned", {}, "runs in which any item overturned"},
               {"failed", "failed"}}};
  for (const study::LimitState& state : overview.states) {
    table.columns.push_back({"exceeded." + state.name, ""});
    table.columns.push_back({"", state.name, {".3g", "%", 0.01}, state.words});
  }
  for (const study::LevelCounts& each : overview.counts) {
    const auto counted = static_cast<double>(each.counted());
    table.add({each.configuration, each.configuration.empty() ? "all runs" : each.configuration,
               each.level, each.runs, each.overturned, each.failed});
    for (const std::size_t exceeded : each.exceeded) {
      table.rows.back().emplace_back(exceeded);
      table.rows.back().emplace_back(static_cast<double>(exceeded) / counted);
    }
  }
  return table;
}

findings::Table failure_findings(const study::StudyOverview& overview) {
  Table table{"failures", "runs that failed, why, and the command that re-runs each", {}};
  for (const study::FailedRun& each : overview.failures)
    add_row(table, {{{"run", "run"}, each.run},
                    {{"cause", "cause"}, each.cause},
                    {{"replay", "command"}, each.command}});
  table.most = kMaxLines;
  return table;
}

findings::Section step_check_findings(const study::StepCheck& of) {
  const Format percent{".0f", "%", 0.01}, two{".2g"};
  Section all{"step_check", "time step"};
  all.json("runs", of.runs);
  all.say(fmt::format("{} runs were repeated with half the step; relative change of their demands",
                      of.runs));
  all.json("failed", of.failed);
  if (of.failed > 0)
    all.say(fmt::format("{} further repetition{} failed", of.failed, of.failed == 1 ? "" : "s"));
  if (of.chaotic) all.add(chaotic_steps(*of.chaotic));
  Table demands{"demands", "", {}};
  for (const study::StepChange& each : of.changes) {
    const auto known = [&](double value) { return each.compared > 0 ? Value(value) : Value(); };
    add_row(demands,
            {{"demand", each.demand},
             {"point", each.point.empty() ? Value() : Value(each.point)},
             {{"", "demand"}, study::name_of(each)},
             {{"compared", "compared"}, each.compared},
             {{"share_within_1_percent", "within 1 %", percent}, known(each.within_1_percent)},
             {{"share_within_5_percent", "within 5 %", percent}, known(each.within_5_percent)},
             {{"median_relative_change", "median", two}, known(each.median)},
             {{"largest_relative_change", "largest", two}, known(each.largest)},
             {{"largest_in_run", "in run"}, each.largest > 0 ? Value(each.largest_run) : Value()}});
  }
  all.add(std::move(demands));
  const std::size_t numbers = of.runs - (of.chaotic ? of.chaotic->runs : 0);
  Table states{"limit_states", "", {}};
  for (const study::StateChange& each : of.states) {
    add_row(states, {{"limit_state", each.state},
                     {"changed_runs", findings::Counts(each.runs.begin(), each.runs.end())}});
    all.say(fmt::format("{}: a different outcome in {} of {} runs", each.state, each.runs.size(),
                        numbers));
  }
  return all.add(std::move(states))
      .list("not_compared", "not compared, the repeated runs keep only demands of items and points",
            of.unjudged);
}

findings::Section energy_findings(const study::StudyOverview& overview) {
  Section all;
  all.json("energy_closure_run", overview.energy_closure_run);
  add_energy(overview.file, fmt::format(" (worst: run {})", overview.energy_closure_run), all);
  return all;
}

findings::Section outcome_findings(const study::RunOverview& overview) {
  Section all;
  all.json("outcome", overview.outcome).json("cause", overview.cause);
  all.json("end_time", overview.end_time);
  all.text("outcome", fmt::format("{} at {:.4g} s{}{}", overview.outcome, overview.end_time,
                                  overview.cause.empty() ? "" : ": ", overview.cause));
  add_energy(overview.file, "", all);
  return all;
}

findings::Section overview_findings(const study::StudyOverview& overview) {
  Section all{"", overview.file.title};
  all.json("filetype", "gurney-study").json("title", overview.file.title);
  all.add(provenance_findings(overview.file, fmt::format("a study of {} runs", overview.runs)));
  all.add(design_findings(overview));
  all.list("demands_not_in_file", "demands not in this file", overview.missing_demands);
  all.fact("runs", "runs", overview.runs, {},
           fmt::format("{} overturned, {}", overview.overturned,
                       failed_runs(overview.failed, overview.untrusted)));
  all.json("overturned", overview.overturned).json("failed", overview.failed);
  all.json("untrusted", overview.untrusted).json("warned", overview.warned);
  const findings::Texts of_runs = warning_cautions(overview);
  for (const std::string& warnings : of_runs) all.text("warnings", warnings);
  all.list("run_warnings", "", of_runs);
  all.add(energy_findings(overview)).list("warnings", "warnings", overview.file.warnings);
  all.add(assumption_findings(overview.file)).add(undrawn_findings(overview.undrawn));
  all.add(records(overview.file));
  all.add(share_findings(overview)).add(failure_findings(overview));
  if (overview.step_check) return all.add(step_check_findings(*overview.step_check));
  return all.json("step_check", Value());
}

findings::Section overview_findings(const study::RunOverview& overview,
                                    const study::UnitSystem& units) {
  Section all{"", overview.file.title};
  all.json("filetype", "gurney-results").json("title", overview.file.title);
  all.add(provenance_findings(overview.file, "one run"));
  all.add(outcome_findings(overview)).list("warnings", "warnings", overview.file.warnings);
  all.add(assumption_findings(overview.file));
  all.add(records(overview.file));
  Table items{"items", "largest and last displacement and largest speed against the floor", {}};
  for (const auto& item : overview.items)
    add_row(items, {{{"name", "item"}, item.name},
                    {{"model", "equipment"}, item.model},
                    {{"peak_displacement", "peak", format_of(units, "m")}, item.peak_displacement},
                    {{"residual_displacement", "residual", format_of(units, "m")},
                     item.residual_displacement},
                    {{"peak_velocity", "speed", format_of(units, "m/s")}, item.peak_velocity},
                    {{"peak_tilt", "tilt", format_of(units, "rad")}, item.peak_tilt},
                    {{"time_of_overturning", "overturned", {".2f", "s"}},
                     item.time_of_overturning < 0 ? Value() : Value(item.time_of_overturning)}});
  all.add(std::move(items));
  if (!units.chosen()) return all;
  Section chosen{"units"};
  chosen.json("peak_displacement", units.of("m").name);
  chosen.json("residual_displacement", units.of("m").name);
  chosen.json("peak_velocity", units.of("m/s").name).json("peak_tilt", units.of("rad").name);
  return all.add(std::move(chosen));
}

}  // namespace gurney::report
