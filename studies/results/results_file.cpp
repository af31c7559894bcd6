#include "studies/results/results_file.h"

#include <functional>
#include <numeric>
#include <span>
#include <type_traits>
#include <vector>

#include "engine/base/append_all.h"
#include "engine/response/response.h"
#include "engine/scene/scene.h"
#include "studies/build_info/build_info.h"
#include "studies/results/hdf5_writer.h"
#include "studies/results/histories.h"
#include "studies/results/names.h"

namespace gurney::study {
namespace {

/// What `of` says of each row.
template <class Rows, class Of>
auto each_of(const Rows& rows, Of of) {
  std::vector<std::decay_t<std::invoke_result_t<Of, decltype(*rows.begin())>>> values;
  for (const auto& row : rows) values.push_back(std::invoke(of, row));
  return values;
}

/// A group of 1-D columns; the first ones identify the run of a row, and what in it.
class Table {
 public:
  Table(Hdf5Writer& file, const std::string& name, std::size_t rows)
      : file_(file), group_("/" + name + "/") {
    file_.add_group("/" + name);
    std::vector<std::int64_t> index(rows);
    std::iota(index.begin(), index.end(), 0);
    file_.add_scale({group_ + "row", "1", "row of the table", {}}, index);
    file_.add({group_ + "run", "1", "index of the run", scales()},
              std::vector<std::int64_t>(rows, 0));
  }

  void add(const std::string& name, const std::string& meaning,
           const std::vector<std::string>& values) {
    file_.add({group_ + name, "1", meaning, scales()}, values);
  }

  void add(const std::string& name, const std::string& units, const std::string& meaning,
           const std::vector<double>& values) {
    file_.add({group_ + name, units, meaning, scales()}, values);
  }

  template <class Row>
  void add(std::span<const TableColumn<Row>> columns, const std::vector<Row>& rows) {
    add_columns(file_, group_, columns, scales(), rows);
  }

  void add(const TableColumn<ItemResponse>& column, const std::vector<ItemResponse>& rows) {
    add(std::span(&column, 1), rows);
  }

 private:
  std::vector<std::string> scales() const { return {group_ + "row"}; }

