#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace gurney {

/// A text file in memory, cut into lines.
///
/// A line ends with LF, CR LF, CR CR LF or a lone CR; line ends are not part of the lines. A UTF-8
/// byte order mark is dropped.
class SourceFile {
 public:
  /// @throws Error if the file cannot be read, is no regular file, is empty or larger than 256 MiB,
  ///         or is not text.
  explicit SourceFile(const std::filesystem::path& path);

  /// Text that is in memory already. @throws Error if it is empty or not text.
  SourceFile(std::string name, std::string bytes);

  SourceFile(const SourceFile&) = delete;  // lines_ point into bytes_
  SourceFile& operator=(const SourceFile&) = delete;

  const std::string& name() const { return name_; }
  const std::vector<std::string_view>& lines() const { return lines_; }
  bool ends_with_line_end() const { return bytes_.back() == '\n' || bytes_.back() == '\r'; }
  std::string sha256() const;  ///< of the bytes, 64 hexadecimal digits (FIPS 180-4)

 private:
  void cut();

  std::string name_;
  std::string bytes_;
  std::vector<std::string_view> lines_;
};

}  // namespace gurney
