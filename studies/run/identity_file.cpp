#include "studies/run/identity_file.h"

#include "engine/base/error.h"
#include "engine/base/hash/sha256.h"
#include "studies/run/part_folder.h"

namespace gurney::study {

IdentityFile::IdentityFile(const std::filesystem::path& folder) : path_(folder / "study") {
  std::error_code unknown;
  const std::string bytes =
      std::filesystem::exists(path_, unknown) ? file_bytes(path_) : std::string();
  exists_ = !bytes.empty();
  const auto end = bytes.find('\n');
  if (end != std::string::npos) identity_ = bytes.substr(end + 1);
  damaged_ = exists_ && bytes != bytes_of(identity_);
}

const std::string& IdentityFile::identity() const {
  require(!damaged_, path_.string() +
                         ": is damaged (its checksum does not match); `gurney run` with --resume "
                         "and `gurney merge` write it again");
  return identity_;
}

std::string IdentityFile::bytes_of(const std::string& identity) {
  return "sha256 = " + sha256(identity) + "\n" + identity;
}

}  // namespace gurney::study
