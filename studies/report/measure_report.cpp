#include "studies/report/measure_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "studies/report/formats.h"

namespace gurney::report {
namespace {

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

}  // namespace

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

}  // namespace gurney::report
