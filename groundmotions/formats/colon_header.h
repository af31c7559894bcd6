#pragma once

#include <string_view>
#include <vector>

#include "groundmotions/formats/source_file.h"

namespace gurney::groundmotions {

/// The lines `key: value` at the top of a file.
class ColonHeader {
 public:
  struct Entry {
    std::string_view key;
    std::string_view value;  ///< may be empty
    std::size_t line;        ///< from 1
  };

  /// Reads up to the first line without a colon.
  explicit ColonHeader(const SourceFile& file);

  /// How many lines it has.
  std::size_t lines() const { return entries_.size(); }

  /// The entry `key`, or null.
  const Entry* find(std::string_view key) const;

  /// The first entry whose key starts with `start`, or null.
  const Entry* find_start(std::string_view start) const;

  /// The value of `key`, empty if there is none.
  std::string_view value(std::string_view key) const;

  /// The number of `key`; an error and 0 if it is no number or not there.
  double number_of(std::string_view key, FileErrors& errors) const;

 private:
  std::vector<Entry> entries_;
};

}  // namespace gurney::groundmotions
