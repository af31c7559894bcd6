#include "studies/study/job/room_reader.h"

#include <fmt/format.h>

#include <set>

#include "equipment/catalogue/room_parts.h"
#include "studies/study/job/load_named.h"

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

/// Adds the constants of two materials once: those stated by job and room, else the item's own,
/// else the usual ones.
class PairList {
 public:
  PairList(Job& job, const equipment::RoomDescription& room)
      : job_(&job), stated_(room.contacts), usual_(equipment::usual_contacts(job.draw)) {}

  /// @return false where there are none
  bool add(const Surface& one, const Surface& other) {
    if (!done_.insert(std::minmax(one.name, other.name)).second) return true;
    const equipment::MaterialContact* found =
        equipment::find_contact(stated_, one.known, other.known);
    const ContactConstants* own = one.own != nullptr ? one.own : other.own;
    if (found == nullptr && own == nullptr)
      found = equipment::find_contact(usual_, one.known, other.known);
    if (found == nullptr && own == nullptr) return false;
    job_->scene.pairs.push_back({one.name, other.name, found != nullptr ? found->constants : *own});
    if (found != nullptr) equipment::add_assumptions(job_->assumptions, found->assumptions);
    return true;
  }

  std::vector<equipment::MaterialContact> contacts() const {
    std::vector<equipment::MaterialContact> all = stated_;
    all.insert(all.end(), usual_.begin(), usual_.end());
    return all;
  }

 private:
  Job* job_;
  std::vector<equipment::MaterialContact> stated_, usual_;
  std::set<std::pair<std::string, std::string>> done_;
};

/// Of each item; gives items their materials.
std::vector<Surface> surfaces_of(const std::vector<JobItem>& items, Scene& scene) {
  std::vector<Surface> surfaces;
  std::set<std::string> taken;
  for (std::size_t i = 0; i < items.size(); ++i) {
    PlacedItem& item = scene.items[i];
    std::string& material = item.model.material;
    if (material.empty()) material = kUsualItem;
    Surface surface{material, material};
    if (!items[i].contacts.empty()) {
      surface.own = &items[i].contacts.front();
      if (!taken.insert(material).second) surface.name = material + " of " + item.name;
    }
    material = surface.name;
    surfaces.push_back(surface);
  }
  return surfaces;
}

}  // namespace

equipment::RoomDescription read_job_room(Table& root, equipment::RoomNames& names) {
  equipment::RoomDescription room;
  auto table = root.table("room");
  if (!table) return room;
  load_named(*table, "file", equipment::DataKind::kRoom, [&](const std::string& file) {
    return equipment::load_room(file, root.document().draw(), names, room);
  });
  equipment::read_room(*table, names, room);
  return room;
}

void furnish(Table& root, std::vector<JobItem>& items, equipment::RoomDescription room, Job& job) {
  Scene& scene = job.scene;
  PairList pairs(job, room);
  scene.floor_material = kUsualFloor;
  if (auto floor = root.table("floor"))
    scene.floor_material = equipment::read_material(*floor, pairs.contacts(), kUsualFloor);
  const std::vector<Surface> surfaces = surfaces_of(items, scene);
  const auto add = [&](std::size_t i, const Surface& one, const Surface& other,
                       const std::string& other_name) {
    if (pairs.add(one, other)) return;
    Table& table = items[i].table;
    table.note(table.has("inline") ? "inline" : "equipment",
               fmt::format(": no [[room.contact]] for the materials '{}' of {} and '{}' of {}",
                           one.known, scene.items[i].name, other.known, other_name));
  };
  for (std::size_t i = 0; i < items.size(); ++i) {
    Surface foot = surfaces[i];
    if (foot.own != nullptr) foot.own = &items[i].contacts.back();
    add(i, foot, {scene.floor_material, scene.floor_material}, "the floor");
    for (const RoomShape& shape : room.shapes)
      add(i, surfaces[i], {shape.material, shape.material}, shape.name);
    for (std::size_t j = 0; j < i; ++j) add(i, surfaces[i], surfaces[j], scene.items[j].name);
  }
  const bool more =
      items.size() > 1 || !room.shapes.empty() || !room.zones.empty() || !scene.tethers.empty();
  if (more && job.settings.solver != Solver::kStar)
    if (auto settings = root.table("settings"))
      settings->note("solver",
                     ": must be \"star\" with a room, tethers or several items; Bullet's "
                     "own solvers are baselines for one item on a floor");
  equipment::add_assumptions(job.assumptions, room.assumptions);
  scene.room = std::move(room.shapes);
  scene.zones = std::move(room.zones);
}

}  // namespace gurney::study
