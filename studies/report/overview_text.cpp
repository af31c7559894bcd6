#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <span>

#include "studies/report/failed_runs.h"
#include "studies/report/overview_report.h"
#include "studies/render/wrapped.h"

namespace gurney::report {
namespace {

constexpr std::ptrdiff_t kMaxLines = 20;

/// Rows of cells; columns as wide as their widest cell, numbers to the right.
class TextTable {
 public:
  explicit TextTable(std::size_t left) : left_(left) {}

  void add(std::vector<std::string> cells) { rows_.push_back(std::move(cells)); }

  std::string text() const {
    std::vector<std::size_t> widths;
    for (const auto& row : rows_) {
      widths.resize(std::max(widths.size(), row.size()), 0);
      for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], row[i].size());
    }
    std::string all;
    for (const auto& row : rows_) {
      std::string line = " ";
      for (std::size_t i = 0; i < row.size(); ++i)
        line += i < left_ ? fmt::format(" {:<{}} ", row[i], widths[i])
                          : fmt::format(" {:>{}} ", row[i], widths[i]);
      all += line.substr(0, line.find_last_not_of(' ') + 1) + "\n";
    }
    return all;
  }

 private:
  std::size_t left_;
  std::vector<std::vector<std::string>> rows_;
};

std::string entry(const std::string& name, const std::string& value) {
  return fmt::format("{:<12}{}\n", name, value);
}

/// The first entries, each of one or more lines, and how many there are more.
std::string shortened(const std::vector<std::string>& entries, const char* what) {
  std::string all;
  std::size_t shown = 0;
  std::ptrdiff_t lines = 0;
  for (; shown < entries.size(); ++shown) {
    lines += 1 + std::ranges::count(entries[shown], '\n');
    if (shown > 0 && lines > kMaxLines) break;
    all += entries[shown] + "\n";
  }
  if (shown < entries.size())
    all += fmt::format("  and {} more {}; --json lists all\n", entries.size() - shown, what);
  return all;
}

std::string head(const study::FileOverview& file, const std::string& what) {
  std::string all = file.title.empty() ? "" : file.title + "\n\n";
  all += entry("file", file.path + ", " + what);
  all +=
      entry("program", fmt::format("gurney {}, commit {}, {}, CPU class {}", file.program_version,
                                   file.git_commit, file.compiler, file.cpu_class));
  all += entry("job", fmt::format("{}, SHA-256 {}", file.job_name, file.job_sha256));
  if (!file.seed.empty()) all += entry("seed", file.seed);
  return all;
}

std::string motions(const study::FileOverview& file) {
  if (file.motions.empty()) return entry("records", "none, the floor is at rest");
  std::vector<std::string> records;
  for (const auto& motion : file.motions) {
    std::string record = "  " + motion.name + (motion.files.empty() ? ", synthetic" : "");
    for (const std::string& each : motion.files) record += "\n    " + each;
    for (const std::string& each : motion.warnings) record += "\n    warning: " + each;
    records.push_back(record);
  }
  return "\n" + entry("records", std::to_string(file.motions.size())) +
         shortened(records, "records");
}

std::string tail(const study::FileOverview& file, const std::string& worst) {
  std::string all;
  if (!std::isnan(file.energy_closure))
    all += entry("energy", fmt::format("closes within {:.2g} of the energy in play{}",
                                       file.energy_closure, worst));
  for (const std::string& each : file.warnings) all += entry("warning", each);
  const std::size_t count = file.assumptions.size();
  all +=
      entry("assumed", count == 0   ? "no parameter without a source"
                       : count == 1 ? "1 parameter without a source, with a reason and a range; "
                                      "--json lists it"
                                    : fmt::format("{} parameters without a source, with a reason "
                                                  "and a range; --json lists them",
                                                  count));
  return all;
}

std::string share(std::size_t count, std::size_t of) {
  return of == 0 ? "-" : fmt::format("{:.3f}", double(count) / double(of));
}

}  // namespace

