#pragma once

#include <filesystem>
#include <string>

namespace gurney::study {

/// The file `study` of a folder of parts, which states whose they are: a line with the SHA-256 of
/// the identity (study_identity.h), and the identity.
class IdentityFile {
 public:
  explicit IdentityFile(const std::filesystem::path& folder);

  bool exists() const { return exists_; }  ///< and has any bytes
  bool damaged() const { return damaged_; }

  /// @throws Error for a damaged file; empty for none
  const std::string& identity() const;

  static std::string bytes_of(const std::string& identity);

 private:
  std::filesystem::path path_;
  std::string identity_;
  bool exists_ = false, damaged_ = false;
};

}  // namespace gurney::study
