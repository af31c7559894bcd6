#include "engine/scene/validate_room.h"

#include <fmt/format.h>

#include <Eigen/QR>
#include <cmath>
#include <set>

#include "engine/base/error.h"

namespace gurney {
namespace {

class Problems {
 public:
  void check(bool holds, const std::string& text) {
    if (!holds) text_ += (text_.empty() ? "" : "\n") + text;
  }
  void number(bool holds, const std::string& name, double value, const char* allowed) {
    check(holds, fmt::format("{} = {:g}: must be {}", name, value, allowed));
  }
  void positive(const std::string& name, double value) {
    number(value > 0 && std::isfinite(value), name, value, "> 0 and finite");
  }
  void not_negative(const std::string& name, double value) {
    number(value >= 0 && std::isfinite(value), name, value, ">= 0 and finite");
  }
  void finish() const { require(text_.empty(), text_); }

 private:
  std::string text_;
};

bool spans_a_volume(const std::vector<Vector3>& points) {
  if (points.size() < 4) return false;
  Eigen::Matrix3Xd spread(3, points.size());
  for (std::size_t i = 0; i < points.size(); ++i)
    spread.col(static_cast<Eigen::Index>(i)) = points[i] - points[0];
  return spread.allFinite() && Eigen::ColPivHouseholderQR<Eigen::MatrixXd>(spread).rank() == 3;
}

void check_shape(const RoomShape& shape, Problems& problems) {
  const std::string owner = "room shape '" + shape.name + "': ";
  problems.check(!shape.name.empty() && shape.name != "floor",
                 owner + "the name must not be empty or 'floor'");
  problems.check(shape.position.allFinite(), owner + "position: must be finite");
  const double norm = shape.rotation.norm();
  problems.number(std::abs(norm - 1) < 1e-9, owner + "norm of rotation", norm, "1");
  if (const auto* box = std::get_if<RoomBox>(&shape.shape)) {
    for (int k = 0; k < 3; ++k) problems.positive(owner + "size", box->size[k]);
  } else if (const auto* column = std::get_if<RoomColumn>(&shape.shape)) {
    problems.positive(owner + "radius", column->radius);
    problems.positive(owner + "height", column->height);
  } else {
    problems.check(spans_a_volume(std::get<RoomHull>(shape.shape).points),
                   owner + "points: 4 or more that span a volume are needed");
  }
}

}  // namespace

void validate_room(const Scene& scene) {
  Problems problems;
  for (const MaterialPair& pair : scene.pairs) {
    const ContactConstants& c = pair.constants;
    const std::string owner = fmt::format("pair of '{}' and '{}': ", pair.item, pair.other);
    problems.positive(owner + "stiffness", c.stiffness);
    problems.not_negative(owner + "damping", c.damping);
    problems.not_negative(owner + "friction", c.friction);
    problems.number(c.restitution >= 0.01 && c.restitution <= 1, owner + "restitution",
                    c.restitution, "in 0.01..1");
  }
  for (std::size_t i = 0; i < scene.room.size(); ++i) {
    check_shape(scene.room[i], problems);
    for (std::size_t j = 0; j < i; ++j)
      problems.check(scene.room[i].name != scene.room[j].name,
                     "room shape '" + scene.room[i].name + "': the name is taken twice");
  }
  std::set<std::string> names{"floor"};
  for (const RoomShape& shape : scene.room) names.insert(shape.name);
  for (const PlacedItem& item : scene.items)
    problems.check(
        scene.items.size() == 1 || (!item.name.empty() && names.insert(item.name).second),
        "item '" + item.name + "': the name must be given and not be taken");
  problems.finish();
  for (std::size_t i = 0; i < scene.items.size(); ++i) {
    const std::string& material = scene.items[i].model.material;
    contact_constants(scene, material, scene.floor_material);
    for (const RoomShape& shape : scene.room) contact_constants(scene, material, shape.material);
    for (std::size_t j = 0; j < i; ++j)
      contact_constants(scene, material, scene.items[j].model.material);
  }
}

}  // namespace gurney
