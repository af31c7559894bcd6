#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace gurney::groundmotions {

/// A file in memory; a text file is cut into lines.
///
/// A line ends with LF, CR LF, CR CR LF or a lone CR; line ends are not part of the lines. A UTF-8
/// byte order mark is dropped, and so are blank lines before the first that is not. Text has no
/// control characters but tabs, line and page ends and the end-of-text of DOS; NULs that pad its
/// end are no part of it, nor are blanks and line ends behind them.
class SourceFile {
 public:
  /// @throws Error if the file cannot be read, is no regular file, is empty or larger than 256 MiB.
  explicit SourceFile(const std::filesystem::path& path);

  /// Takes what is in memory already. @throws Error if it is empty.
  SourceFile(std::string name, std::string bytes);

  SourceFile(const SourceFile&) = delete;  // lines_ point into bytes_
  SourceFile& operator=(const SourceFile&) = delete;

  const std::string& name() const { return name_; }
  std::string_view bytes() const { return bytes_; }
  bool is_text() const { return !lines_.empty(); }

  /// At least one. @throws Error if the file is not text.
  const std::vector<std::string_view>& lines() const {
    if (!is_text()) refuse_binary();
    return lines_;
  }

  std::size_t blank_lines() const { return blank_lines_; }  ///< dropped before the first line

  bool ends_with_line_end() const { return text_.ends_with('\n') || text_.ends_with('\r'); }
  std::string sha256() const;  ///< of the bytes, 64 hexadecimal digits (FIPS 180-4)

 private:
  void cut();
  [[noreturn]] void refuse_binary() const;

  std::string name_;
  std::string bytes_;
  std::string_view text_;                ///< without the NULs that pad its end
  std::vector<std::string_view> lines_;  ///< none: not text
  std::size_t blank_lines_ = 0;
};

}  // namespace gurney::groundmotions
