#include "studies/results/hdf5_version.h"

#include <fmt/format.h>
#include <hdf5.h>

#include "studies/results/hdf5_handle.h"

namespace gurney::study {

std::string hdf5_version_built() {
  return fmt::format("{}.{}.{}", H5_VERS_MAJOR, H5_VERS_MINOR, H5_VERS_RELEASE);
}

std::string hdf5_version_loaded() {
  hdf5::require_memory();
  unsigned major = 0, minor = 0, release = 0;
  H5get_libversion(&major, &minor, &release);
  return fmt::format("{}.{}.{}", major, minor, release);
}

}  // namespace gurney::study
