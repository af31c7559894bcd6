#pragma once

#include <cstdint>
#include <set>
#include <string>
#include <vector>

#include "engine/base/error.h"

namespace gurney::study {

/// Description of a dataset in its file.
struct Hdf5Dataset {
  std::string path;
  std::string type;  ///< "float64", "int64", "uint8" or "string"
  std::vector<std::uint64_t> shape;
  std::vector<std::string> scales;  ///< name of the scale of each dimension; a scale names itself
  std::string units;
  std::string long_name;
  double bytes = 0;  ///< of memory that its values take once they are read
};

/// An HDF5 file that may be damaged, or made to harm: it is read in a child process first; values
/// stand in the file itself and are not more than its bytes; columns are as long as their tables;
/// texts come without control characters.
class Hdf5Reader {
 public:
  /// @throws Error when `path` is not an HDF5 file, is damaged, or leads to other files.
  explicit Hdf5Reader(const std::string& path);
  ~Hdf5Reader();
  Hdf5Reader(const Hdf5Reader&) = delete;
  Hdf5Reader& operator=(const Hdf5Reader&) = delete;

  const std::string& path() const { return path_; }
  std::vector<Hdf5Dataset> datasets() const { return datasets_; }  ///< in order of their paths
  bool has(const std::string& dataset) const;
  std::vector<std::string> attributes() const;                  ///< names, of the file itself
  std::string text_attribute(const std::string& name) const;    ///< of the file itself
  std::int64_t whole_attribute(const std::string& name) const;  ///< of the file; 0: it has none
  std::vector<std::string> text_attributes(const std::string& name) const;  ///< a list of texts

  /// @throws Error where the dataset is absent or of another type
  std::vector<double> numbers(const std::string& path) const;
  std::vector<std::string> strings(const std::string& path) const;

  /// @throws Error unless each dataset has so many rows
  void require_length(const std::vector<std::string>& paths, std::uint64_t length) const;

 private:
  void open();
  std::vector<Hdf5Dataset> described() const;
  const Hdf5Dataset& dataset(const std::string& path) const;
  void read_all() const;

  /// Calls `read`; its errors get the file's name.
  template <class Read>
  auto named(Read read) const {
    try {
      return read();
    } catch (const Error& error) {
      throw Error(path_ + ": " + error.what());
    }
  }

  std::string path_;
  std::int64_t file_ = -1;
  std::vector<Hdf5Dataset> datasets_;
};

/// Files that this process has read and whose bytes could not be verified: their checksum was cut
/// off, as by another program that wrote into them.
std::set<std::string> files_without_checksum();

}  // namespace gurney::study
