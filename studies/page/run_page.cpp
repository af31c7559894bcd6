#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include "engine/base/append_all.h"
#include "engine/base/error.h"
#include "engine/base/names.h"
#include "studies/explanation/words.h"
#include "studies/figures/explanation_figure.h"
#include "studies/figures/labels.h"
#include "studies/figures/plan_figures.h"
#include "studies/figures/record_figures.h"
#include "studies/page/html.h"
#include "studies/page/study_page.h"
#include "studies/report/explanation_report.h"
#include "studies/report/overview_report.h"
#include "studies/results/columns.h"
#include "studies/results/names.h"
#include "studies/results/stored_predictability.h"

namespace gurney::page {
namespace {

using findings::Cell;
using findings::Table;
using findings::Value;

struct GroupColumn {
  std::string name;
  findings::Column head;
  std::vector<Value> values;
  bool text = false;
};

/// Values that mean "none": of times -1, of numbers NaN.
Value value_of(const study::Hdf5Dataset& dataset, double value) {
  if (dataset.units == "s" && value == -1) return {};
  return dataset.type == "int64" ? Value(static_cast<std::int64_t>(value)) : Value(value);
}

std::vector<GroupColumn> columns_of(const study::Hdf5Reader& file, const std::string& group,
                                    const study::UnitSystem& units,
                                    const std::vector<std::string>& first) {
  std::vector<GroupColumn> columns;
  const std::string before = "/" + group + "/";
  for (const study::Hdf5Dataset& dataset : file.datasets()) {
    if (!dataset.path.starts_with(before) || dataset.shape.size() != 1) continue;
    const std::string name = dataset.path.substr(before.size());
    if (name == "row" || name == "run") continue;
    const bool text = dataset.type == "string";
    const study::ReportUnit unit = units.of(text ? "1" : dataset.units);
    GroupColumn column{name,
                       {"",
                        figures::with_unit(figures::label_of(name), unit),
                        {".4g", "", unit.in_si},
                        dataset.long_name},
                       {},
                       text};
    if (text)
      for (const std::string& each : file.strings(dataset.path)) column.values.emplace_back(each);
    else
      for (const double each : file.numbers(dataset.path))
        column.values.push_back(value_of(dataset, each));
    columns.push_back(std::move(column));
  }
  std::ranges::stable_sort(columns, {}, [&](const GroupColumn& column) {
    return std::ranges::find(first, column.name) - first.begin();
  });
  return columns;
}

/// A group of columns of a results file as a table: every column but the row and the run, titles
/// with units, meanings where one points. No rows where the file does not have the group.
/// @param first  columns that come first, in this order; the others by name
Table table_of_group(const study::Hdf5Reader& file, const std::string& group,
                     const std::string& caption, const std::vector<std::string>& first,
                     const study::UnitSystem& units) {
  const std::vector<GroupColumn> columns = columns_of(file, group, units, first);
  Table table{"", caption, {}};
  for (const GroupColumn& column : columns) {
    table.columns.push_back(column.head);
    table.rows.resize(column.values.size());
    for (std::size_t row = 0; row < column.values.size(); ++row)
      table.rows[row].emplace_back(column.values[row]);
  }
  // Columns as long as the shortest.
  std::erase_if(table.rows, [&](const auto& row) { return row.size() != columns.size(); });
  return table;
}

/// The same with a row for each column of numbers, and a column for each row, which the column
/// `name` names; empty: the group has one row. Quantities without a value in any column are left out.
/// @param first  quantities that come first, in this order; the others by name
Table turned_table_of_group(const study::Hdf5Reader& file, const std::string& group,
                            const std::string& caption, const std::string& name,
                            const study::UnitSystem& units,
                            const std::vector<std::string>& first = {}) {
  const std::vector<GroupColumn> columns = columns_of(file, group, units, first);
  Table table{"", caption, {{"", "Quantity"}}};
  for (const GroupColumn& column : columns)
    if (column.name == name)
      for (const Value& each : column.values) table.columns.push_back({"", written(each, {})});
  if (name.empty()) table.columns.push_back({"", "Value"});
  table.columns.push_back({"", "Meaning"});
  for (const GroupColumn& column : columns) {
    if (column.text || column.values.size() + 2 != table.columns.size() ||
        std::ranges::all_of(column.values, &Value::is_missing))
      continue;
    std::vector<Cell> row{column.head.label};
    for (const Value& each : column.values) row.emplace_back(each, column.head.format);
    row.emplace_back(column.head.meaning);
    table.add(std::move(row));
  }
  return table;
}

/// What the page of one run is made of.
struct RunFile {
  explicit RunFile(const PageRequest& request)
      : overview(study::run_overview(request.file)),
        units(request.units),
        file(request.file),
        histories(request.file) {
    try {
      scene = scene_of_run(file, request.job);
    } catch (const Error& error) {
      no_scene = std::string("No drawing: ") + error.what();
    }
  }

