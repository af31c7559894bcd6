#include "studies/report/sensitivity_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>

#include "studies/report/json_values.h"

namespace gurney::report {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t kFew = 100;
constexpr double kMuchLeft = 0.2;

std::string with_unit(double value, const study::ReportUnit& unit) {
  return fmt::format("{:.3g}{}", value / unit.in_si, unit.name == "1" ? "" : " " + unit.name);
}

std::string index_text(const std::optional<statistics::VarianceIndex>& index) {
  if (!index) return fmt::format("{:>6}  {:<14}", "-", "too few runs");
  return fmt::format("{:>6.2f}  {:<14}", index->estimate,
                     fmt::format("{:.2f} to {:.2f}", index->interval.low, index->interval.high));
}

std::string row_text(const study::SensitiveInput& input, std::size_t width,
                     const study::ReportUnit& unit) {
  std::string text = fmt::format("{:<{}} ", name_of(input), width) + index_text(input.index);
  if (input.total) text += " " + index_text(input.total);
  if (!input.drawn) return text + "\n";
  const auto mean_text = [&](double mean, double error, std::size_t runs) {
    if (std::isnan(mean)) return fmt::format("- ({} runs)", runs);
    return fmt::format("{:.3g} (+-{:.2g}, {} runs)", mean / unit.in_si, error / unit.in_si, runs);
  };
  const double swing = input.bar.swing() / unit.in_si;
  return text + fmt::format(" {:>10.3g} {:>10.3g}  {:<28} {:<28} {:>10}\n", input.low, input.high,
                            mean_text(input.bar.low, input.bar.low_error, input.bar.low_runs),
                            mean_text(input.bar.high, input.bar.high_error, input.bar.high_runs),
                            std::isnan(swing) ? "-" : fmt::format("{:.3g}", swing));
}

std::string table_text(const study::StudySensitivity& found, const study::ReportUnit& unit) {
  std::size_t width = 8;
  for (const study::SensitiveInput& input : found.inputs)
    width = std::max(width, name_of(input).size());
  const auto percent = [](double share) { return fmt::format("{:g} %", 100 * share); };
  std::string text = fmt::format("{:<{}} {:>6}  {:<14}", "input", width,
                                 found.designed ? "first" : "index", "95 % interval");
  if (found.designed) text += fmt::format(" {:>6}  {:<14}", "total", "95 % interval");
  text += fmt::format(" {:>10} {:>10}  {:<28} {:<28} {:>10}\n", percent(found.share),
                      percent(1 - found.share), "mean below", "mean above", "swing");
  for (const study::SensitiveInput& input : found.inputs) text += row_text(input, width, unit);
  return text;
}

void add_index(Json& json, const std::string& before,
               const std::optional<statistics::VarianceIndex>& index) {
  json[before + "index"] = index ? json_number(index->estimate) : Json();
  json[before + "interval"] = index ? json_interval(index->interval) : Json();
}

Json input_json(const study::SensitiveInput& input, double unit) {
  Json json{{"names", input.names}, {"drawn", input.drawn}};
  add_index(json, "", input.index);
  if (input.total) add_index(json, "total_", input.total);
  if (input.drawn) {
    json["low"] = json_number(input.low);
    json["high"] = json_number(input.high);
    json["mean_below"] = json_number(input.bar.low / unit);
    json["mean_below_error"] = json_number(input.bar.low_error / unit);
    json["runs_below"] = input.bar.low_runs;
    json["runs_above"] = input.bar.high_runs;
    json["mean_above"] = json_number(input.bar.high / unit);
    json["mean_above_error"] = json_number(input.bar.high_error / unit);
  }
  return json;
}

}  // namespace

std::string name_of(const study::SensitiveInput& input) {
  if (input.names.size() == 1) return input.names.front();
  return fmt::format("{} and {} equal to it", input.names.front(), input.names.size() - 1);
}

