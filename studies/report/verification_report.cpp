#include "studies/report/verification_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "studies/build_info/build_info.h"
#include "studies/render/render.h"
#include "studies/report/formats.h"

namespace gurney::report {
namespace {

using verification::CaseRun;
using verification::Check;

std::string values_text(const CaseRun& run) {
  std::string text;
  for (std::size_t i = 0; i < run.set.values.size(); ++i) {
    const verification::Parameter& p = run.family->parameters[i];
    text += fmt::format("{}{} {:.6g} {}", i == 0 ? "" : ", ", p.name, run.set.values[i], p.unit);
  }
  return text;
}

std::string with_unit(double value, const std::string& unit) {
  return unit.empty() ? fmt::format("{:.7g}", value) : fmt::format("{:.7g} {}", value, unit);
}

std::string check_text(const Check& c) {
  return fmt::format(
      "    {} {}\n         computed {}, reference {}, error {:.2g}, tolerance {:.2g} ({:.0f} % "
      "used)\n         tolerance: {}\n",
      c.passed() ? "ok  " : "FAIL",
      c.where.empty() ? c.quantity : c.quantity + ", worst at " + c.where,
      with_unit(c.computed, c.unit), with_unit(c.reference, c.unit), c.error(), c.tolerance,
      100 * c.used(), c.derivation);
}

/// The largest error of a stock solver over that of ours would be unfair where ours is tiny: the
/// errors stand beside each other.
std::string stock_text(const CaseRun& run) {
  std::string text;
  for (const verification::StockRun& stock : run.stock)
    for (const Check& c : stock.findings.checks)
      text +=
          fmt::format("    {}: {}: error {:.2g} {}\n", stock.solver, c.quantity, c.error(), c.unit);
  return text;
}

using namespace findings;
using Cases = std::vector<const Section*>;

const Format kSeven{".7g"}, kSix{".6g"}, kThree{".3g"}, kTwo{".2g"}, kUsed{".3g", "%"};

Table checks_table(const std::string& key, const verification::Findings& findings) {
  Table table{key, "Every check of every case", {}};
  for (const verification::Check& c : findings.checks)
    add_row(table, {{{"quantity", "quantity"}, c.quantity},
                    {{"where", "worst at"}, c.where},
                    {{"unit", "unit"}, c.unit},
                    {{"computed", "computed", kSeven}, c.computed},
                    {{"reference", "reference", kSeven}, c.reference},
                    {{"error", "error", kTwo, "computed less reference"}, c.error()},
                    {{"tolerance", "tolerance", kTwo}, c.tolerance},
                    {{"passed", "passed"}, c.passed()},
                    {{"derivation", "where the tolerance comes from"}, c.derivation}});
  return table;
}

Section case_section(const verification::CaseRun& run) {
  const verification::Statement& statement = run.family->statement;
  Section of("cases[]");
  of.json("name", run.name()).json("group", statement.group).json("title", statement.title);
  of.json("equation", statement.equation).json("source", statement.source);
  Table parameters{"parameters{}", "Parameters, and the ranges in which the closed forms hold", {}};
  for (std::size_t i = 0; i < run.set.values.size(); ++i) {
    const verification::Parameter& p = run.family->parameters[i];
    add_row(parameters, {{{"", "parameter"}, p.name},
                         {{"value", "value", kSix}, run.set.values[i]},
                         {{"unit", "unit"}, p.unit},
                         {{"lowest", "lowest", kSix}, p.low},
                         {{"highest", "highest", kSix}, p.high}});
  }
  of.add(std::move(parameters)).json("passed", run.findings.passed());
  of.add(checks_table("checks", run.findings));
  Section stock("stock_bullet");
  for (const verification::StockRun& each : run.stock)
    stock.add(checks_table(each.solver, each.findings));
  return std::move(of.add(std::move(stock)).json("seconds", run.seconds));
}

// Conclusions.

bool passed(const Section& of) { return text_of(of, "passed") == "yes"; }

std::string form_of(const Section& of) {
  const std::string name = text_of(of, "name");
  return name.substr(0, name.find('/'));
}

std::string unit_of(const Table& checks, std::size_t row) {
  const std::string& unit = text_in(checks, row, "unit");
  return unit.empty() ? "1" : unit;
}

/// The check that uses most of its tolerance, one that is no number before all.
std::size_t worst_of(const Table& checks) {
  std::size_t worst = 0;
  const auto use = [&](std::size_t row) {
    const double used = used_of(checks, row);
    return std::isnan(used) ? std::numeric_limits<double>::infinity() : used;
  };
  for (std::size_t row = 1; row < checks.rows.size(); ++row)
    if (use(row) > use(worst)) worst = row;
  return worst;
}

/// A table of every case, or of every check of it, after the name of the case.
Table of_cases(const char* title, std::vector<Column> columns) {
  columns.insert(columns.begin(), {"", "case"});
  return {"", title, std::move(columns)};
}

Table empty_checks(const char* title) {
  verification::Findings one;
  one.checks.resize(1);
  Table all = of_cases(title, checks_table("", one).columns);
  all.columns.insert(all.columns.end() - 1, {"", "used", kUsed, "|error| over tolerance"});
  return all;
}

void add_check(Table& all, const Section& of, const Table& checks, std::size_t row) {
  std::vector<Cell> cells = checks.rows[row];
  cells.insert(cells.begin(), text_of(of, "name"));
  cells.insert(cells.end() - 1, 100 * used_of(checks, row));
  all.add(std::move(cells));
}

Section glance(const Cases& cases) {
  std::size_t count = 0, failed = 0;
  double seconds = 0, most = 0;
  std::string worst = "none used";
  Table wrong = empty_checks("Checks that failed");
  for (const Section* each : cases) {
    const Table& checks = *find<Table>(*each, "checks");
    count += checks.rows.size();
    failed += !passed(*each);
    seconds += std::get<double>(find<Fact>(*each, "seconds")->value);
    for (std::size_t row = 0; row < checks.rows.size(); ++row) {
      if (!std::get<bool>(value_in(checks, row, "passed"))) add_check(wrong, *each, checks, row);
      if (!(used_of(checks, row) > most)) continue;
      most = used_of(checks, row);
      worst = fmt::format("{:.3g} %: {}, {}", 100 * most, text_of(*each, "name"),
                          text_in(checks, row, "quantity"));
    }
    if (!checks.rows.empty()) continue;
    wrong.add({text_of(*each, "name"), "checks nothing"});
    wrong.rows.back().resize(wrong.columns.size(), Value());
  }
  Section all("", "At a glance");
  all.text("result", failed == 0 ? "all cases passed"
                                 : fmt::format("{} of {} cases failed", failed, cases.size()));
  all.text("cases", cases.size()).text("checks", count).text("most of a tolerance", worst);
  all.text("computing time", seconds, {".3g", "s"});
  all.say(
      "Each case compares what the engine computes with a closed form or a law that it must obey. "
      "A tolerance is a formula of the case's parameters: it was not fitted to the results.");
  if (failed > 0)
    all.add(List{"",
                 kCautions,
                 {fmt::format("{} of {} cases failed, with {} failed checks: the engine of this "
                              "program does not compute what it should here.",
                              failed, cases.size(), wrong.rows.size())}});
  return std::move(all.add(std::move(wrong)));
}

Section by_group(const Cases& cases) {
  Section all("", "Cases");
  std::vector<std::string> groups;
  for (const Section* each : cases)
    if (const std::string group = text_of(*each, "group");
        std::ranges::find(groups, group) == groups.end())
      groups.push_back(group);
  for (const std::string& group : groups) {
    Table table = of_cases("", {{"", "passed"},
                                {"", "used", kUsed, "|error| over tolerance"},
                                {"", "most by"},
                                {"", "error", kTwo, "computed less reference"},
                                {"", "tolerance", kTwo},
                                {"", "unit"},
                                {"", "checks"}});
    table.title = "Cases of " + group;
    for (const Section* each : cases) {
      if (text_of(*each, "group") != group) continue;
      const Table& checks = *find<Table>(*each, "checks");
      const std::size_t worst = worst_of(checks), count = checks.rows.size();
      if (count == 0)
        table.add({text_of(*each, "name"), passed(*each), Value(), "checks nothing", Value(),
                   Value(), "", count});
      else
        table.add({text_of(*each, "name"), passed(*each), 100 * used_of(checks, worst),
                   value_in(checks, worst, "quantity"), value_in(checks, worst, "error"),
                   value_in(checks, worst, "tolerance"), unit_of(checks, worst), count});
    }
    all.add(std::move(table));
  }
  return all;
}

Section forms(const Cases& cases) {
  Table table{"", "Closed forms", {}};
  std::map<std::string, std::size_t> counts;
  for (const Section* each : cases) ++counts[form_of(*each)];
  for (const Section* each : cases) {
    const auto found = counts.extract(form_of(*each));
    if (!found.empty())
      add_row(table, {{{"", "closed form"}, found.key()},
                      {{"", "what happens"}, text_of(*each, "title")},
                      {{"", "reference"}, text_of(*each, "equation")},
                      {{"", "source"}, text_of(*each, "source")},
                      {{"", "cases"}, found.mapped()}});
  }
  return std::move(Section("", "Closed forms and their sources").add(std::move(table)));
}

Section numbers(const Cases& cases) {
  const Section example = example_of_verification_facts();
  Table checks = empty_checks("Every check of every case"),
        parameters =
            of_cases("Parameters, and the ranges in which the closed forms hold",
                     find<Table>(*find<Section>(example, "cases[]"), "parameters{}")->columns),
        others = of_cases("Errors of other solvers on the same cases",
                          {{"", "solver"},
                           {"", "quantity"},
                           {"", "unit"},
                           {"", "error", kTwo},
                           {"", "tolerance of the engine", kTwo}});
  for (const Section* each : cases) {
    const std::string name = text_of(*each, "name");
    const Table& of = *find<Table>(*each, "checks");
    for (std::size_t row = 0; row < of.rows.size(); ++row) add_check(checks, *each, of, row);
    for (std::vector<Cell> row : find<Table>(*each, "parameters{}")->rows) {
      row.insert(row.begin(), name);
      parameters.add(std::move(row));
    }
    for (const Part& part : find<Section>(*each, "stock_bullet")->parts) {
      const Table& solver = std::get<Table>(part);
      for (std::size_t row = 0; row < solver.rows.size(); ++row)
        others.add({name, solver.key, value_in(solver, row, "quantity"), unit_of(solver, row),
                    value_in(solver, row, "error"), value_in(solver, row, "tolerance")});
    }
  }
  Section all("", "All numbers");
  return std::move(all.add(std::move(checks)).add(std::move(parameters)).add(std::move(others)));
}

using verification::StockRun;

/// The check of one quantity that used most of its tolerance, among all cases of a family.
struct Row {
  std::string quantity;
  const CaseRun* run;
  const Check* check;
};

std::vector<Row> rows_of(const std::vector<CaseRun>& runs, const verification::Family* family) {
  std::vector<Row> rows;
  for (const CaseRun& run : runs) {
    if (run.family != family) continue;
    for (const Check& check : run.findings.checks) {
      const auto at = std::ranges::find(rows, check.quantity, &Row::quantity);
      if (at == rows.end())
        rows.push_back({check.quantity, &run, &check});
      else if (check.used() > at->check->used())
        *at = {check.quantity, &run, &check};
    }
  }
  return rows;
}

std::vector<const verification::Family*> families_of(const std::vector<CaseRun>& runs) {
  std::vector<const verification::Family*> families;
  for (const CaseRun& run : runs)
    if (families.empty() || families.back() != run.family) families.push_back(run.family);
  return families;
}

/// Error of a quantity on a stock solver.
std::string stock_error(const StockRun& stock, const std::string& quantity) {
  const auto at = std::ranges::find(stock.findings.checks, quantity, &Check::quantity);
  return at == stock.findings.checks.end() ? "" : fmt::format("{:.1e}", at->error());
}

std::string code(const std::string& name) { return "`" + name + "`"; }

std::string with_unit(const Check& check) {
  return check.unit.empty() ? check.quantity : check.quantity + " [" + check.unit + "]";
}

/// A derivation that the row above has as well.
const std::string kAsAbove = "as above";

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
  Table table{"numbers", "", {}};
  table.grouped = true;
  for (const study::ConvergedNumber& each : found.numbers) {
    const findings::Format format = format_of(units.or_else("m"), each.units, ".5g"),
                           json = format_of(units.or_else("si"), each.units);
    add_row(table,
            {{{"", "item"}, each.item.empty() ? "Share of runs" : each.item},
             {"item", each.item},
             {{"name", "demand"}, each.name},
             {"units", units.or_else("si").of(each.units).name},
             {{"runs", "runs"}, each.runs},
             {"values", {each.values, json}},
             {"scatter", {each.scatter, json}},
             {{"", found.runs == 1 ? "value" : "median or share"}, {each.values.front(), format}},
             {{"", "unit"}, format.unit},
             {{"change", "step", percent}, each.change},
             {"order", each.order},
             {{"", "order", {".1f"}}, each.change > 0 ? Value(each.order) : Value()},
             {"verdict", name_of(each.step)},
             {"time_step_needed_s", each.step_needed},
             {{"solver_change", "solver", percent}, each.solver_change},
             {{"tread_stiffness_change", "tread", percent}, each.stiffness_change},
             {{"", "verdict on the time step"}, verdict(each, found.tolerance)}});
  }
  return table;
}

}  // namespace

