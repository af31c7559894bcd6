#include "studies/results/hdf5_writer.h"

#include <hdf5_hl.h>

#include <algorithm>
#include <fstream>
#include <functional>
#include <numeric>
#include <utility>

#include "engine/base/error.h"
#include "studies/results/hdf5_checks.h"
#include "studies/results/hdf5_handle.h"

namespace gurney::study {

using hdf5::checked;
using hdf5::Handle;
using hdf5::prepare_library;
using hdf5::text_type;

namespace {

constexpr hsize_t kRowsPerChunk = 4096;

Handle file_creation() {
  Handle creation(H5Pcreate(H5P_FILE_CREATE), "make a file");
  checked(H5Pset_obj_track_times(creation, false), "switch object times off");
  return creation;
}

std::size_t size_of(std::span<const std::string> values) {
  std::size_t bytes = values.size() * sizeof(const char*);
  for (const std::string& value : values) bytes += value.size();
  return bytes;
}

std::vector<const char*> pointers(std::span<const std::string> values) {
  std::vector<const char*> result;
  for (const std::string& value : values) result.push_back(value.c_str());
  return result;
}

}  // namespace

Hdf5Writer::Hdf5Writer() {
  hdf5::require_memory();
  prepare_library();
  const Handle access(H5Pcreate(H5P_FILE_ACCESS), "make a file in memory");
  checked(H5Pset_fapl_core(access, 1 << 20, false), "make a file in memory");
  file_ =
      checked(H5Fcreate("gurney-results", H5F_ACC_TRUNC, file_creation(), access), "make a file");
}

Hdf5Writer::Hdf5Writer(const std::string& path) {
  hdf5::require_memory();
  prepare_library();
  path_ = path;
  file_ =
      checked(H5Fcreate(path.c_str(), H5F_ACC_TRUNC, file_creation(), H5P_DEFAULT), "make " + path);
}

Hdf5Writer::~Hdf5Writer() {
  if (file_ >= 0) hdf5::close_file(file_);
}

void Hdf5Writer::require_memory(std::size_t bytes) {
  hdf5::require_memory(held_ + bytes);
  if (path_.empty()) held_ += bytes;
}

void Hdf5Writer::finish() {
  require_memory();
  checked(H5Fflush(file_, H5F_SCOPE_GLOBAL), "finish " + path_);
  checked(H5Fclose(std::exchange(file_, H5I_INVALID_HID)), "finish " + path_);
  const std::string seal = hdf5::seal_of(path_);
  std::ofstream stream(path_, std::ios::binary | std::ios::app);
  stream << seal;
  require(bool(stream.flush()), path_ + ": cannot be written: is the disk full?");
}

void Hdf5Writer::add_group(const std::string& path) {
  require_memory();
  const Handle creation(H5Pcreate(H5P_GROUP_CREATE), "make group " + path);
  checked(H5Pset_obj_track_times(creation, false), "switch object times off");
  Handle(H5Gcreate2(file_, path.c_str(), H5P_DEFAULT, creation, H5P_DEFAULT), "make group " + path);
}

void Hdf5Writer::write_attribute(const std::string& object, const std::string& name,
                                 std::int64_t type, const std::vector<std::uint64_t>& shape,
                                 const void* value) {
  const std::string what = "write attribute '" + name + "' of " + object;
  require_memory();
  const Handle owner(H5Oopen(file_, object.c_str(), H5P_DEFAULT), what);
  const std::vector<hsize_t> extent(shape.begin(), shape.end());
  const Handle space(
      extent.empty() ? H5Screate(H5S_SCALAR) : H5Screate_simple(1, extent.data(), nullptr), what);
  const Handle attribute(H5Acreate2(owner, name.c_str(), type, space, H5P_DEFAULT, H5P_DEFAULT),
                         what);
  if (extent.empty() || extent[0] > 0) checked(H5Awrite(attribute, type, value), what);
}

void Hdf5Writer::set_attribute(const std::string& object, const std::string& name,
                               const std::string& value) {
  require_memory(value.size());
  const char* const text = value.c_str();
  write_attribute(object, name, text_type(), {}, &text);
}

void Hdf5Writer::set_attribute(const std::string& object, const std::string& name,
                               std::int64_t value) {
  write_attribute(object, name, H5T_STD_I64LE, {}, &value);
}

void Hdf5Writer::set_attribute(const std::string& object, const std::string& name, double value) {
  write_attribute(object, name, H5T_IEEE_F64LE, {}, &value);
}

void Hdf5Writer::set_attribute(const std::string& object, const std::string& name,
                               const std::vector<std::string>& values) {
  require_memory(size_of(values));
  write_attribute(object, name, text_type(), {values.size()}, pointers(values).data());
}

void Hdf5Writer::set_attribute(const std::string& object, const std::string& name,
                               const std::vector<std::uint8_t>& values) {
  write_attribute(object, name, H5T_STD_U8LE, {values.size()}, values.data());
}

void Hdf5Writer::write(const Hdf5Spec& spec, const Shape& shape, std::span<const double> values) {
  write(spec, shape, H5T_IEEE_F64LE, values.data(), values.size());
}

void Hdf5Writer::write(const Hdf5Spec& spec, const Shape& shape,
                       std::span<const std::int64_t> values) {
  write(spec, shape, H5T_STD_I64LE, values.data(), values.size());
}

void Hdf5Writer::write(const Hdf5Spec& spec, const Shape& shape,
                       std::span<const std::uint8_t> values) {
  write(spec, shape, H5T_STD_U8LE, values.data(), values.size());
}

void Hdf5Writer::write(const Hdf5Spec& spec, const Shape& shape,
                       std::span<const std::string> values) {
  require_memory(size_of(values));
  write(spec, shape, text_type(), pointers(values).data(), values.size());
}

void Hdf5Writer::write(const Hdf5Spec& spec, const Shape& shape, std::int64_t type,
                       const void* values, std::size_t count) {
  const std::string what = "write dataset " + spec.path;
  require_memory(count * sizeof(double));
  const std::vector<hsize_t> extent(shape.begin(), shape.end());
  const auto expected =
      std::accumulate(extent.begin(), extent.end(), hsize_t{1}, std::multiplies<>());
  require(expected == count, what + ": its scales ask for " + std::to_string(expected) +
                                 " values, got " + std::to_string(count));
  const Handle creation(H5Pcreate(H5P_DATASET_CREATE), what);
  checked(H5Pset_obj_track_times(creation, false), "switch object times off");
  if (count > 0) {
    std::vector<hsize_t> chunk = extent;
    chunk[0] = std::min(chunk[0], kRowsPerChunk);
    checked(H5Pset_chunk(creation, static_cast<int>(chunk.size()), chunk.data()), what);
    if (checked(H5Tis_variable_str(type), what) == 0) {  // HDF5 does not compress text on its heap
      checked(H5Pset_shuffle(creation), what);
      checked(H5Pset_deflate(creation, 4), what);
    }
  }
  const Handle space(H5Screate_simple(static_cast<int>(extent.size()), extent.data(), nullptr),
                     what);
  const Handle dataset(
      H5Dcreate2(file_, spec.path.c_str(), type, space, H5P_DEFAULT, creation, H5P_DEFAULT), what);
  if (count > 0) checked(H5Dwrite(dataset, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, values), what);
  describe(dataset, spec);
}

void Hdf5Writer::describe(std::int64_t dataset, const Hdf5Spec& spec) {
  const std::string what = "describe dataset " + spec.path;
  set_attribute(spec.path, "units", spec.units);
  set_attribute(spec.path, "long_name", spec.long_name);
  for (std::size_t i = 0; i < spec.scales.size(); ++i) {
    const Handle scale(H5Dopen2(file_, spec.scales[i].c_str(), H5P_DEFAULT), what);
    checked(H5DSattach_scale(dataset, scale, static_cast<unsigned>(i)), what);
  }
}

void Hdf5Writer::add_growing(const Hdf5Spec& spec, Hdf5Type type, std::size_t text_width) {
  const std::string what = "make dataset " + spec.path;
  require_memory();
  const Handle creation(H5Pcreate(H5P_DATASET_CREATE), what);
  checked(H5Pset_obj_track_times(creation, false), "switch object times off");
  checked(H5Pset_chunk(creation, 1, &kRowsPerChunk), what);
  checked(H5Pset_shuffle(creation), what);
  checked(H5Pset_deflate(creation, 4), what);
  const hsize_t none = 0, any = H5S_UNLIMITED;
  const Handle space(H5Screate_simple(1, &none, &any), what);
  const Handle text = text_type(std::max<std::size_t>(1, text_width));
  const hid_t kind = type == Hdf5Type::kFloat64 ? H5T_IEEE_F64LE
                     : type == Hdf5Type::kInt64 ? H5T_STD_I64LE
                                                : hid_t(text);
  const Handle dataset(
      H5Dcreate2(file_, spec.path.c_str(), kind, space, H5P_DEFAULT, creation, H5P_DEFAULT), what);
  describe(dataset, spec);
  if (spec.scales.empty()) make_scale(spec.path, 0);
}

void Hdf5Writer::append(const std::string& path, std::int64_t type, const void* values,
                        std::size_t count) {
  const std::string what = "append to dataset " + path + (path_.empty() ? "" : " of " + path_);
  if (count == 0) return;
  require_memory(count * sizeof(double));
  const Handle dataset(H5Dopen2(file_, path.c_str(), H5P_DEFAULT), what);
  hsize_t length = 0;
  {
    const Handle space(H5Dget_space(dataset), what);
    checked(H5Sget_simple_extent_dims(space, &length, nullptr), what);
  }
  const hsize_t rows = count, longer = length + rows;
  checked(H5Dset_extent(dataset, &longer), what);
  const Handle space(H5Dget_space(dataset), what),
      memory(H5Screate_simple(1, &rows, nullptr), what);
  checked(H5Sselect_hyperslab(space, H5S_SELECT_SET, &length, nullptr, &rows, nullptr), what);
  checked(H5Dwrite(dataset, type, memory, space, H5P_DEFAULT, values), what);
}

void Hdf5Writer::append(const std::string& path, std::span<const double> values) {
  append(path, H5T_NATIVE_DOUBLE, values.data(), values.size());
}

void Hdf5Writer::append(const std::string& path, std::span<const std::int64_t> values) {
  append(path, H5T_NATIVE_INT64, values.data(), values.size());
}

void Hdf5Writer::append(const std::string& path, std::span<const std::string> values) {
  std::size_t width = 1;
  for (const std::string& value : values) width = std::max(width, value.size());
  std::string flat;
  for (const std::string& value : values) flat += value + std::string(width - value.size(), '\0');
  require_memory(flat.size());
  append(path, text_type(width), flat.data(), values.size());
}

std::vector<std::uint64_t> Hdf5Writer::shape_of(const Hdf5Spec& spec) const {
  std::vector<std::uint64_t> shape;
  for (const std::string& path : spec.scales) {
    const auto scale = std::find_if(scales_.begin(), scales_.end(),
                                    [&](const Scale& known) { return known.path == path; });
    require(scale != scales_.end(), "no dimension scale " + path + " for " + spec.path);
    shape.push_back(scale->length);
  }
  return shape;
}

void Hdf5Writer::make_scale(const std::string& path, std::uint64_t length) {
  const std::string what = "make a dimension scale of " + path;
  require_memory();
  const Handle dataset(H5Dopen2(file_, path.c_str(), H5P_DEFAULT), what);
  checked(H5DSset_scale(dataset, path.substr(path.rfind('/') + 1).c_str()), what);
  scales_.push_back({path, length});
}

std::string Hdf5Writer::image() {
  require_memory();
  checked(H5Fflush(file_, H5F_SCOPE_GLOBAL), "finish a file");
  const auto size = checked(H5Fget_file_image(file_, nullptr, 0), "size a file");
  std::string bytes(static_cast<std::size_t>(size), '\0');
  checked(H5Fget_file_image(file_, bytes.data(), bytes.size()), "copy a file");
  return bytes + hdf5::seal_of_bytes(bytes);
}

}  // namespace gurney::study
