#include "studies/job/room_reader.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <set>
#include <string>

#include "engine/base/append_all.h"
#include "engine/base/names.h"
#include "engine/config/nearest_name.h"
#include "engine/contact/body_form.h"
#include "equipment/catalogue/quantity.h"
#include "equipment/catalogue/room_description.h"
#include "equipment/catalogue/tether_type.h"
#include "studies/job/job_parts.h"

namespace gurney::study {
namespace {

using config::Table;

constexpr const char* kUsualItem = "equipment";
constexpr const char* kUsualFloor = "floor";

/// A material in the scene. Items with constants of their own have one each, named after them where
/// `known` is taken.
struct Surface {
  std::string name;
  std::string known;  // to [[contact]]
  const ContactConstants* own = nullptr;
};

std::vector<equipment::MaterialContact> known_contacts(const JobParts& job) {
  std::vector<equipment::MaterialContact> all = job.room.contacts;
  append_all(all, job.usual_contacts);
  return all;
}

/// Adds the constants of two materials once: those stated by job and room, else the item's own,
/// else the usual ones.
class PairList {
 public:
  explicit PairList(JobParts& job) : job_(&job) {}

  /// @return false where there are none
  bool add(const Surface& one, const Surface& other) {
    if (!done_.insert(std::minmax(one.name, other.name)).second) return true;
    const equipment::MaterialContact* found =
        find_contact(job_->room.contacts, one.known, other.known);
    const ContactConstants* own = one.own != nullptr ? one.own : other.own;
    if (found == nullptr && own == nullptr)
      found = find_contact(job_->usual_contacts, one.known, other.known);
    if (found == nullptr && own == nullptr) return false;
    job_->scene.pairs.push_back({one.name, other.name, found != nullptr ? found->constants : *own});
    if (found != nullptr) equipment::add_assumptions(job_->assumptions, found->assumptions);
    return true;
  }

