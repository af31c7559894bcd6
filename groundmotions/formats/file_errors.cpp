#include "groundmotions/formats/file_errors.h"

#include <fmt/format.h>

#include "engine/base/error.h"

namespace gurney::groundmotions {

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