std::string verification_text(const CaseRun& run, bool in_full) {
  const verification::Findings& f = run.findings;
  std::string text =
      f.checks.empty()
          ? fmt::format("FAIL {:<36} checks nothing\n", run.name())
          : fmt::format("{} {:<36} {:2} checks, {:5.1f} % of a tolerance used, {:.2f} s\n",
                        f.passed() ? "ok  " : "FAIL", run.name(), f.checks.size(),
                        100 * f.worst().used(), run.seconds);
  if (in_full || !f.passed())
    text += fmt::format("    {}\n    {}\n    {}\n", run.family->statement.title,
                        run.family->statement.equation, values_text(run));
  for (const Check& c : f.checks)
    if (in_full || !c.passed()) text += check_text(c);
  if (in_full) text += stock_text(run);
  return text;
}

std::string verification_summary(const std::vector<CaseRun>& runs) {
  std::size_t checks = 0;
  std::vector<std::string> failed;
  double seconds = 0;
  for (const CaseRun& run : runs) {
    checks += run.findings.checks.size();
    seconds += run.seconds;
    if (!run.findings.passed()) failed.push_back(run.name());
  }
  if (failed.empty())
    return fmt::format("{} cases with {} checks: all passed ({:.1f} s of computing)\n", runs.size(),
                       checks, seconds);
  return fmt::format("{} of {} cases failed: {}\n", failed.size(), runs.size(),
                     fmt::join(failed, ", "));
}

