#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace gurney {

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

  std::vector<Hdf5Dataset> datasets() const;                    ///< in order of their paths
  std::vector<std::string> attributes() const;                  ///< names, of the file itself
  std::string text_attribute(const std::string& name) const;    ///< of the file itself
  std::int64_t whole_attribute(const std::string& name) const;  ///< of the file; 0: it has none
  std::vector<std::string> text_attributes(const std::string& name) const;  ///< a list of texts
  std::vector<double> numbers(const std::string& path) const;
  std::vector<std::string> strings(const std::string& path) const;

 private:
  std::int64_t file_;
};

}  // namespace gurney