  Hdf5Writer& file_;
  std::string group_;
};

constexpr const char* kItem = "name of the item";

void add_items(Hdf5Writer& file, const Scene& scene, const std::vector<ItemResponse>& items) {
  Table table(file, "items", items.size());
  table.add("item", kItem, item_names(scene));
  table.add("model", "name of its kind of equipment",
            each_of(scene.items, [](const PlacedItem& item) { return item.model.name; }));
  table.add(demand_columns(), each_of(items, &ItemResponse::demands));

  Table account(file, "energy", items.size());
  account.add("item", kItem, item_names(scene));
  account.add({"stored_energy_at_start", "J", "energy stored at the start",
               [](const ItemResponse& item) { return item.stored_energy_at_start; }},
              items);
  account.add(energy_columns(), each_of(items, &ItemResponse::energy));
}

/// Empty where no twin was run.
void add_predictability(Hdf5Writer& file, const Scene& scene,
                        const std::vector<ItemResponse>& items) {
  const std::vector<std::string> names = item_names(scene);
  std::vector<std::string> of, verdicts;
  std::vector<Predictability> rows;
  for (std::size_t i = 0; i < items.size(); ++i)
    if (const auto& found = items[i].predictability) {
      of.push_back(names[i]);
      verdicts.emplace_back(name_of(found->verdict));
      rows.push_back(*found);
    }
  Table table(file, "predictability", rows.size());
  table.add("item", kItem, of);
  table.add("verdict", "of the peaks: predictable, sensitive or chaotic", verdicts);
  table.add(predictability_columns(), rows);
}

/// One row for each demand of each item, its wheels and marked points; empty where a repetition is
/// missing.
void add_settled(Hdf5Writer& file, const Scene& scene, const std::vector<ItemResponse>& items) {
  const std::vector<std::string> names = item_names(scene);
  std::vector<std::string> of, parts, demands, units;
  std::vector<SettledDemand> rows;
  for (std::size_t i = 0; i < items.size(); ++i)
    for (const SettledDemand& each : settled_demands(items[i])) {
      of.push_back(names[i]);
      parts.push_back(part_of(each.number, scene.items[i].model));
      demands.emplace_back(each.number.name);
      units.emplace_back(each.number.units);
      rows.push_back(each);
    }
  Table table(file, "settled", rows.size());
  table.add("item", kItem, of);
  table.add("part", "the wheel or marked point; empty: the item", parts);
  table.add("demand", "name of the demand", demands);
  table.add("unit", "its SI unit", units);
  table.add(settled_columns(), rows);
}

/// One row for each wheel or marked point of every item.
template <class Row>
void add_parts(Hdf5Writer& file, const std::string& name, const std::string& part,
               const std::string& meaning, const Scene& scene, const Response& response,
               std::span<const TableColumn<Row>> columns, std::vector<Row> Demands::*member,
               std::vector<std::string> (*names_of)(const EquipmentModel&)) {
  std::vector<std::string> items, parts;
  std::vector<Row> rows;
  const std::vector<std::string> names = item_names(scene);
  for (std::size_t i = 0; i < response.items.size(); ++i) {
    const std::vector<Row>& of_item = response.items[i].demands.*member;
    const std::vector<std::string> of_model = names_of(scene.items[i].model);
    append_all(rows, of_item);
    append_all(parts, of_model);
    items.insert(items.end(), of_item.size(), names[i]);
  }
  Table table(file, name, rows.size());
  table.add("item", kItem, items);
  table.add(part, meaning, parts);
  table.add(columns, rows);
}

void add_events(Hdf5Writer& file, const Scene& scene, const std::vector<Impact>& impacts) {
  const std::vector<std::string> names = item_names(scene);
  Table table(file, "events", impacts.size());
  table.add("item", kItem, each_of(impacts, [&](const Impact& i) { return names.at(i.item); }));
  table.add("body", "its part: chassis, or the name of a caster", each_of(impacts, &Impact::body));
  table.add("other", "what it hit: floor, or the name of a shape of the room or of an item",
            each_of(impacts, &Impact::other));
  table.add("other_body", "part of the other item; empty: it hit no item",
            each_of(impacts, &Impact::other_body));
  table.add(impact_columns(), impacts);
}

/// `value` of each of the first `rows` parts.
template <class Part, class Value>
std::vector<double> values_of(const std::vector<Part>& parts, std::size_t rows, Value value) {
  std::vector<double> values;
  for (std::size_t i = 0; i < rows; ++i) values.push_back(value(parts.at(i)));
  return values;
}

void add_places(Table& table, const std::vector<Zone>& zones, std::size_t rows) {
  const auto add = [&](const char* name, const char* units, const char* meaning, auto value) {
    table.add(name, units, meaning, values_of(zones, rows, value));
  };
  add("center_x", "m", "x of its middle", [](const Zone& z) { return z.center.x(); });
  add("center_y", "m", "y of its middle", [](const Zone& z) { return z.center.y(); });
  add("length", "m", "length along its way through", [](const Zone& z) { return z.length; });
  add("width", "m", "width across", [](const Zone& z) { return z.width; });
  add("angle", "rad", "of its way through, from the floor's x axis",
      [](const Zone& z) { return z.angle; });
}

void add_places(Table& table, const std::vector<Tether>& tethers, std::size_t rows) {
  const char* const axes[] = {"x", "y", "z"};
  for (int axis = 0; axis < 3; ++axis) {
    const std::string letter = axes[axis];
    table.add("point_" + letter, "m", letter + " of its end at the item, item axes",
              values_of(tethers, rows, [axis](const Tether& t) { return t.point[axis]; }));
    table.add("anchor_" + letter, "m", letter + " of its end in the room, floor axes",
              values_of(tethers, rows, [axis](const Tether& t) { return t.anchor[axis]; }));
  }
  table.add("slack_length", "m", "length up to which it is slack",
            values_of(tethers, rows, [](const Tether& t) { return t.slack_length; }));
}

void add_zones(Hdf5Writer& file, const Scene& scene, const std::vector<ZoneOutcome>& zones) {
  std::vector<std::string> names;
  for (std::size_t i = 0; i < zones.size(); ++i) names.push_back(scene.zones.at(i).name);
  Table table(file, "zones", zones.size());
  table.add("zone", "name of the zone", names);
  table.add(zone_columns(), zones);
  add_places(table, scene.zones, zones.size());
}

void add_tethers(Hdf5Writer& file, const Scene& scene, const std::vector<TetherOutcome>& tethers) {
  std::vector<std::string> names, items, anchors;
  const std::vector<std::string> of_items = item_names(scene);
  for (std::size_t i = 0; i < tethers.size(); ++i) {
    const Tether& tether = scene.tethers.at(i);
    names.push_back(tether.name);
    items.push_back(of_items.at(tether.item));
    anchors.push_back(tether.anchor_item ? of_items.at(*tether.anchor_item) : "");
  }
  Table table(file, "tethers", tethers.size());
  table.add("tether", "name of the tether", names);
  table.add("item", kItem, items);
  table.add(tether_columns(), tethers);
  add_places(table, scene.tethers, tethers.size());
  if (std::ranges::any_of(anchors, [](const std::string& each) { return !each.empty(); }))
    table.add("anchor_item", "where it ends, in whose item axes anchor is; empty: in the room",
              anchors);
}

/// The groups that hold one row for each item, wheel, point, impact, zone or tether of a run:
/// /items, /energy, /wheels, /points, /events, /zones and /tethers. All columns are 1-D.
void add_tables(Hdf5Writer& file, const Scene& scene, const Response& response) {
  add_items(file, scene, response.items);
  add_predictability(file, scene, response.items);
  add_settled(file, scene, response.items);
  add_parts(file, "wheels", "wheel", "name of the caster", scene, response, wheel_demand_columns(),
            &Demands::wheels, caster_names);
  add_parts(file, "points", "point", "name of the marked point", scene, response,
            point_demand_columns(), &Demands::points, point_names);
  add_events(file, scene, response.impacts);
  add_zones(file, scene, response.zones);
  add_tethers(file, scene, response.tethers);
}

using Scales = std::vector<std::string>;

const Scales kRun{"/runs/run"};

void add_root(Hdf5Writer& file, const RunFacts& facts) {
  const auto text = [&](const std::string& name, const std::string& value) {
    file.set_attribute("/", name, value);
  };
  add_program(file, "gurney-results", kResultsFormatVersion);
  text("job_name", facts.job_name);
  text("job_text", facts.job_text);
  text("job_sha256", facts.job_sha256);
  text("title", facts.title);
  if (facts.seed) text("seed", std::to_string(*facts.seed));
  if (facts.draw) {
    text("draw_seed", std::to_string(facts.draw->seed()));
    text("draw", std::to_string(facts.draw->run()));
  }
  const RecordFacts record = facts.record.value_or(RecordFacts{});
  file.set_attribute("/", "record_files", each_of(record.files, &FileFacts::name));
  file.set_attribute("/", "record_sha256", each_of(record.files, &FileFacts::sha256));
  file.set_attribute("/", "record_components", record.components);
  file.set_attribute("/", "record_processing", record.processing);
  file.set_attribute("/", "warnings", facts.warnings);
}

void add_record(Hdf5Writer& file, const RecordFacts& record) {
  const auto per_axis = [&](const char* name, const char* units, const char* meaning,
                            const Vector3& value) {
    file.add({std::string("/runs/record_") + name, units, meaning, {"/runs/run", "/runs/axis"}},
             std::span<const double>(value.data(), 3));
  };
  per_axis("pga", "m/s2", "largest |floor acceleration|", record.pga);
  per_axis("pgv", "m/s", "largest |floor velocity|", record.pgv);
  per_axis("pgd", "m", "largest |floor displacement|", record.pgd);
  per_axis("residual_velocity", "m/s", "floor velocity left at the end of the record",
           record.residual_velocity);
  per_axis("residual_displacement", "m", "floor displacement left at the end of the record",
           record.residual_displacement);
}

void add_runs(Hdf5Writer& file, const RunFacts& facts, const Response& response) {
  const auto one_text = [&](const char* name, const char* meaning, const std::string& value) {
    file.add({std::string("/runs/") + name, "1", meaning, kRun}, std::vector<std::string>{value});
  };
  file.add_group("/runs");
  file.add_scale({"/runs/run", "1", "index of the run", {}}, std::vector<std::int64_t>{0});
  file.add_scale({"/runs/axis", "1", "floor axis", {}}, std::vector<std::string>{"x", "y", "z"});
  one_text("record", "name of the floor motion; empty: the floor is at rest",
           facts.record ? facts.record->name : "");
  one_text("outcome",
           "how the run ended: rested, still_moving, stopped, overturned, diverged or untrusted",
           name_of(response.outcome));
  one_text("cause", "why the run failed, or ends where its item overturned; otherwise empty",
           response.cause);
  file.add({"/runs/end_time", "s", "end of the run", kRun}, std::vector<double>{response.end_time});
  add_record(file, facts.record.value_or(RecordFacts{}));
}

void add_verification(Hdf5Writer& file, const Response& response) {
  file.add_group("/verification");
  file.add_scale({"/verification/run", "1", "index of the run", {}}, std::vector<std::int64_t>{0});
  const Scales run{"/verification/run"};
  add_columns(file, "/verification/", quality_columns(), run,
              std::vector<Quality>{response.quality});
}

void add_assumptions(Hdf5Writer& file, const std::vector<AssumptionFacts>& assumptions) {
  const std::string group = "/assumptions/";
  const auto add = [&](const char* name, const char* meaning, std::string AssumptionFacts::*of) {
    file.add({group + name, "1", meaning, {group + "key"}}, each_of(assumptions, of));
  };
  file.add_group("/assumptions");
  file.add_scale({group + "key", "1", "the number that has no source", {}},
                 each_of(assumptions, &AssumptionFacts::key));
  add("value", "its value in this run", &AssumptionFacts::value);
  add("range", "how far it may be off", &AssumptionFacts::range);
  add("reason", "why this value", &AssumptionFacts::reason);
  add("file", "data file that states it", &AssumptionFacts::file);
}

void add_drawn(Hdf5Writer& file, const std::vector<DrawnFacts>& drawn) {
  const std::string group = "/drawn/";
  const auto add = [&](const char* name, const char* meaning, auto DrawnFacts::*of) {
    file.add({group + name, "1", meaning, {group + "variable"}}, each_of(drawn, of));
  };
  file.add_group("/drawn");
  file.add_scale({group + "variable", "1", "the parameter that was drawn", {}},
                 each_of(drawn, &DrawnFacts::variable));
  add("value", "its value in this run, in the unit given", &DrawnFacts::value);
  add("unit", "unit of its value", &DrawnFacts::unit);
  add("distribution", "what it was drawn from, in the unit given", &DrawnFacts::distribution);
  add("file", "data file that states it", &DrawnFacts::file);
}

}  // namespace

void add_program(Hdf5Writer& file, const std::string& filetype, int format_version) {
  const build_info::BuildInfo build = build_info::build_info();
  file.set_attribute("/", "filetype", filetype);
  file.set_attribute("/", "format_version", std::int64_t{format_version});
  file.set_attribute("/", "program_version", build.program_version);
  file.set_attribute("/", "git_commit", build.git_commit);
  file.set_attribute("/", "compiler", build.compiler);
  file.set_attribute("/", "bullet_precision", build.bullet_precision);
  file.set_attribute("/", "cpu_class", build.cpu_class);
}

std::string results_image(const RunFacts& facts, const Response& response) {
  Hdf5Writer file;
  add_root(file, facts);
  add_runs(file, facts, response);
  add_tables(file, facts.scene, response);
  add_shapes(file, facts.scene, response);
  add_histories(file, facts, response);
  add_assumptions(file, facts.assumptions);
  if (facts.draw) add_drawn(file, facts.drawn);
  add_verification(file, response);
  return file.image();
}

}  // namespace gurney::study