  study::RunOverview overview;
  study::UnitSystem units;
  study::Hdf5Reader file;
  study::StoredHistories histories;
  std::optional<JobScene> scene;
  std::string no_scene;
};

/// The verdict on each item whose numbers are those of one run among many, before all numbers.
std::vector<std::string> cautions_of(const RunFile& run) {
  std::vector<std::string> all;
  for (const auto& [item, found] : study::stored_predictability(run.file))
    if (found.verdict != Predictability::Verdict::kPredictable)
      all.push_back(item + ": " + explanation::sentence(found) + ".");
  if (run.overview.outcome == name_of(Outcome::kStillMoving))
    all.push_back("Something still moved at the end: residual values are not final.");
  append_all(all, run.overview.file.warnings);
  return all;
}

std::vector<std::string> names_of_demands() { return names_of(study::demand_columns()); }

constexpr std::size_t kMostSettled = 3;  // items; of more the table would be too wide

/// Inserts what each demand of an item is settled to, beside it. Nothing where the run was not judged.
void insert_settled(const RunFile& run, Table& table) {
  const std::size_t items = table.columns.size() - 2;
  if (items > kMostSettled || !run.file.has("/settled/demand")) return;
  const auto text = [&](const char* name) {
    return run.file.strings(std::string("/settled/") + name);
  };
  const auto names = text("item"), parts = text("part"), demands = text("demand"),
             units = text("unit");
  const std::vector<double> settled = run.file.numbers("/settled/settled_to");
  std::map<std::pair<std::string, std::string>, std::string> of;  // by item and label
  for (std::size_t i = 0; i < settled.size(); ++i)
    if (parts.at(i).empty())
      of[{names.at(i),
          figures::with_unit(figures::label_of(demands.at(i)), run.units.of(units.at(i)))}] =
          std::isfinite(settled[i]) ? fmt::format("{:g} %", 100 * settled[i]) : "NOT SETTLED";
  for (std::size_t item = items; item > 0; --item) {
    const auto at = static_cast<std::ptrdiff_t>(item) + 1;
    const std::string name = table.columns[item].label;
    table.columns.insert(table.columns.begin() + at, {"", "settled to"});
    for (std::vector<Cell>& row : table.rows) {
      const auto found = of.find({name, written(row.front().value, {})});
      const bool absent = found == of.end() || row[item].value.is_missing();
      row.insert(row.begin() + at, absent ? std::string() : found->second);
    }
  }
}

Section summary(const RunFile& run, const findings::Section& narrative) {
  Table demands = turned_table_of_group(run.file, "items", "Demands of the items", "item",
                                        run.units, names_of_demands());
  insert_settled(run, demands);
  return {"summary", "At a glance",
          caution_box(cautions_of(run)) + html(narrative) +
              html(report::outcome_findings(run.overview)) + html(demands)};
}

Section design(const RunFile& run) {
  Html content;
  if (run.scene)
    content += scene_drawings(*run.scene, "", run.units);
  else
    content += paragraph(run.no_scene);
  content += html(table_of_group(run.file, "drawn", "Parameters that were drawn",
                                 {"variable", "value", "unit"}, run.units));
  return {"design", "What was run", content};
}

/// Nothing for files of earlier programs, which do not have the floor's motion.
Html spectra_of_floor(const RunFile& run) {
  const auto spectra = study::floor_spectra(run.histories);
  if (!spectra) return {};
  return html(Drawing{"spectra", figures::floor_spectra_figure({.units = run.units}, "", *spectra),
                      "Response spectra of the floor\u2019s motion.",
                      "Pseudo-acceleration over the period, 5 % damping, on logarithmic axes."});
}

/// "NAME (SHA-256 0123456789ab...)" of "SHA-256 NAME".
std::string file_words(const std::string& hash_and_name) {
  constexpr std::size_t kDigits = 12;
  const std::size_t space = hash_and_name.find(' ');
  if (space == std::string::npos) return hash_and_name;
  return fmt::format("{} (SHA-256 {}\u2026)", hash_and_name.substr(space + 1),
                     hash_and_name.substr(0, std::min(space, kDigits)));
}

Section record(const RunFile& run) {
  std::vector<std::pair<std::string, std::string>> named;
  for (const auto& motion : run.overview.file.motions) {
    named.emplace_back("Record", motion.name);
    for (const std::string& each : motion.files) named.emplace_back("File", file_words(each));
  }
  for (const std::string& each : run.file.text_attributes("record_components"))
    named.emplace_back("Component", each);
  for (const std::string& each : run.file.text_attributes("record_processing"))
    named.emplace_back("Processing", each);
  if (named.empty()) return {"records", "Ground motion", paragraph("The floor is at rest.")};
  return {"records", "Ground motion", facts(named) + spectra_of_floor(run)};
}

Section paths(const RunFile& run) {
  if (run.histories.names().empty())
    return {"paths", "Paths", paragraph("The run kept no histories (settings.history_step_s).")};
  return {
      "paths", "Paths",
      html(Drawing{"paths", figures::trajectory_figure({.units = run.units}, run.histories.path()),
                   "Paths of the items seen from above, outlines at the start and at the end.",
                   "The room with the items before and after the motion."})};
}

Section explanation_section(const PageRequest& request) {
  if (!request.explanation)
    return {"explanation", "What happened and why",
            paragraph("Not explained: " + request.no_explanation)};
  const explanation::Explanation& of = *request.explanation;
  Html content = html(report::explanation_findings(of));
  if (!of.failed)
    content +=
        html(Drawing{"explanation", figures::explanation_figure(of), explanation::headline(of),
                     "Floor acceleration, distance, tilt, forces and energies around it."});
  return {"explanation", "What happened and why", content};
}

Section histories(const RunFile& run) {
  const std::vector<std::string> known = run.histories.names();
  Html figures;
  for (const char* name : {"floor_acceleration", "displacement", "velocity", "tilt", "yaw",
                           "normal_force", "swivel_angle", "point_absolute_acceleration"}) {
    if (std::ranges::find(known, name) == known.end() || run.histories.runs().empty()) continue;
    const study::StoredHistory history = run.histories.history(name, run.histories.runs().front());
    if (history.series.empty() || history.time.empty()) continue;
    std::string id = std::string("history-") + name;
    std::ranges::replace(id, '_', '-');
    figures += html(Drawing{
        id, figures::history_figure({.width = kNarrow, .units = run.units}, "", "", {history}),
        figures::label_of(name) + " over time.",
        fmt::format("{} over {:.4g} seconds.", counted(history.series.size(), "curve"),
                    history.time.back())});
  }
  return {"histories", "Histories", side_by_side(figures)};
}

Section tables(const RunFile& run) {
  struct Group {
    const char *name, *caption;
    std::vector<std::string> first;
  };
  const Group groups[] = {
      {"events", "Impacts, by time", {"time", "item", "body", "other", "other_body"}},
      {"zones", "Zones of the room", {"zone"}},
      {"tethers", "Tethers", {"tether"}},
      {"wheels", "Wheels", {"item", "wheel"}},
      {"points", "Marked points", {"item", "point"}},
      {"predictability", "What became of a change of all masses by 1e-9", {"item", "verdict"}},
      {"settled",
       "Which demands half the time step and a change of all masses by 1e-9 leave",
       {"item", "part", "demand", "settled_to", "step_change", "twin_change"}}};
  Html content;
  for (const Group& group : groups)
    content += html(table_of_group(run.file, group.name, group.caption, group.first, run.units));
  content += html(
      turned_table_of_group(run.file, "energy", "Energy balance at the end", "item", run.units));
  content +=
      html(turned_table_of_group(run.file, "verification", "Numerical quality", "", run.units));
  return {"tables", "Tables", content};
}

Section methods(const RunFile& run) {
  const study::FileOverview& file = run.overview.file;
  std::string text = fmt::format(
      "The response was simulated with Gurney {} (commit {}, CPU class "
      "{})",
      file.program_version, file.git_commit, file.cpu_class);
  if (run.scene && run.scene->settings.peak_error > 0)
    text += fmt::format(" with the time step halved from {:g} ms until the peaks settled",
                        1000 * run.scene->settings.time_step);
  else if (run.scene && run.scene->settings.tolerance <= 0)
    text += fmt::format(" with a time step of {:g} ms", 1000 * run.scene->settings.time_step);
  text += file.motions.empty()
              ? "; the floor was at rest."
              : "; the floor moved as the record " + file.motions.front().name + ".";
  text += fmt::format(" The run ended after {:.4g} s ({}).", run.overview.end_time,
                      run.overview.outcome);
  return {"methods", "Methods", element("div", paragraph(text), {{"class", "methods"}})};
}

}  // namespace

Document run_document(const PageRequest& request) {
  const RunFile run(request);
  const study::FileOverview& file = run.overview.file;
  return {file.title.empty() ? file.job_name : file.title,
          fmt::format("One run of {}: {} at {:.4g} s", counted(run.overview.items.size(), "item"),
                      run.overview.outcome, run.overview.end_time),
          {summary(run, request.narrative), design(run), record(run), paths(run),
           explanation_section(request), histories(run), tables(run), methods(run),
           assumptions_section(file, {}),
           provenance_section(file, run.file.text_attribute("job_text"), {})},
          {}};
}

}  // namespace gurney::page
