#pragma once

#include <pybind11/numpy.h>

#include "studies/bindings/finished_run.h"

namespace gurney::bindings {

/// Histories by the names of the results file (docs/formats/results_file.md), with its dimensions:
/// time, item, then axis. Empty without histories.
pybind11::dict histories(const FinishedRun& run);

/// {item: {demand: number}}, {item: {wheel: {demand: number}}}, and the same of marked points; NaN:
/// there is none.
pybind11::dict demands(const FinishedRun& run);
pybind11::dict wheel_demands(const FinishedRun& run);
pybind11::dict point_demands(const FinishedRun& run);

}  // namespace gurney::bindings
