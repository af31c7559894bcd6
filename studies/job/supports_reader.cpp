#include "studies/job/supports_reader.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

#include "engine/config/nearest_name.h"

namespace gurney::study {
namespace {

using config::Table;

bool lies_in(const Box& box, const Vector2& point) {
  return ((point - box.center.head<2>()).cwiseAbs() - box.size.head<2>() / 2).maxCoeff() <= 0;
}

/// The highest top of an item's boxes over a point of its plan.
std::optional<double> top_of(const EquipmentModel& model, const Vector2& point) {
  std::optional<double> top;
  for (const Box& box : model.shape)
    if (lies_in(box, point)) top = std::max(top.value_or(0), box.center.z() + box.size.z() / 2);
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
  if (box == nullptr || !lies_in({Vector3::Zero(), box->size}, there.head<2>())) return {};
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

}  // namespace

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
