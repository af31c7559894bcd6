#include "studies/workbench/wasm/files.h"

#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <memory>
#include <vector>

#include "engine/base/error.h"
#include "engine/base/files_read.h"
#include "engine/base/input_file.h"

namespace gurney {
namespace workbench {

std::map<std::string, std::string>& files() {
  static std::map<std::string, std::string> all;
  return all;
}

void add_archive(const char* bytes, std::size_t size) {
  constexpr std::size_t kBlock = 512, kSizeAt = 124, kTypeAt = 156, kPrefixAt = 345;
  for (std::size_t at = 0; at + kBlock <= size && bytes[at] != '\0';) {
    const char* const header = bytes + at;
    const std::size_t length = std::strtoul(std::string(header + kSizeAt, 12).c_str(), nullptr, 8);
    const std::string prefix(header + kPrefixAt, strnlen(header + kPrefixAt, 155));
    const std::string name(header, strnlen(header, 100));
    if (header[kTypeAt] == '0')
      files()[kRoot + (prefix.empty() ? name : prefix + "/" + name)] =
          std::string(header + kBlock, length);
    at += kBlock * (1 + (length + kBlock - 1) / kBlock);
  }
}

}  // namespace workbench

void require_regular_file(const std::string& path) {
  require(!std::filesystem::is_directory(path), path + ": is a folder, not a file");
  require(workbench::files().contains(std::filesystem::absolute(path).lexically_normal().string()),
          path + ": no such file on this page");
}

std::string read_input_file(const std::string& path, std::uintmax_t) {
  require_regular_file(path);
  return workbench::files().at(std::filesystem::absolute(path).lexically_normal().string());
}

void note_read(const std::string&) {}
bool was_read(const std::string&) { return false; }

}  // namespace gurney

// The functions of <filesystem> that Debian's libc++ for WebAssembly is built without, for these files.
_LIBCPP_BEGIN_NAMESPACE_FILESYSTEM
namespace {

using gurney::workbench::files;

string_view after_last_slash(string_view path) { return path.substr(path.rfind('/') + 1); }

/// Where the extension of a file name begins.
size_t dot_of(string_view name) {
  const size_t dot = name.rfind('.');
  return name == ".." || dot == 0 || dot == string_view::npos ? name.size() : dot;
}

string key_of(const path& any) {
  string key = __absolute(any).lexically_normal().native();
  while (key.size() > 1 && key.ends_with('/')) key.pop_back();
  return key;
}

}  // namespace

int path::__compare(__string_view other) const {
  const int order = __string_view(__pn_).compare(other);
  return order < 0 ? -1 : order > 0;
}

path::__string_view path::__root_name() const { return {}; }
path::__string_view path::__root_directory() const {
  return __pn_.starts_with('/') ? __string_view(__pn_).substr(0, 1) : __string_view();
}
path::__string_view path::__root_path_raw() const { return __root_directory(); }
path::__string_view path::__relative_path() const {
  return __string_view(__pn_).substr(__root_directory().size());
}
path::__string_view path::__filename() const { return after_last_slash(__pn_); }
path::__string_view path::__stem() const { return __filename().substr(0, dot_of(__filename())); }
path::__string_view path::__extension() const { return __filename().substr(dot_of(__filename())); }
path::__string_view path::__parent_path() const {
  const size_t slash = __pn_.rfind('/');
  if (slash == string::npos) return {};
  return __string_view(__pn_).substr(0, slash == 0 ? 1 : slash);
}

path& path::replace_extension(const path& extension) {
  __pn_.resize(__pn_.size() - __extension().size());
  if (!extension.empty() && !extension.native().starts_with('.')) __pn_ += '.';
  __pn_ += extension.native();
  return *this;
}

path path::lexically_normal() const {
  const bool absolute = __pn_.starts_with('/');
  vector<string_view> parts;
  bool folder = false;
  for (string_view rest = __pn_; !rest.empty();) {
    const size_t slash = rest.find('/');
    const string_view part = rest.substr(0, slash);
    folder = slash != string_view::npos || part == "." || part == "..";
    rest = slash == string_view::npos ? string_view() : rest.substr(slash + 1);
    if (part.empty() || part == ".") continue;
    if (part != "..")
      parts.push_back(part);
    else if (!parts.empty() && parts.back() != "..")
      parts.pop_back();
    else if (!absolute)
      parts.push_back(part);
  }
  std::string result = absolute ? "/" : "";
  for (size_t i = 0; i < parts.size(); ++i) result.append(i > 0 ? "/" : "").append(parts[i]);
  if (folder && !parts.empty() && parts.back() != "..") result += '/';
  return result.empty() && !__pn_.empty() ? "." : result;
}

path __absolute(const path& any, error_code* failure) {
  if (failure != nullptr) failure->clear();
  return any.is_absolute() ? any : path("/") / any;
}

file_status __status(const path& any, error_code* failure) {
  if (failure != nullptr) failure->clear();
  const string key = key_of(any);
  if (files().contains(key)) return file_status(file_type::regular);
  const string folder = key == "/" ? key : key + '/';
  const auto inside = files().lower_bound(folder);
  const bool found = inside != files().end() && inside->first.starts_with(folder);
  return file_status(found ? file_type::directory : file_type::not_found);
}

path __read_symlink(const path&, error_code* failure) {
  if (failure != nullptr) *failure = make_error_code(errc::invalid_argument);
  return {};
}

error_code directory_entry::__do_refresh() noexcept { return {}; }

class __dir_stream {
 public:
  vector<directory_entry> entries;
  size_t at = 0;
};

directory_iterator::directory_iterator(const path& folder, error_code* failure, directory_options) {
  if (failure != nullptr) failure->clear();
  const string key = key_of(folder) + '/';
  auto stream = make_shared<__dir_stream>();
  for (auto file = files().lower_bound(key); file != files().end() && file->first.starts_with(key);
       ++file)
    if (file->first.find('/', key.size()) == string::npos)
      stream->entries.emplace_back(path(file->first));
  if (!stream->entries.empty())
    __imp_ = stream;
  else if (failure != nullptr)
    *failure = make_error_code(errc::no_such_file_or_directory);
}

directory_iterator& directory_iterator::__increment(error_code*) {
  if (++__imp_->at == __imp_->entries.size()) __imp_.reset();
  return *this;
}

const directory_entry& directory_iterator::__dereference() const {
  return __imp_->entries[__imp_->at];
}

filesystem_error::~filesystem_error() = default;
void filesystem_error::__create_what(int) { __storage_->__what_ = "not a file of this page"; }

_LIBCPP_END_NAMESPACE_FILESYSTEM
