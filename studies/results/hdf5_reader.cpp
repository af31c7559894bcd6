#include "studies/results/hdf5_reader.h"

#include <hdf5_hl.h>

#include <filesystem>

#include "engine/base/error.h"
#include "studies/results/hdf5_handle.h"

namespace gurney {

using hdf5::checked;
using hdf5::Handle;
using hdf5::silence_printing;
using hdf5::text_type;

namespace {

std::vector<std::string> take_strings(hid_t type, hid_t space, std::vector<char*>& raw) {
  std::vector<std::string> result;
  for (const char* text : raw) result.emplace_back(text ? text : "");
  checked(H5Dvlen_reclaim(type, space, H5P_DEFAULT, raw.data()), "release text");
  return result;
}

std::vector<std::string> fixed_strings(hid_t dataset, std::size_t width, std::size_t count) {
  std::string flat(width * count, '\0');
  checked(H5Dread(dataset, text_type(width), H5S_ALL, H5S_ALL, H5P_DEFAULT, flat.data()),
          "read text");
  std::vector<std::string> result;
  for (std::size_t i = 0; i < count; ++i) {
    const std::string padded = flat.substr(i * width, width);
    result.push_back(padded.substr(0, padded.find('\0')));
  }
  return result;
}

std::vector<std::string> texts_of(hid_t object, const std::string& name) {
  const std::string what = "read attribute '" + name + "'";
  if (checked(H5Aexists(object, name.c_str()), what) == 0) return {};
  const Handle attribute(H5Aopen(object, name.c_str(), H5P_DEFAULT), what);
  const Handle space(H5Aget_space(attribute), what);
  const Handle type = text_type();
  std::vector<char*> raw(
      static_cast<std::size_t>(checked(H5Sget_simple_extent_npoints(space), what)));
  if (raw.empty()) return {};
  checked(H5Aread(attribute, type, raw.data()), what);
  return take_strings(type, space, raw);
}

std::string text_of(hid_t object, const std::string& name) {
  const std::vector<std::string> texts = texts_of(object, name);
  return texts.empty() ? "" : texts.front();
}

std::string type_name(hid_t dataset) {
  const Handle type(H5Dget_type(dataset), "read a type");
  const auto bits = std::to_string(8 * H5Tget_size(type));
  switch (H5Tget_class(type)) {
    case H5T_FLOAT:
      return "float" + bits;
    case H5T_INTEGER:
      return (H5Tget_sign(type) == H5T_SGN_NONE ? "uint" : "int") + bits;
    case H5T_STRING:
      return "string";
    default:
      return "other";
  }
}

herr_t take_scale_name(hid_t, unsigned, hid_t scale, void* names) {
  char name[256];
  if (H5DSget_scale_name(scale, name, sizeof name) < 0) return -1;
  static_cast<std::vector<std::string>*>(names)->emplace_back(name);
  return 1;
}

herr_t take_dataset_path(hid_t, const char* name, const H5O_info_t* info, void* paths) {
  if (info->type == H5O_TYPE_DATASET)
    static_cast<std::vector<std::string>*>(paths)->push_back(std::string("/") + name);
  return 0;
}

Hdf5Dataset describe(hid_t file, const std::string& path) {
  const Handle dataset(H5Dopen2(file, path.c_str(), H5P_DEFAULT), "open dataset " + path);
  Hdf5Dataset found{
      path, type_name(dataset), {}, text_of(dataset, "units"), text_of(dataset, "long_name")};
  if (H5DSis_scale(dataset) > 0) {
    take_scale_name(dataset, 0, dataset, &found.scales);
    return found;
  }
  const Handle space(H5Dget_space(dataset), "read the shape of " + path);
  for (int i = 0; i < H5Sget_simple_extent_ndims(space); ++i)
    H5DSiterate_scales(dataset, static_cast<unsigned>(i), nullptr, take_scale_name, &found.scales);
  return found;
}

}  // namespace

Hdf5Reader::Hdf5Reader(const std::string& path) {
  silence_printing();
  std::error_code ignored;
  require(std::filesystem::exists(path, ignored), path + ": no such file");
  require(!std::filesystem::is_directory(path, ignored),
          path + ": is a folder, no results file of gurney");
  require(H5Fis_hdf5(path.c_str()) != 0, path + ": is no results file of gurney (no HDF5 file)");
  file_ = checked(H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), "open " + path);
}

Hdf5Reader::~Hdf5Reader() { H5Fclose(file_); }

std::vector<Hdf5Dataset> Hdf5Reader::datasets() const {
  std::vector<std::string> paths;
  checked(H5Ovisit2(file_, H5_INDEX_NAME, H5_ITER_INC, take_dataset_path, &paths, H5O_INFO_BASIC),
          "list datasets");
  std::vector<Hdf5Dataset> result;
  for (const std::string& path : paths) result.push_back(describe(file_, path));
  return result;
}

std::vector<std::string> Hdf5Reader::attributes() const {
  std::vector<std::string> result;
  const auto take_name = [](hid_t, const char* name, const H5A_info_t*, void* names) -> herr_t {
    static_cast<std::vector<std::string>*>(names)->emplace_back(name);
    return 0;
  };
  checked(H5Aiterate2(file_, H5_INDEX_NAME, H5_ITER_INC, nullptr, take_name, &result),
          "list attributes");
  return result;
}

std::string Hdf5Reader::text_attribute(const std::string& name) const {
  return text_of(file_, name);
}

std::int64_t Hdf5Reader::whole_attribute(const std::string& name) const {
  if (checked(H5Aexists(file_, name.c_str()), "look for attribute " + name) == 0) return 0;
  const Handle attribute(H5Aopen(file_, name.c_str(), H5P_DEFAULT), "open attribute " + name);
  std::int64_t value = 0;
  checked(H5Aread(attribute, H5T_NATIVE_INT64, &value), "read attribute " + name);
  return value;
}

std::vector<std::string> Hdf5Reader::text_attributes(const std::string& name) const {
  return texts_of(file_, name);
}

std::vector<double> Hdf5Reader::numbers(const std::string& path) const {
  const Handle dataset(H5Dopen2(file_, path.c_str(), H5P_DEFAULT), "open dataset " + path);
  const Handle space(H5Dget_space(dataset), "read the shape of " + path);
  std::vector<double> values(
      static_cast<std::size_t>(checked(H5Sget_simple_extent_npoints(space), "size " + path)));
  checked(H5Dread(dataset, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()),
          "read " + path);
  return values;
}

std::vector<std::string> Hdf5Reader::strings(const std::string& path) const {
  const Handle dataset(H5Dopen2(file_, path.c_str(), H5P_DEFAULT), "open dataset " + path);
  const Handle space(H5Dget_space(dataset), "read the shape of " + path);
  const auto count =
      static_cast<std::size_t>(checked(H5Sget_simple_extent_npoints(space), "size " + path));
  const Handle stored(H5Dget_type(dataset), "read the type of " + path);
  if (checked(H5Tis_variable_str(stored), "read the type of " + path) == 0)
    return fixed_strings(dataset, H5Tget_size(stored), count);
  if (count == 0) return {};
  std::vector<char*> raw(count);
  const Handle type = text_type();
  checked(H5Dread(dataset, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, raw.data()), "read " + path);
  return take_strings(type, space, raw);
}

}  // namespace gurney
