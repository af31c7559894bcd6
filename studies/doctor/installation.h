#pragma once

#include "studies/doctor/finding.h"

namespace gurney::doctor {

/// Version, commit and compiler.
Finding program();

/// Versions of the build; HDF5 is compared with the one that is loaded.
Finding libraries();

/// The catalogue: where it is, and whether every file of it can be read.
Finding data();

/// Whether figures can be written as PDF and PNG.
Finding figures();

}  // namespace gurney::doctor
