#include "studies/results/hdf5_file.h"

#include <hdf5.h>
#include <hdf5_hl.h>

#include <algorithm>
#include <functional>
#include <numeric>
#include <utility>

#include "engine/base/error.h"

namespace gurney {
namespace {

static_assert(std::is_same_v<hid_t, std::int64_t>);

herr_t append_message(unsigned, const H5E_error2_t* error, void* text) {
  std::string& message = *static_cast<std::string*>(text);
  message += message.empty() ? "" : "; ";
  message += std::string(error->func_name) + ": " + error->desc;
  return 0;
}

[[noreturn]] void fail(const std::string& what) {
  std::string stack;
  H5Ewalk2(H5E_DEFAULT, H5E_WALK_UPWARD, append_message, &stack);
  H5Eclear2(H5E_DEFAULT);
  throw Error("HDF5 cannot " + what + (stack.empty() ? "" : ": " + stack));
}

/// Passes on what an HDF5 call returned unless it reports a failure (a negative number).
template <class Result>
Result checked(Result result, const std::string& what) {
  if (result < 0) fail(what);
  return result;
}

/// Owns one HDF5 identifier.
class Handle {
 public:
  Handle(hid_t id, const std::string& what) : id_(checked(id, what)) {}
  Handle(Handle&& other) noexcept : id_(std::exchange(other.id_, H5I_INVALID_HID)) {}
  Handle& operator=(Handle&&) = delete;
  ~Handle() {
    if (id_ >= 0) H5Idec_ref(id_);
  }
  operator hid_t() const { return id_; }