std::string sensitivity_remarks(const study::StudySensitivity& found) {
  std::string text;
  const auto lead = std::ranges::find_if(found.inputs, [](const study::SensitiveInput& input) {
    const auto& index = input.total ? input.total : input.index;
    return index && index->interval.low > 0;
  });
  if (lead == found.inputs.end())
    text += "No input stands out: every interval reaches 0.\n";
  else
    text +=
        fmt::format("{} contributes most: first-order Sobol' index {:.2f}{}.\n", name_of(*lead),
                    lead->index->estimate,
                    lead->total ? fmt::format(", total index {:.2f}", lead->total->estimate) : "");
  text += fmt::format("The indices sum to {:.2f}{}.\n", found.sum,
                      found.correlated.empty() ? "" : ", correlated inputs counted once");
  const char* const rest = 1 - found.sum > kMuchLeft
                               ? "What is missing to 1 is of inputs acting together, or chance. "
                               : "";
  if (found.designed)
    text += fmt::format(
        "{}The first index is of an input alone, the total of all in which it has a part: an input "
        "whose total is 0 does not matter.\n",
        rest);
  else
    text += fmt::format(
        "{}An index is of an input alone: what inputs do only together (interactions) "
        "is in none of them.\n",
        rest);
  for (const study::SensitiveInput& input : found.inputs)
    if (input.names.size() > 1)
      text += fmt::format("Equal in every run, so one input: {}.\n", fmt::join(input.names, ", "));
  for (const auto& names : found.correlated)
    text += fmt::format("Correlated, so the index of each holds what the others do: {}.\n",
                        fmt::join(names, ", "));
  if (!found.constant.empty())
    text += fmt::format("Drawn, but the same in every run: {}.\n", fmt::join(found.constant, ", "));
  if (!found.why_level.empty())
    text += fmt::format("Level: {}, {}.\n", found.level, found.why_level);
  if (std::ranges::any_of(found.inputs, [](const study::SensitiveInput& input) {
        return input.drawn && std::isnan(input.bar.swing());
      }))
    text += fmt::format("Means of fewer than {} runs are not stated.\n", study::kFewestOfMean);
  if (found.runs < kFew && !found.designed)
    text += fmt::format(
        "Few runs: {} make wide intervals, and classes of {:.0f} runs smooth what "
        "changes fast; 100 or more are better.\n",
        found.runs, std::sqrt(static_cast<double>(found.runs)));
  if (found.repeated_draws && found.designed)
    text += fmt::format(
        "Several angles or levels share {} points: the indices are of the variance within them, "
        "and the intervals are too narrow; look at one --level.\n",
        found.draws);
  else if (found.repeated_draws)
    text += fmt::format(
        "{} runs share {} draws: they are not independent and the intervals are "
        "too narrow; look at one --level.\n",
        found.runs, found.draws);
  if (found.overturned > 0)
    text += fmt::format("{} runs overturned: their demands are those before overturning.\n",
                        found.overturned);
  if (found.left_out > 0)
    text += fmt::format("{} runs {}\n", found.left_out,
                        found.designed ? "are excluded: they have no such demand, or another run "
                                         "of their point has none or failed."
                                       : "have no such demand and are excluded.");
  return text;
}

std::string sensitivity_text(const std::vector<SensitivityReport>& reports) {
  std::string text;
  for (const SensitivityReport& report : reports) {
    const study::StudySensitivity& found = report.found;
    if (!report.why_not.empty()) {
      text +=
          fmt::format("{}{}: {}\n", text.empty() ? "" : "\n", report.configuration, report.why_not);
      continue;
    }
    const study::ReportUnit unit = report.units.of(found.units);
    text +=
        fmt::format("{}{}{}{}: mean {}, standard deviation {}, {} runs\n", text.empty() ? "" : "\n",
                    found.output, report.configuration.empty() ? "" : ", " + report.configuration,
                    found.level.empty() ? "" : ", " + found.level, with_unit(found.mean, unit),
                    with_unit(found.deviation, unit), found.runs);
    text += table_text(found, unit) + sensitivity_remarks(found);
  }
  return text;
}

std::string sensitivity_json(const std::vector<SensitivityReport>& reports) {
  Json json = Json::array();
  for (const SensitivityReport& report : reports) {
    const study::StudySensitivity& found = report.found;
    if (!report.why_not.empty()) {
      json.push_back({{"configuration", report.configuration}, {"why_not", report.why_not}});
      continue;
    }
    const study::ReportUnit unit = report.units.or_else("si").of(found.units);
    Json inputs = Json::array();
    for (const study::SensitiveInput& input : found.inputs)
      inputs.push_back(input_json(input, unit.in_si));
    json.push_back({{"configuration", report.configuration},
                    {"output", found.output},
                    {"units", unit.name},
                    {"level", found.level},
                    {"designed", found.designed},
                    {"runs", found.runs},
                    {"left_out", found.left_out},
                    {"draws", found.draws},
                    {"overturned", found.overturned},
                    {"mean", json_number(found.mean / unit.in_si)},
                    {"standard_deviation", json_number(found.deviation / unit.in_si)},
                    {"sum_of_indices", json_number(found.sum)},
                    {"tornado_share", found.share},
                    {"inputs", inputs},
                    {"correlated", found.correlated},
                    {"constant", found.constant}});
  }
  return json.dump(2) + "\n";
}

}  // namespace gurney::report
