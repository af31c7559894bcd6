#pragma once

#include <span>

#include "groundmotions/record/record.h"

namespace gurney::bindings {

/// A record of samples in memory: one row for each time, of the acceleration along x, or along x, y
/// and z [m/s2].
/// @throws Error for other numbers of columns, fewer than 2 rows, values that are not finite and time
///         steps that no file may have either
groundmotions::Record array_record(std::span<const double> samples, std::size_t columns,
                                   double time_step);

}  // namespace gurney::bindings
