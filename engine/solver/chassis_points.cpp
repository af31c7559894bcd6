#include "engine/solver/chassis_points.h"

#include <algorithm>
#include <limits>

#include "engine/solver/placed_shape.h"

namespace gurney {
namespace {

double reach_of(const BodyForm& form, const Vector3& center) {
  if (const auto* column = std::get_if<Cylinder>(&form))
    return std::hypot(column->radius, column->half_height);
  double reach = 0;
  for (const Vector3& corner : std::get<ConvexShape>(form).corners)
    reach = std::max(reach, (corner - center).norm());
  return reach;
}

/// Larger gaps between items count as this [m].
constexpr double kLargestGap = 1;

/// The largest gap of a along the normals of b's faces.
double face_gap(const BodyForm& a, const ConvexShape& b) {
  double gap = -std::numeric_limits<double>::infinity();
  for (const ConvexShape::Face& face : b.faces)
    gap = std::max(gap, lowest(a, face.normal) - b.level(face));
  return gap;
}

}  // namespace

/// Gap of the balls around both, or along the normals of a polyhedron's faces, or from a column's
/// axis: while it is above the margin, nothing is found. The least distance from a column's axis is
/// that of a corner or across an edge, and both are axes of the search but for edges along the
/// column within 1e-6.
double ChassisPoints::gap_of(const PlacedBody& body, const Obstacle& obstacle) {
  const Vector3 between = body.center - obstacle.center;
  const double around = between.norm() - body.reach - obstacle.reach;
  if (const auto* column = std::get_if<Cylinder>(&obstacle.form))
    return std::max(around, (between - column->axis.dot(between) * column->axis).norm() -
                                body.reach - column->radius);
  return std::max(around, face_gap(body.form, std::get<ConvexShape>(obstacle.form)));
}

double ChassisPoints::gap_of(const PlacedBody& a, const PlacedBody& b) {
  const Vector3 between = a.center - b.center;
  const double distance = between.norm();
  double gap = distance - a.reach - b.reach;
  const auto *solid_a = std::get_if<ConvexShape>(&a.form),
             *solid_b = std::get_if<ConvexShape>(&b.form);
  if (solid_b) gap = std::max(gap, face_gap(a.form, *solid_b));
  if (solid_a) gap = std::max(gap, face_gap(b.form, *solid_a));
  if (!(solid_a && solid_b) && distance > 0) {
    const Vector3 along = between / distance;
    gap = std::max(gap, lowest(a.form, along) + lowest(b.form, -along));
  }
  return gap;
}

ChassisPoints::ChassisPoints(const Scene& scene, const Assembly& assembly) : assembly_(assembly) {
  for (std::size_t i = 0; i < scene.items.size(); ++i) {
    const Vector3& center = assembly.items[i].chassis.center_of_mass;
    auto& bodies = bodies_.emplace_back();
    double& reach = reach_.emplace_back(0);
    for (const BodyShape& shape : scene.items[i].model.shape) {
      const bool is_round = round_surface(shape, center).radius > 0;
      bodies.push_back({body_form(shape, center), shape.center - center,
                        reach_from(shape, shape.center), shape.is_box(), is_round});
      reach = std::max(reach, reach_from(shape, center));
    }
  }
  for (std::size_t i = 0; i < scene.room.size(); ++i) {
    Obstacle obstacle{static_cast<int>(i) + 1, placed_shape(scene.room[i]), scene.room[i].position,
                      0};
    obstacle.reach = reach_of(obstacle.form, obstacle.center);
    obstacles_.push_back(std::move(obstacle));
  }
  for (const auto& bodies : bodies_) {
    auto& placed = placed_.emplace_back();
    for (const Body& body : bodies) placed.emplace_back().form = body.form;
    from_room_.emplace_back(bodies.size() * obstacles_.size());
    for (const auto& others : bodies_) pairs_.emplace_back(bodies.size() * others.size());
  }
}

const ChassisPoints::PlacedBody& ChassisPoints::placed(std::size_t item, std::size_t shape,
                                                       const State& state) {
  PlacedBody& here = placed_[item][shape];
  if (here.is_now) return here;
  const Body& body = bodies_[item][shape];
  place(body.form, state.rotation, state.position, here.form);
  if (body.is_box) {
    const std::vector<Vector3>& corners = std::get<ConvexShape>(here.form).corners;
    const Vector3 &low = corners.front(), &high = corners.back();
    here.center = 0.5 * (low + high);
    here.reach = 0.5 * (high - low).norm();
  } else {
    here.center = state.position + state.rotation * body.center;
    here.reach = body.reach;
  }
  here.velocity = state.velocity.chassis.head<3>() +
                  state.velocity.chassis.tail<3>().cross(here.center - state.position);
  here.is_now = true;
  return here;
}

BodyContact::Side ChassisPoints::side(std::size_t item, std::size_t shape, const State& state,
                                      const Vector3& point, bool rolls,
                                      const Vector3& outwards) const {
  BodyContact::Side side{item, -1, state.rotation.conjugate() * (point - state.position)};
  if (!rolls || !bodies_[item][shape].is_round) return side;
  side.outwards = outwards;
  side.round = static_cast<int>(shape);
  return side;
}

void ChassisPoints::against_room(std::size_t item, const Search& search) {
  const State& state = search.state.items[item];
  const double travelled = search.travels.of(item).chassis(reach_[item]);
  std::vector<FacingPoint> points;
  for (std::size_t k = 0; k < bodies_[item].size(); ++k)
    for (std::size_t o = 0; o < obstacles_.size(); ++o) {
      const Obstacle& obstacle = obstacles_[o];
      Clearance& clearance = from_room_[item][k * obstacles_.size() + o];
      if (clearance.exceeds(search.margin, travelled)) continue;
      const PlacedBody& box = placed(item, k, state);
      const double gap = gap_of(box, obstacle);
      clearance.measure(gap, travelled);
      if (clearance.exceeds(search.margin, travelled)) continue;
      if (!bodies_[item][k].is_box && gap > search.margin) continue;
      if ((box.center - obstacle.center).norm() > box.reach + obstacle.reach + search.margin)
        continue;
      points.clear();
      const Vector3 motion = search.step * box.velocity;
      form_points(box.form, obstacle.form, motion, search.margin, points);
      for (const FacingPoint& point : points) {
        BodyContact& contact = search.contacts.emplace_back();
        contact.side = side(item, k, state, point.on_a, point.rolls_a, -point.normal);
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
  for (std::size_t i = 0; i < bodies_[a].size(); ++i)
    for (std::size_t j = 0; j < bodies_[b].size(); ++j) {
      PairClearance& pair = pairs_[a * bodies_.size() + b][i * bodies_[b].size() + j];
      const auto travelled = [&] {
        return of_a.path + of_b.path + pair.arm * (of_a.turn + of_b.turn);
      };
      if (pair.clearance.exceeds(search.margin, travelled())) continue;
      const PlacedBody &first = placed(a, i, at_a), &second = placed(b, j, at_b);
      const bool boxes = bodies_[a][i].is_box && bodies_[b][j].is_box;
      const double gap = std::min(gap_of(first, second), kLargestGap);
      // The normal of a face turns with its item: seen from there, a point of the other at r from
      // the centre moves by r times the turn as well. Until the gap is used up, r is at most this.
      pair.arm = distance + std::max(gap, 0.0) + std::max(reach_[a], reach_[b]);
      pair.clearance.measure(gap, travelled());
      if (pair.clearance.exceeds(search.margin, travelled())) continue;
      if (!boxes && gap > search.margin) continue;
      if ((first.center - second.center).norm() > first.reach + second.reach + search.margin)
        continue;
      points.clear();
      form_points(first.form, second.form, search.step * (first.velocity - second.velocity),
                  search.margin, points);
      for (const FacingPoint& point : points) {
        BodyContact& contact = search.contacts.emplace_back();
        contact.side = side(a, i, at_a, point.on_a, point.rolls_a, -point.normal);
        contact.other = BodyContact::kItem;
        contact.other_side = side(b, j, at_b, point.on_b, point.rolls_b, point.normal);
        contact.normal = point.normal;
      }
    }
}

void ChassisPoints::collect(const SceneState& state, const Travels& travels, double step,
                            double margin, std::vector<BodyContact>& contacts,
                            const Riders* riders) {
  const std::size_t count = bodies_.size();
  if (obstacles_.empty() && count == 1) return;
  for (auto& bodies : placed_)
    for (PlacedBody& body : bodies) body.is_now = false;
  const Search search{state, travels, step, margin, contacts};
  for (std::size_t i = 0; i < count; ++i) {
    against_room(i, search);
    for (std::size_t j = i + 1; j < count; ++j) {
      if (assembly_.joined(i, j) || (riders && riders->together(i, j))) continue;
      const double distance = (state.items[i].position - state.items[j].position).norm();
      if (distance > reach_[i] + reach_[j] + margin) continue;
      between(i, j, search);
    }
  }
}

}  // namespace gurney
