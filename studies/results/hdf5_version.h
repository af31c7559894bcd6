#pragma once

#include <string>

namespace gurney::study {

/// Versions of the HDF5 library that the program was built with, and of the one that it found:
/// "1.10.8".
std::string hdf5_version_built();
std::string hdf5_version_loaded();

}  // namespace gurney::study
