#include "studies/report/study_report.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "engine/base/error.h"
#include "studies/analysis/study_comparison.h"
#include "studies/analysis/zone_occupancy.h"
#include "studies/report/formats.h"

namespace gurney::report {
namespace {

std::string counted_words(std::size_t count, const std::string& what) {
  return fmt::format("{} {}{}", count, what, count == 1 ? "" : "s");
}

/// "brakes on" of a study with one factor, else the configuration.
std::string subject_of(const study::StudyOverview& overview, const std::string& configuration) {
  return overview.factors.size() == 1 ? overview.factors.front().name + " " + configuration
                                      : configuration;
}

/// "brakes on, overturned".
std::string subject_of(const study::StudyOverview& overview, const study::FragilityResult& of) {
  return (of.configuration.empty() ? "" : subject_of(overview, of.configuration) + ", ") + of.state;
}

/// `PGV (larger)` of `PGV larger`.
std::string measure_words(const std::string& measure) {
  const auto at = measure.rfind(' ');
  return at == std::string::npos ? measure
                                 : measure.substr(0, at) + " (" + measure.substr(at + 1) + ")";
}

/// "brakes on, overturned: median PGV (larger) of 0.97 m/s (95 % interval 0.72 to 1.6), dispersion 0.85."
std::string headline(const study::StudyOverview& overview, const study::FragilityResult& of,
                     const study::ReportUnit& unit) {
  const std::string subject = subject_of(overview, of) + ": ";
  return fmt::format("{}median {} of {:.3g}{} (95 % interval {}), dispersion {:.2f}.", subject,
                     measure_words(of.measure.name), of.curve()->theta / unit.in_si,
                     unit.name == "1" ? "" : " " + unit.name,
                     study::interval_text(of.band.theta, unit.in_si, 3, of.audit),
                     of.curve()->beta);
}

using findings::Table;
using findings::Value;

constexpr double kSettled = 0.95, kOpen = 0.8;

bool is_fitted(const statistics::IntensityRow& row) {
  return row.status == statistics::CloudStatus::kFitted;
}

/// "scale" of "factor on the record".
std::string short_name(const std::string& property) {
  return property == "factor on the record" ? "scale" : property;
}

Table measures(const study::MeasureChoice& choice, const study::UnitSystem& units) {
  const findings::Format three{".3g"};
  Table table{"measures",
              "",
              {{"name", "measure"},
               {"units", ""},
               {"status", ""},
               {"runs", ""},
               {"left_out", ""},
               {"efficiency", "efficiency", three},
               {"practicality", "practicality", three},
               {"proficiency", "proficiency", three},
               {"r_squared", "R2", {".3f"}},
               {"log_likelihood", "ln L", {".2f"}}}};
  for (const std::string& property : choice.properties)
    table.columns.push_back({"sufficiency." + property, "p of " + short_name(property), three});
  table.columns.push_back({"", "remark"});
  for (std::size_t i = 0; i < choice.rows.size(); ++i) {
    const statistics::IntensityRow& row = choice.rows[i];
    const auto known = [&](double value) { return is_fitted(row) ? Value(value) : Value(); };
    table.add({row.name, units.of(choice.units[i]).name, text(row.status), row.runs, row.left_out,
               known(row.efficiency), known(row.practicality), known(row.proficiency),
               known(row.r_squared), known(row.log_likelihood)});
    for (std::size_t k = 0; k < choice.properties.size(); ++k)
      table.rows.back().push_back(is_fitted(row) ? Value(row.sufficiency.at(k)) : Value());
    table.rows.back().push_back(!is_fitted(row)    ? text(row.status)
                                : row.left_out > 0 ? fmt::format("{} runs only", row.runs)
                                                   : std::string());
  }
  return table;
}

findings::Texts sufficiency_lines(const study::MeasureChoice& choice) {
  const bool known = std::ranges::any_of(choice.rows, [](const statistics::IntensityRow& row) {
    return is_fitted(row) && !std::isnan(row.sufficiency.front());
  });
  findings::Texts lines{
      known ? "p of scale: of the test that the scale factor changes nothing once the measure is "
              "known; where it is small, scaling biases the demand"
            : "p of scale: unknown, the factor on the records follows from the measure or does "
              "not vary"};
  for (const char* name : {"magnitude", "distance"})
    lines.push_back(
        std::ranges::find(choice.properties, name) != choice.properties.end()
            ? fmt::format("p of {0}: the same for the {0} of the records", name)
            : fmt::format("not tested: {}, which the file does not contain for every run", name));
  return lines;
}

constexpr std::size_t kFew = 100;
constexpr double kMuchLeft = 0.2;

}  // namespace

findings::Texts warning_cautions(const study::StudyOverview& overview) {
  findings::Texts all;
  for (const study::WarningKind& kind : overview.warnings)
    all.push_back(fmt::format("{} with a warning, such as: {}",
                              counted_words(kind.runs.size(), "run"), kind.first));
  return all;
}

findings::Texts cautions_of(const study::StudyOverview& overview, const study::StudyData& data,
                            const std::vector<study::FragilityResult>& fragilities) {
  findings::Texts all;
  if (overview.failed > 0)
    all.push_back(fmt::format("{} of {}: excluded from every statistic",
                              failed_runs(overview.failed, overview.untrusted),
                              counted_words(overview.runs, "run")));
  if (overview.factors_on_records.above() > 0)
    all.push_back("scale factors on the records " + overview.factors_on_records.text() +
                  ", where scaling may bias demands");
  std::ranges::move(warning_cautions(overview), std::back_inserter(all));
  if (overview.step_check)
    for (const study::StateChange& each : overview.step_check->states)
      all.push_back(fmt::format("with half the time step the outcome at {} differs in {} of {}",
                                each.state, each.runs.size(),
                                counted_words(overview.step_check->runs, "run")));
  if (overview.undrawn && overview.undrawn->parameters() > 0)
    all.push_back(
        fmt::format("{} with a range kept {}, so that this uncertainty is in no number of "
                    "this page: see Assumptions",
                    counted_words(overview.undrawn->parameters(), "parameter"),
                    overview.undrawn->parameters() == 1 ? "its value" : "their values"));
  for (const study::ZoneOccupancy& each : study::zone_occupancy(data))
    if (each.from_start > 0)
      all.push_back(fmt::format(
          "{}zone {}: an item stands in it from the start in {} of {}, which count as entries",
          each.configuration.empty() ? "" : each.configuration + ", ", each.zone, each.from_start,
          counted_words(each.runs, "run")));
  if (!overview.missing_demands.empty())
    all.push_back(fmt::format("this file was written by gurney {} and does not have: {}",
                              overview.file.program_version,
                              fmt::join(overview.missing_demands, ", ")));
  for (const study::FragilityResult& each : fragilities) {
    const study::ReportUnit unit = study::report_unit(data, each.measure);
    study::CurveAudit audit = each.audit;
    audit.factors = {};  // stated once, of all runs
    for (const std::string& caution : study::cautions(audit, unit))
      all.push_back((each.configuration.empty() ? "" : each.configuration + ", ") + each.state +
                    ": " + caution);
  }
  return all;
}

findings::List answers_of(const study::StudyOverview& overview, const study::StudyData& data,
                          const std::vector<study::FragilityResult>& fragilities) {
  findings::List answers{"", "Intensity at which a limit state is exceeded", {}};
  std::vector<std::pair<std::string, findings::Texts>> without;  // a reason, and what it is of
  for (const study::FragilityResult& each : fragilities) {
    const study::ReportUnit unit = study::report_unit(data, each.measure);
    if (each.curve()) {
      answers.lines.push_back(headline(overview, each, unit));
      continue;
    }
    const std::string reason = study::no_curve_text(each, unit);
    auto same = std::ranges::find(without, reason, &std::pair<std::string, findings::Texts>::first);
    if (same == without.end()) same = without.insert(same, {reason, {}});
    same->second.push_back(subject_of(overview, each));
  }
  for (const auto& [reason, subjects] : without)
    answers.lines.push_back(fmt::format("{}: {}.", fmt::join(subjects, "; "), reason));
  return answers;
}

findings::List compared_answers(const study::StudyOverview& overview,
                                const study::StudyData& data) {
  findings::List answers{"", "", {}};
  if (overview.configurations.size() != 2) return answers;
  study::StudyComparison found;
  try {
    found = study::compare_studies({&data, 0}, {&data, 1},
                                   {.demands = {"peak_displacement"}, .resamples = 1});
  } catch (const Error&) {
    return answers;
  }
  if (found.pairs.group == study::RunPairs::Group::kNone) return answers;
  for (const study::ComparedQuantity& each : found.quantities) {
    if (each.kind != study::ComparedQuantity::Kind::kShare) continue;
    if (!std::isfinite(each.p_holm)) continue;  // too few records to say anything
    const bool shown = each.p_holm < 0.05;
    answers.lines.push_back(fmt::format(
        "{}: {:.3g} % of the runs instead of {:.3g} %, {} (95 % interval of the difference {:.3g} "
        "to {:.3g} points, by {} {}, p = {:.2g}).",
        each.name, 100 * each.b, 100 * each.a,
        !shown                ? "which shows no difference"
        : each.difference < 0 ? "less often"
                              : "more often",
        100 * each.interval.low, 100 * each.interval.high, each.groups,
        found.pairs.group == study::RunPairs::Group::kRecord ? "records" : "draws", each.p_holm));
  }
  if (!answers.lines.empty())
    answers.title =
        fmt::format("{} instead of {}, over all intensities",
                    subject_of(overview, overview.configurations[1]), overview.configurations[0]);
  return answers;
}

findings::Table zone_findings(const study::StudyData& data) {
  const findings::Format width = format_of(data.units().of("m"), 1, ".3g"), share{".3g", "%", 0.01};
  findings::Table table{"", "Zones of the room, over the runs that did not fail", {}};
  for (const study::ZoneOccupancy& each : study::zone_occupancy(data)) {
    const auto share_of = [&](std::size_t count) {
      return static_cast<double>(count) / static_cast<double>(each.runs);
    };
    add_row(
        table,
        {{{"", "zone"}, each.zone},
         {{"", "configuration"}, each.configuration.empty() ? "all runs" : each.configuration},
         {{"", "runs"}, each.runs},
         {{"", "entered", share, "share of the runs in which an item entered the zone"},
          share_of(each.entered)},
         {{"", "occupied at the end", share, "share of the runs"}, share_of(each.occupied_at_end)},
         {{"", "mean time occupied", {".3g", "s"}}, each.occupied_time},
         {{"", "median least free width", width, "of the widest free path along the zone"},
          each.least_free_width},
         {{"", "smallest free width", width, "over all runs"}, each.smallest_free_width}});
  }
  return table;
}

std::string failed_runs(std::size_t failed, std::size_t untrusted) {
  return fmt::format("{} failed", failed) +
         (untrusted > 0 ? fmt::format(" ({} untrusted)", untrusted) : "");
}

std::string verdict(const study::MeasureChoice& choice) {
  if (choice.rows.empty() || choice.rows.front().status != statistics::CloudStatus::kFitted)
    return "No measure can be judged: " +
           (choice.rows.empty() ? "none is known" : text(choice.rows.front().status)) + ".\n";
  const statistics::IntensityRow& best = choice.rows.front();
  std::string words = fmt::format("{} predicts this demand best", best.name);
  std::vector<std::string> ties;
  for (std::size_t i = 1; i <= choice.ties; ++i) ties.push_back(choice.rows[i].name);
  if (!ties.empty())
    words += fmt::format(", as good as {}, to which it is proportional", fmt::join(ties, ", "));
  if (std::isnan(choice.lead)) return words + "; there is no other to compare with.\n";
  const statistics::IntensityRow& next = choice.rows[choice.ties + 1];
  words +=
      fmt::format(": its ln likelihood is {:.2f} above that of {} (scatter {:.3g}, there {:.3g})",
                  choice.lead, next.name, best.efficiency, next.efficiency);
  if (std::isnan(choice.stays_best))
    return words + ". One record does not show whether this holds for others.\n";
  words += fmt::format(".\nIt stays first in {:.0f} % of the resamples of the records: ",
                       100 * choice.stays_best);
  if (choice.stays_best >= kSettled) return words + "the difference matters.\n";
  if (choice.stays_best > kOpen) return words + "the difference is likely, not certain.\n";
  return words + "the difference is inconclusive for these records.\n";
}

findings::Section measure_findings(const MeasureReport& report) {
  const study::MeasureChoice& choice = report.choice;
  const study::UnitSystem units = report.units.or_else("si");
  const findings::Format demand = format_of(units, choice.demand_units, ".3g");
  findings::Section all{
      "", fmt::format("limit state {} ({}){}", report.state, report.words,
                      report.configuration.empty() ? "" : ", " + report.configuration)};
  all.json("configuration", report.configuration).json("limit_state", report.state);
  all.json("words", report.words).json("runs", choice.runs).json("records", choice.records);
  all.json("overturned", choice.overturned).json("at_floor", choice.at_floor);
  all.json("floor", choice.floor, demand);
  all.json("floor_units", units.of(choice.demand_units).name);
  all.say(fmt::format(
      "{} runs of {} record{}; {} overturned: demand at least the limit; {} below {}: at most that",
      choice.runs, choice.records, choice.records == 1 ? "" : "s", choice.overturned,
      choice.at_floor, with_unit(choice.floor, demand)));
  all.add(measures(choice, units)).list("unknown", "not known for these records", choice.unknown);
  all.json("lead_of_log_likelihood", choice.lead).json("stays_best", choice.stays_best);
  all.json("verdict", verdict(choice)).say(verdict(choice));
  if (!choice.rows.empty() && is_fitted(choice.rows.front()))
    for (std::string& line : sufficiency_lines(choice)) all.say(std::move(line));
  return all;
}

std::string name_of(const study::SensitiveInput& input) {
  if (input.names.size() == 1) return input.names.front();
  return fmt::format("{} and {} equal to it", input.names.front(), input.names.size() - 1);
}

findings::Texts sensitivity_remarks(const study::StudySensitivity& found) {
  findings::Texts lines;
  const auto say = [&](std::string line) { lines.push_back(std::move(line)); };
  const auto lead = std::ranges::find_if(found.inputs, &study::SensitiveInput::stands_out);
  if (lead == found.inputs.end())
    say("No input stands out: every interval reaches 0.");
  else
    say(fmt::format("{} contributes most{}: first-order Sobol' index {:.2f}{}.", name_of(*lead),
                    lead == found.inputs.begin() ? "" : " of those whose interval does not reach 0",
                    lead->index->estimate,
                    lead->total ? fmt::format(", total index {:.2f}", lead->total->estimate) : ""));
  if (lead != found.inputs.end() && lead != found.inputs.begin()) {
    findings::Texts larger;
    for (auto each = found.inputs.begin(); each != lead; ++each) larger.push_back(name_of(*each));
    say(fmt::format("Before it, but not settled, since the interval reaches 0: {}.",
                    findings::listed(larger)));
  }
  say(fmt::format("The indices sum to {:.2f}{}.", found.sum,
                  found.correlated.empty() ? "" : ", correlated inputs counted once"));
  const char* const rest = 1 - found.sum > kMuchLeft
                               ? "What is missing to 1 is of inputs acting together, or chance. "
                               : "";
  if (found.designed)
    say(fmt::format(
        "{}The first index is of an input alone, the total of all in which it has a part: an input "
        "whose total is 0 does not matter.",
        rest));
  else
    say(
        fmt::format("{}An index is of an input alone: what inputs do only together (interactions) "
                    "is in none of them.",
                    rest));
  for (const study::SensitiveInput& input : found.inputs)
    if (input.names.size() > 1)
      say(fmt::format("Equal in every run, so one input: {}.", fmt::join(input.names, ", ")));
  for (const auto& names : found.correlated)
    say(fmt::format("Correlated, so the index of each holds what the others do: {}.",
                    fmt::join(names, ", ")));
  if (!found.constant.empty())
    say(fmt::format("Drawn, but the same in every run: {}.", fmt::join(found.constant, ", ")));
  if (!found.why_level.empty()) say(fmt::format("Level: {}, {}.", found.level, found.why_level));
  if (std::ranges::any_of(found.inputs, [](const study::SensitiveInput& input) {
        return input.drawn && std::isnan(input.bar.swing());
      }))
    say(fmt::format("Means of fewer than {} runs are not stated.", study::kFewestOfMean));
  if (found.runs < kFew && !found.designed)
    say(
        fmt::format("Few runs: {} make wide intervals, and classes of {:.0f} runs smooth what "
                    "changes fast; 100 or more are better.",
                    found.runs, std::sqrt(static_cast<double>(found.runs))));
  const char* const advice = found.level.empty() ? "; look at one --level" : "";
  if (found.repeated_draws && found.designed)
    say(fmt::format(
        "Several angles or levels share {} points: the indices are of the variance within them, "
        "and the intervals are too narrow{}.",
        found.draws, advice));
  else if (found.repeated_draws)
    say(
        fmt::format("{} runs share {} draws: they are not independent and the intervals are "
                    "too narrow{}.",
                    found.runs, found.draws, advice));
  if (found.overturned > 0)
    say(
        fmt::format("{} runs overturned: their demands contain what they do on the floor, unless "
                    "settings.follow_overturning = false.",
                    found.overturned));
  if (found.left_out > 0)
    say(fmt::format("{} runs {}", found.left_out,
                    found.designed ? "are excluded: they have no such demand, or another run "
                                     "of their point has none or failed."
                                   : "have no such demand and are excluded."));
  return lines;
}

findings::Table sensitive_inputs(const SensitivityReport& report) {
  const study::StudySensitivity& found = report.found;
  const findings::Format index{".2f"}, ends_of = interval_format(index), three{".3g"},
                                       value = format_of(report.units, found.units, ".3g");
  const auto quantile = [](double share) { return fmt::format("{:g} %", 100 * share); };
  findings::Table table{"inputs",
                        "",
                        {{"names", ""},
                         {"", "input"},
                         {"drawn", ""},
                         {"index", found.designed ? "first" : "index", index,
                          "share of the variance by the input alone"},
                         {"interval", "95 % interval", ends_of}}};
  if (found.designed)
    table.columns.insert(table.columns.end(),
                         {{"total_index", "total", index, "with all interactions"},
                          {"total_interval", "95 % interval", ends_of}});
  table.columns.insert(table.columns.end(), {{"low", quantile(found.share), three,
                                              "the input is lower in this share of the runs"},
                                             {"high", quantile(1 - found.share), three},
                                             {"mean_below", "mean below", value},
                                             {"mean_below_error", "+-", value, "standard error"},
                                             {"runs_below", "runs"},
                                             {"mean_above", "mean above", value},
                                             {"mean_above_error", "+-", value, "standard error"},
                                             {"runs_above", "runs"},
                                             {"swing", "swing", value}});
  for (const study::SensitiveInput& input : found.inputs) {
    std::vector<findings::Cell> row{input.names, name_of(input), input.drawn};
    const auto add = [&](const std::optional<statistics::VarianceIndex>& of) {
      row.emplace_back(of ? Value(of->estimate) : Value());
      row.emplace_back(of ? ends(of->interval) : Value());
    };
    add(input.index);
    if (found.designed) add(input.total);
    const statistics::TornadoBar& bar = input.bar;
    for (const double each : {input.low, input.high, bar.low, bar.low_error})
      row.emplace_back(input.drawn ? Value(each) : Value());
    row.emplace_back(input.drawn ? Value(bar.low_runs) : Value());
    for (const double each : {bar.high, bar.high_error})
      row.emplace_back(input.drawn ? Value(each) : Value());
    row.emplace_back(input.drawn ? Value(bar.high_runs) : Value());
    row.emplace_back(input.drawn ? Value(bar.swing()) : Value());
    table.add(std::move(row));
  }
  return table;
}

std::string sensitivity_title(const SensitivityReport& report) {
  const study::StudySensitivity& found = report.found;
  const findings::Format of = format_of(report.units, found.units, ".3g");
  return fmt::format("{}{}{}: mean {}, standard deviation {}, {} runs", found.output,
                     report.configuration.empty() ? "" : ", " + report.configuration,
                     found.level.empty() ? "" : ", " + found.level, with_unit(found.mean, of),
                     with_unit(found.deviation, of), found.runs);
}

findings::Section sensitivity_findings(const SensitivityReport& report) {
  const study::StudySensitivity& found = report.found;
  if (!report.why_not.empty())
    return findings::Section{"", report.configuration + ": " + report.why_not}
        .json("configuration", report.configuration)
        .json("why_not", report.why_not);
  const findings::Format of = format_of(report.units, found.units);
  findings::Section all{"", sensitivity_title(report)};
  all.json("configuration", report.configuration).json("output", found.output);
  all.json("units", report.units.or_else("si").of(found.units).name).json("level", found.level);
  all.json("designed", found.designed).json("runs", found.runs).json("left_out", found.left_out);
  all.json("draws", found.draws).json("overturned", found.overturned);
  all.json("mean", found.mean, of).json("standard_deviation", found.deviation, of);
  all.json("sum_of_indices", found.sum).json("tornado_share", found.share);
  all.add(sensitive_inputs(report));
  for (std::string& remark : sensitivity_remarks(found)) all.say(std::move(remark));
  all.json("correlated", found.correlated);
  return all.json("constant", found.constant);
}

}  // namespace gurney::report
