#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <nlohmann/json.hpp>
#include <numeric>

#include "engine/base/shell_word.h"
#include "studies/analysis/configuration_view.h"
#include "studies/analysis/demand_runs.h"
#include "studies/analysis/demands.h"
#include "studies/figures/labels.h"
#include "studies/page/html.h"
#include "studies/page/study_page.h"
#include "studies/render/script_json.h"

namespace gurney::page {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

/// Each text once, in the order of their coming.
CaseColumn of_texts(const std::string& title, const std::vector<std::string>& texts) {
  CaseColumn column{.title = title};
  std::map<std::string, std::size_t> known;
  for (const std::string& text : texts) {
    const auto [at, is_new] = known.emplace(text, column.texts.size());
    if (is_new) column.texts.push_back(text);
    column.values.push_back(static_cast<double>(at->second));
  }
  return column;
}

CaseColumn of_numbers(const std::string& label, const study::ReportUnit& unit,
                      std::vector<double> values) {
  return {.title = figures::with_unit(label, unit), .unit = unit, .values = std::move(values)};
}

CaseColumn of_counts(const std::string& title, std::vector<double> values) {
  return {.title = title, .whole = true, .values = std::move(values)};
}

std::vector<std::string> records_of_runs(const study::StudyData& data) {
  const auto record = data.file().numbers("runs/record"),
             configuration = data.file().numbers("runs/configuration");
  std::vector<std::vector<std::string>> names;
  for (std::size_t i = 0; i < data.configurations().size(); ++i)
    names.push_back(study::record_names({&data, i}));
  std::vector<std::string> result;
  for (std::size_t run = 0; run < record.size(); ++run) {
    const auto& of = names[static_cast<std::size_t>(configuration[run])];
    const auto index = static_cast<std::size_t>(record[run]);
    result.push_back(index < of.size() ? of[index] : fmt::format("record {}", index));
  }
  return result;
}

CaseColumn demand(const study::StudyData& data, const std::string& name) {
  std::vector<double> values(data.file().runs(), kNone);
  study::ReportUnit unit{"1", 1};
  for (std::size_t i = 0; i < data.configurations().size(); ++i) {
    if (data.runs_of(i).empty()) continue;
    for (const study::NamedDemand& each : study::demands_named(data, i, {name})) {
      unit = data.units().of(each.units);
      const std::vector<double> of = study::values_of_runs(data, each, data.runs_of(i));
      for (std::size_t k = 0; k < of.size(); ++k) {
        double& value = values[data.runs_of(i)[k]];
        if (!(of[k] <= value)) value = std::isnan(of[k]) ? value : of[k];
      }
    }
  }
  return of_numbers(figures::label_of(name), unit, std::move(values));
}

CaseColumn exceeded(const study::StudyData& data, std::size_t state) {
  CaseColumn column{.title = data.limit_states()[state].name, .texts = {"no", "yes"}};
  column.values.assign(data.file().runs(), kNone);
  for (std::size_t i = 0; i < data.configurations().size(); ++i) {
    const std::vector<bool> exceeds = data.exceedances(state, data.runs_of(i));
    for (std::size_t k = 0; k < exceeds.size(); ++k) column.values[data.runs_of(i)[k]] = exceeds[k];
  }
  return column;
}

bool is_constant(const CaseColumn& column) {
  return std::ranges::all_of(column.values,
                             [&](double value) { return value == column.values.front(); });
}

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
  const Html tools =
      element("label", escaped("Show runs with ") +
                           Html{"<input id=\"cases-filter\" type=\"search\" "
                                "size=\"28\" placeholder=\"record, outcome, number\">"}) +
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

std::vector<CaseColumn> case_columns(const study::StudyData& data) {
  const study::StudyReader& file = data.file();
  std::vector<double> index(file.runs());
  for (std::size_t run = 0; run < index.size(); ++run) index[run] = static_cast<double>(run);
  std::vector<std::string> configurations;
  for (const double each : file.numbers("runs/configuration"))
    configurations.push_back(data.configurations()[static_cast<std::size_t>(each)]);

  std::vector<CaseColumn> columns{
      of_texts("Configuration", configurations), of_texts("Record", records_of_runs(data)),
      of_numbers("Angle", data.units().of("rad"), file.numbers("runs/angle"))};
  if (file.has_column("runs/draw")) columns.push_back(of_counts("Draw", file.numbers("runs/draw")));
  if (file.has_column("runs/replica"))
    columns.push_back(of_counts("Replica", file.numbers("runs/replica")));
  if (!file.text_attribute("intensity_measure").empty()) {
    const study::RunMeasure measure = data.measure("");
    columns.push_back(of_numbers(measure.name, study::report_unit(data, measure), measure.values));
  }
  columns.push_back(of_numbers("Factor", {"1", 1}, file.numbers("runs/scale")));
  for (std::size_t state = 0; state < data.limit_states().size(); ++state)
    columns.push_back(exceeded(data, state));
  std::erase_if(columns, is_constant);
  for (const char* each : {"peak_displacement", "peak_tilt"}) columns.push_back(demand(data, each));
  columns.insert(columns.begin(),
                 {of_counts("Run", index), of_texts("Outcome", file.strings("runs/outcome"))});
  return columns;
}

std::string case_json(const std::vector<CaseColumn>& columns, const std::string& replay) {
  using Json = nlohmann::ordered_json;
  Json all{{"replay", replay}, {"columns", Json::array()}};
  for (const CaseColumn& column : columns) {
    Json values = Json::array();
    for (const double value : column.values)
      values.push_back(column.whole && std::isfinite(value)
                           ? Json(static_cast<std::int64_t>(value))
                           : Json(value));  // null where it is not finite
    all["columns"].push_back({{"title", column.title},
                              {"in_si", column.unit.in_si},
                              {"whole", column.whole},
                              {"texts", column.texts.empty() ? Json() : Json(column.texts)},
                              {"values", std::move(values)}});
  }
  return render::script_json(all);
}

Section study_cases(const StudyPage& page) {
  const std::vector<CaseColumn> columns = case_columns(page.data);
  const CaseColumn& peak = columns[columns.size() - 2];  // before tilt
  // Runs of an unfinished study will have other numbers.
  const std::string replay =
      page.unfinished.empty() ? "gurney replay " + shell_word(page.path) : "";
  return {"cases", "Runs", extreme_cases(columns, peak) + all_cases(columns, replay)};
}

}  // namespace gurney::page