std::string shares_text(const study::StudyOverview& overview, std::size_t most_rows) {
  TextTable table(2);
  std::vector<std::string> names{"configuration",
                                 overview.measure.empty() ? "records" : overview.measure, "runs",
                                 "overturned", "failed"};
  for (const study::LimitState& state : overview.states) names.push_back(state.name);
  table.add(names);
  const std::size_t shown = std::min(most_rows, overview.counts.size());
  for (const study::LevelCounts& each : std::span(overview.counts).first(shown)) {
    std::vector<std::string> row{each.configuration.empty() ? "-" : each.configuration, each.level,
                                 std::to_string(each.runs), std::to_string(each.overturned),
                                 std::to_string(each.failed)};
    for (const std::size_t exceeded : each.exceeded) row.push_back(share(exceeded, each.counted()));
    table.add(row);
  }
  std::string all = "share of the runs that exceed a limit state; failed runs are not counted\n";
  all += table.text();
  if (shown < overview.counts.size())
    all += fmt::format("  and {} more rows: gurney show\n", overview.counts.size() - shown);
  for (const study::LimitState& state : overview.states)
    if (state.words != state.name) all += fmt::format("  {}: {}\n", state.name, state.words);
  return all;
}

namespace {

std::string failures(const study::StudyOverview& overview) {
  if (overview.failures.empty()) return {};
  std::vector<std::string> lines;
  for (const study::FailedRun& each : overview.failures)
    lines.push_back(fmt::format("  {}: {}\n    {}", each.run, each.cause, each.command));
  return "\nruns that failed, why, and the command that re-runs each\n" + shortened(lines, "runs");
}

/// "0.98 [0.90, 1.07]"
std::string with_interval(double value, double low, double high) {
  return fmt::format("{:.3g} [{:.3g}, {:.3g}]", value, low, high);
}

std::string chaotic_steps(const study::ChaoticStepCheck& of) {
  std::string all = fmt::format(
      "  {} of them are of chaotic cases, whose replicas part: no step gives them a number, so "
      "distributions are compared, by records\n",
      of.runs);
  TextTable table(1);
  table.add({"demand", "records", "median at half the step over that at the step"});
  for (const study::StepDistribution& each : of.demands)
    if (each.of.pairs > 1)
      table.add({each.name, std::to_string(each.of.pairs),
                 with_interval(std::exp(each.of.difference), std::exp(each.of.interval.low),
                               std::exp(each.of.interval.high))});
  all += table.text();
  for (const study::StepDistribution& each : of.states)
    all +=
        fmt::format("  {}: P {:.3g} at the step, {:.3g} at half of it, difference {}\n", each.name,
                    each.of.mean_a, each.of.mean_b,
                    with_interval(each.of.difference, each.of.interval.low, each.of.interval.high));
  return all;
}

std::string share_text(double share) { return fmt::format("{:.0f} %", 100 * share); }

std::string step_check(const study::StudyOverview& overview) {
  if (!overview.step_check) return {};
  const study::StepCheck& of = *overview.step_check;
  std::string all = fmt::format(
      "\ntime step: {} runs were repeated with half the step; relative change of their demands\n",
      of.runs);
  if (of.failed > 0)
    all += fmt::format("  {} further repetition{} failed\n", of.failed, of.failed == 1 ? "" : "s");
  if (of.chaotic) all += chaotic_steps(*of.chaotic);
  const std::size_t numbers = of.runs - (of.chaotic ? of.chaotic->runs : 0);
  if (numbers == 0) return all;
  TextTable table(1);
  table.add({"demand", "compared", "within 1 %", "within 5 %", "median", "largest", "in run"});
  for (const study::StepChange& each : of.changes)
    if (each.compared > 0)
      table.add({study::name_of(each), std::to_string(each.compared),
                 share_text(each.within_1_percent), share_text(each.within_5_percent),
                 fmt::format("{:.2g}", each.median), fmt::format("{:.2g}", each.largest),
                 each.largest > 0 ? std::to_string(each.largest_run) : "-"});
  all += table.text();
  for (const study::StateChange& each : of.states)
    all += fmt::format("  {}: a different outcome in {} of {} runs\n", each.state, each.runs.size(),
                       numbers);
  for (const std::string& each : of.unjudged)
    all += fmt::format(
        "  {}: not compared, the repeated runs keep only demands of items and points\n", each);
  return all;
}

}  // namespace

