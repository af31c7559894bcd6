#include "studies/job/room_reader.h"

#include <fmt/format.h>

#include <set>

#include "equipment/catalogue/room_parts.h"
#include "studies/job/load_named.h"

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
  all.insert(all.end(), job.usual_contacts.begin(), job.usual_contacts.end());
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

/// Of each item; gives items their materials.
std::vector<Surface> surfaces_of(JobParts& job) {
  std::vector<Surface> surfaces;
  std::set<std::string> taken;
  for (std::size_t i = 0; i < job.scene.items.size(); ++i) {
    PlacedItem& item = job.scene.items[i];
    const std::vector<ContactConstants>& own = job.item_contacts[i];
    std::string& material = item.model.material;
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

/// @param spots  where each item is described
void add_pairs(const std::vector<config::Spot>& spots, JobParts& job, equipment::Sampler& of) {
  const Scene& scene = job.scene;
  PairList pairs(job);
  const std::vector<Surface> surfaces = surfaces_of(job);
  const auto add = [&](std::size_t i, const Surface& one, const Surface& other,
                       const std::string& other_name) {
    if (pairs.add(one, other)) return;
    of.error(spots[i],
             fmt::format(": no [[room.contact]] for the materials '{}' of {} and '{}' of {}",
                         one.known, scene.items[i].name, other.known, other_name));
  };
  for (std::size_t i = 0; i < spots.size(); ++i) {
    Surface foot = surfaces[i];
    if (foot.own != nullptr) foot.own = &job.item_contacts[i].back();
    add(i, foot, {scene.floor_material, scene.floor_material}, "the floor");
    for (const RoomShape& shape : job.room.shapes)
      add(i, surfaces[i], {shape.material, shape.material}, shape.name);
    for (std::size_t j = 0; j < i; ++j) add(i, surfaces[i], surfaces[j], scene.items[j].name);
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
  std::vector<config::Spot> spots;
  for (Table& item : items) spots.push_back(description_spot(item));
  const equipment::RoomDescription& room = job.stated().room;
  const bool more = spots.size() > 1 || !room.shapes.empty() || !room.zones.empty() ||
                    !job.stated().scene.tethers.empty();
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

}  // namespace gurney::study
