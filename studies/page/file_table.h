#pragma once

#include <string>
#include <vector>

#include "studies/findings/findings.h"
#include "studies/results/hdf5_reader.h"
#include "studies/units/unit_system.h"

namespace gurney::page {

/// A group of columns of a results file as a table: every column but the row and the run, titles
/// with units, meanings where one points. No rows where the file does not have the group.
/// @param first  columns that come first, in this order; the others by name
findings::Table table_of_group(const study::Hdf5Reader& file, const std::string& group,
                               const std::string& caption, const std::vector<std::string>& first,
                               const study::UnitSystem& units);

/// The same with a row for each column of numbers, and a column for each row, which the column
/// `name` names; empty: the group has one row. Quantities without a value in any column are left out.
/// @param first  quantities that come first, in this order; the others by name
findings::Table turned_table_of_group(const study::Hdf5Reader& file, const std::string& group,
                                      const std::string& caption, const std::string& name,
                                      const study::UnitSystem& units,
                                      const std::vector<std::string>& first = {});

}  // namespace gurney::page
