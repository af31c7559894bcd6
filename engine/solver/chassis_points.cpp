#include "engine/solver/chassis_points.h"

#include <algorithm>
#include <limits>

#include "engine/contact/convex_points.h"
#include "engine/solver/placed_shape.h"

namespace gurney {
namespace {

double reach_of(const std::variant<ConvexShape, Cylinder>& shape, const Vector3& center) {
  if (const auto* column = std::get_if<Cylinder>(&shape))
    return std::hypot(column->radius, column->half_height);
  double reach = 0;
  for (const Vector3& corner : std::get<ConvexShape>(shape).corners)
    reach = std::max(reach, (corner - center).norm());
  return reach;
}

/// Larger gaps between items count as this [m].
constexpr double kLargestGap = 1;

/// The largest gap of a along the normals of b's faces.
double face_gap(const ConvexShape& a, const ConvexShape& b) {
  double gap = -std::numeric_limits<double>::infinity();
  for (const ConvexShape::Face& face : b.faces)
    gap = std::max(gap, a.lowest(face.normal) - b.level(face));
  return gap;
}

}  // namespace

/// Gap of the balls around both, or along the normals of a polyhedron's faces, or from a column's
/// axis: while it is above the margin, nothing is found. The least distance from a column's axis is
/// that of a corner or across an edge, and both are axes of the search but for edges along the
/// column within 1e-6.
double ChassisPoints::gap_of(const PlacedBox& box, const Obstacle& obstacle) {
  const Vector3 between = box.center - obstacle.center;
  const double around = between.norm() - box.reach - obstacle.reach;
  if (const auto* column = std::get_if<Cylinder>(&obstacle.shape))
    return std::max(around, (between - column->axis.dot(between) * column->axis).norm() -
                                box.reach - column->radius);
  return std::max(around, face_gap(box.shape, std::get<ConvexShape>(obstacle.shape)));
}

double ChassisPoints::gap_of(const PlacedBox& a, const PlacedBox& b) {
  return std::max({(a.center - b.center).norm() - a.reach - b.reach, face_gap(a.shape, b.shape),
                   face_gap(b.shape, a.shape)});
}

ChassisPoints::ChassisPoints(const Scene& scene, const Assembly& assembly) : assembly_(assembly) {
  for (std::size_t i = 0; i < scene.items.size(); ++i) {
    const Vector3& center = assembly.items[i].chassis.center_of_mass;
    auto& boxes = boxes_.emplace_back();
    double& reach = reach_.emplace_back(0);
    for (const Box& box : scene.items[i].model.shape) {
      boxes.push_back(convex_box(box.center - center, box.size));
      reach = std::max(reach, (box.center - center).norm() + 0.5 * box.size.norm());
    }
  }
  for (std::size_t i = 0; i < scene.room.size(); ++i) {
    Obstacle obstacle{static_cast<int>(i) + 1, placed_shape(scene.room[i]), scene.room[i].position,
                      0};
    obstacle.reach = reach_of(obstacle.shape, obstacle.center);
    obstacles_.push_back(std::move(obstacle));
  }
  for (const auto& boxes : boxes_) {
    auto& placed = placed_.emplace_back();
    for (const ConvexShape& box : boxes) placed.emplace_back().shape = box;
    from_room_.emplace_back(boxes.size() * obstacles_.size());
    for (const auto& others : boxes_) pairs_.emplace_back(boxes.size() * others.size());
  }
}

const ChassisPoints::PlacedBox& ChassisPoints::placed(std::size_t item, std::size_t box,
                                                      const State& state) {
  PlacedBox& here = placed_[item][box];
  if (here.is_now) return here;
  boxes_[item][box].place(state.rotation, state.position, here.shape);
  const Vector3 &low = here.shape.corners.front(), &high = here.shape.corners.back();
  here.center = 0.5 * (low + high);
  here.reach = 0.5 * (high - low).norm();
  here.velocity = state.velocity.chassis.head<3>() +
                  state.velocity.chassis.tail<3>().cross(here.center - state.position);
  here.is_now = true;
  return here;
}

void ChassisPoints::against_room(std::size_t item, const Search& search) {
  const State& state = search.state.items[item];
  const double travelled = search.travels.of(item).chassis(reach_[item]);
  std::vector<FacingPoint> points;
  for (std::size_t k = 0; k < boxes_[item].size(); ++k)
    for (std::size_t o = 0; o < obstacles_.size(); ++o) {
      const Obstacle& obstacle = obstacles_[o];
      Clearance& clearance = from_room_[item][k * obstacles_.size() + o];
      if (clearance.exceeds(search.margin, travelled)) continue;
      const PlacedBox& box = placed(item, k, state);
      clearance.measure(gap_of(box, obstacle), travelled);
      if (clearance.exceeds(search.margin, travelled)) continue;
      if ((box.center - obstacle.center).norm() > box.reach + obstacle.reach + search.margin)
        continue;
      points.clear();
      const Vector3 motion = search.step * box.velocity;
      if (const auto* column = std::get_if<Cylinder>(&obstacle.shape))
        column_points(box.shape, *column, motion, search.margin, points);
      else
        convex_points(box.shape, std::get<ConvexShape>(obstacle.shape), motion, search.margin,
                      points);
      for (const FacingPoint& point : points) {
        BodyContact& contact = search.contacts.emplace_back();
        contact.side = {item, -1, state.rotation.conjugate() * (point.on_a - state.position)};
        contact.other = obstacle.other;
        contact.normal = point.normal;
        contact.offset = point.normal.dot(point.on_b);
      }
    }
}

void ChassisPoints::between(std::size_t a, std::size_t b, const Search& search) {
  const State &at_a = search.state.items[a], &at_b = search.state.items[b];
  const Travel &of_a = search.travels.of(a), &of_b = search.travels.of(b);
  const double distance = (at_a.position - at_b.position).norm();
  std::vector<FacingPoint> points;
  for (std::size_t i = 0; i < boxes_[a].size(); ++i)
    for (std::size_t j = 0; j < boxes_[b].size(); ++j) {
      PairClearance& pair = pairs_[a * boxes_.size() + b][i * boxes_[b].size() + j];
      const auto travelled = [&] {
        return of_a.path + of_b.path + pair.arm * (of_a.turn + of_b.turn);
      };
      if (pair.clearance.exceeds(search.margin, travelled())) continue;
      const PlacedBox &first = placed(a, i, at_a), &second = placed(b, j, at_b);
      const double gap = std::min(gap_of(first, second), kLargestGap);
      // The normal of a face turns with its item: seen from there, a point of the other at r from
      // the centre moves by r times the turn as well. Until the gap is used up, r is at most this.
      pair.arm = distance + std::max(gap, 0.0) + std::max(reach_[a], reach_[b]);
      pair.clearance.measure(gap, travelled());
      if (pair.clearance.exceeds(search.margin, travelled())) continue;
      if ((first.center - second.center).norm() > first.reach + second.reach + search.margin)
        continue;
      points.clear();
      convex_points(first.shape, second.shape, search.step * (first.velocity - second.velocity),
                    search.margin, points);
      for (const FacingPoint& point : points) {
        BodyContact& contact = search.contacts.emplace_back();
        contact.side = {a, -1, at_a.rotation.conjugate() * (point.on_a - at_a.position)};
        contact.other = BodyContact::kItem;
        contact.other_side = {b, -1, at_b.rotation.conjugate() * (point.on_b - at_b.position)};
        contact.normal = point.normal;
      }
    }
}

void ChassisPoints::collect(const SceneState& state, const Travels& travels, double step,
                            double margin, std::vector<BodyContact>& contacts) {
  const std::size_t count = boxes_.size();
  if (obstacles_.empty() && count == 1) return;
  for (auto& boxes : placed_)
    for (PlacedBox& box : boxes) box.is_now = false;
  const Search search{state, travels, step, margin, contacts};
  for (std::size_t i = 0; i < count; ++i) {
    against_room(i, search);
    for (std::size_t j = i + 1; j < count; ++j) {
      if (assembly_.joined(i, j)) continue;
      const double distance = (state.items[i].position - state.items[j].position).norm();
      if (distance > reach_[i] + reach_[j] + margin) continue;
      between(i, j, search);
    }
  }
}

}  // namespace gurney
