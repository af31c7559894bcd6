#include "studies/report/measure_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "studies/report/json_values.h"

namespace gurney::report {
namespace {

using Json = nlohmann::ordered_json;

constexpr double kSettled = 0.95, kOpen = 0.8;

std::string cell(double value) { return std::isnan(value) ? "-" : fmt::format("{:.3g}", value); }

std::string row_text(const statistics::IntensityRow& row, std::size_t width) {
  if (row.status != statistics::CloudStatus::kFitted)
    return fmt::format("{:<{}}  {}\n", row.name, width, text(row.status));
  std::string text =
      fmt::format("{:<{}} {:>10} {:>12} {:>11} {:>7} {:>9.2f}", row.name, width,
                  cell(row.efficiency), cell(row.practicality), cell(row.proficiency),
                  fmt::format("{:.3f}", row.r_squared), row.log_likelihood);
  for (const double p : row.sufficiency) text += fmt::format(" {:>11}", cell(p));
  return text + (row.left_out > 0 ? fmt::format("  {} runs only", row.runs) : "") + "\n";
}

/// "scale" of "factor on the record".
std::string short_name(const std::string& property) {
  return property == "factor on the record" ? "scale" : property;
}

std::string table_text(const study::MeasureChoice& choice) {
  std::size_t width = 8;
  for (const statistics::IntensityRow& row : choice.rows) width = std::max(width, row.name.size());
  std::string text = fmt::format("{:<{}} {:>10} {:>12} {:>11} {:>7} {:>9}", "measure", width,
                                 "efficiency", "practicality", "proficiency", "R2", "ln L");
  for (const std::string& property : choice.properties)
    text += fmt::format(" {:>11}", "p of " + short_name(property));
  text += "\n";
  for (const statistics::IntensityRow& row : choice.rows) text += row_text(row, width);
  if (!choice.unknown.empty())
    text += fmt::format("not known for these records: {}\n", fmt::join(choice.unknown, ", "));
  return text;
}

std::string sufficiency_text(const study::MeasureChoice& choice) {
  const bool known = std::ranges::any_of(choice.rows, [](const statistics::IntensityRow& row) {
    return row.status == statistics::CloudStatus::kFitted && !std::isnan(row.sufficiency.front());
  });
  std::string text = known ? "p of scale: of no dependence on the factor on the records once the "
                             "measure is known; small: scaling biases\n"
                           : "p of scale: unknown, the factor on the records follows from the "
                             "measure or does not vary\n";
  std::vector<std::string> tested, untested;
  for (const char* name : {"magnitude", "distance"})
    (std::ranges::find(choice.properties, name) != choice.properties.end() ? tested : untested)
        .push_back(name);
  if (!tested.empty())
    text += fmt::format("p of {}: the same for the {} of the records\n",
                        fmt::join(tested, ", p of "), fmt::join(tested, " and "));
  if (!untested.empty())
    text += fmt::format("not tested: {}, which the file does not contain for every run\n",
                        fmt::join(untested, " and "));
  return text;
}

Json row_json(const statistics::IntensityRow& row, const study::MeasureChoice& choice,
              std::size_t i, const study::UnitSystem& units) {
  Json json{{"name", row.name},
            {"units", units.of(choice.units[i]).name},
            {"status", text(row.status)},
            {"runs", row.runs},
            {"left_out", row.left_out}};
  if (row.status != statistics::CloudStatus::kFitted) return json;
  json["efficiency"] = json_number(row.efficiency);
  json["practicality"] = json_number(row.practicality);
  json["proficiency"] = json_number(row.proficiency);
  json["r_squared"] = json_number(row.r_squared);
  json["log_likelihood"] = json_number(row.log_likelihood);
  for (std::size_t k = 0; k < choice.properties.size(); ++k)
    json["sufficiency"][choice.properties[k]] = json_number(row.sufficiency[k]);
  return json;
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
  words += fmt::format(": scatter {:.3g} against {:.3g} of {}, ln likelihood {:.2f} higher",
                       best.efficiency, next.efficiency, next.name, choice.lead);
  if (std::isnan(choice.stays_best))
    return words + ". One record does not show whether this holds for others.\n";
  words += fmt::format(".\nIt stays first in {:.0f} % of the resamples of the records: ",
                       100 * choice.stays_best);
  if (choice.stays_best >= kSettled) return words + "the difference matters.\n";
  if (choice.stays_best > kOpen) return words + "the difference is likely, not certain.\n";
  return words + "the difference is inconclusive for these records.\n";
}

std::string measure_text(const std::vector<MeasureReport>& reports) {
  std::string text;
  for (const MeasureReport& report : reports) {
    const study::MeasureChoice& choice = report.choice;
    text +=
        fmt::format("{}limit state {} ({}){}\n", text.empty() ? "" : "\n", report.state,
                    report.words, report.configuration.empty() ? "" : ", " + report.configuration);
    text += fmt::format(
        "{} runs of {} record{}; {} overturned: demand at least the limit; {} below {}: "
        "at most that\n",
        choice.runs, choice.records, choice.records == 1 ? "" : "s", choice.overturned,
        choice.at_floor,
        report.units.chosen() ? report.units.text(choice.floor, choice.demand_units)
                              : fmt::format("{:.3g} (SI)", choice.floor));
    if (!choice.rows.empty() && choice.rows.front().status == statistics::CloudStatus::kFitted)
      text += table_text(choice) + verdict(choice) + sufficiency_text(choice);
    else
      text += verdict(choice);
  }
  return text;
}

std::string measure_json(const std::vector<MeasureReport>& reports) {
  Json json = Json::array();
  for (const MeasureReport& report : reports) {
    const study::MeasureChoice& choice = report.choice;
    const study::UnitSystem units = report.units.or_else("si");
    const study::ReportUnit demand = units.of(choice.demand_units);
    Json rows = Json::array();
    for (std::size_t i = 0; i < choice.rows.size(); ++i)
      rows.push_back(row_json(choice.rows[i], choice, i, units));
    json.push_back({{"configuration", report.configuration},
                    {"limit_state", report.state},
                    {"words", report.words},
                    {"runs", choice.runs},
                    {"records", choice.records},
                    {"overturned", choice.overturned},
                    {"at_floor", choice.at_floor},
                    {"floor", choice.floor / demand.in_si},
                    {"floor_units", demand.name},
                    {"measures", rows},
                    {"unknown", choice.unknown},
                    {"lead_of_log_likelihood", json_number(choice.lead)},
                    {"stays_best", json_number(choice.stays_best)},
                    {"verdict", verdict(choice)}});
  }
  return json.dump(2) + "\n";
}

}  // namespace gurney::report
