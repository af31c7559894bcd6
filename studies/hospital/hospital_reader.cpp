#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <limits>
#include <set>

#include "engine/base/csv_row.h"
#include "engine/base/error.h"
#include "engine/base/names.h"
#include "engine/base/number_text.h"
#include "engine/base/toml_string.h"
#include "engine/config/nearest_name.h"
#include "engine/config/table.h"
#include "equipment/catalogue/check_file.h"
#include "equipment/catalogue/quantity.h"
#include "groundmotions/formats/source_file.h"
#include "studies/hospital/hospital.h"
#include "studies/hospital/toml_text.h"

namespace gurney::study {
namespace {

namespace fs = std::filesystem;
using config::Range;
using config::Table;

constexpr const char* kSchema = "gurney-hospital/1";
constexpr int kMostPieces = 100000;
const std::vector<std::string> kPlaces = {"open", "bay"};

std::string beside(const config::Document& document, const std::string& path) {
  return (fs::path(document.path()).parent_path() / path).lexically_normal().string();
}

/// The name of a table, which must be new and not empty.
std::string new_name(Table& in, std::set<std::string>& taken) {
  const std::string name = in.text("name");
  if (name.empty() || name.find('/') != std::string::npos)
    in.note("name", " = \"" + name + "\": must be a name, without '/'");
  else if (!taken.insert(name).second)
    in.note("name", " = \"" + name + "\": is taken already");
  return name;
}

std::optional<Requirement> read_works(Table& in, bool needed) {
  if (!needed && !in.has("works")) return {};
  const std::string text = in.text("works");
  if (!in.is_text("works")) return {};
  try {
    return read_requirement(text);
  } catch (const Error& error) {
    in.note("works", fmt::format(" = '{}': {}", text, error.what()));
    return {};
  }
}

HospitalItem read_item(Table& in, std::set<std::string>& taken) {
  HospitalItem item;
  item.equipment = in.text("equipment");
  if (in.has("name"))
    item.name = new_name(in, taken);
  else if (!taken.insert(item.name = item.equipment).second)
    in.note("name", ": must be given, '" + item.name + "' is taken already");
  item.count = in.integer("count", 1, kMostPieces, 1);
  item.place = kPlaces[in.choice("place", kPlaces, 0)];
  item.securing.brakes = static_cast<Brakes>(in.choice("brakes", brakes_names(), 0));
  item.securing.share = in.number("share_braked", Range::within(0, 1), 1);
  item.securing.tether_holds = in.number("tether_holds", Range::within(0, 1), 0);
  item.where = in.where("equipment");
  if (in.has("share_braked") && item.securing.brakes == Brakes::kOff)
    in.note("share_braked", ": has no effect: the brakes are off");
  return item;
}

/// A table of items, a row for each group, with the keys of [[room.item]] as columns.
class ItemTable {
 public:
  ItemTable(const std::string& path, std::set<std::string>& taken) : path_(path), taken_(taken) {
    const groundmotions::SourceFile file(path);
    line_ = file.blank_lines();
    for (const std::string_view line : file.lines()) {
      ++line_;
      if (trimmed(line).empty() || line.starts_with('#')) continue;
      take(csv_row(line));
    }
    require(!items_.empty(), path + ": has no row of an item");
  }

  std::vector<HospitalItem> items() && { return std::move(items_); }

 private:
  [[noreturn]] void fail(std::size_t column, const std::string& message) const {
    throw Error(fmt::format("{}:{}:{}: {}", path_, line_, column, message));
  }

