#include "studies/job/tether_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>

#include "engine/config/nearest_name.h"
#include "equipment/catalogue/quantity.h"
#include "equipment/catalogue/tether_type.h"
#include "studies/job/load_named.h"

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

/// A place, or the index of a point of the room.
struct Anchor {
  std::optional<std::array<equipment::StatedQuantity, 3>> place;
  std::optional<std::size_t> point;
};

Anchor read_anchor(equipment::Quantities& in, const std::vector<equipment::RoomPoint>& points) {
  Table& table = in.table();
  if (table.has("anchor") == table.has("anchor_m")) {
    table.note("anchor", ": must name a [[room.point]], or anchor_m must give a place, not both");
    return {};
  }
  if (table.has("anchor_m")) return {in.vector("anchor_m", Range::any()), {}};
  const std::string name = table.text("anchor");
  std::vector<std::string> known;
  for (const equipment::RoomPoint& point : points) {
    if (point.name == name) return {{}, known.size()};
    known.push_back(point.name);
  }
  if (table.is_text("anchor"))
    table.note("anchor",
               " = \"" + name + "\": the room has no such point" + config::suggestion(name, known));
  return {};
}

/// Constants of the kind, and those the job states in their place.
struct Constants {
  std::optional<equipment::Uncertain<equipment::TetherType>> kind;
  std::optional<equipment::StatedQuantity> stiffness, damping, strength, slack_pull;
};

Constants read_constants(equipment::Quantities& in) {
  Table& table = in.table();
  Constants constants;
  constants.kind =
      load_named(table, "kind", equipment::DataKind::kTether, equipment::load_tether_type);
  const bool known = table.has("kind");  // its errors are noted; it is not missing
  const auto read =
      [&](const char* key, const Range& range,
          std::optional<double> fallback = {}) -> std::optional<equipment::StatedQuantity> {
    if (known && !table.has(key)) return {};
    return in.number(key, range, fallback);
  };
  constants.stiffness = read("stiffness_n_per_m", Range::positive());
  constants.damping = read("damping_n_s_per_m", Range::not_negative(), 0.0);
  constants.strength = read("strength_n", Range::positive().with_infinity());
  constants.slack_pull = read("slack_pull_n", Range::not_negative(), 0.0);
  return constants;
}

void set_constants(const Constants& constants, Tether& tether, JobParts& job,
                   equipment::Sampler& of) {
  equipment::TetherType usual =
      constants.kind ? constants.kind->sample(of) : equipment::TetherType{};
  const auto choose = [&](const std::optional<equipment::StatedQuantity>& stated, double of_kind,
                          const char* key_of_kind) {
    if (!stated) return of_kind;
    std::erase_if(usual.assumptions, [&](const equipment::Assumption& each) {
      return each.key.ends_with(key_of_kind);
    });
    return of(*stated);
  };
  tether.stiffness =
      choose(constants.stiffness, usual.axial_stiffness / tether.slack_length, "axial_stiffness_n");
  tether.damping = choose(constants.damping, usual.damping, "damping_n_s_per_m");
  tether.strength = choose(constants.strength, usual.strength, "strength_n");
  tether.slack_pull = choose(constants.slack_pull, usual.slack_pull, "slack_pull_n");
  add_assumptions(job.assumptions, usual.assumptions);
}

double distance_at_start(const Tether& tether, const InitialMotion& start) {
  const Vector3 point =
      start.position + Eigen::AngleAxisd(start.yaw, Vector3::UnitZ()) * tether.point;
  return (point - tether.anchor).norm();
}

void check_length(const Tether& tether, const PlacedItem& item, const config::Spot& spot,
                  equipment::Sampler& of) {
  const double distance = distance_at_start(tether, item.initial);
  if (!(tether.slack_length >= distance))
    of.error(spot, fmt::format(" = {:g}: must be at least {:.4g}, the distance from '{}' to the "
                               "anchor at the start",
                               tether.slack_length, distance, item.name));
}

void read_tether(Table& table, const std::string& element, const std::string& name,
                 JobReading& job) {
  config::Document& document = table.document();
  const std::size_t errors = document.errors();
  equipment::Quantities in(table);
  Tether fixed;
  fixed.name = name;
  fixed.item = read_item(table, job.stated().scene.items);
  const auto point = in.vector("point_m", Range::any());
  const Anchor anchor = read_anchor(in, job.stated().room.points);
  const equipment::StatedQuantity slack = in.number("slack_length_m", Range::positive());
  const bool clean = document.errors() == errors;
  const Constants constants = read_constants(in);
  job.add(document, [=](JobParts& of_draw, equipment::Sampler& of_job) {
    equipment::Sampler of = of_job.of_element(element, name);
    Tether tether = fixed;
    tether.point = of(point);
    if (anchor.place) tether.anchor = of(*anchor.place);
    if (anchor.point) tether.anchor = of_draw.room.points[*anchor.point].position;
    tether.slack_length = of(slack);
    set_constants(constants, tether, of_draw, of);
    if (clean) check_length(tether, of_draw.scene.items[tether.item], slack.spot, of);
    of_draw.scene.tethers.push_back(tether);
  });
}

}  // namespace

void read_tethers(Table& root, JobReading& job) {
  equipment::UniqueNames names;
  std::size_t index = 0;
  for (Table& table : root.tables("tether")) {
    const std::string name = names.read(table, "tether", index);
    read_tether(table, fmt::format("tether[{}]", index), name, job);
    ++index;
  }
}

}  // namespace gurney::study
