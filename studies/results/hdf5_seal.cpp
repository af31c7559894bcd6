#include <filesystem>
#include <fstream>
#include <string_view>

#include "engine/base/error.h"
#include "engine/base/hash/sha256.h"
#include "engine/base/hash/sha256_of_file.h"
#include "studies/results/hdf5_checks.h"

namespace gurney::hdf5 {
namespace {

constexpr std::string_view kWord = "\ngurney sha256 ";
constexpr std::size_t kLength = kWord.size() + 64 + 1;  // with its line end

std::string with_word(const std::string& sum) { return std::string(kWord) + sum + "\n"; }

/// The last bytes of a file, as many as a seal has; empty: it has fewer.
std::string end_of(const std::string& path, std::uintmax_t size) {
  if (size < kLength) return {};
  std::string bytes(kLength, '\0');
  std::ifstream file(path, std::ios::binary);
  file.seekg(static_cast<std::streamoff>(size - kLength));
  require(bool(file.read(bytes.data(), kLength)), path + ": cannot be read");
  return bytes;
}

}  // namespace

std::string seal_of(const std::string& path) {
  return with_word(sha256_of_file(path, std::filesystem::file_size(path)));
}

std::string seal_of_bytes(const std::string& bytes) { return with_word(sha256(bytes)); }

void check_seal(const std::string& path) {
  const std::uintmax_t size = std::filesystem::file_size(path);
  const std::string end = end_of(path, size);
  if (!end.starts_with(kWord)) return;
  require(end == with_word(sha256_of_file(path, size - kLength)),
          path + ": is damaged: its bytes are not those that were written (its SHA-256 differs)");
}

}  // namespace gurney::hdf5
