#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "studies/results/columns.h"
#include "studies/results/hdf5_writer.h"

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

}  // namespace gurney::study
