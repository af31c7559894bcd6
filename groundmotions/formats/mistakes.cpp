#include "groundmotions/formats/mistakes.h"

#include <fmt/format.h>

#include "engine/base/error.h"

namespace gurney::groundmotions {

constexpr std::size_t kShown = 20;

void Mistakes::add(std::size_t line, std::size_t column, const std::string& message) {
  keep(fmt::format("{}:{}:{}: {}", file_, line_in_file(line), column, message));
}

void Mistakes::add(const std::string& message) { keep(fmt::format("{}: {}", file_, message)); }

void Mistakes::keep(std::string line) {
  if (++count_ <= kShown) lines_.push_back(std::move(line));
}

void Mistakes::throw_if_any() const {
  if (!any()) return;
  std::string message = fmt::format("{}", fmt::join(lines_, "\n"));
  if (count_ > kShown)
    message += fmt::format("\n{}: and {} more of the kind", file_, count_ - kShown);
  throw Error(message);
}

void refuse_spectra(const std::string& file, const std::string& what, const std::string& instead) {
  throw Error(fmt::format(
      "{}:1:1: this file ({}) holds response spectra, not an acceleration history; take "
      "{} of this record",
      file, what, instead));
}

}  // namespace gurney::groundmotions
