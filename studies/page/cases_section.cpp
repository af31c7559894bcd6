#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "engine/base/shell_word.h"
#include "studies/page/case_columns.h"
#include "studies/page/findings_html.h"
#include "studies/page/study_page.h"

namespace gurney::page {
namespace {

constexpr std::size_t kExtreme = 20;

findings::Value value_of(const CaseColumn& column, std::size_t run) {
  const double value = column.values[run];
  if (std::isnan(value)) return {};
  if (!column.texts.empty()) return column.texts[static_cast<std::size_t>(value)];
  return column.whole ? findings::Value(static_cast<std::int64_t>(value)) : findings::Value(value);
}

/// The runs with the largest peak displacements, for print and for those without JavaScript.
Html extreme_cases(const std::vector<CaseColumn>& columns, const CaseColumn& demand) {
  std::vector<std::size_t> runs(demand.values.size());
  std::iota(runs.begin(), runs.end(), std::size_t{0});
  std::erase_if(runs, [&](std::size_t run) { return std::isnan(demand.values[run]); });
  const std::size_t count = std::min(kExtreme, runs.size());
  std::ranges::partial_sort(
      runs, runs.begin() + static_cast<std::ptrdiff_t>(count), [&](std::size_t a, std::size_t b) {
        return std::pair(-demand.values[a], a) < std::pair(-demand.values[b], b);
      });
  runs.resize(count);
  findings::Table table{
      "", fmt::format("The {} with the largest peak displacements", counted(count, "run")), {}};
  table.rows.resize(count);
  for (const CaseColumn& column : columns) {
    table.columns.push_back({"", column.title, {".4g", "", column.unit.in_si}});
    for (std::size_t row = 0; row < count; ++row)
      table.rows[row].emplace_back(value_of(column, runs[row]));
  }
  return html(table);
}

Html button(const std::string& id, const std::string& text) {
  return element("button", text, {{"type", "button"}, {"id", id}});
}

/// The table of all runs, of which the page's script shows 25 at a time.
Html all_cases(const std::vector<CaseColumn>& columns, const std::string& replay) {
  Html head;
  for (const CaseColumn& column : columns) {
    Attributes attributes{{"scope", "col"}, {"aria-sort", "none"}};
    if (column.texts.empty()) attributes.emplace_back("class", "number");
    head += element("th", element("button", column.title, {{"type", "button"}}), attributes);
  }
  const Html tools = element("label", escaped("Show runs with ") +
                                          Html{"<input id=\"cases-filter\" type=\"search\" "
                                               "placeholder=\"record, outcome, number\">"}) +
                     button("cases-back", "Back") + button("cases-on", "Next") +
                     element("span", "", {{"id", "cases-page"}, {"role", "status"}});
  const Html table = element(
      "table",
      element("caption", "All runs; the number of a run gives the command that re-runs it") +
          element("thead", element("tr", head)) + element("tbody", ""),
      {{"id", "cases-all"}});
  return element(
             "div",
             element("div", tools, {{"class", "cases-tools"}}) +
                 element("div", table,
                         {{"class", "scroll"},
                          {"tabindex", "0"},
                          {"role", "region"},
                          {"aria-label", "All runs"}}) +
                 element("p", element("code", "", {{"id", "cases-command"}}), {{"role", "status"}}),
             {{"id", "cases-table"}, {"hidden", ""}}) +
         element("script", Html{case_json(columns, replay)},
                 {{"type", "application/json"}, {"id", "cases-data"}});
}

}  // namespace

Section study_cases(const StudyPage& page) {
  const std::vector<CaseColumn> columns = case_columns(page.data);
  const CaseColumn& peak = columns[columns.size() - 3];  // before tilt and outcome
  // Runs of an unfinished study will have other numbers.
  const std::string replay =
      page.unfinished.empty() ? "gurney replay " + shell_word(page.path) : "";
  return {"cases", "Runs", extreme_cases(columns, peak) + all_cases(columns, replay)};
}

}  // namespace gurney::page
