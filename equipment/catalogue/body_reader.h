#pragma once

#include "engine/base/error.h"
#include "engine/scene/equipment_model.h"
#include "engine/scene/problems.h"
#include "equipment/catalogue/quantity.h"

namespace gurney::equipment {

/// Members of a description that hold a rigid body.
template <class T>
struct BodyMembers {
  double T::*mass;
  Vector3 T::*center_of_mass;
  Matrix3 T::*inertia;  ///< about the centre of mass
};

/// The keys mass_kg, center_of_mass_mm, and inertia_box_mm or inertia_kg_m2 with inertia_products_kg_m2.
/// Errors are noted in the table's document.
template <class T>
void read_body(Quantities& in, const BodyMembers<T>& members, Uncertain<T>& result) {
  using config::Range;
  result.set(members.mass, in.number("mass_kg", Range::positive()));
  result.set(members.center_of_mass, in.vector_mm("center_of_mass_mm", Range::any()));
  const bool box = in.table().has("inertia_box_mm");
  if (box && in.table().has("inertia_kg_m2"))
    in.table().note("inertia_box_mm", ": must not go with inertia_kg_m2; one of them states it");
  if (!box && !in.table().has("inertia_kg_m2")) {
    in.table().note("inertia_box_mm", ": missing; must be given, or inertia_kg_m2 in its place");
    in.table().has("inertia_products_kg_m2");  // is known, though useless alone
    return;
  }
  if (box) {
    result.add([members, size = in.vector_mm("inertia_box_mm", Range::positive())](T& of_draw,
                                                                                   Sampler& of) {
      of_draw.*members.inertia = solid_box_inertia(of_draw.*members.mass, of(size));
    });
    return;
  }
  result.add(in.table().document(),
             [members, spot = in.table().spot("inertia_kg_m2"),
              moments = in.vector("inertia_kg_m2", Range::positive(), Vector3::Ones()),
              products = in.vector("inertia_products_kg_m2", Range::any(), Vector3::Zero())](
                 T& of_draw, Sampler& of) {
               Matrix3& inertia = of_draw.*members.inertia;
               inertia = of(moments).asDiagonal();
               const Vector3 off_diagonal = of(products);
               inertia(0, 1) = inertia(1, 0) = off_diagonal[0];
               inertia(0, 2) = inertia(2, 0) = off_diagonal[1];
               inertia(1, 2) = inertia(2, 1) = off_diagonal[2];
               try {
                 Problems problems;
                 problems.inertia("", inertia, true);
                 problems.finish();
               } catch (const Error& error) {
                 of.error(spot, error.what());
               }
             });
}

template <class T>
void read_marked_points(config::Table& table, std::vector<MarkedPoint> T::*points,
                        Uncertain<T>& result) {
  for (config::Table& point : table.tables("marked_point")) {
    Uncertain<MarkedPoint> marked(MarkedPoint{point.text("name"), Vector3::Zero()});
    marked.set(&MarkedPoint::position,
               Quantities(point).vector_mm("position_mm", config::Range::any()));
    result.append(points, std::move(marked));
  }
}

}  // namespace gurney::equipment
