#include <fcntl.h>
#include <sys/mman.h>
#include <unistd.h>

#include <filesystem>
#include <string_view>

#include "engine/base/error.h"
#include "engine/base/hash/sha256.h"
#include "studies/study/results/hdf5_checks.h"

namespace gurney::hdf5 {
namespace {

constexpr std::string_view kWord = "\ngurney sha256 ";
constexpr std::size_t kLength = kWord.size() + 64 + 1;  // with its line end

/// The bytes of a file, mapped: none of them need memory of ours.
class MappedFile {
 public:
  explicit MappedFile(const std::string& path) : size_(std::filesystem::file_size(path)) {
    const int file = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
    if (file >= 0 && size_ > 0) data_ = ::mmap(nullptr, size_, PROT_READ, MAP_PRIVATE, file, 0);
    if (file >= 0) ::close(file);
    require(size_ == 0 || (data_ != nullptr && data_ != MAP_FAILED), path + ": cannot be read");
  }
  ~MappedFile() {
    if (size_ > 0) ::munmap(data_, size_);
  }
  MappedFile(const MappedFile&) = delete;
  MappedFile& operator=(const MappedFile&) = delete;

  std::string_view bytes() const { return {static_cast<const char*>(data_), size_}; }

 private:
  std::size_t size_;
  void* data_ = nullptr;
};

std::string seal(std::string_view bytes) { return std::string(kWord) + sha256(bytes) + "\n"; }

}  // namespace

std::string seal_of(const std::string& path) { return seal(MappedFile(path).bytes()); }

std::string seal_of_bytes(const std::string& bytes) { return seal(bytes); }

void check_seal(const std::string& path) {
  const MappedFile file(path);
  const std::string_view bytes = file.bytes();
  if (bytes.size() < kLength) return;
  const std::size_t content = bytes.size() - kLength;
  if (!bytes.substr(content).starts_with(kWord)) return;
  require(bytes.substr(content) == seal(bytes.substr(0, content)),
          path + ": is damaged: its bytes are not those that were written (its SHA-256 differs)");
}

}  // namespace gurney::hdf5
