#include "studies/results/tables.h"

#include <numeric>

#include "studies/results/column_writer.h"
#include "studies/results/names.h"

namespace gurney::study {
namespace {

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
  std::vector<Demands> demands;
  std::vector<EnergyAccount> energy;
  std::vector<std::string> models;
  for (const ItemResponse& item : items) {
    demands.push_back(item.demands);
    energy.push_back(item.energy);
  }
  for (const PlacedItem& item : scene.items) models.push_back(item.model.name);
  Table table(file, "items", items.size());
  table.add("item", kItem, item_names(scene));
  table.add("model", "name of its kind of equipment", models);
  table.add(demand_columns(), demands);

  Table account(file, "energy", items.size());
  account.add("item", kItem, item_names(scene));
  account.add({"stored_energy_at_start", "J", "energy stored at the start",
               [](const ItemResponse& item) { return item.stored_energy_at_start; }},
              items);
  account.add(energy_columns(), energy);
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
    rows.insert(rows.end(), of_item.begin(), of_item.end());
    parts.insert(parts.end(), of_model.begin(), of_model.end());
    items.insert(items.end(), of_item.size(), names[i]);
  }
  Table table(file, name, rows.size());
  table.add("item", kItem, items);
  table.add(part, meaning, parts);
  table.add(columns, rows);
}

void add_events(Hdf5Writer& file, const Scene& scene, const std::vector<Impact>& impacts) {
  const std::vector<std::string> names = item_names(scene);
  std::vector<std::string> items, bodies, others, other_bodies;
  for (const Impact& impact : impacts) {
    items.push_back(names.at(impact.item));
    bodies.push_back(impact.body);
    others.push_back(impact.other);
    other_bodies.push_back(impact.other_body);
  }
  Table table(file, "events", impacts.size());
  table.add("item", kItem, items);
  table.add("body", "its part: chassis, or the name of a caster", bodies);
  table.add("other", "what it hit: floor, or the name of a shape of the room or of an item",
            others);
  table.add("other_body", "part of the other item; empty: it hit no item", other_bodies);
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
  std::vector<std::string> names, items;
  const std::vector<std::string> of_items = item_names(scene);
  for (std::size_t i = 0; i < tethers.size(); ++i) {
    names.push_back(scene.tethers.at(i).name);
    items.push_back(of_items.at(scene.tethers[i].item));
  }
  Table table(file, "tethers", tethers.size());
  table.add("tether", "name of the tether", names);
  table.add("item", kItem, items);
  table.add(tether_columns(), tethers);
  add_places(table, scene.tethers, tethers.size());
}

}  // namespace

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

}  // namespace gurney::study
