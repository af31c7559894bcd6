#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

/// HDF5 behind values and exceptions. The files hdf5_*.cpp are the only ones that include hdf5.h.
/// Every call is checked; an Error states the reason.
namespace gurney::study {

/// Name and meaning of a dataset. Its shape is given by dimension scales, named by path.
struct Hdf5Spec {
  std::string path;       ///< such as "/runs/end_time"
  std::string units;      ///< "1" for a pure number
  std::string long_name;  ///< one sentence
  std::vector<std::string> scales;
};

enum class Hdf5Type { kFloat64, kInt64, kText };

/// An HDF5 file. No object carries a time: the same calls give the same bytes.
class Hdf5Writer {
 public:
  Hdf5Writer();  ///< in memory, so that a full disk can never meet HDF5 half-way: image()

  /// On disk, for results that do not fit into memory: finish().
  /// @throws Error as every other call, where the disk is full
  explicit Hdf5Writer(const std::string& path);
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
    write(spec, {values.size()}, std::span<const typename Values::value_type>(values));
    make_scale(spec.path, values.size());
  }

  /// A dataset in row-major order, chunked, shuffled and deflated.
  /// @throws Error unless the scales' lengths multiply to the number of values.
  template <class Values>
  void add(const Hdf5Spec& spec, const Values& values) {
    write(spec, shape_of(spec), std::span<const typename Values::value_type>(values));
  }

  /// A column that gets its values by append(). Without scales it is a scale itself.
  /// @param text_width  of kText: bytes of its longest value
  void add_growing(const Hdf5Spec& spec, Hdf5Type type, std::size_t text_width = 1);
  void append(const std::string& path, std::span<const double> values);
  void append(const std::string& path, std::span<const std::int64_t> values);
  void append(const std::string& path, std::span<const std::string> values);

  /// Completes a file on disk, with the SHA-256 of its bytes at its end.
  void finish();

  /// The bytes of the finished file in memory, with their SHA-256 at the end.
  std::string image();

 private:
  struct Scale {
    std::string path;
    std::uint64_t length;
  };
  using Shape = std::vector<std::uint64_t>;
  void write(const Hdf5Spec& spec, const Shape& shape, std::span<const double> values);
  void write(const Hdf5Spec& spec, const Shape& shape, std::span<const std::int64_t> values);
  void write(const Hdf5Spec& spec, const Shape& shape, std::span<const std::uint8_t> values);
  void write(const Hdf5Spec& spec, const Shape& shape, std::span<const std::string> values);
  void write(const Hdf5Spec& spec, const Shape& shape, std::int64_t type, const void* values,
             std::size_t count);
  void write_attribute(const std::string& object, const std::string& name, std::int64_t type,
                       const std::vector<std::uint64_t>& shape, const void* value);
  std::vector<std::uint64_t> shape_of(const Hdf5Spec& spec) const;
  void append(const std::string& path, std::int64_t type, const void* values, std::size_t count);
  void describe(std::int64_t dataset, const Hdf5Spec& spec);
  void make_scale(const std::string& path, std::uint64_t length);

  /// To be called before HDF5 is, with the bytes of the values that it is given.
  /// @throws std::bad_alloc
  void require_memory(std::size_t bytes = 0);

  std::string path_;  ///< on disk; empty: in memory
  std::int64_t file_;
  std::size_t held_ = 0;  ///< in memory: at most the bytes of the file
  std::vector<Scale> scales_;
};

}  // namespace gurney::study
