#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "studies/figures/verification_figures.h"
#include "studies/page/drawing.h"
#include "studies/page/json_pages.h"
#include "studies/page/study_page.h"
#include "studies/page/table.h"

namespace gurney::page {
namespace {

const study::ReportUnit kPlain{"", 1};

struct Check {
  std::string quantity, unit, derivation, where;
  double computed, reference, error, tolerance;
  bool passed;

  explicit Check(const JsonValue& of)
      : quantity(of.text("quantity")),
        unit(of.text("unit")),
        derivation(of.text("derivation")),
        where(of.text("where")),
        computed(of.number("computed")),
        reference(of.number("reference")),
        error(of.number("error")),
        tolerance(of.number("tolerance")),
        passed(of.flag("passed")) {}

  double used() const {
    if (!passed && !(tolerance > 0)) return std::numeric_limits<double>::infinity();
    return error == 0 ? 0 : std::abs(error) / tolerance;
  }
};

struct Case {
  std::string name, group, title, equation, source;
  std::vector<std::pair<std::string, JsonValue>> parameters;
  std::vector<Check> checks;
  std::vector<std::pair<std::string, std::vector<Check>>> others;  ///< by solver
  bool passed;
  double seconds;

  explicit Case(const JsonValue& of)
      : name(of.text("name")),
        group(of.text("group")),
        title(of.text("title")),
        equation(of.text("equation")),
        source(of.text("source")),
        parameters(of.members("parameters")),
        passed(of.flag("passed")),
        seconds(of.number("seconds")) {
    for (const JsonValue& each : of.objects("checks")) checks.emplace_back(each);
    for (const auto& [solver, list] : of.members("stock_bullet")) {
      others.push_back({solver, {}});
      for (const JsonValue& each : list.elements()) others.back().second.emplace_back(each);
    }
  }

