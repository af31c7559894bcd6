#pragma once

#include "groundmotions/record/record.h"

namespace gurney::groundmotions {

/// Brings the components of a record to one time step, one start and one length; each change is a
/// warning.
///
/// 1. Time steps that differ by more than 1e-6: all components are resampled to the smallest
///    (processing/resample.h).
/// 2. Starts that differ by a sample or more, where every file states its own (if only some do, a
///    warning says that no start is used): the record begins
///    with the earliest component, zeros stand before the others. They are shifted by whole
///    samples; what is left, half a sample at most, is part of the warning if it is more than 0.01
///    of a sample.
/// 3. Shorter components are filled with zeros at their end.
///
/// @throws Error for starts further apart than the shortest component is long: other earthquakes.
void align(Record& record);

}  // namespace gurney::groundmotions