Section verification_facts(const std::vector<verification::CaseRun>& runs) {
  const build_info::BuildInfo build = build_info::build_info();
  Section all("", "Verification of the engine");
  all.json("schema", "gurney-verification/1");
  Section provenance("", "Provenance");
  provenance.fact("program_version", "gurney", build.program_version);
  provenance.fact("git_commit", "commit", build.git_commit);
  provenance.fact("compiler", "compiler", build.compiler);
  provenance.fact("cpu_class", "CPU class", build.cpu_class);
  all.add(std::move(provenance));
  all.json("passed", std::ranges::all_of(runs, [](const verification::CaseRun& each) {
             return each.findings.passed();
           }));
  for (const verification::CaseRun& run : runs) all.add(case_section(run));
  return all;
}

Section example_of_verification_facts() {
  verification::Family family;
  family.parameters.push_back({"", "", 0, 1});
  verification::CaseRun one{.family = &family, .set = {"", {0}}, .findings = {}, .stock = {}};
  one.findings.checks.resize(1);
  one.stock.push_back({kAnyKey, one.findings});
  return verification_facts({one});
}

Cases verified_cases(const Section& facts) {
  Cases cases;
  for (const Part& part : facts.parts)
    if (const auto* of = std::get_if<Section>(&part); of && of->key == "cases[]")
      cases.push_back(of);
  std::ranges::stable_sort(cases, {}, [](const Section* each) { return passed(*each); });
  return cases;
}

