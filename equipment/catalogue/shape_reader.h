#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/scene/equipment_model.h"
#include "equipment/catalogue/quantity.h"

namespace gurney::equipment {

/// Reads one solid: `kind` (box where absent) with size_mm; radius_mm, length_mm and axis; radius_mm;
/// points_mm; or file and unit of a mesh, which is one hull for each of its objects. A table [[shape]]
/// has its place too: center_mm, of hulls and meshes position_mm of their origin. Errors are noted in
/// the table's document.
/// @param placed  false: without its place, about the origin
Uncertain<std::vector<BodyShape>> read_solid(config::Table& table, bool placed);

/// The direction `axis`, of length 1.
/// @param usual  without the key
Vector3 read_axis(config::Table& table, const std::optional<Vector3>& usual);

/// Whether a solid, or a table [[shape]] of `owner`, is one that rolls.
bool is_round(config::Table& solid);
bool has_round_shape(config::Table& owner);

/// The tables [[shape]], one or more.
template <class T>
void read_shape(config::Table& table, std::vector<BodyShape> T::*shape, Uncertain<T>& result) {
  std::vector<config::Table> tables = table.tables("shape");
  for (config::Table& each : tables)
    result.add([shape, solids = read_solid(each, true)](T& of_draw, Sampler& of) {
      for (BodyShape& solid : solids.sample(of)) (of_draw.*shape).push_back(std::move(solid));
    });
  if (tables.empty())
    table.note("shape",
               ": must have at least one box or other solid [[" + table.name_of("shape") + "]]");
}

}  // namespace gurney::equipment
