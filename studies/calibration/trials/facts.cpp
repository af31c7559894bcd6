#include "studies/calibration/trials/facts.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <sstream>

#include "engine/config/nearest_name.h"
#include "engine/config/unit_limit.h"

namespace gurney::calibration {

std::optional<double> number_in(const std::string& text) {
  const char* begin = text.data() + (text.starts_with('+') ? 1 : 0);
  const char* const end = text.data() + text.size();
  double value = 0;
  const auto [stop, failed] = std::from_chars(begin, end, value);
  if (failed != std::errc() || stop != end || !std::isfinite(value)) return {};
  return value;
}

std::string not_a_number(const std::string& key, const std::string& text) {
  return fmt::format("{} = \"{}\": must be a number{}", key, text,
                     text.find(';') != std::string::npos
                         ? "; cells are apart by commas and the decimal mark is a point"
                         : "");
}

void Facts::add(const std::string& key, const TextCell& value) {
  if (!value.text.empty()) values_.insert_or_assign(key, value);
}

const TextCell* Facts::find(const std::string& key, bool needed) {
  asked_.insert(key);
  const auto found = values_.find(key);
  if (found != values_.end()) return &found->second;
  if (needed) errors_->note(at_, key + ": missing");
  return nullptr;
}

const TextCell& Facts::at(const std::string& key) const {
  const auto found = values_.find(key);
  return found != values_.end() ? found->second : at_;
}

std::string Facts::text(const std::string& key, std::optional<std::string> fallback) {
  const TextCell* cell = find(key, !fallback);
  return cell != nullptr ? cell->text : fallback.value_or("");
}

double Facts::number(const std::string& key, const config::Range& range,
                     std::optional<double> fallback) {
  const TextCell* cell = find(key, !fallback);
  if (cell == nullptr) return fallback.value_or(1);
  const std::optional<double> value = number_in(cell->text);
  if (!value)
    errors_->note(*cell, not_a_number(key, cell->text));
  else
    note_outside(*cell, key, range, cell->text, *value);
  return value.value_or(1);
}

void Facts::note_outside(const TextCell& cell, const std::string& key, const config::Range& range,
                         const std::string& text, double value) {
  const std::string allowed =
      range.contains(value) ? config::beyond_unit(key, range, value) : range.text();
  if (!allowed.empty()) errors_->note(cell, fmt::format("{} = {}: must be {}", key, text, allowed));
}

std::size_t Facts::choice(const std::string& key, const std::vector<std::string>& allowed) {
  const TextCell* cell = find(key, true);
  if (cell == nullptr) return 0;
  const auto found = std::ranges::find(allowed, cell->text);
  if (found != allowed.end()) return static_cast<std::size_t>(found - allowed.begin());
  errors_->note(*cell, fmt::format("{} = \"{}\": unknown{}", key, cell->text,
                                   config::suggestion(cell->text, allowed)));
  return 0;
}

std::vector<double> Facts::numbers(const std::string& key, const config::Range& range) {
  const TextCell* cell = find(key, false);
  std::vector<double> values;
  if (cell == nullptr) return values;
  std::istringstream words(cell->text);
  for (std::string word; words >> word;) {
    const std::optional<double> value = number_in(word);
    if (!value)
      errors_->note(*cell, not_a_number(key, word));
    else
      note_outside(*cell, key, range, word, *value);
    values.push_back(value.value_or(1));
  }
  return values;
}

}  // namespace gurney::calibration
