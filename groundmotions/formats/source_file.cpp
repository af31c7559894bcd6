#include "groundmotions/formats/source_file.h"

#include <fmt/format.h>

#include <algorithm>

#include "engine/base/error.h"
#include "engine/base/hash/sha256.h"
#include "engine/base/input_file.h"

namespace gurney::groundmotions {

namespace {

constexpr std::string_view kByteOrderMark = "\xef\xbb\xbf";
constexpr std::uintmax_t kLargestFile = std::uintmax_t{256} << 20;

bool is_binary(char c) {
  const auto byte = static_cast<unsigned char>(c);
  return (byte < 0x20 && (byte < '\t' || byte > '\r') && byte != 0x1a) || byte == 0x7f;
}

/// Without the NULs that pad the end of a file, also where line ends follow them.
std::string_view without_padding(std::string_view bytes) {
  using namespace std::string_view_literals;
  const auto end = bytes.find_last_not_of("\0\r\n\t \x1a"sv) + 1;
  return bytes.substr(0, bytes.find('\0', end));
}

}  // namespace

SourceFile::SourceFile(const std::filesystem::path& path)
    : SourceFile(path.string(), read_input_file(path.string(), kLargestFile)) {}

SourceFile::SourceFile(std::string name, std::string bytes)
    : name_(std::move(name)), bytes_(std::move(bytes)) {
  require(!bytes_.empty() && bytes_ != kByteOrderMark, name_ + ": the file is empty");
  text_ = without_padding(bytes_);
  if (!text_.empty() && std::ranges::none_of(text_, is_binary)) cut();
}

void SourceFile::refuse_binary() const {
  const auto at = std::ranges::find_if(bytes_, is_binary);
  throw Error(fmt::format("{}: not a text file (byte {} is 0x{:02x})", name_,
                          at - bytes_.begin() + 1, static_cast<unsigned char>(*at)));
}

void SourceFile::cut() {
  std::string_view rest = text_;
  if (rest.starts_with(kByteOrderMark)) rest.remove_prefix(kByteOrderMark.size());
  while (!rest.empty()) {
    const auto length = static_cast<std::size_t>(
        std::ranges::find_if(rest, [](char c) { return c == '\n' || c == '\r'; }) - rest.begin());
    lines_.push_back(rest.substr(0, length));
    rest.remove_prefix(length);
    const auto end = std::min(rest.find_first_not_of('\r'), rest.size());
    if (end < rest.size() && rest[end] == '\n')
      rest.remove_prefix(end + 1);
    else if (!rest.empty())
      rest.remove_prefix(1);
  }
  const auto first = std::ranges::find_if(lines_, [](std::string_view line) {
    return line.find_first_not_of(" \t\v\f\x1a") != std::string_view::npos;
  });
  if (first == lines_.end()) return;
  blank_lines_ = static_cast<std::size_t>(first - lines_.begin());
  lines_.erase(lines_.begin(), first);
}

std::string SourceFile::sha256() const { return gurney::sha256(bytes_); }

void FileErrors::add(std::size_t line, std::size_t column, const std::string& message) {
  errors_.add(fmt::format("{}:{}:{}: {}", file_, line_in_file(line), column, message));
}

void FileErrors::add(const std::string& message) {
  errors_.add(fmt::format("{}: {}", file_, message));
}

void FileErrors::throw_if_any() const {
  errors_.raise(kShown, file_ + ": and ", " more of the kind");
}

void refuse_spectra(const std::string& file, const std::string& what, const std::string& instead) {
  throw Error(fmt::format(
      "{}:1:1: this file ({}) holds response spectra, not an acceleration history; take "
      "{} of this record",
      file, what, instead));
}

}  // namespace gurney::groundmotions
