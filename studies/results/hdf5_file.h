#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

/// HDF5 behind values and exceptions. hdf5_file.cpp is the only file that includes hdf5.h. Every
/// call is checked; an Error carries HDF5's own stack of messages.
namespace gurney {

/// What a dataset is called and means. Its shape is given by dimension scales, named by path.
struct Hdf5Spec {
  std::string path;       ///< such as "/runs/end_time"
  std::string units;      ///< "1" for a pure number
  std::string long_name;  ///< one sentence
  std::vector<std::string> scales;
};

/// An HDF5 file made in memory, so that a full disk can never meet HDF5 half-way. No object
/// carries a time: the same calls give the same bytes.
class Hdf5Writer {
 public:
  Hdf5Writer();
  ~Hdf5Writer();
  Hdf5Writer(const Hdf5Writer&) = delete;
  Hdf5Writer& operator=(const Hdf5Writer&) = delete;

  void add_group(const std::string& path);

  /// @param object  path of a group or dataset, "/" for the file
  void set_attribute(const std::string& object, const std::string& name, const std::string& value);
  void set_attribute(const std::string& object, const std::string& name, std::int64_t value);
  void set_attribute(const std::string& object, const std::string& name, double value);
  void set_attribute(const std::string& object, const std::string& name,
                     const std::vector<std::string>& values);
  void set_attribute(const std::string& object, const std::string& name,
                     const std::vector<std::uint8_t>& values);

  /// A 1-D dataset that is itself a dimension; spec.scales must be empty.
  template <class Values>
  void add_scale(const Hdf5Spec& spec, const Values& values) {
    add_column(spec, values, values.size());
    make_scale(spec.path, values.size());
  }

  /// A dataset in row-major order, chunked, shuffled and deflated.
  /// @throws Error unless the scales' lengths multiply to the number of values.
  void add(const Hdf5Spec& spec, std::span<const double> values);
  void add(const Hdf5Spec& spec, std::span<const std::int64_t> values);
  void add(const Hdf5Spec& spec, std::span<const std::uint8_t> values);
  void add(const Hdf5Spec& spec, std::span<const std::string> values);

  /// The bytes of the finished file.
  std::string image();

 private:
  struct Scale {
    std::string path;
    std::uint64_t length;
  };
  void add_column(const Hdf5Spec& spec, std::span<const double> values, std::size_t length);
  void add_column(const Hdf5Spec& spec, std::span<const std::int64_t> values, std::size_t length);
  void add_column(const Hdf5Spec& spec, std::span<const std::string> values, std::size_t length);
  void write(const Hdf5Spec& spec, const std::vector<std::uint64_t>& shape, std::int64_t type,
             const void* values, std::size_t count);
  std::vector<std::uint64_t> shape_of(const Hdf5Spec& spec) const;
  void make_scale(const std::string& path, std::uint64_t length);

  std::int64_t file_;
  std::vector<Scale> scales_;
};

/// What a file says of one of its datasets.
struct Hdf5Dataset {
  std::string path;
  std::string type;                 ///< "float64", "int64", "uint8" or "string"
  std::vector<std::string> scales;  ///< name of the scale of each dimension; a scale names itself
  std::string units;
  std::string long_name;
};

class Hdf5Reader {
 public:
  /// @throws Error when `path` is no HDF5 file.
  explicit Hdf5Reader(const std::string& path);
  ~Hdf5Reader();
  Hdf5Reader(const Hdf5Reader&) = delete;
  Hdf5Reader& operator=(const Hdf5Reader&) = delete;

  std::vector<Hdf5Dataset> datasets() const;                  ///< in order of their paths
  std::vector<std::string> attributes() const;                ///< names, of the file itself
  std::string text_attribute(const std::string& name) const;  ///< of the file itself
  std::vector<double> numbers(const std::string& path) const;
  std::vector<std::string> strings(const std::string& path) const;

 private:
  std::int64_t file_;
};

}  // namespace gurney