  void take(const std::vector<CsvCell>& cells) {
    if (titles_.empty()) {
      static const std::vector<std::string> kKnown = {
          "name", "equipment", "count", "place", "brakes", "share_braked", "tether_holds"};
      for (const CsvCell& cell : cells) {
        if (std::ranges::find(kKnown, cell.text) == kKnown.end())
          fail(cell.column, fmt::format("'{}': unknown column{}", cell.text,
                                        config::suggestion(cell.text, kKnown)));
        titles_.push_back(cell.text);
      }
      return;
    }
    if (cells.size() != titles_.size())
      fail(1, fmt::format("has {} values for {} columns", cells.size(), titles_.size()));
    std::string toml;
    static const std::set<std::string> kNumbers = {"count", "share_braked", "tether_holds"};
    for (std::size_t i = 0; i < cells.size(); ++i) {
      if (cells[i].text.empty()) continue;
      if (kNumbers.contains(titles_[i]) && !number(cells[i].text))
        fail(cells[i].column,
             fmt::format("{} = '{}': must be a number", titles_[i], cells[i].text));
      toml += titles_[i] + " = " +
              (kNumbers.contains(titles_[i]) ? cells[i].text : toml_string(cells[i].text)) + "\n";
    }
    // The same rules as those of the tables; messages get the place of the row.
    HospitalItem item;
    try {
      config::Document document(toml, "row");
      Table root = document.root();
      item = read_item(root, taken_);
      document.finish();
    } catch (const Error& error) {
      const std::string message = error.what();
      fail(1, message.substr(message.find(": ") + 2));
    }
    item.where = fmt::format("{}:{}:1", path_, line_);
    items_.push_back(std::move(item));
  }

