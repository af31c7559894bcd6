#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "engine/base/diagnostics.h"

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

/// Collects what is wrong with one file, so that one Error reports all of it.
class FileErrors {
 public:
  explicit FileErrors(const SourceFile& file)
      : file_(file.name()), before_(file.blank_lines()), errors_(kShown) {}

  /// The number in the file of a line of SourceFile::lines(), both counted from 1.
  std::size_t line_in_file(std::size_t line) const { return line + before_; }

  /// @param line, column  of SourceFile::lines(), counted from 1
  void add(std::size_t line, std::size_t column, const std::string& message);

  /// An error of the whole file.
  void add(const std::string& message);

  bool any() const { return !errors_.none(); }

  /// @throws Error with one line for each error, the first 20 in full.
  void throw_if_any() const;

 private:
  static constexpr std::size_t kShown = 20;

  std::string file_;
  std::size_t before_;  ///< blank lines before the first
  Diagnostics errors_;
};

/// @param what     the file is: "volume 3"
/// @param instead  the file to take: "the .V2"
/// @throws Error that says so.
[[noreturn]] void refuse_spectra(const std::string& file, const std::string& what,
                                 const std::string& instead);

}  // namespace gurney::groundmotions