 private:
  hid_t id_;
};

void silence_printing() { H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr); }

Handle text_type() {
  Handle type(H5Tcopy(H5T_C_S1), "make a text type");
  checked(H5Tset_size(type, H5T_VARIABLE), "make a text type");
  checked(H5Tset_cset(type, H5T_CSET_UTF8), "make a text type");
  return type;
}

std::vector<const char*> pointers(std::span<const std::string> values) {
  std::vector<const char*> result;
  for (const std::string& value : values) result.push_back(value.c_str());
  return result;
}

void write_attribute(hid_t file, const std::string& object, const std::string& name, hid_t type,
                     const std::vector<std::uint64_t>& shape, const void* value) {
  const std::string what = "write attribute '" + name + "' of " + object;
  const Handle owner(H5Oopen(file, object.c_str(), H5P_DEFAULT), what);
  const std::vector<hsize_t> extent(shape.begin(), shape.end());
  const Handle space(
      extent.empty() ? H5Screate(H5S_SCALAR) : H5Screate_simple(1, extent.data(), nullptr), what);
  const Handle attribute(H5Acreate2(owner, name.c_str(), type, space, H5P_DEFAULT, H5P_DEFAULT),
                         what);
  if (extent.empty() || extent[0] > 0) checked(H5Awrite(attribute, type, value), what);
}

std::vector<std::string> take_strings(hid_t type, hid_t space, std::vector<char*>& raw) {
  std::vector<std::string> result;
  for (const char* text : raw) result.emplace_back(text ? text : "");
  checked(H5Dvlen_reclaim(type, space, H5P_DEFAULT, raw.data()), "release text");
  return result;
}

std::string text_of(hid_t object, const std::string& name) {
  const std::string what = "read attribute '" + name + "'";
  if (checked(H5Aexists(object, name.c_str()), what) == 0) return {};
  const Handle attribute(H5Aopen(object, name.c_str(), H5P_DEFAULT), what);
  const Handle space(H5Aget_space(attribute), what);
  const Handle type = text_type();
  std::vector<char*> raw(1);
  checked(H5Aread(attribute, type, raw.data()), what);
  return take_strings(type, space, raw).front();
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

Hdf5Writer::Hdf5Writer() {
  silence_printing();
  const Handle access(H5Pcreate(H5P_FILE_ACCESS), "make a file in memory");
  checked(H5Pset_fapl_core(access, 1 << 20, false), "make a file in memory");
  const Handle creation(H5Pcreate(H5P_FILE_CREATE), "make a file in memory");
  checked(H5Pset_obj_track_times(creation, false), "switch object times off");
  file_ = checked(H5Fcreate("gurney-results", H5F_ACC_TRUNC, creation, access), "make a file");
}

Hdf5Writer::~Hdf5Writer() { H5Fclose(file_); }

void Hdf5Writer::add_group(const std::string& path) {
  const Handle creation(H5Pcreate(H5P_GROUP_CREATE), "make group " + path);
  checked(H5Pset_obj_track_times(creation, false), "switch object times off");
  Handle(H5Gcreate2(file_, path.c_str(), H5P_DEFAULT, creation, H5P_DEFAULT), "make group " + path);
}

void Hdf5Writer::set_attribute(const std::string& object, const std::string& name,
                               const std::string& value) {
  const char* const text = value.c_str();
  write_attribute(file_, object, name, text_type(), {}, &text);
}

void Hdf5Writer::set_attribute(const std::string& object, const std::string& name,
                               std::int64_t value) {
  write_attribute(file_, object, name, H5T_STD_I64LE, {}, &value);
}

void Hdf5Writer::set_attribute(const std::string& object, const std::string& name, double value) {
  write_attribute(file_, object, name, H5T_IEEE_F64LE, {}, &value);
}

void Hdf5Writer::set_attribute(const std::string& object, const std::string& name,
                               const std::vector<std::string>& values) {
  write_attribute(file_, object, name, text_type(), {values.size()}, pointers(values).data());
}

void Hdf5Writer::set_attribute(const std::string& object, const std::string& name,
                               const std::vector<std::uint8_t>& values) {
  write_attribute(file_, object, name, H5T_STD_U8LE, {values.size()}, values.data());
}

void Hdf5Writer::add(const Hdf5Spec& spec, std::span<const double> values) {
  write(spec, shape_of(spec), H5T_IEEE_F64LE, values.data(), values.size());
}

void Hdf5Writer::add(const Hdf5Spec& spec, std::span<const std::int64_t> values) {
  write(spec, shape_of(spec), H5T_STD_I64LE, values.data(), values.size());
}

void Hdf5Writer::add(const Hdf5Spec& spec, std::span<const std::uint8_t> values) {
  write(spec, shape_of(spec), H5T_STD_U8LE, values.data(), values.size());
}

void Hdf5Writer::add(const Hdf5Spec& spec, std::span<const std::string> values) {
  write(spec, shape_of(spec), text_type(), pointers(values).data(), values.size());
}

void Hdf5Writer::add_column(const Hdf5Spec& spec, std::span<const double> values,
                            std::size_t length) {
  write(spec, {length}, H5T_IEEE_F64LE, values.data(), values.size());
}

void Hdf5Writer::add_column(const Hdf5Spec& spec, std::span<const std::int64_t> values,
                            std::size_t length) {
  write(spec, {length}, H5T_STD_I64LE, values.data(), values.size());
}

void Hdf5Writer::add_column(const Hdf5Spec& spec, std::span<const std::string> values,
                            std::size_t length) {
  write(spec, {length}, text_type(), pointers(values).data(), values.size());
}

void Hdf5Writer::write(const Hdf5Spec& spec, const std::vector<std::uint64_t>& shape,
                       std::int64_t type, const void* values, std::size_t count) {
  constexpr hsize_t kRowsPerChunk = 4096;
  const std::string what = "write dataset " + spec.path;
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
  set_attribute(spec.path, "units", spec.units);
  set_attribute(spec.path, "long_name", spec.long_name);
  for (std::size_t i = 0; i < spec.scales.size(); ++i) {
    const Handle scale(H5Dopen2(file_, spec.scales[i].c_str(), H5P_DEFAULT), what);
    checked(H5DSattach_scale(dataset, scale, static_cast<unsigned>(i)), what);
  }
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
  const Handle dataset(H5Dopen2(file_, path.c_str(), H5P_DEFAULT), what);
  checked(H5DSset_scale(dataset, path.substr(path.rfind('/') + 1).c_str()), what);
  scales_.push_back({path, length});
}

std::string Hdf5Writer::image() {
  checked(H5Fflush(file_, H5F_SCOPE_GLOBAL), "finish a file");
  const auto size = checked(H5Fget_file_image(file_, nullptr, 0), "size a file");
  std::string bytes(static_cast<std::size_t>(size), '\0');
  checked(H5Fget_file_image(file_, bytes.data(), bytes.size()), "copy a file");
  return bytes;
}

Hdf5Reader::Hdf5Reader(const std::string& path) {
  silence_printing();
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
  std::vector<char*> raw(
      static_cast<std::size_t>(checked(H5Sget_simple_extent_npoints(space), "size " + path)));
  const Handle type = text_type();
  checked(H5Dread(dataset, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, raw.data()), "read " + path);
  return take_strings(type, space, raw);
}

}  // namespace gurney
