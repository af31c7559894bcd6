#include "studies/results/hdf5_reader.h"

#include <fmt/format.h>
#include <hdf5_hl.h>
#include <sys/stat.h>

#include <algorithm>
#include <exception>
#include <filesystem>
#include <fstream>
#include <functional>
#include <map>
#include <mutex>
#include <new>
#include <optional>
#include <set>
#include <string_view>
#include <tuple>

#include "engine/base/error.h"
#include "engine/base/files_read.h"
#include "engine/base/input_file.h"
#include "engine/base/printable.h"
#include "studies/results/hdf5_checks.h"
#include "studies/results/hdf5_handle.h"

namespace gurney::study {

using hdf5::checked;
using hdf5::Handle;
using hdf5::prepare_library;

namespace {

/// Values of a file may take so much memory: some times what files of this program need, whose
/// columns of zeros take little of the file.
double largest_values(double file_size) { return 1e9 + 50 * file_size; }

constexpr std::uint64_t kMaxProbed = std::uint64_t{1} << 22;  // values of one dataset

std::vector<std::string> take_strings(hid_t type, hid_t space, std::vector<char*>& raw) {
  std::vector<std::string> result;
  for (const char* text : raw) result.push_back(printable(text ? text : ""));
  checked(H5Dvlen_reclaim(type, space, H5P_DEFAULT, raw.data()), "release text");
  return result;
}

std::vector<std::string> cut_strings(const std::string& flat, std::size_t width) {
  std::vector<std::string> result;
  for (std::size_t at = 0; at < flat.size(); at += width) {
    const std::string_view padded = std::string_view(flat).substr(at, width);
    result.push_back(printable(padded.substr(0, padded.find('\0'))));
  }
  return result;
}

/// The texts of a dataset or an attribute, of fixed or of any length; HDF5 turns no ASCII into
/// UTF-8, so they are read as they are stored.
/// @param read  takes a type in memory and where to put the values
template <class Read>
std::vector<std::string> texts(hid_t stored, hid_t space, const std::string& what, Read read) {
  const auto count = static_cast<std::size_t>(checked(H5Sget_simple_extent_npoints(space), what));
  if (count == 0) return {};
  hdf5::require_memory(count * H5Tget_size(stored));
  if (checked(H5Tis_variable_str(stored), what) > 0) {
    std::vector<char*> raw(count);
    checked(read(stored, static_cast<void*>(raw.data())), what);
    return take_strings(stored, space, raw);
  }
  const std::size_t width = H5Tget_size(stored);
  std::string flat(width * count, '\0');
  checked(read(stored, static_cast<void*>(flat.data())), what);
  return cut_strings(flat, width);
}

/// An attribute whose values are few enough to be in the file.
class Attribute {
 public:
  Attribute(hid_t object, const std::string& name)
      : what_("read attribute '" + name + "'"),
        id_(H5Aopen(object, name.c_str(), H5P_DEFAULT), what_),
        space_(H5Aget_space(id_), what_),
        type_(H5Aget_type(id_), what_) {
    hsize_t file_size = 0;
    checked(H5Fget_filesize(Handle(H5Iget_file_id(id_), what_), &file_size), what_);
    require(static_cast<double>(count()) * static_cast<double>(H5Tget_size(type_)) <=
                static_cast<double>(file_size),
            "attribute '" + name + "' states more values than the file has bytes");
  }

  hssize_t count() const { return checked(H5Sget_simple_extent_npoints(space_), what_); }
  H5T_class_t type() const { return H5Tget_class(type_); }

  std::vector<std::string> texts() const {
    return study::texts(type_, space_, what_,
                        [&](hid_t type, void* to) { return H5Aread(id_, type, to); });
  }
  std::int64_t whole() const {
    std::int64_t value = 0;
    checked(H5Aread(id_, H5T_NATIVE_INT64, &value), what_);
    return value;
  }

