#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "engine/base/floor_motion.h"
#include "engine/response/response.h"
#include "engine/scene/scene.h"
#include "studies/results/columns.h"
#include "studies/results/hdf5_writer.h"
#include "studies/results/run_facts.h"

namespace gurney::study {

/// One dataset for each column, one value for each row.
/// @param group  with its slash, such as "/runs/"
template <class Row>
void add_columns(Hdf5Writer& file, const std::string& group,
                 std::span<const TableColumn<Row>> columns, const std::vector<std::string>& scales,
                 const std::vector<Row>& rows) {
  for (const TableColumn<Row>& column : columns) {
    std::vector<double> values;
    for (const Row& row : rows) values.push_back(column.value(row));
    const Hdf5Spec spec{group + column.name, column.units, column.meaning, scales};
    if (column.whole()) {
      const std::vector<std::int64_t> whole(values.begin(), values.end());
      file.add(spec, whole);
    } else {
      file.add(spec, values);
    }
    if (column.missing != 0) file.set_attribute(spec.path, "_FillValue", column.missing);
  }
}

/// Displacement of the floor since 0 s [m], from rest.
/// @param times  that increase [s]
std::vector<Vector3> floor_displacement(const FloorMotion& floor, const std::vector<double>& times);

/// The translation of the floor in /histories.
/// @param times  those of /histories/time
void add_floor_histories(Hdf5Writer& file, const FloorMotion& floor,
                         const std::vector<double>& times);

/// Adds /shapes: what items and room look like, for pictures of the histories. A shape is convex
/// and given by its points in the axes of its body: of a chassis item axes, of a caster fork axes
/// (engine/scene/equipment_model.h), of the room floor axes.
void add_shapes(Hdf5Writer& file, const Scene& scene, const Response& response);

/// The group /histories: samples of all items and of the floor at common times.
void add_histories(Hdf5Writer& file, const RunFacts& facts, const Response& response);

}  // namespace gurney::study