  std::string path_;
  std::set<std::string>& taken_;
  std::size_t line_ = 0;
  std::vector<std::string> titles_;
  std::vector<HospitalItem> items_;
};

Storey read_storey(Table& in, std::set<std::string>& taken) {
  Storey storey;
  storey.where = in.where("name");
  storey.name = new_name(in, taken);
  storey.floor = in.text("floor", "ground");
  if (in.has("pfv_over_pgv")) {
    storey.amplification = in.number("pfv_over_pgv", Range::positive());
    storey.scatter = in.number("pfv_beta", Range::not_negative(), 0);
  }
  if (auto building = in.table("building")) {
    storey.building = inline_toml(*in.document().tree().find("storey"), "building", storey.name,
                                  fs::path(in.document().path()).parent_path());
    in.set_aside("building");
  }
  return storey;
}

Room read_room(Table& in, const std::vector<std::string>& storeys, std::set<std::string>& taken) {
  Room room;
  room.name = new_name(in, taken);
  room.spot = in.spot(in.has("works") ? "works" : "name");
  room.storey = in.choice("storey", storeys);
  room.count = in.integer("count", 1, kMostPieces, 1);
  room.beds = in.integer("beds", 0, kMostPieces, 0);
  room.works = read_works(in, false);
  std::set<std::string> names;
  if (in.has("items")) {
    try {
      room.items = ItemTable(beside(in.document(), in.text("items")), names).items();
    } catch (const Error& error) {
      in.document().note(error);
    }
  }
  for (Table item : in.tables("item")) room.items.push_back(read_item(item, names));
  if (room.items.empty() && in.document().clean())
    in.note("item", ": must be given: tables [[room.item]], or items = \"FILE.csv\"");
  return room;
}

/// `bay/pole`: a room and one of its items.
std::optional<std::pair<std::size_t, std::size_t>> find_item(const Hospital& hospital,
                                                             const std::string& name) {
  for (std::size_t room = 0; room < hospital.rooms.size(); ++room)
    for (std::size_t item = 0; item < hospital.rooms[room].items.size(); ++item)
      if (hospital.rooms[room].name + "/" + hospital.rooms[room].items[item].name == name)
        return std::pair{room, item};
  return {};
}

/// @param complete  whether all rooms could be read
HospitalAction read_action(Table& in, const Hospital& hospital, bool complete,
                           std::set<std::string>& taken) {
  HospitalAction action;
  action.name = new_name(in, taken);
  std::vector<std::string> known;
  for (const Room& room : hospital.rooms)
    for (const HospitalItem& item : room.items) known.push_back(room.name + "/" + item.name);
  const std::vector<std::string> names = in.texts("items");
  if (names.empty()) in.note("items", ": must be given: a list of \"ROOM/ITEM\"");
  for (std::size_t i = 0; i < names.size(); ++i) {
    const auto found = find_item(hospital, names[i]);
    const std::string message = ": no such item" + config::suggestion(names[i], known);
    if (found)
      action.items.push_back(*found);
    else if (!complete)
      continue;  // it may be one of those that could not be read
    else if (in.is_array("items"))
      in.note_element("items", i, message);
    else
      in.note("items", " = \"" + names[i] + "\"" + message);
  }
  if (in.has("brakes")) action.brakes = static_cast<Brakes>(in.choice("brakes", brakes_names()));
  if (in.has("tether_holds"))
    action.tether_holds =
        equipment::Quantities(in).number("tether_holds", Range::within(0, 1)).value;
  if (action.brakes.has_value() == action.tether_holds.has_value())
    in.note("brakes", ": an action states either brakes or tether_holds");
  action.cost = equipment::Quantities(in).number("cost", Range::not_negative());
  return action;
}

void read_motion(Table in, Hospital& hospital) {
  hospital.levels = in.numbers("pgv_m_per_s", Range::positive());
  if (hospital.levels.empty() && in.is_array("pgv_m_per_s"))
    in.note("pgv_m_per_s", " = []: must have 1 or more values");
  if (!std::ranges::is_sorted(hospital.levels, std::less_equal<>()))
    in.note("pgv_m_per_s", ": must increase");
  const auto correlation =
      equipment::Quantities(in).number("correlation", Range::within(0, 1), 0.5);
  hospital.correlation = correlation.value;
  if (in.has("hazard")) try {
      hospital.hazard = read_hazard_file(beside(in.document(), in.text("hazard")));
      if (hospital.hazard->measure != "PGV larger")
        in.note("hazard", fmt::format(": is over {}; must be over PGV, component \"larger\"",
                                      hospital.hazard->measure));
    } catch (const Error& error) {
      in.document().note(error);
    }
}

HospitalStudy read_study(Table in) {
  HospitalStudy study;
  study.covering = in.text("covering", "");
  study.synthetic_records = in.integer("synthetic_records", 1, std::numeric_limits<int>::max(), 0);
  study.draws = in.integer("draws", 1, std::numeric_limits<int>::max(), 1);
  study.seed =
      static_cast<std::uint64_t>(in.integer("seed", 0, std::numeric_limits<int>::max(), 1));
  if (auto record = in.table("record")) {
    if (record->has("suite_by_level"))
      record->note("suite_by_level",
                   ": a hospital needs the same records at all levels, as suite has them");
    study.record = inline_toml(*in.document().tree().find("simulation"), "record", "",
                               fs::path(in.document().path()).parent_path());
    in.set_aside("record");
  } else {
    in.note("record", ": must be given: the keys of excitation.record of a job");
  }
  return study;
}

}  // namespace

const std::vector<std::string>& brakes_names() {
  static const std::vector<std::string> kNames = {"off", "on", "locked"};
  return kNames;
}

Hospital read_hospital(const std::string& path) {
  config::Document document(path);
  equipment::refuse_other_kind(document, kSchema);
  Table root = document.root();
  root.choice("schema", {kSchema});
  Hospital hospital;
  hospital.path = path;
  hospital.title = root.text("title", "");
  hospital.consequences =
      root.has("consequences") ? beside(document, root.text("consequences")) : usual_consequences();
  for (const std::string& curves : root.texts("curves"))
    hospital.curves.push_back(beside(document, curves));
  if (auto motion = root.table("motion"))
    read_motion(*motion, hospital);
  else
    root.note("motion", ": must be given");
  std::set<std::string> storeys, names, actions;
  for (Table each : root.tables("storey")) hospital.storeys.push_back(read_storey(each, storeys));
  if (hospital.storeys.empty()) root.note("storey", ": must be given: tables [[storey]]");
  const std::vector<std::string> storey_names = names_of(hospital.storeys);
  for (Table each : root.tables("room"))
    hospital.rooms.push_back(read_room(each, storey_names, names));
  if (hospital.rooms.empty()) root.note("room", ": must be given: tables [[room]]");
  for (Table each : root.tables("service")) {
    HospitalService service;
    service.name = new_name(each, names);
    service.spot = each.spot("works");
    service.works = read_works(each, true).value_or(Requirement());
    hospital.services.push_back(std::move(service));
  }
  const bool complete = document.clean();
  for (Table each : root.tables("action"))
    hospital.actions.push_back(read_action(each, hospital, complete, actions));
  if (auto simulation = root.table("simulation")) hospital.study = read_study(*simulation);
  document.finish();
  return hospital;
}

}  // namespace gurney::study