  std::string form() const { return name.substr(0, name.find('/')); }
  const Check* worst() const {
    const auto found = std::ranges::max_element(checks, {}, [](const Check& each) {
      return std::isnan(each.used()) ? 1e300 : each.used();
    });
    return found == checks.end() ? nullptr : &*found;
  }
};

/// What failed first, as many as there are; the others as they come.
std::vector<Case> cases_of(const JsonValue& all) {
  std::vector<Case> cases;
  for (const JsonValue& each : all.objects("cases")) cases.emplace_back(each);
  std::ranges::stable_sort(cases, {}, [](const Case& each) { return each.passed; });
  return cases;
}

std::vector<std::string> groups_of(const std::vector<Case>& cases) {
  std::vector<std::string> groups;
  for (const Case& each : cases)
    if (std::ranges::find(groups, each.group) == groups.end()) groups.push_back(each.group);
  return groups;
}

std::string unit_of(const Check& check) { return check.unit.empty() ? "1" : check.unit; }

std::vector<Cell> cells_of(const Case& of, const Check& check) {
  return {of.name,
          check.passed ? "passed" : "FAILED",
          check.where.empty() ? check.quantity : check.quantity + ", worst at " + check.where,
          unit_of(check),
          Cell(check.computed, kPlain, 7),
          Cell(check.reference, kPlain, 7),
          Cell(check.error, kPlain, 2),
          Cell(check.tolerance, kPlain, 2),
          Cell(100 * check.used(), kPlain, 3),
          check.derivation};
}

const std::vector<Column> kCheckColumns{{"Case"},
                                        {"Result"},
                                        {"Quantity"},
                                        {"Unit"},
                                        {"Computed", true},
                                        {"Reference", true},
                                        {"Error", true, "computed less reference"},
                                        {"Tolerance", true},
                                        {"Used (%)", true, "|error| over tolerance"},
                                        {"Where the tolerance comes from"}};

Section summary(const std::vector<Case>& cases) {
  std::size_t checks = 0, failed = 0;
  double seconds = 0, most = 0;
  std::string worst;
  for (const Case& each : cases) {
    checks += each.checks.size();
    failed += !each.passed;
    seconds += each.seconds;
    if (const Check* const check = each.worst(); check != nullptr && check->used() > most) {
      most = check->used();
      worst = fmt::format("{:.3g} %: {}, {}", 100 * most, each.name, check->quantity);
    }
  }
  Html content = facts({{"Result", failed == 0 ? "all cases passed"
                                               : fmt::format("{} of {} failed", failed,
                                                             counted(cases.size(), "case"))},
                        {"Cases", std::to_string(cases.size())},
                        {"Checks", std::to_string(checks)},
                        {"Most of a tolerance", worst.empty() ? "none used" : worst},
                        {"Computing time", fmt::format("{:.3g} s", seconds)}});
  content += paragraph(
      "Each case compares what the engine computes with a closed form or a law that it must obey. "
      "A "
      "tolerance is a formula of the case's parameters: it was not fitted to the results.");
  Table table{"Checks that failed", kCheckColumns};
  for (const Case& each : cases) {
    if (each.checks.empty())
      table.rows.push_back({each.name, "FAILED", "checks nothing", "", "", "", "", "", "", ""});
    for (const Check& check : each.checks)
      if (!check.passed) table.rows.push_back(cells_of(each, check));
  }
  if (!table.rows.empty())
    content += element("div",
                       element("h3", "Failed") +
                           list({fmt::format("{} with {}: the engine of this "
                                             "program does not compute what "
                                             "it should here.",
                                             counted(failed, "case"),
                                             counted(table.rows.size(), "failed check"))}),
                       {{"class", "cautions"}}) +
               html(table);
  return {"summary", "At a glance", content};
}

Section figure(const std::vector<Case>& cases, const std::vector<std::string>& groups) {
  std::vector<figures::ToleranceRow> rows;
  for (const std::string& group : groups) {
    rows.push_back({group, {}});
    for (const Case& each : cases)
      if (each.group == group)
        for (const Check& check : each.checks) rows.back().used.push_back(check.used());
    rows.back().label += fmt::format(" ({})", counted(rows.back().used.size(), "check"));
  }
  if (rows.empty()) return {"tolerances", "Use of the tolerances", {}};
  return {"tolerances", "Use of the tolerances",
          html(Drawing{"tolerances", figures::tolerance_figure({.width = 900}, rows),
                       "Error over tolerance of every check, by group.",
                       "One row for each group of closed forms; marks left of the dashed line "
                       "passed. The same numbers are in the tables below."})};
}

Section cases_section(const std::vector<Case>& cases, const std::vector<std::string>& groups) {
  Html content;
  for (const std::string& group : groups) {
    Table table{fmt::format("Cases of {}", group),
                {{"Case"},
                 {"Result"},
                 {"Used (%)", true, "|error| over tolerance"},
                 {"Most by"},
                 {"Error", true, "computed less reference"},
                 {"Tolerance", true},
                 {"Unit"},
                 {"Checks", true}}};
    for (const Case& each : cases) {
      if (each.group != group) continue;
      std::vector<Cell> cells{each.name, each.passed ? "passed" : "FAILED"};
      if (const Check* const worst = each.worst())
        cells.insert(cells.end(), {Cell(100 * worst->used(), kPlain, 3), worst->quantity,
                                   Cell(worst->error, kPlain, 2), Cell(worst->tolerance, kPlain, 2),
                                   unit_of(*worst)});
      else
        cells.insert(cells.end(), 5, Cell("\u2013"));
      cells.emplace_back(each.checks.size());
      table.rows.push_back(cells);
    }
    content += element("h3", group) + html(table);
  }
  return {"cases", "Cases", content};
}

Section forms_section(const std::vector<Case>& cases) {
  Table table{"Closed forms",
              {{"Closed form"}, {"What happens"}, {"Reference"}, {"Source"}, {"Cases", true}}};
  std::vector<std::pair<const Case*, std::size_t>> forms;
  for (const Case& each : cases) {
    const auto found =
        std::ranges::find(forms, each.form(), [](const auto& form) { return form.first->form(); });
    if (found == forms.end())
      forms.emplace_back(&each, 1);
    else
      ++found->second;
  }
  for (const auto& [first, count] : forms)
    table.rows.push_back(
        {first->form(), first->title, first->equation, first->source, Cell(count)});
  return {"forms", "Closed forms and their sources", html(table)};
}

Section checks_section(const std::vector<Case>& cases) {
  Table checks{"Every check", kCheckColumns};
  Table parameters{
      "Parameters of the cases",
      {{"Case"}, {"Parameter"}, {"Value", true}, {"Unit"}, {"Lowest", true}, {"Highest", true}}};
  Table others{"The same cases on other solvers",
               {{"Case"},
                {"Solver"},
                {"Quantity"},
                {"Unit"},
                {"Error", true},
                {"Tolerance of the engine", true}}};
  for (const Case& each : cases) {
    for (const Check& check : each.checks) checks.rows.push_back(cells_of(each, check));
    for (const auto& [name, of] : each.parameters)
      parameters.rows.push_back({each.name, name, Cell(of.number("value"), kPlain, 6),
                                 of.text("unit"), Cell(of.number("lowest"), kPlain, 6),
                                 Cell(of.number("highest"), kPlain, 6)});
    for (const auto& [solver, list] : each.others)
      for (const Check& check : list)
        others.rows.push_back({each.name, solver, check.quantity, unit_of(check),
                               Cell(check.error, kPlain, 2), Cell(check.tolerance, kPlain, 2)});
  }
  Html content =
      folded("Every check of every case", html(checks)) +
      folded("Parameters, and the ranges in which the closed forms hold", html(parameters));
  if (!others.rows.empty())
    content += folded("Errors of other solvers on the same cases", html(others));
  return {"checks", "All numbers", content};
}

}  // namespace

Document verification_document(const JsonValue& all) {
  const std::vector<Case> cases = cases_of(all);
  const std::vector<std::string> groups = groups_of(cases);
  Document document{
      "Verification of the engine",
      fmt::format("{} in {}: {}", counted(cases.size(), "case"), counted(groups.size(), "group"),
                  all.flag("passed") ? "all passed" : "FAILED"),
      {summary(cases), figure(cases, groups), cases_section(cases, groups), forms_section(cases),
       checks_section(cases)},
      {}};
  document.sections.push_back(
      {"provenance", "Provenance",
       facts({{"Program that computed", "gurney " + all.text("program_version")},
              {"Commit", all.text("git_commit")},
              {"Compiler", all.text("compiler")},
              {"CPU class", all.text("cpu_class")}}) +
           paragraph("The same program on the same class of CPU gives the same numbers, with any "
                     "number of threads. gurney verify CASE prints a case in full, --figures draws "
                     "computed and reference over time, --draw tries other parameters.")});
  return document;
}

}  // namespace gurney::page