double used_of(const Table& checks, std::size_t row) {
  const double error = number_in(checks, row, "error"),
               tolerance = number_in(checks, row, "tolerance");
  if (!std::get<bool>(value_in(checks, row, "passed")) && !(tolerance > 0))
    return std::numeric_limits<double>::infinity();
  return error == 0 ? 0 : std::abs(error) / tolerance;
}

Section verification_findings(const Section& facts) {
  const Cases cases = verified_cases(facts);
  Section all("", facts.title);
  all.add(glance(cases)).add(by_group(cases)).add(forms(cases)).add(numbers(cases));
  for (const Part& part : facts.parts)
    if (const auto* of = std::get_if<Section>(&part); of && of->title == "Provenance") all.add(*of);
  return all;
}

std::string verification_markdown(const std::vector<CaseRun>& runs) {
  Table statements{"", "", {}};
  Table checks{"", "", {}};
  Table stock{"", "", {}};
  for (const verification::Family* family : families_of(runs)) {
    const verification::Statement& s = family->statement;
    add_row(statements, {{{"", "closed form"}, code(s.name)},
                         {{"", "what happens"}, s.title},
                         {{"", "reference"}, s.equation},
                         {{"", "source"}, s.source},
                         {{"", "cases"}, std::ranges::count(runs, family, &CaseRun::family)}});
    std::string last;
    for (const Row& row : rows_of(runs, family)) {
      const Check& check = *row.check;
      add_row(checks, {{{"", "closed form"}, code(s.name)},
                       {{"", "quantity"}, with_unit(check)},
                       {{"", "worst case"}, row.run->set.name},
                       {{"", "reference", {".5g"}}, check.reference},
                       {{"", "error", {".1e"}}, check.error()},
                       {{"", "tolerance", {".1e"}}, check.tolerance},
                       {{"", "how the tolerance follows"},
                        check.derivation == last ? kAsAbove : check.derivation}});
      last = check.derivation;
    }
  }
  for (const CaseRun& run : runs) {
    if (run.stock.size() != 2) continue;
    for (const Check& c : run.findings.checks) {
      const std::string bullet = stock_error(run.stock[0], c.quantity);
      if (!bullet.empty())
        add_row(stock, {{{"", "case"}, code(run.name())},
                        {{"", "quantity"}, with_unit(c)},
                        {{"", "reference", {".5g"}}, c.reference},
                        {{"", "error of gurney", {".1e"}}, c.error()},
                        {{"", "of bullet"}, bullet},
                        {{"", "of bullet-dantzig"}, stock_error(run.stock[1], c.quantity)}});
    }
  }
  return std::string(R"(# Closed forms

Written by `gurney verify --markdown`; [verification](verification.md) explains how to read and repeat it.

## What is compared

)") + render::markdown(statements) +
         R"(
## Worst case of each quantity

For each quantity the case that uses most of its tolerance. The computed value is reference + error; `gurney verify
--json` prints it for every case.

)" + render::markdown(checks) +
         R"(
## Stock Bullet on the same cases

`bullet` is its iterated contact solver (50 iterations), `bullet-dantzig` its direct one, with the same steps. Cases
with fixtures or drop weights are omitted, which stock Bullet does not support. Its friction cone is a pyramid: hence
the error of `isotropy_free`.

)" + render::markdown(stock);
}

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
  Table variants{"variants", "", {}};
  for (const study::Variant& each : found.variants)
    add_row(variants, {{"varied", key_of(each.varied)}, {"factor", each.factor}});
  return all.add(std::move(variants)).add(numbers(found, units));
}

}  // namespace gurney::report
