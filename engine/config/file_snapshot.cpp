#include "engine/config/file_snapshot.h"

#include <filesystem>
#include <utility>

#include "engine/base/input_file.h"

namespace gurney::config {
namespace {

namespace fs = std::filesystem;

thread_local FileSnapshot* current = nullptr;

std::string key_of(const std::string& path) {
  return fs::absolute(path).lexically_normal().string();
}

}  // namespace

FileSnapshot::Scope::Scope(FileSnapshot& snapshot) : before_(std::exchange(current, &snapshot)) {}

FileSnapshot::Scope::~Scope() { current = before_; }

std::string FileSnapshot::bytes_of(const std::string& path) {
  if (current == nullptr) return read_input_file(path);
  const std::string key = key_of(path);
  const auto known = current->files_.find(key);
  if (known != current->files_.end()) return known->second;
  return current->files_[key] = read_input_file(path);
}

bool FileSnapshot::exists(const std::string& path) {
  std::error_code ignored;
  if (current == nullptr) return fs::exists(path, ignored);
  const std::string key = key_of(path);
  if (current->files_.contains(key) || current->seen_.contains(key)) return true;
  const bool there = fs::exists(path, ignored);
  if (there) current->seen_.insert(key);
  return there;
}

void FileSnapshot::note(const std::string& path, const std::string& bytes) {
  if (current == nullptr) return;
  current->files_.try_emplace(key_of(path), bytes);
}

}  // namespace gurney::config