std::string undrawn_text(const std::optional<study::UndrawnRanges>& undrawn) {
  const std::string name = "uncertainties not propagated";
  if (!undrawn) return name + ": not stated in this file\n";
  if (undrawn->parameters() == 0) return name + ": none\n";
  std::string all = name + ", parameters with a range that keep their values:\n";
  for (const std::string& line : undrawn->lines()) all += "  " + render::wrapped(line, 4, 2) + "\n";
  return all;
}

std::string overview_text(const study::StudyOverview& overview) {
  std::string all = head(overview.file, fmt::format("a study of {} runs", overview.runs));
  for (const auto& factor : overview.factors)
    all += entry("factor", fmt::format("{}: {}", factor.name, fmt::join(factor.levels, ", ")));
  all += entry("variants", fmt::format("{} configuration{}", overview.configurations.size(),
                                       overview.configurations.size() == 1 ? "" : "s"));
  std::vector<std::string> angles;
  const study::ReportUnit turn = overview.units.of("rad");
  for (const double angle : overview.angles)
    angles.push_back(fmt::format("{:g}", angle / turn.in_si));
  all += entry("angles", fmt::format("{} {}", fmt::join(angles, ", "), turn.name));
  all += entry("intensity",
               fmt::format("{}: {}", overview.measure.empty() ? "records" : overview.measure,
                           fmt::join(overview.levels, ", ")));
  if (overview.factors_on_records.any())
    all += entry("scaling", "factors " + overview.factors_on_records.text());
  all += entry("draws", overview.draws > 0 ? fmt::format("{} of each record", overview.draws)
                                           : "none: every parameter has its value");
  if (overview.replicas > 1)
    all += entry("replicas", fmt::format("{} of each draw", overview.replicas));
  all += undrawn_text(overview.undrawn);
  if (!overview.missing_demands.empty())
    all += fmt::format("demands not in this file:\n  {}\n",
                       render::wrapped(fmt::format("{}", fmt::join(overview.missing_demands, ", ")), 4, 2));
  all += entry("runs", fmt::format("{}, {} overturned, {}", overview.runs, overview.overturned,
                                   failed_runs(overview.failed, overview.untrusted)));
  if (overview.warned > 0)
    all += entry("warnings", fmt::format("in {} runs the building warned (/warnings), such as: {}",
                                         overview.warned, overview.first_warning));
  all += tail(overview.file, fmt::format(" (worst: run {})", overview.energy_closure_run));
  return all + motions(overview.file) + "\n" + shares_text(overview, overview.counts.size()) +
         failures(overview) + step_check(overview);
}

std::string overview_text(const study::RunOverview& overview, const study::UnitSystem& units) {
  std::string all = head(overview.file, "one run");
  all += entry("outcome", fmt::format("{} at {:.4g} s{}{}", overview.outcome, overview.end_time,
                                      overview.cause.empty() ? "" : ": ", overview.cause));
  all += tail(overview.file, "") + motions(overview.file);
  TextTable table(2);
  table.add({"item", "equipment", "peak", "residual", "speed", "tilt", "overturned"});
  const std::string length = units.of("m").name;
  table.add({"", "", length, length, units.of("m/s").name, units.of("rad").name, "s"});
  for (const auto& item : overview.items)
    table.add(
        {item.name, item.model, units.number(item.peak_displacement, "m", 4),
         units.number(item.residual_displacement, "m", 4),
         units.number(item.peak_velocity, "m/s", 3), units.number(item.peak_tilt, "rad", 2),
         item.time_of_overturning < 0 ? "-" : fmt::format("{:.2f}", item.time_of_overturning)});
  return all + "\nlargest and last displacement and largest speed against the floor\n" +
         table.text();
}

}  // namespace gurney::report
