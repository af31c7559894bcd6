#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "groundmotions/formats/source_file.h"
#include "groundmotions/record/record.h"

namespace gurney::groundmotions {

/// Statements of the user: what a file does not state must be stated here; what it states too is checked against this.
struct ReadOptions {
  std::string unit = {};                    ///< as acceleration_unit() takes it; empty: not stated
  std::optional<double> time_step = {};     ///< > 0 [s]
  std::optional<double> si_per_count = {};  ///< > 0, of a file of raw counts [m/s2]

  /// Meaning of the columns of a table of plain numbers are: "samples" (row by row one component), or
  /// names from time, h1, h2, vertical and skip, such as "time,h1"; empty: not stated.
  std::string columns = {};
};

/// One layout of record files.
struct Format {
  const char* name;

  /// Looks at the content, never at the file's name; never throws.
  bool (*recognises)(const SourceFile& file);

  /// @returns at least one component, warnings included; `file`, `format` and `sha256` are left to
  ///          the caller.
  /// @throws  Error with a line for each error in the file.
  std::vector<Component> (*read)(const SourceFile& file, const ReadOptions& options);

  bool is_binary = false;      ///< formats of text never see a binary file, nor the other way round
  bool takes_counts = false;   ///< its samples may be raw counts: si_per_count is allowed
  bool takes_columns = false;  ///< `columns` is allowed
};

/// All formats, those with the surest marks first: the first that recognises a file reads it.
const std::vector<Format>& formats();

/// The components of one file; their texts are readable().
/// @throws Error if the file cannot be read, no format recognises it, its content is wrong, or an
///         option is wrong or of no use to its format.
std::vector<Component> read_components(const std::filesystem::path& path,
                                       const ReadOptions& options = {});
std::vector<Component> read_components(const SourceFile& file, const ReadOptions& options = {});

/// Names a file that is known well but is no record (an archive, an HDF5 file, XML, a picture,
/// ...), by its first bytes, and what to do about it; nothing for any other.
std::optional<std::string> foreign_file(std::string_view bytes);

/// `text` in UTF-8 on one line: bytes that are no UTF-8 are taken as Latin-1, as in station names
/// of older files, and control characters become blanks.
std::string readable(std::string_view text);

}  // namespace gurney::groundmotions
