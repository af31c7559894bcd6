#include "studies/job/room_reader.h"

#include <fmt/format.h>

#include <set>

#include "equipment/room_parts.h"
#include "studies/job/load_named.h"

namespace gurney {
namespace {

using config::Table;

constexpr const char* kUsualItem = "equipment";
constexpr const char* kUsualFloor = "floor";

/// Adds the constants of two materials once.
class PairList {
 public:
  PairList(Job& job, const RoomDescription& room) : job_(&job), contacts_(room.contacts) {
    for (MaterialContact& each : usual_contacts(job.draw)) contacts_.push_back(std::move(each));
  }

  /// @return false where there are none
  bool add(const std::string& one, const std::string& other) {
    if (!done_.insert(std::minmax(one, other)).second) return true;
    const MaterialContact* found = find_contact(contacts_, one, other);
    if (found == nullptr) return false;
    job_->scene.pairs.push_back({one, other, found->constants});
    add_assumptions(job_->assumptions, found->assumptions);
    return true;
  }

  const std::vector<MaterialContact>& contacts() const { return contacts_; }

 private:
  Job* job_;
  std::vector<MaterialContact> contacts_;
  std::set<std::pair<std::string, std::string>> done_;
};

}  // namespace

RoomDescription read_job_room(Table& root, RoomNames& names) {
  RoomDescription room;
  auto table = root.table("room");
  if (!table) return room;
  load_named(*table, "file", DataKind::kRoom, [&](const std::string& file) {
    return load_room(file, root.document().draw(), names, room);
  });
  read_room(*table, names, room);
  return room;
}

void furnish(Table& root, std::vector<Table>& items, RoomDescription room, Job& job) {
  Scene& scene = job.scene;
  PairList pairs(job, room);
  scene.floor_material = kUsualFloor;
  if (auto floor = root.table("floor"))
    scene.floor_material = read_material(*floor, pairs.contacts(), kUsualFloor);
  const auto add = [&](Table& table, const PlacedItem& item, const std::string& other,
                       const std::string& other_name) {
    if (pairs.add(item.model.material, other)) return;
    table.note(table.has("inline") ? "inline" : "equipment",
               fmt::format(": no [[room.contact]] for the materials '{}' of {} and '{}' of {}",
                           item.model.material, item.name, other, other_name));
  };
  for (std::size_t i = 0; i < items.size(); ++i) {
    PlacedItem& item = scene.items[i];
    if (item.model.material.empty()) item.model.material = kUsualItem;
    add(items[i], item, scene.floor_material, "the floor");
    for (const RoomShape& shape : room.shapes) add(items[i], item, shape.material, shape.name);
    for (std::size_t j = 0; j < i; ++j)
      add(items[i], item, scene.items[j].model.material, scene.items[j].name);
  }
  const bool more =
      items.size() > 1 || !room.shapes.empty() || !room.zones.empty() || !scene.tethers.empty();
  if (more && job.settings.solver != Solver::kStar)
    if (auto settings = root.table("settings"))
      settings->note("solver",
                     ": must be \"star\" with a room, tethers or several items; Bullet's "
                     "own solvers are baselines for one item on a floor");
  add_assumptions(job.assumptions, room.assumptions);
  scene.room = std::move(room.shapes);
  scene.zones = std::move(room.zones);
}

}  // namespace gurney
