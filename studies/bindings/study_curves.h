#pragma once

#include <pybind11/pybind11.h>

namespace gurney::bindings {

/// The statistics of studies: Study (limit states, outcomes and curves of a results file), Curve and
/// Hazard. HDF5 keeps its state in one place: the GIL stays.
void define_curves(pybind11::module_& module);

}  // namespace gurney::bindings
