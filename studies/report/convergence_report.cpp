#include "studies/report/convergence_report.h"

#include <fmt/format.h>

#include "studies/report/formats.h"

namespace gurney::report {
namespace {

using findings::Section;
using findings::Table;
using findings::Value;

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

std::string verdict(const study::ConvergedNumber& number, double tolerance) {
  std::string text = name_of(number.step);
  if (number.step == study::StepVerdict::kConverging)
    text = fmt::format("{} ({:.2g} s)", text, number.step_needed);
  if (number.solver_change > tolerance) text += "; solver tolerance too loose";
  if (number.stiffness_change > tolerance) text += "; depends on the tread stiffness";
  return text;
}

Table numbers(const study::Convergence& found, const study::UnitSystem& units) {
  const findings::Format percent{".2g", "%", 0.01};
  Table table{"numbers",
              "",
              {{"", "item"},
               {"item", ""},
               {"name", "demand"},
               {"units", ""},
               {"runs", "runs"},
               {"values", ""},
               {"scatter", ""},
               {"", found.runs == 1 ? "value" : "median or share"},
               {"", "unit"},
               {"change", "step", percent},
               {"order", ""},
               {"", "order", {".1f"}},
               {"verdict", ""},
               {"time_step_needed_s", ""},
               {"solver_change", "solver", percent},
               {"tread_stiffness_change", "tread", percent},
               {"", "verdict on the time step"}}};
  table.grouped = true;
  for (const study::ConvergedNumber& each : found.numbers) {
    const findings::Format format = format_of(units.or_else("m"), each.units, ".5g"),
                           json = format_of(units.or_else("si"), each.units);
    table.add({each.item.empty() ? "Share of runs" : each.item,
               each.item,
               each.name,
               units.or_else("si").of(each.units).name,
               each.runs,
               {each.values, json},
               {each.scatter, json},
               {each.values.front(), format},
               format.unit,
               each.change,
               each.order,
               each.change > 0 ? Value(each.order) : Value(),
               name_of(each.step),
               each.step_needed,
               each.solver_change,
               each.stiffness_change,
               verdict(each, found.tolerance)});
  }
  return table;
}

}  // namespace

findings::Section convergence_findings(const study::Convergence& found,
                                       const study::UnitSystem& units) {
  Section all;
  all.fact("runs", "runs", found.runs, {}, fmt::format("of {}", found.of_runs));
  all.json("of_runs", found.of_runs);
  all.fact("time_step_s", "time step", found.settings.time_step, {"g", "s"},
           fmt::format("compared with {:g} s", 0.125 * found.settings.time_step));
  all.fact("residual", "residual of the solver", found.settings.residual, {"g"});
  all.fact("tolerance", "tolerance", found.tolerance, {"g", "%", 0.01});
  all.list("failed", "failed", found.failed);
  Table variants{"variants", "", {{"varied", ""}, {"factor", ""}}};
  for (const study::Variant& each : found.variants)
    variants.add({key_of(each.varied), each.factor});
  return all.add(std::move(variants)).add(numbers(found, units));
}

}  // namespace gurney::report
