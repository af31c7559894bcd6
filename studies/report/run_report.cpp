#include "studies/report/run_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <string_view>

#include "engine/base/names.h"
#include "engine/response/settled.h"
#include "studies/build_info/build_info.h"
#include "studies/explanation/overturning.h"
#include "studies/report/explanation_report.h"
#include "studies/report/formats.h"
#include "studies/results/columns.h"
#include "studies/results/names.h"

namespace gurney::report {
namespace {

using findings::Cell;
using findings::Format;
using findings::Section;
using findings::Table;
using findings::Texts;
using findings::Value;
using study::UnitSystem;
using Of = DemandNumber::Of;

/// Missing of an item without casters.
const std::set<std::string> kDemandsOfWheels = {"peak_normal_force", "lifted_time",
                                                "most_wheels_lifted"};

std::string words_of(std::string name) {
  std::ranges::replace(name, '_', ' ');
  return name;
}

template <class Row>
Value value_of(const study::TableColumn<Row>& column, const Row& row) {
  const double value = column.value(row);
  if (column.is_missing(value)) return {};
  return column.whole() ? Value(static_cast<std::int64_t>(value)) : Value(value);
}

/// @param shown  for people: a millionth of the least length, angle, ... that anybody asks for is rounding
template <class Row>
Format format_of(const study::TableColumn<Row>& column, const UnitSystem& units, bool shown) {
  Format format = report::format_of(units.of(column.units), 1, "");
  if (shown && std::string_view(column.units) != "1")
    format.least = 1e-6 * size_of_interest(column.units);
  return format;
}

/// A fact for each column of a row.
/// @param shown  for people too
/// @param note   of a column by its name
template <class Row, class Note>
Section facts_of(const std::string& key, const std::string& title,
                 std::span<const study::TableColumn<Row>> columns, const Row& row,
                 const UnitSystem& units, bool shown, Note note) {
  Section all(key, title);
  for (const study::TableColumn<Row>& column : columns)
    all.fact(column.name, shown ? words_of(column.name) : "", value_of(column, row),
             format_of(column, units, shown), note(column.name));
  return all;
}

template <class Row>
Section json_facts(const std::string& key, std::span<const study::TableColumn<Row>> columns,
                   const Row& row) {
  return facts_of(key, "", columns, row, {}, false, [](const char*) { return ""; });
}

/// A row with its name for each of them, the first columns for people.
/// @param mark  before the number of a row and a column
template <class Row, class Mark>
Table rows_of(const std::string& key, const std::string& label,
              std::span<const study::TableColumn<Row>> columns, std::size_t shown,
              const Texts& names, const std::vector<Row>& rows, const UnitSystem& units,
              Mark mark) {
  Table table{key, "", {{"name", shown > 0 ? label : ""}}};
  for (const study::TableColumn<Row>& column : columns)
    table.columns.push_back({column.name,
                             table.columns.size() <= shown ? words_of(column.name) : "",
                             format_of(column, units, shown > 0), column.meaning});
  for (std::size_t i = 0; i < rows.size(); ++i) {
    std::vector<Cell> cells{names.at(i)};
    for (const study::TableColumn<Row>& column : columns) {
      Format format = format_of(column, units, shown > 0);
      format.before = mark(i, column.name);
      cells.emplace_back(value_of(column, rows[i]), format);
    }
    table.add(std::move(cells));
  }
  return table;
}

template <class Row, class Named>
Table json_rows(const std::string& key, std::span<const study::TableColumn<Row>> columns,
                const std::vector<Row>& rows, const std::vector<Named>& named) {
  const std::vector<std::string> names = names_of(named);
  return rows_of(key, "", columns, 0, names, rows, {}, [](std::size_t, const char*) { return ""; });
}

// Inputs of the run.

double mass_of(const EquipmentModel& item) { return whole_item(item).mass; }

void add_items(const Texts& names, const Scene& scene, const UnitSystem& units, Section& all) {
  for (std::size_t i = 0; i < names.size(); ++i) {
    const EquipmentModel& model = scene.items[i].model;
    all.text(
        "item",
        fmt::format("{}: {}{} {}", names[i], names[i] == model.name ? "" : model.name + ", ",
                    units.fixed(mass_of(model), "kg", 1),
                    model.casters.empty() ? "without casters"
                                          : fmt::format("on {} casters", model.casters.size())));
  }
}

void add_record(const std::optional<study::RecordFacts>& record, const UnitSystem& units,
                Section& all) {
  if (!record) {
    all.json("record", {}).text("floor", "at rest");
    return;
  }
  const study::RecordFacts& r = *record;
  Section of("record");
  of.json("name", r.name);
  of.text("floor",
          fmt::format("{}: {:.2f} s, sampled every {:g} s", r.name, r.duration, r.time_step));
  for (const std::string& each : r.components) of.text("component", each);
  for (const std::string& each : r.processing) of.text("processing", each);
  Table files{"files", "", {}};
  for (const study::FileFacts& each : r.files)
    add_row(files, {{"name", each.name}, {"sha256", each.sha256}});
  of.add(std::move(files)).list("components", "", r.components);
  of.list("processing", "", r.processing);
  of.json("duration_s", r.duration).json("time_step_s", r.time_step);
  Table peaks{"", "", {{"", "floor motion"}, {"", "x"}, {"", "y"}, {"", "z"}, {"", "unit"}}};
  const auto add = [&](const char* key, const char* label, const char* si, const Vector3& value) {
    of.json(key, value);
    const study::ReportUnit unit = units.of(si);
    std::vector<Cell> row{label};
    for (const double each : value)
      row.emplace_back(Value(each), report::format_of(unit, 1, ".4f"));
    row.emplace_back(unit.name);
    peaks.add(std::move(row));
  };
  add("pga_m_per_s2", "PGA", "m/s2", r.pga);
  add("pgv_m_per_s", "PGV", "m/s", r.pgv);
  add("pgd_m", "PGD", "m", r.pgd);
  add("residual_velocity_m_per_s", "residual velocity", "m/s", r.residual_velocity);
  add("residual_displacement_m", "residual displacement", "m", r.residual_displacement);
  all.add(std::move(of.add(std::move(peaks))));
}

// Results, item by item.

/// Labels of the demands, shaped as these.
Section settled_section(const std::vector<SettledDemand>& all, const EquipmentModel& model) {
  Section demands("demands");
  std::vector<Section> wheels(model.casters.size(), Section("wheels[]")),
      points(model.marked_points.size(), Section("points[]"));
  for (std::size_t i = 0; i < wheels.size(); ++i) wheels[i].json("name", model.casters[i].name);
  for (std::size_t i = 0; i < points.size(); ++i)
    points[i].json("name", model.marked_points[i].name);
  for (const SettledDemand& each : all) {
    Section& of = each.number.of == Of::kItem    ? demands
                  : each.number.of == Of::kWheel ? wheels.at(each.number.part)
                                                 : points.at(each.number.part);
    Section labels(each.number.name);
    labels.json("settled_to", each.within()).json("step_change", each.step_change);
    of.add(std::move(labels.json("twin_change", each.twin_change)));
  }
  Section section("settled");
  section.add(std::move(demands)).list("wheels", "", {}).list("points", "", {});
  for (Section& each : wheels) section.add(std::move(each));
  for (Section& each : points) section.add(std::move(each));
  return section;
}

/// @param shown  for people: the only item
Section item_section(const std::string& name, const EquipmentModel& model, const ItemResponse& item,
                     const UnitSystem& units, bool shown) {
  const std::vector<SettledDemand> settled = settled_demands(item);
  const auto label = [&](Of of, std::size_t part, const std::string& demand) {
    const auto found = std::ranges::find_if(settled, [&](const SettledDemand& each) {
      return each.number.of == of && each.number.part == part && each.number.name == demand;
    });
    return found == settled.end() ? nullptr : &*found;
  };
  const auto mark = [&](Of of) {
    return [&label, of](std::size_t part, const char* demand) {
      const SettledDemand* const found = label(of, part, demand);
      return found != nullptr && !found->settled() ? "~" : "";
    };
  };
  const Demands& demands = item.demands;
  const bool rolls = !model.casters.empty();
  Section all("items[]");
  all.json("name", name).json("model", model.name);
  Section of_item = facts_of("demands", "demands", study::demand_columns(), demands, units, shown,
                             [&](const char* demand) -> std::string {
                               const SettledDemand* const found = label(Of::kItem, 0, demand);
                               if (found == nullptr) return "";
                               return found->settled()
                                          ? fmt::format("settled to {:g} %", 100 * found->within())
                                          : "NOT SETTLED";
                             });
  if (!rolls)
    for (findings::Part& each : of_item.parts)
      if (auto& fact = std::get<findings::Fact>(each); kDemandsOfWheels.contains(fact.key))
        fact.label.clear();
  all.add(std::move(of_item));
  // When wheels lifted before an overturning, and numerical accelerations, are reported in words.
  constexpr std::size_t kOfWheels = 5;
  all.add(rows_of("wheels", "wheel", study::wheel_demand_columns(), shown ? kOfWheels : 0,
                  study::caster_names(model), demands.wheels, units, mark(Of::kWheel)));
  all.add(rows_of("points", "point", study::point_demand_columns(),
                  shown ? study::judged_point_columns().size() : 0, study::point_names(model),
                  demands.points, units, mark(Of::kPoint)));
  if (shown && std::ranges::any_of(settled, [](const SettledDemand& each) {
        return each.number.of != Of::kItem && !each.settled();
      }))
    all.say("~ not settled");
  all.add(json_facts("energy", study::energy_columns(), item.energy));
  if (item.predictability)
    all.add(std::move(
        json_facts("predictability", study::predictability_columns(), *item.predictability)
            .json("verdict", name_of(item.predictability->verdict))));
  else
    all.json("predictability", {});
  if (settled.empty()) return std::move(all.json("settled", {}));
  return std::move(all.add(settled_section(settled, model)));
}

/// A row for each item that stands on another or is a part, with what only these have.
void add_parts_table(const Texts& names, const std::vector<ItemResponse>& items,
                     const UnitSystem& units, Section& all) {
  const auto format = [&](const UnitSystem& system, const char* si, const char* digits) {
    return report::format_of(system.of(si), 1, digits);
  };
  const UnitSystem lengths = units.or_else("g-mm");
  constexpr double kYield = 1e-9;  // less is what a lock gives under the weight at the start [m]
  const auto known = [](double number) {
    return std::isnan(number) ? Value() : Value(number < kYield ? 0.0 : number);
  };
  const auto time = [](double number) { return number >= 0 ? Value(number) : Value(); };
  Table table{"", "", {}};
  for (std::size_t i = 0; i < items.size(); ++i) {
    const Demands& d = items[i].demands;
    if (std::isnan(d.peak_slide) && std::isnan(d.peak_travel) && std::isnan(d.peak_swing)) continue;
    add_row(table, {{{"", "item"}, names.at(i)},
                    {{"", "slid", format(lengths, "m", ".4g")}, known(d.peak_slide)},
                    {{"", "toppled", format(units, "s", ".2f")}, time(d.time_of_toppling)},
                    {{"", "fell", format(units, "s", ".2f")}, time(d.time_of_fall)},
                    {{"", "latch open", format(units, "s", ".2f")}, time(d.time_of_release)},
                    {{"", "opened", format(lengths, "m", ".4g")}, known(d.peak_travel)},
                    {{"", "swung", format(units, "rad", ".1f")}, known(d.peak_swing)},
                    {{"", "stop", format(units, "m/s", ".2f")}, known(d.largest_stop_speed)}});
  }
  if (!table.rows.empty()) all.add(std::move(table));
}

/// A row for each of several items.
void add_items_table(const Texts& names, const std::vector<ItemResponse>& items,
                     const UnitSystem& units, Section& all) {
  const auto of = [](const UnitSystem& system, const char* si, const char* digits) {
    return report::format_of(system.of(si), 1, digits);
  };
  const UnitSystem lengths = units.or_else("g-mm");
  Table table{"", "", {}};
  for (std::size_t i = 0; i < items.size(); ++i) {
    const Demands& d = items[i].demands;
    add_row(table, {{{"", "item"}, names.at(i)},
                    {{"", "moved", of(lengths, "m", ".4g")}, d.peak_displacement},
                    {{"", "at end", of(lengths, "m", ".4g")}, d.residual_displacement},
                    {{"", "turned", of(units, "rad", ".1f")}, d.peak_yaw},
                    {{"", "tilt", of(units, "rad", ".1f")}, d.peak_tilt},
                    {{"", "lifted", of(units, "s", ".2f")}, d.lifted_time},
                    {{"", "impacts"}, d.impacts},
                    {{"", "fastest", of(units, "m/s", ".2f")},
                     d.impacts > 0 ? Value(d.largest_approach_speed) : Value()},
                    {{"", "overturned", of(units, "s", ".2f")},
                     d.time_of_overturning >= 0 ? Value(d.time_of_overturning) : Value()}});
  }
  all.add(std::move(table));
  add_parts_table(names, items, units, all);
  all.say("Wheels, points and impacts one by one: --json, or the results file.");
}

// Events, for programs; people read the narrative.

void add_events(const study::RunFacts& facts, const Response& response, const Texts& names,
                Section& all) {
  Table impacts{"impacts", "", json_columns({"item", "body", "other", "other_body"})};
  for (const auto& column : study::impact_columns()) impacts.columns.push_back({column.name, ""});
  for (const Impact& each : response.impacts) {
    std::vector<Cell> row{names.at(each.item), each.body, each.other, each.other_body};
    for (const auto& column : study::impact_columns()) row.emplace_back(value_of(column, each));
    impacts.add(std::move(row));
  }
  all.add(std::move(impacts)).list("overturnings", "", {});
  for (const explanation::Overturning& each : explanation::overturnings_of(facts, response)) {
    Section of("overturnings[]");
    of.json("item", names.at(each.item)).json("topples", each.topples).json("time_s", each.time);
    of.json("direction_rad", each.direction);
    Table liftoffs{"liftoffs", "", {}};
    for (const auto& wheel : each.liftoffs)
      add_row(liftoffs, {{"wheel", wheel.wheel}, {"time_s", wheel.time}});
    add_pulse("floor_pulse", each.half_cycle, of.add(std::move(liftoffs)));
    all.add(std::move(of));
  }
  all.add(json_rows("zones", study::zone_columns(), response.zones, facts.scene.zones));
  all.add(json_rows("tethers", study::tether_columns(), response.tethers, facts.scene.tethers));
}

/// Accelerations that are none.
std::string numerical_note(const std::vector<ItemResponse>& items, const UnitSystem& units) {
  double largest = 0;
  for (const ItemResponse& item : items)
    for (const PointDemands& point : item.demands.points)
      largest = std::fmax(largest, point.numerical_acceleration);
  if (!(largest > 0)) return "";
  return fmt::format(
      "note: accelerations of points leave out impacts that state a restitution and no stiffness; "
      "the numerical ones there reach {}.",
      units.chosen() ? units.text(largest, "m/s2") : fmt::format("{:.3g} m/s2", largest));
}

// Assumptions.

void add_draw(const study::RunFacts& facts, Section& all) {
  if (!facts.draw) {
    all.json("draw", {});
    return;
  }
  Section draw("draw", fmt::format("{}: {} parameters", facts.draw->text(), facts.drawn.size()));
  draw.json("seed", facts.draw->seed()).json("draw", facts.draw->run());
  Table drawn{"parameters", "", {}};
  for (const study::DrawnFacts& each : facts.drawn)
    add_row(drawn, {{{"variable", "parameter"}, each.variable},
                    {{"value", "value", {".5g"}}, each.value},
                    {"unit", each.unit},
                    {{"", "unit"}, each.unit == "1" ? "" : each.unit},
                    {"distribution", each.distribution},
                    {"file", each.file}});
  all.add(std::move(draw.add(std::move(drawn))));
}

void add_assumptions(const std::vector<study::AssumptionFacts>& assumptions, Section& all) {
  Table table{"assumptions", "", json_columns({"key", "value", "range", "reason", "file"})};
  std::vector<std::pair<std::string, int>> counts;
  for (const study::AssumptionFacts& each : assumptions) {
    table.add({each.key, each.value, each.range, each.reason, each.file});
    auto known = std::ranges::find(counts, each.file, &std::pair<std::string, int>::first);
    if (known == counts.end()) known = counts.insert(counts.end(), {each.file, 0});
    ++known->second;
  }
  all.add(std::move(table));
  Texts files;
  for (const auto& [file, count] : counts) files.push_back(fmt::format("{} {}", file, count));
  if (!assumptions.empty())
    all.say(fmt::format(
        "{} parameters of this run have no published source and are assumed ({}). Values, ranges "
        "and reasons: --json, or /assumptions in the results file.",
        assumptions.size(), fmt::join(files, ", ")));
}

}  // namespace

Section run_findings(const study::RunFacts& facts, const Response& response,
                     const UnitSystem& units) {
  const UnitSystem of_tables = units.or_else("m");
  const Texts names = study::item_names(facts.scene);
  const bool one = names.size() == 1;
  const build_info::BuildInfo build = build_info::build_info();
  Section all("", facts.title.empty() ? facts.job_name : facts.title);
  all.json("title", facts.title).json("job_name", facts.job_name);
  all.json("job_sha256", facts.job_sha256).json("program_version", build.program_version);
  all.json("git_commit", build.git_commit).json("cpu_class", build.cpu_class);
  add_items(names, facts.scene, units, all);
  add_record(facts.record, units, all);
  all.json("outcome", name_of(response.outcome)).json("cause", response.cause);
  for (const std::string& warning : facts.warnings) all.say("warning: " + warning);
  Section story = narrative(facts, response, units);
  all.json("narrative", fmt::format("{}", fmt::join(findings::lines_of(story), "\n")));
  all.add(std::move(story)).json("end_time_s", response.end_time);
  all.list("items", "", {});
  for (std::size_t i = 0; i < names.size(); ++i)
    all.add(
        item_section(names[i], facts.scene.items[i].model, response.items.at(i), of_tables, one));
  if (!one) add_items_table(names, response.items, units, all);
  add_events(facts, response, names, all);
  all.say(numerical_note(response.items, units));
  all.add(facts_of("quality", "quality", study::quality_columns(), response.quality, of_tables,
                   true, [](const char*) { return ""; }));
  all.list("warnings", "", facts.warnings);
  add_draw(facts, all);
  add_assumptions(facts.assumptions, all);
  return all;
}

}  // namespace gurney::report
