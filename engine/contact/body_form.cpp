#include "engine/contact/body_form.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace gurney {
namespace {

constexpr double kLevel = 1e-6;  // of a normal: sine of the angle

/// Integrals over a tetrahedron from the origin: for p = J u and the unit tetrahedron,
/// integral of u u' = (1 + 1') / 120.
void add_tetrahedron(const Matrix3& corners, double& volume, Vector3& first, Matrix3& second) {
  const double determinant = corners.determinant();
  volume += determinant / 6;
  first += determinant / 24 * corners.rowwise().sum();
  const Matrix3 unit = (Matrix3::Ones() + Matrix3::Identity()) / 120;
  second += determinant * corners * unit * corners.transpose();
}

struct HullProperties {
  double volume = 0;
  Vector3 center = Vector3::Zero();
  Matrix3 inertia = Matrix3::Zero();  // about the centre, of density 1
};

HullProperties properties_of(const ConvexShape& hull) {
  const Vector3 origin = hull.corners.front();
  HullProperties sum;
  Vector3 first = Vector3::Zero();
  Matrix3 second = Matrix3::Zero();
  const auto corner = [&](int i) { return hull.corners[static_cast<std::size_t>(i)] - origin; };
  for (const ConvexShape::Face& face : hull.faces)
    for (std::size_t k = 1; k + 1 < face.loop.size(); ++k) {
      Matrix3 corners;
      corners << corner(face.loop[0]), corner(face.loop[k]), corner(face.loop[k + 1]);
      add_tetrahedron(corners, sum.volume, first, second);
    }
  const Vector3 center = first / sum.volume;
  second -= sum.volume * center * center.transpose();
  sum.center = origin + center;
  sum.inertia = second.trace() * Matrix3::Identity() - second;
  return sum;
}

bool lies_in(const ConvexShape& shape, const ConvexShape::Face& face, const Vector2& point) {
  for (std::size_t k = 0; k < face.loop.size(); ++k) {
    const Vector2 from = shape.corners[static_cast<std::size_t>(face.loop[k])].head<2>();
    const Vector2 to =
        shape.corners[static_cast<std::size_t>(face.loop[(k + 1) % face.loop.size()])].head<2>();
    const Vector2 along = to - from, there = point - from;
    if (along.x() * there.y() - along.y() * there.x() < 0) return false;
  }
  return true;
}

}  // namespace

BodyForm body_form(const BodyShape& shape, const Vector3& origin) {
  const Vector3 center = shape.center - origin;
  if (const auto* solid = std::get_if<SolidCylinder>(&shape.solid))
    return Cylinder{center, solid->axis, solid->radius, 0.5 * solid->length,
                    solid->axis.unitOrthogonal()};
  if (const auto* solid = std::get_if<SolidSphere>(&shape.solid))
    return Sphere{center, solid->radius};
  if (shape.is_box()) return convex_box(center, shape.size);
  return convex_body(outline_points(shape.moved(-origin)));
}

void place(const BodyForm& form, const Quaternion& rotation, const Vector3& position,
           BodyForm& result) {
  if (const auto* polyhedron = std::get_if<ConvexShape>(&form)) {
    polyhedron->place(rotation, position, std::get<ConvexShape>(result));
  } else if (const auto* cylinder = std::get_if<Cylinder>(&form)) {
    result = Cylinder{position + rotation * cylinder->center, rotation * cylinder->axis,
                      cylinder->radius, cylinder->half_height, rotation * cylinder->rim};
  } else {
    const auto& sphere = std::get<Sphere>(form);
    result = Sphere{position + rotation * sphere.center, sphere.radius};
  }
}

double lowest(const BodyForm& form, const Vector3& direction) {
  if (const auto* polyhedron = std::get_if<ConvexShape>(&form))
    return polyhedron->lowest(direction);
  if (const auto* cylinder = std::get_if<Cylinder>(&form)) return cylinder->lowest(direction);
  const auto& sphere = std::get<Sphere>(form);
  return direction.dot(sphere.center) - sphere.radius * direction.norm();
}

Vector3 RoundSurface::farthest(const Matrix3& rotation, const Vector3& local,
                               const Vector3& outwards) const {
  const Vector3 turned = rotation * axis;
  const Vector3 across = outwards - turned.dot(outwards) * turned;
  const double size = across.norm();
  if (!(size > 0)) return rotation * local;
  const Vector3 middle = center + axis.dot(local - center) * axis;
  return rotation * middle + (radius / size) * across;
}

RoundSurface round_surface(const BodyShape& shape, const Vector3& origin) {
  const Vector3 center = shape.center - origin;
  if (const auto* solid = std::get_if<SolidCylinder>(&shape.solid))
    return {center, solid->axis, solid->radius};
  if (const auto* solid = std::get_if<SolidSphere>(&shape.solid))
    return {center, Vector3::Zero(), solid->radius};
  return {};
}

double volume_of(const BodyShape& shape) {
  constexpr double kPi = std::numbers::pi;
  if (const auto* solid = std::get_if<SolidCylinder>(&shape.solid))
    return kPi * solid->radius * solid->radius * solid->length;
  if (const auto* solid = std::get_if<SolidSphere>(&shape.solid))
    return 4 * kPi / 3 * std::pow(solid->radius, 3);
  if (shape.is_box()) return shape.size.prod();
  return properties_of(convex_body(outline_points(shape))).volume;
}

MassProperties uniform_solid(double mass, const BodyShape& shape) {
  if (const auto* solid = std::get_if<SolidCylinder>(&shape.solid)) {
    const double r2 = solid->radius * solid->radius, h2 = solid->length * solid->length;
    const double across = mass * (3 * r2 + h2) / 12, along = mass * r2 / 2;
    return {
        mass, shape.center,
        across * Matrix3::Identity() + (along - across) * solid->axis * solid->axis.transpose()};
  }
  if (const auto* solid = std::get_if<SolidSphere>(&shape.solid))
    return {mass, shape.center, 0.4 * mass * solid->radius * solid->radius * Matrix3::Identity()};
  if (shape.is_box()) return {mass, shape.center, solid_box_inertia(mass, shape.size)};
  const HullProperties hull = properties_of(convex_body(outline_points(shape)));
  return {mass, hull.center, mass / hull.volume * hull.inertia};
}

MassProperties uniform_solid(double mass, const std::vector<BodyShape>& shapes) {
  double volume = 0;
  for (const BodyShape& shape : shapes) volume += volume_of(shape);
  MassProperties sum;
  for (const BodyShape& shape : shapes) {
    const MassProperties part = uniform_solid(mass * (volume_of(shape) / volume), shape);
    sum.add(part.mass, part.center_of_mass, part.inertia);
  }
  return sum;
}

std::optional<double> level_top(const BodyShape& shape, const Vector2& point) {
  const Vector2 from = point - shape.center.head<2>();
  if ((from.cwiseAbs() - shape.size.head<2>() / 2).maxCoeff() > 0) return {};
  if (shape.is_box()) return shape.top();
  if (const auto* solid = std::get_if<SolidCylinder>(&shape.solid)) {
    const bool upright = solid->axis.head<2>().norm() < kLevel;
    return upright && from.norm() <= solid->radius ? std::optional(shape.top()) : std::nullopt;
  }
  if (std::holds_alternative<SolidSphere>(shape.solid)) return {};
  const ConvexShape hull = convex_body(outline_points(shape));
  for (const ConvexShape::Face& face : hull.faces)
    if (face.normal.z() > 0 && face.normal.head<2>().norm() < kLevel && lies_in(hull, face, point))
      return hull.level(face) / face.normal.z();
  return {};
}

}  // namespace gurney
