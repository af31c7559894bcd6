#include "studies/report/convergence_report.h"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "studies/report/json_values.h"

namespace gurney::report {
namespace {

using Json = nlohmann::ordered_json;

std::string percent(double share) {
  return share == 0 ? "0" : fmt::format("{:.2g} %", 100 * share);
}

const char* key_of(study::Varied varied) {
  switch (varied) {
    case study::Varied::kTimeStep:
      return "time_step";
    case study::Varied::kSolverTolerance:
      return "solver_tolerance";
    case study::Varied::kTreadStiffness:
      break;
  }
  return "tread_stiffness";
}

std::string row(const study::ConvergedNumber& number, double tolerance,
                const study::UnitSystem& units) {
  std::string verdict = name_of(number.step);
  if (number.step == study::StepVerdict::kConverging)
    verdict = fmt::format("{} ({:.2g} s)", verdict, number.step_needed);
  if (number.solver_change > tolerance) verdict += "; solver tolerance too loose";
  if (number.stiffness_change > tolerance) verdict += "; depends on the tread stiffness";
  const study::ReportUnit unit = units.of(number.units);
  const std::string name = unit.name == "1" ? "" : " " + unit.name;
  return fmt::format(
      "{:<28} {:>4} {:>16} {:>9} {:>6} {:>9} {:>9}  {}\n", number.name, number.runs,
      fmt::format("{:.5g}{}", number.values.front() / unit.in_si, name), percent(number.change),
      number.change > 0 && std::isfinite(number.order) ? fmt::format("{:.1f}", number.order) : "-",
      percent(number.solver_change), percent(number.stiffness_change), verdict);
}

}  // namespace

std::string convergence_text(const study::Convergence& found, const study::UnitSystem& units) {
  std::string text = fmt::format(
      "runs        {} of {}\ntime step   {:g} s, compared with {:g} s\nsolver      residual {:g}\n"
      "tolerance   {:g} %\n",
      found.runs, found.of_runs, found.settings.time_step, 0.125 * found.settings.time_step,
      found.settings.residual, 100 * found.tolerance);
  for (const std::string& each : found.failed) text += "failed      " + each + '\n';
  const std::string* item = nullptr;
  for (const study::ConvergedNumber& number : found.numbers) {
    if (item == nullptr || *item != number.item)
      text += fmt::format("\n{:<28} {:>4} {:>16} {:>9} {:>6} {:>9} {:>9}  {}\n",
                          number.item.empty() ? "Share of runs" : number.item, "runs",
                          found.runs == 1 || number.item.empty() ? "value" : "median", "step",
                          "order", "solver", "tread", "verdict on the time step");
    item = &number.item;
    text += row(number, found.tolerance, units.or_else("m"));
  }
  return text;
}

std::string convergence_json(const study::Convergence& found, const study::UnitSystem& units) {
  Json json{{"runs", found.runs},
            {"of_runs", found.of_runs},
            {"time_step_s", found.settings.time_step},
            {"residual", found.settings.residual},
            {"tolerance", found.tolerance},
            {"failed", found.failed}};
  json["variants"] = Json::array();
  for (const study::Variant& each : found.variants)
    json["variants"].push_back({{"varied", key_of(each.varied)}, {"factor", each.factor}});
  json["numbers"] = Json::array();
  for (const study::ConvergedNumber& each : found.numbers) {
    const study::ReportUnit unit = units.or_else("si").of(each.units);
    std::vector<double> values = each.values;
    for (double& value : values) value /= unit.in_si;
    json["numbers"].push_back({{"item", each.item},
                               {"name", each.name},
                               {"units", unit.name},
                               {"runs", each.runs},
                               {"values", values},
                               {"scatter", each.scatter / unit.in_si},
                               {"change", each.change},
                               {"order", json_number(each.order)},
                               {"verdict", name_of(each.step)},
                               {"time_step_needed_s", each.step_needed},
                               {"solver_change", each.solver_change},
                               {"tread_stiffness_change", each.stiffness_change}});
  }
  return json.dump(2) + '\n';
}

}  // namespace gurney::report