 private:
  JobParts* job_;
  std::set<std::pair<std::string, std::string>> done_;
};

/// Contact pairs of each item; gives items their materials.
std::vector<Surface> surfaces_of(JobParts& job) {
  std::vector<Surface> surfaces;
  std::set<std::string> taken;
  for (std::size_t i = 0; i < job.scene.items.size(); ++i) {
    PlacedItem& item = job.scene.items[i];
    const std::vector<ContactConstants>& own = job.item_contacts[i];
    std::string& material = item.model.material;
    if (joint_of(job.scene, i) && material.empty()) {  // a part of its chassis' material
      surfaces.push_back(surfaces[job.owners[i]]);
      material = surfaces.back().name;
      continue;
    }
    if (material.empty()) material = kUsualItem;
    Surface surface{material, material};
    if (!own.empty()) {
      surface.own = &own.front();
      if (!taken.insert(material).second) surface.name = material + " of " + item.name;
    }
    material = surface.name;
    surfaces.push_back(surface);
  }
  return surfaces;
}

/// @param spots  where each item of the job is described
void add_pairs(const std::vector<config::Spot>& spots, JobParts& job, equipment::Sampler& of) {
  const Scene& scene = job.scene;
  PairList pairs(job);
  const std::vector<Surface> surfaces = surfaces_of(job);
  const auto add = [&](std::size_t i, const Surface& one, const Surface& other,
                       const std::string& other_name) {
    if (pairs.add(one, other)) return;
    of.error(spots[job.owners[i]],
             fmt::format(": no [[room.contact]] for the materials '{}' of {} and '{}' of {}",
                         one.known, scene.items[i].name, other.known, other_name));
  };
  for (std::size_t i = 0; i < scene.items.size(); ++i) {
    Surface foot = surfaces[i];
    if (foot.own != nullptr) foot.own = &job.item_contacts[i].back();
    add(i, foot, {scene.floor_material, scene.floor_material}, "the floor");
    for (const RoomShape& shape : job.room.shapes)
      add(i, surfaces[i], {shape.material, shape.material}, shape.name);
    for (std::size_t j = 0; j < i; ++j) add(i, surfaces[i], surfaces[j], scene.items[j].name);
  }
}

using config::Range;
using config::Table;

/// Index of the item, part or content that `key` names.
std::size_t read_item(Table& table, const char* key, const std::vector<PlacedItem>& items) {
  const std::string name = table.text(key);
  const std::vector<std::string> known = names_of(items);
  const auto found = std::ranges::find(known, name);
  if (found != known.end()) return static_cast<std::size_t>(found - known.begin());
  if (table.is_text(key))
    table.note(key, " = \"" + name + "\": no such item" + config::suggestion(name, known));
  return 0;
}

/// A place, of an item where there is one, or the index of a point of the room.
struct Anchor {
  std::optional<std::array<equipment::StatedQuantity, 3>> place;
  std::optional<std::size_t> point, item;
};

Anchor read_anchor(equipment::Quantities& in, const std::vector<PlacedItem>& items,
                   const std::vector<equipment::RoomPoint>& points) {
  Table& table = in.table();
  if (table.has("anchor_item")) {
    if (table.has("anchor"))
      table.note("anchor", ": must not be given with anchor_item, whose place is anchor_m");
    const std::size_t item = read_item(table, "anchor_item", items);
    return {in.vector("anchor_m", Range::any()), {}, item};
  }
  if (table.has("anchor") == table.has("anchor_m")) {
    table.note("anchor", ": must name a [[room.point]], or anchor_m must give a place, not both");
    return {};
  }
  if (table.has("anchor_m")) return {in.vector("anchor_m", Range::any()), {}, {}};
  const std::string name = table.text("anchor");
  std::vector<std::string> known;
  for (const equipment::RoomPoint& point : points) {
    if (point.name == name) return {{}, known.size(), {}};
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

/// @return the index of its item
std::size_t read_tether(Table& table, const std::string& element, const std::string& name,
                        JobReading& job) {
  config::Document& document = table.document();
  const std::size_t errors = document.errors();
  equipment::Quantities in(table);
  Tether fixed;
  fixed.name = name;
  const std::vector<PlacedItem>& items = job.stated().scene.items;
  if (job.stated().unfolded.size() > 1 || table.has("item"))
    fixed.item = read_item(table, "item", items);
  const auto point = in.vector("point_m", Range::any());
  const Anchor anchor = read_anchor(in, items, job.stated().room.points);
  fixed.anchor_item = anchor.item;
  if (anchor.item == fixed.item && document.errors() == errors)
    table.note("anchor_item",
               fmt::format(" = \"{}\": must not be the tether's own item", items[fixed.item].name));
  const equipment::StatedQuantity slack = in.number("slack_length_m", Range::positive());
  const Constants constants = read_constants(in);
  job.add(document, [=](JobParts& of_draw, equipment::Sampler& of_job) {
    equipment::Sampler of = of_job.of_element(element, name);
    Tether tether = fixed;
    tether.point = of(point);
    if (anchor.place) tether.anchor = of(*anchor.place);
    if (anchor.point) tether.anchor = of_draw.room.points[*anchor.point].position;
    tether.slack_length = of(slack);
    set_constants(constants, tether, of_draw, of);
    of_draw.scene.tethers.push_back(tether);
  });
  return fixed.item;
}

using config::Table;

/// The highest level top of an item's shapes over a point of its plan.
std::optional<double> top_of(const EquipmentModel& model, const Vector2& point) {
  std::optional<double> top;
  for (const BodyShape& shape : model.shape)
    if (const auto here = level_top(shape, point)) top = std::max(top.value_or(0), *here);
  return top;
}

std::optional<double> top_of(const RoomShape& shape, const Vector2& point) {
  const Vector3 there = shape.rotation.conjugate() *
                        Vector3(point.x() - shape.position.x(), point.y() - shape.position.y(), 0);
  if (const auto* column = std::get_if<RoomColumn>(&shape.shape)) {
    if (there.head<2>().norm() > column->radius) return {};
    return shape.position.z() + column->height / 2;
  }
  const auto* box = std::get_if<RoomBox>(&shape.shape);
  if (box == nullptr || !level_top({Vector3::Zero(), box->size}, there.head<2>())) return {};
  return shape.position.z() + box->size.z() / 2;
}

/// Whether its top is a level plane.
bool has_a_top(const RoomShape& shape) {
  const bool upright = (shape.rotation * Vector3::UnitZ()).z() > 1 - 1e-12;
  return upright && !std::holds_alternative<RoomHull>(shape.shape);
}

/// Finds what an item stands on.
struct Search {
  const Scene& scene;
  std::size_t item;
  const std::string& name;

  /// @param why_not  what is wrong with the name, if anything is
  std::optional<Support> find(std::string& why_not) const {
    std::vector<std::string> known;
    for (std::size_t i = 0; i < scene.items.size(); ++i) {
      if (scene.items[i].name == name) {
        if (i < item) return Support{Support::Kind::kItem, i, 0};
        why_not = i == item ? ": is the item itself" : ": must be an item before this one";
        return {};
      }
      if (i < item) known.push_back(scene.items[i].name);
    }
    for (std::size_t i = 0; i < scene.room.size(); ++i) {
      if (scene.room[i].name == name) {
        if (has_a_top(scene.room[i])) return Support{Support::Kind::kShape, i, 0};
        why_not = ": has no level top: must be an upright box or column";
        return {};
      }
      if (has_a_top(scene.room[i])) known.push_back(scene.room[i].name);
    }
    why_not = ": no item before this one and no shape of the room is called so" +
              config::suggestion(name, known);
    return {};
  }
};

void stand_on(Scene& scene, std::size_t index, const std::string& name, const config::Spot& spot,
              equipment::Sampler& of) {
  const std::string stated = fmt::format(" = \"{}\"", name);
  PlacedItem& item = scene.items[index];
  if (!item.model.casters.empty())
    return of.error(spot, stated + ": only an item without casters stands on something, " +
                              item.model.name + " has casters");
  std::string why_not;
  std::optional<Support> on = Search{scene, index, name}.find(why_not);
  if (!on) return of.error(spot, stated + why_not);
  const Vector2 place = item.initial.position.head<2>();
  std::optional<double> top;
  if (on->kind == Support::Kind::kShape) {
    top = top_of(scene.room[on->index], place);
  } else {
    const PlacedItem& below = scene.items[on->index];
    top = top_of(below.model, place);
    const Eigen::Rotation2Dd turn(below.initial.yaw);
    item.initial.position.head<2>() = below.initial.position.head<2>() + turn * place;
    item.initial.yaw += below.initial.yaw;
    if (top && below.on) *top += below.on->height;
  }
  if (!top)
    return of.error(spot,
                    stated + fmt::format(": nothing of it lies below position_m = [{:g}, {:g}]",
                                         place.x(), place.y()));
  on->height = *top;
  item.on = *on;
}

/// Materials of bodies with a cylinder or a sphere.
std::set<std::string> round_materials(const JobParts& job) {
  std::set<std::string> materials;
  const auto take = [&](const EquipmentModel& model) {
    for (const BodyShape& shape : model.shape)
      if (std::holds_alternative<SolidCylinder>(shape.solid) ||
          std::holds_alternative<SolidSphere>(shape.solid))
        materials.insert(model.material.empty() ? kUsualItem : model.material);
  };
  for (const PlacedItem& item : job.scene.items) take(item.model);
  for (const JobParts::Unfolded& of_item : job.unfolded) {
    for (const equipment::LoadedPart& part : of_item.parts) take(part.model);
    for (const equipment::LoadedContent& content : of_item.contents) take(content.model);
  }
  return materials;
}

/// Notes each [[room.contact]] of the job with a material that nothing has, or with a resistance of what does
/// not roll: it changes nothing.
void note_idle_contacts(Table& root, const std::string& floor_material, JobReading& job) {
  auto room = root.table("room");
  if (!room) return;
  std::set<std::string> there{floor_material};
  for (const PlacedItem& item : job.stated().scene.items)
    there.insert(item.model.material.empty() ? kUsualItem : item.model.material);
  for (const RoomShape& shape : job.stated().room.shapes) there.insert(shape.material);
  const std::vector<std::string> known(there.begin(), there.end());
  const std::set<std::string> rolling = round_materials(job.stated());
  for (Table& contact : room->tables("contact")) {
    if (contact.has("rolling_resistance_mm") &&
        std::ranges::none_of(contact.texts("materials"),
                             [&](const auto& material) { return rolling.contains(material); }))
      job.add(
          [line = fmt::format("{}: {}: has no effect: nothing round is of these materials",
                              contact.where("rolling_resistance_mm"),
                              contact.name_of("rolling_resistance_mm"))](
              JobParts& of_draw, equipment::Sampler&) { of_draw.without_effect.push_back(line); });
    for (const std::string& material : contact.texts("materials"))
      if (!there.contains(material))
        job.add([line = fmt::format("{}: {}: nothing is of the material '{}'{}",
                                    contact.where("materials"), contact.name_of("materials"),
                                    material, config::suggestion(material, known))](
                    JobParts& of_draw, equipment::Sampler&) {
          of_draw.without_effect.push_back(line);
        });
  }
}

}  // namespace

void read_job_room(Table& root, equipment::RoomNames& names, JobReading& job) {
  auto table = root.table("room");
  if (!table) return;
  equipment::Uncertain<equipment::RoomDescription> room;
  load_named(*table, "file", equipment::DataKind::kRoom,
             [&](const std::string& file) { return load_room(file, names, room); });
  read_room(*table, names, room);
  job.set(&JobParts::room, std::move(room));
}

void furnish(Table& root, std::vector<Table>& items, JobReading& job) {
  job.set(&JobParts::usual_contacts, equipment::usual_contacts());
  std::string floor_material = kUsualFloor;
  if (auto floor = root.table("floor"))
    floor_material = read_material(*floor, known_contacts(job.stated()), kUsualFloor);
  if (root.document().clean()) note_idle_contacts(root, floor_material, job);
  std::vector<config::Spot> spots;
  for (Table& item : items) spots.push_back(description_spot(item));
  const equipment::RoomDescription& room = job.stated().room;
  const bool more = job.stated().scene.items.size() > 1 || !room.shapes.empty() ||
                    !room.zones.empty() || !job.stated().scene.tethers.empty();
  if (more && job.stated().settings.solver != Solver::kImplicit)
    if (auto settings = root.table("settings"))
      settings->note("solver",
                     ": must be \"implicit\" with a room, tethers or several items; Bullet's "
                     "own solvers are baselines for one item on a floor");
  job.add(root.document(), [spots, floor_material](JobParts& of_draw, equipment::Sampler& of) {
    of_draw.scene.floor_material = floor_material;
    add_pairs(spots, of_draw, of);
    add_assumptions(of_draw.assumptions, of_draw.room.assumptions);
    of_draw.scene.room = std::move(of_draw.room.shapes);
    of_draw.scene.zones = std::move(of_draw.room.zones);
  });
}

TetherSpots read_tethers(Table& root, JobReading& job) {
  equipment::UniqueNames names;
  std::map<std::size_t, std::size_t> of_item;
  TetherSpots spots;
  for (Table& table : root.tables("tether")) {
    const std::size_t index = spots.size(), errors = root.document().errors();
    const std::string name = names.read(table, "tether", index);
    const std::size_t item = read_tether(table, fmt::format("tether[{}]", index), name, job);
    if (++of_item[item] == EquipmentModel::kMaxTethers + 1)
      table.note("item",
                 fmt::format(": must not have more than {} tethers", EquipmentModel::kMaxTethers));
    const bool clean = root.document().errors() == errors;
    spots.push_back(clean ? std::optional(table.spot("slack_length_m")) : std::nullopt);
  }
  return spots;
}

void check_tethers(const TetherSpots& spots, config::Document& document, JobReading& job) {
  for (std::size_t i = 0; i < spots.size(); ++i) {
    if (!spots[i]) continue;
    job.add(document, [i, spot = *spots[i]](JobParts& of_draw, equipment::Sampler& of) {
      const Scene& scene = of_draw.scene;
      const Tether& tether = scene.tethers[i];
      const double distance = placed_length(scene, tether);
      if (!(tether.slack_length >= distance))
        of.error(spot,
                 fmt::format(" = {:g}: must be at least {:.4g}, the distance from '{}' to "
                             "{} at the start",
                             tether.slack_length, distance, scene.items[tether.item].name,
                             tether.anchor_item ? "'" + scene.items[*tether.anchor_item].name + "'"
                                                : "the anchor"));
    });
  }
}

void read_supports(const std::vector<Table>& items, JobReading& job) {
  for (std::size_t i = 0; i < items.size(); ++i) {
    Table table = items[i];
    if (!table.has("on")) continue;
    job.add(table.document(), [i, name = table.text("on"), spot = table.spot("on")](
                                  JobParts& of_draw, equipment::Sampler& of) {
      if (of.clean()) stand_on(of_draw.scene, i, name, spot, of);
    });
  }
}

}  // namespace gurney::study
