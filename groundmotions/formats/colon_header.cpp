#include "groundmotions/formats/colon_header.h"

#include <fmt/format.h>

#include <algorithm>

#include "groundmotions/formats/numbers.h"

namespace gurney::groundmotions {

ColonHeader::ColonHeader(const SourceFile& file) {
  for (const std::string_view line : file.lines()) {
    const auto colon = line.find(':');
    if (colon == std::string_view::npos) break;
    entries_.push_back(
        {trimmed(line.substr(0, colon)), trimmed(line.substr(colon + 1)), entries_.size() + 1});
  }
}

const ColonHeader::Entry* ColonHeader::find(std::string_view key) const {
  const auto at = std::ranges::find(entries_, key, &Entry::key);
  return at == entries_.end() ? nullptr : &*at;
}

const ColonHeader::Entry* ColonHeader::find_start(std::string_view start) const {
  const auto at =
      std::ranges::find_if(entries_, [&](const Entry& e) { return e.key.starts_with(start); });
  return at == entries_.end() ? nullptr : &*at;
}

std::string_view ColonHeader::value(std::string_view key) const {
  const Entry* entry = find(key);
  return entry ? entry->value : std::string_view();
}

double ColonHeader::number_of(std::string_view key, FileErrors& errors) const {
  const Entry* entry = find(key);
  const auto value = entry ? number(entry->value) : std::nullopt;
  if (!entry)
    errors.add(fmt::format("the header has no line '{}'", key));
  else if (!value)
    errors.add(entry->line, 1, fmt::format("{} must be a number, got '{}'", key, entry->value));
  return value.value_or(0);
}

}  // namespace gurney::groundmotions
