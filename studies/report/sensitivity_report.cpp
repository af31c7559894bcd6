#include "studies/report/sensitivity_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "studies/report/formats.h"

namespace gurney::report {
namespace {

using findings::Value;

constexpr std::size_t kFew = 100;
constexpr double kMuchLeft = 0.2;

}  // namespace

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
    say(fmt::format("{} contributes most: first-order Sobol' index {:.2f}{}.", name_of(*lead),
                    lead->index->estimate,
                    lead->total ? fmt::format(", total index {:.2f}", lead->total->estimate) : ""));
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
  if (found.repeated_draws && found.designed)
    say(fmt::format(
        "Several angles or levels share {} points: the indices are of the variance within them, "
        "and the intervals are too narrow; look at one --level.",
        found.draws));
  else if (found.repeated_draws)
    say(
        fmt::format("{} runs share {} draws: they are not independent and the intervals are "
                    "too narrow; look at one --level.",
                    found.runs, found.draws));
  if (found.overturned > 0)
    say(fmt::format("{} runs overturned: their demands are those before overturning.",
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
