#pragma once

#include <optional>
#include <string_view>

namespace gurney::groundmotions {

/// Seconds since 1970-01-01 00:00 UTC of a date and a time in UTC: year, month, day, hour, minute
/// and second, which may have a fraction, apart by what is no digit, or year to day and hour to
/// second without anything between: `2018/01/24 19:51:43`, `20090330_215650.967`. Nothing for what
/// is no date.
std::optional<double> utc_seconds(std::string_view text);

/// Reads a date with its day first: `14/11/2010 23:09:19.300`.
std::optional<double> day_first_utc_seconds(std::string_view text);

/// Takes numbers; nothing if there is no such date or time from 1900 to 3000.
std::optional<double> utc_seconds(int year, int month, int day, double hour, double minute,
                                  double second);

}  // namespace gurney::groundmotions
