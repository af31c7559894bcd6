#pragma once

#include <string>

#include "engine/base/diagnostics.h"
#include "groundmotions/formats/source_file.h"

namespace gurney::groundmotions {

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
