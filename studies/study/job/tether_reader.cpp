#include "studies/study/job/tether_reader.h"

#include <fmt/format.h>

#include <algorithm>

#include "engine/config/nearest_name.h"
#include "equipment/catalogue/quantity.h"
#include "equipment/catalogue/tether_type.h"
#include "studies/study/job/load_named.h"

namespace gurney::study {
namespace {

using config::Range;
using config::Table;

std::size_t read_item(Table& table, const std::vector<PlacedItem>& items) {
  if (items.size() == 1 && !table.has("item")) return 0;
  const std::string name = table.text("item");
  std::vector<std::string> known;
  for (const PlacedItem& item : items) known.push_back(item.name);
  const auto found = std::ranges::find(known, name);
  if (found != known.end()) return static_cast<std::size_t>(found - known.begin());
  if (table.is_text("item"))
    table.note("item", " = \"" + name + "\": no such item" + config::suggestion(name, known));
  return 0;
}

Vector3 read_anchor(equipment::Quantities& in, const std::vector<equipment::RoomPoint>& points) {
  Table& table = in.table();
  if (table.has("anchor") == table.has("anchor_m")) {
    table.note("anchor", ": must name a [[room.point]], or anchor_m must give a place, not both");
    return Vector3::Zero();
  }
  if (table.has("anchor_m")) return in.vector("anchor_m", Range::any());
  const std::string name = table.text("anchor");
  std::vector<std::string> known;
  for (const equipment::RoomPoint& point : points) {
    if (point.name == name) return point.position;
    known.push_back(point.name);
  }
  if (table.is_text("anchor"))
    table.note("anchor",
               " = \"" + name + "\": the room has no such point" + config::suggestion(name, known));
  return Vector3::Zero();
}

/// Constants of the kind, and those the job states in their place.
void read_constants(equipment::Quantities& in, Tether& tether,
                    std::vector<equipment::Assumption>& assumptions) {
  Table& table = in.table();
  const std::optional<Draw>& draw = table.document().draw();
  const auto type =
      load_named(table, "kind", equipment::DataKind::kTether,
                 [&](const std::string& file) { return equipment::load_tether_type(file, draw); });
  const std::optional<double> none;
  const bool known = table.has("kind");  // its mistakes are noted; it is not missing
  equipment::TetherType usual = type.value_or(equipment::TetherType{});
  const auto fallback = [&](double value) { return known ? std::optional<double>(value) : none; };
  const auto stated = [&](const char* key, const char* of_kind) {
    if (table.has(key))
      std::erase_if(usual.assumptions,
                    [&](const equipment::Assumption& each) { return each.key.ends_with(of_kind); });
  };
  stated("stiffness_n_per_m", "axial_stiffness_n");
  stated("damping_n_s_per_m", "damping_n_s_per_m");
  stated("strength_n", "strength_n");
  stated("slack_pull_n", "slack_pull_n");
  tether.stiffness = in.number("stiffness_n_per_m", Range::positive(),
                               fallback(usual.axial_stiffness / tether.slack_length));
  tether.damping =
      in.number("damping_n_s_per_m", Range::not_negative(), known ? usual.damping : 0.0);
  tether.strength =
      in.number("strength_n", Range::positive().with_infinity(), fallback(usual.strength));
  tether.slack_pull =
      in.number("slack_pull_n", Range::not_negative(), known ? usual.slack_pull : 0.0);
  equipment::add_assumptions(assumptions, usual.assumptions);
}

double distance_at_start(const Tether& tether, const InitialMotion& start) {
  const Vector3 point =
      start.position + Eigen::AngleAxisd(start.yaw, Vector3::UnitZ()) * tether.point;
  return (point - tether.anchor).norm();
}

Tether read_tether(Table& table, const std::string& name,
                   const std::vector<equipment::RoomPoint>& points, Job& job) {
  Tether tether;
  tether.name = name;
  const std::size_t mistakes = table.document().mistakes();
  equipment::Quantities in(table, job.assumptions);
  tether.item = read_item(table, job.scene.items);
  tether.point = in.vector("point_m", Range::any());
  tether.anchor = read_anchor(in, points);
  tether.slack_length = in.number("slack_length_m", Range::positive());
  const bool clean = table.document().mistakes() == mistakes;
  read_constants(in, tether, job.assumptions);
  const double distance = distance_at_start(tether, job.scene.items[tether.item].initial);
  if (clean && !(tether.slack_length >= distance))
    table.note("slack_length_m",
               fmt::format(" = {:g}: must be at least {:.4g}, the distance from '{}' to the anchor "
                           "at the start",
                           tether.slack_length, distance, job.scene.items[tether.item].name));
  return tether;
}

}  // namespace

void read_tethers(Table& root, const std::vector<equipment::RoomPoint>& points, Job& job) {
  equipment::UniqueNames names;
  std::size_t index = 0;
  for (Table& table : root.tables("tether")) {
    const std::string name = names.read(table, "tether", index);
    if (job.draw)
      root.document().set_draw_of(fmt::format("tether[{}]", index), job.draw->of_part(name));
    job.scene.tethers.push_back(read_tether(table, name, points, job));
    ++index;
  }
  root.document().set_draw_of("", job.draw);
}

}  // namespace gurney::study
