#include "studies/results/hdf5_checks.h"

#include <fmt/format.h>

#include "engine/base/error.h"

namespace gurney::hdf5 {
namespace {

/// Deflate makes 1032 bytes of one at most (RFC 1951: 258 bytes of 2 bits).
constexpr double kMaxInflation = 1032;
constexpr double kSmall = 4096;  // [bytes] are always allowed

herr_t take_soft_link(hid_t, const char* name, const H5L_info_t* info, void* found) {
  if (info->type == H5L_TYPE_HARD) return 0;
  *static_cast<std::string*>(found) = name;
  return 1;
}

}  // namespace

void refuse_links(hid_t file, const std::string& path) {
  std::string found;
  checked(H5Lvisit(file, H5_INDEX_NAME, H5_ITER_INC, take_soft_link, &found), "list " + path);
  require(found.empty(),
          fmt::format("{}: /{} is a link to elsewhere; a results file has none", path, found));
}

void check_storage(hid_t dataset, const std::string& name) {
  const Handle creation(H5Dget_create_plist(dataset), "read how " + name + " is stored");
  const H5D_layout_t layout = H5Pget_layout(creation);
  require(
      layout != H5D_VIRTUAL && (layout != H5D_CONTIGUOUS || H5Pget_external_count(creation) == 0),
      name + ": its values stand in other files; those of a results file stand in itself");
  const Handle space(H5Dget_space(dataset), "read the shape of " + name);
  const Handle type(H5Dget_type(dataset), "read the type of " + name);
  hsize_t extent[H5S_MAX_RANK];
  const int rank = checked(H5Sget_simple_extent_dims(space, extent, nullptr), "size " + name);
  double values = H5Sget_simple_extent_type(space) == H5S_NULL ? 0 : 1;
  for (int i = 0; i < rank; ++i) values *= static_cast<double>(extent[i]);
  const double bytes = values * static_cast<double>(H5Tget_size(type));
  const auto stored = static_cast<double>(H5Dget_storage_size(dataset));
  require(bytes <= kMaxInflation * stored + (stored > 0 ? kSmall : 0),
          fmt::format("{}: states {:.0f} values, but only {:.0f} bytes of them are in the file",
                      name, values, stored));
}

}  // namespace gurney::hdf5
