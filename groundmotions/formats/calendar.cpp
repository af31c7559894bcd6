#include "groundmotions/formats/calendar.h"

#include <algorithm>
#include <cctype>
#include <chrono>
#include <cmath>
#include <utility>
#include <vector>

#include "groundmotions/formats/numbers.h"

namespace gurney::groundmotions {

namespace {

/// The numbers of "2018/01/24 19:51:43.5" or "20180124_195143.5" as text; the last one keeps its
/// fraction.
std::vector<std::string_view> fields_of(std::string_view text) {
  std::vector<std::string_view> fields;
  for (std::size_t i = 0; i < text.size();) {
    std::size_t end = i;
    const auto is_part = [&](char c) {
      return std::isdigit(static_cast<unsigned char>(c)) != 0 || (c == '.' && end > i);
    };
    while (end < text.size() && is_part(text[end])) ++end;
    const auto field = text.substr(i, end - i);
    const auto digits = field.substr(0, field.find('.')).size();
    if (fields.empty() && digits == 8) {
      fields = {field.substr(0, 4), field.substr(4, 2), field.substr(6)};
    } else if (fields.size() == 3 && digits == 6) {
      fields.insert(fields.end(), {field.substr(0, 2), field.substr(2, 2), field.substr(4)});
    } else if (!field.empty()) {
      fields.push_back(field);
    }
    i = end + 1;
  }
  return fields;
}

std::optional<double> seconds_of(const std::vector<std::string_view>& fields) {
  if (fields.size() != 6) return {};
  double values[6];
  for (std::size_t i = 0; i < 6; ++i) {
    const auto value = number(fields[i]);
    if (!value || (i < 5 && *value != std::floor(*value))) return {};
    values[i] = *value;
  }
  const auto part = [&](std::size_t i) { return static_cast<int>(std::min(values[i], 1e6)); };
  return utc_seconds(part(0), part(1), part(2), values[3], values[4], values[5]);
}

}  // namespace

std::optional<double> utc_seconds(std::string_view text) {
  return seconds_of(fields_of(trimmed(text)));
}

std::optional<double> day_first_utc_seconds(std::string_view text) {
  auto fields = fields_of(trimmed(text));
  if (fields.size() == 6) std::swap(fields[0], fields[2]);
  return seconds_of(fields);
}

std::optional<double> utc_seconds(int year, int month, int day, double hour, double minute,
                                  double second) {
  const bool in_range = year >= 1900 && year <= 3000 && month >= 1 && day >= 1 && hour >= 0 &&
                        hour < 24 && minute >= 0 && minute < 60 && second >= 0 &&
                        second < 61;  // a leap second
  if (!in_range) return {};
  const std::chrono::year_month_day date(std::chrono::year(year),
                                         std::chrono::month(static_cast<unsigned>(month)),
                                         std::chrono::day(static_cast<unsigned>(day)));
  if (!date.ok()) return {};
  const auto days = std::chrono::sys_days(date).time_since_epoch().count();
  return ((static_cast<double>(days) * 24 + hour) * 60 + minute) * 60 + second;
}

}  // namespace gurney::groundmotions