 private:
  std::string what_;
  Handle id_, space_, type_;
};

std::vector<std::string> texts_of(hid_t object, const std::string& name) {
  hdf5::require_memory();
  if (checked(H5Aexists(object, name.c_str()), "look for attribute " + name) == 0) return {};
  const Attribute attribute(object, name);
  require(attribute.type() == H5T_STRING, "attribute '" + name + "' must be text");
  return attribute.texts();
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

/// Width of a value in the file [bytes]
double width_of(hid_t dataset) {
  return static_cast<double>(H5Tget_size(Handle(H5Dget_type(dataset), "read a type")));
}

std::vector<std::uint64_t> shape_of(hid_t dataset, const std::string& path) {
  const Handle space(H5Dget_space(dataset), "read the shape of " + path);
  hsize_t extent[H5S_MAX_RANK];
  const int rank = checked(H5Sget_simple_extent_dims(space, extent, nullptr), "size " + path);
  return {extent, extent + rank};
}

std::string last_part(const std::string& path) { return path.substr(path.rfind('/') + 1); }

struct ScaleNames {
  std::vector<std::string> names;
  std::exception_ptr no_memory;
};

/// H5DSget_scale_name() frees twice over damaged files. No exception may pass through HDF5.
herr_t take_scale_name(hid_t, unsigned, hid_t scale, void* taken) {
  auto& [names, no_memory] = *static_cast<ScaleNames*>(taken);
  try {
    names.push_back(text_of(scale, "NAME"));
    return 1;
  } catch (const std::bad_alloc&) {
    no_memory = std::current_exception();
  } catch (const std::exception&) {
  }
  return -1;
}

/// One for each dimension that has a scale.
std::vector<std::string> scale_names(hid_t dataset, std::size_t dimensions) {
  ScaleNames taken;
  for (unsigned i = 0; i < dimensions; ++i)
    H5DSiterate_scales(dataset, i, nullptr, take_scale_name, &taken);
  if (taken.no_memory) std::rethrow_exception(taken.no_memory);
  return taken.names;
}

herr_t take_dataset_path(hid_t, const char* name, const H5O_info_t* info, void* paths) {
  if (info->type == H5O_TYPE_DATASET)
    static_cast<std::vector<std::string>*>(paths)->push_back(std::string("/") + name);
  return 0;
}

std::uint64_t size_of(const Hdf5Dataset& dataset) {
  std::uint64_t size = 1;
  for (const std::uint64_t length : dataset.shape) size *= length;
  return size;
}

Hdf5Dataset describe(hid_t file, const std::string& path) {
  const Handle dataset(H5Dopen2(file, path.c_str(), H5P_DEFAULT), "open dataset " + path);
  hdf5::check_storage(dataset, "dataset " + path);
  Hdf5Dataset found{path, type_name(dataset),        shape_of(dataset, path),
                    {},   text_of(dataset, "units"), text_of(dataset, "long_name"),
                    0};
  constexpr double kText = 32;  // a std::string beside its characters [bytes]
  found.bytes = static_cast<double>(size_of(found)) *
                (found.type == "string" ? kText + width_of(dataset) : sizeof(double));
  if (text_of(dataset, "CLASS") == "DIMENSION_SCALE")
    found.scales = {last_part(path)};
  else
    found.scales = scale_names(dataset, found.shape.size());
  return found;
}

std::vector<Hdf5Dataset> datasets_of(hid_t file) {
  std::vector<std::string> paths;
  checked(H5Ovisit2(file, H5_INDEX_NAME, H5_ITER_INC, take_dataset_path, &paths, H5O_INFO_BASIC),
          "list datasets");
  std::vector<Hdf5Dataset> result;
  for (const std::string& path : paths) result.push_back(describe(file, path));
  return result;
}

std::string group_of(const std::string& path) { return path.substr(0, path.rfind('/')); }

/// Few bytes can state many values: what is read of them must be what a table can have.
void check_sizes(const std::vector<Hdf5Dataset>& datasets, const std::string& path) {
  std::map<std::string, std::uint64_t> rows;
  for (const Hdf5Dataset& each : datasets)
    if (last_part(each.path) == "row" && each.shape.size() == 1)
      rows[group_of(each.path)] = each.shape[0];
  double bytes = 0;
  for (const Hdf5Dataset& each : datasets) {
    bytes += each.bytes;
    const auto table = rows.find(group_of(each.path));
    require(table == rows.end() || (!each.shape.empty() && each.shape[0] == table->second),
            fmt::format("{}: dataset {} must be a column as long as its table", path, each.path));
  }
  std::error_code ignored;
  const auto size = static_cast<double>(std::filesystem::file_size(path, ignored));
  require(bytes <= largest_values(size),
          fmt::format("{}: its values would take {:.1f} GB of memory, which is more than a results "
                      "file of {:.1f} MB has",
                      path, bytes / 1e9, size / 1e6));
}

struct Noted {
  std::mutex mutex;
  std::set<std::string> paths;
};

Noted& without_checksum() {
  static Noted noted;
  return noted;
}

void note_without_checksum(const std::string& path) {
  const std::lock_guard lock(without_checksum().mutex);
  without_checksum().paths.insert(path);
}

}  // namespace

std::set<std::string> files_without_checksum() {
  const std::lock_guard lock(without_checksum().mutex);
  return without_checksum().paths;
}

namespace {

/// Device, number, size and time of a file: written again, it is another.
using Written = std::tuple<dev_t, ino_t, off_t, time_t, long>;

std::optional<Written> written(const std::string& path) {
  struct stat of {};
  if (::stat(path.c_str(), &of) != 0) return {};
  return Written(of.st_dev, of.st_ino, of.st_size, of.st_mtim.tv_sec, of.st_mtim.tv_nsec);
}

using Datasets = std::vector<Hdf5Dataset>;

/// The datasets of a file, checked and described once as long as it is not written again: most commands open
/// it several times.
/// @param read      reads the whole file in a child process
/// @param describe  lists the datasets of the file once it is known to be sound
Datasets checked_once(const std::string& path, const std::function<void()>& read,
                      const std::function<Datasets()>& describe) {
  static std::mutex mutex;
  struct Known {
    Written when;
    Datasets datasets;
  };
  static std::map<std::string, Known> known;
  const std::optional<Written> now = written(path);
  const std::lock_guard lock(mutex);
  const auto before = known.find(path);
  if (now && before != known.end() && before->second.when == *now) return before->second.datasets;
  if (!hdf5::check_seal(path)) note_without_checksum(path);
  hdf5::probe(path, read);
  const Datasets found = describe();
  if (now) known.insert_or_assign(path, Known{*now, found});
  return found;
}

}  // namespace

Hdf5Reader::Hdf5Reader(const std::string& path) : path_(path) {
  hdf5::require_memory();
  prepare_library();
  require_regular_file(path);
  note_read(path);
  require(std::ifstream(path).is_open(), path + ": cannot be read");
  require(H5Fis_hdf5(path.c_str()) > 0, path + ": is not a results file of gurney (no HDF5 file)");
  const auto read = [&] {
    open();
    datasets_ = described();
    read_all();
  };
  try {
    datasets_ = checked_once(path, read, [&] {
      open();
      return described();
    });
    if (file_ < 0) open();
  } catch (...) {
    if (file_ >= 0) hdf5::close_file(file_);
    throw;
  }
}

void Hdf5Reader::open() {
  file_ = checked(H5Fopen(path_.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), "open " + path_);
}

std::vector<Hdf5Dataset> Hdf5Reader::described() const {
  hdf5::refuse_links(file_, path_);
  const Datasets datasets = named([&] { return datasets_of(file_); });
  check_sizes(datasets, path_);
  return datasets;
}

Hdf5Reader::~Hdf5Reader() { hdf5::close_file(file_); }

void Hdf5Reader::read_all() const {
  for (const std::string& name : attributes())
    if (Attribute(file_, name).type() == H5T_STRING) text_attributes(name);
  for (const Hdf5Dataset& each : datasets_) {
    if (each.type == "string")
      strings(each.path);
    else if (each.type != "other" && size_of(each) <= kMaxProbed)
      numbers(each.path);
  }
}

std::vector<std::string> Hdf5Reader::attributes() const {
  hdf5::require_memory();
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
  return named([&] { return text_of(file_, name); });
}

std::vector<std::string> Hdf5Reader::text_attributes(const std::string& name) const {
  return named([&] { return texts_of(file_, name); });
}

std::int64_t Hdf5Reader::whole_attribute(const std::string& name) const {
  hdf5::require_memory();
  if (checked(H5Aexists(file_, name.c_str()), "look for attribute " + name) == 0) return 0;
  return named([&] {
    const Attribute attribute(file_, name);
    require(attribute.type() == H5T_INTEGER && attribute.count() == 1,
            "attribute '" + name + "' must be one whole number");
    return attribute.whole();
  });
}

const Hdf5Dataset& Hdf5Reader::dataset(const std::string& path) const {
  for (const Hdf5Dataset& each : datasets_)
    if (each.path == path) return each;
  throw Error(path_ + ": has no dataset " + path);
}

std::vector<double> Hdf5Reader::numbers(const std::string& path) const {
  const Hdf5Dataset& found = dataset(path);
  hdf5::require_memory(size_of(found) * sizeof(double));
  require(found.type.starts_with("float") || found.type.find("int") != std::string::npos,
          fmt::format("{}: dataset {} must hold numbers", path_, path));
  return named([&] {
    const Handle dataset(H5Dopen2(file_, path.c_str(), H5P_DEFAULT), "open dataset " + path);
    require(shape_of(dataset, path) == found.shape, "it was written again while it was read");
    std::vector<double> values(size_of(found));
    checked(H5Dread(dataset, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()),
            "read " + path);
    return values;
  });
}

std::vector<std::string> Hdf5Reader::strings(const std::string& path) const {
  require(dataset(path).type == "string",
          fmt::format("{}: dataset {} must hold texts", path_, path));
  return named([&] {
    hdf5::require_memory();
    const Handle dataset(H5Dopen2(file_, path.c_str(), H5P_DEFAULT), "open dataset " + path);
    const Handle space(H5Dget_space(dataset), "read the shape of " + path);
    const Handle stored(H5Dget_type(dataset), "read the type of " + path);
    return texts(stored, space, "read " + path, [&](hid_t type, void* to) {
      return H5Dread(dataset, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, to);
    });
  });
}

bool Hdf5Reader::has(const std::string& path) const {
  return std::ranges::any_of(datasets_, [&](const Hdf5Dataset& each) { return each.path == path; });
}

void Hdf5Reader::require_length(const std::vector<std::string>& paths, std::uint64_t length) const {
  for (const std::string& path : paths) {
    const Hdf5Dataset& found = dataset(path);
    require(!found.shape.empty() && found.shape[0] == length &&
                size_of(found) % std::max<std::uint64_t>(length, 1) == 0,
            fmt::format("{}: dataset {} has {} rows; must have {}", path_, path,
                        found.shape.empty() ? 1 : found.shape[0], length));
  }
}

}  // namespace gurney::study
