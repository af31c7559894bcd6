#include "groundmotions/formats/leading_numbers.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace gurney::groundmotions {

namespace {

constexpr std::size_t kFewest = 10;  ///< samples that make a count or a scale factor credible

bool is_count(double value) { return value >= 2 && value == std::floor(value); }
bool is_step(double value) { return value > 0 && value <= 1; }

/// 0.01, 0.005, 0.0078125: a whole number of samples in a second, as recorders take them.
bool is_usual_step(double value) {
  const double rate = 1 / value;
  return value > 0 && value <= 0.1 && std::abs(rate - std::round(rate)) <= 1e-6 * rate;
}

void drop_rows(PlainRows& rows, std::size_t count) {
  const auto at = [](std::size_t n) { return static_cast<std::ptrdiff_t>(n); };
  std::size_t values = 0;
  for (std::size_t i = 0; i < count; ++i) values += rows.lengths[i];
  rows.values.erase(rows.values.begin(), rows.values.begin() + at(values));
  rows.lengths.erase(rows.lengths.begin(), rows.lengths.begin() + at(count));
  rows.lines.erase(rows.lines.begin(), rows.lines.begin() + at(count));
}

/// Rows of a time and values follow a first row, and the times have the step of that row.
bool times_follow(const PlainRows& rows, double step) {
  if (rows.lengths.size() < 3 || rows.lengths[1] < 2 || rows.lengths[2] != rows.lengths[1])
    return false;
  const double first = rows.values[rows.lengths[0]];
  const double second = rows.values[rows.lengths[0] + rows.lengths[1]];
  return std::abs(second - first - step) <= 0.01 * step;
}

/// `4684 0.0100`, in either order.
LeadingNumbers count_and_step(const PlainRows& rows) {
  double count = rows.values[0], step = rows.values[1];
  const bool is_reversed = is_step(count) && is_count(step) && step >= kFewest;
  if (is_reversed) std::swap(count, step);
  if (!is_count(count) || !is_step(step)) return {};
  const bool in_one_row = rows.lengths[0] == 2;
  if (!in_one_row && rows.lengths[1] != 1) return {};
  const bool fits = count == static_cast<double>(rows.values.size() - 2);
  const LeadingNumbers found{count, step, rows.lines[0], false, {}};
  if (!in_one_row) return fits ? found : LeadingNumbers{};
  const bool counts_rows = count == static_cast<double>(rows.lengths.size() - 1);
  if (rows.lengths[1] > 1 && !fits && (counts_rows || times_follow(rows, step))) {
    LeadingNumbers table = found;
    table.of_rows = true;
    return table;
  }
  return fits || (!is_reversed && rows.lengths[1] != 2) ? found : LeadingNumbers{};
}

/// A count alone in the first row.
LeadingNumbers count_alone(const PlainRows& rows) {
  const double count = rows.values[0];
  if (rows.lengths[0] != 1 || !is_count(count) || rows.lengths.size() <= kFewest) return {};
  LeadingNumbers found{count, 0, rows.lines[0], false, {}};
  if (rows.lengths[1] > 1 && count == static_cast<double>(rows.lengths.size() - 1)) {
    found.of_rows = true;
  } else if (count != static_cast<double>(rows.values.size() - 1)) {
    return {};
  }
  found.warning =
      fmt::format("the first number, {}, is how many follow: taken as their count", count);
  return found;
}

/// `1` and `0.01` before one column of samples.
bool are_scale_and_step(const PlainRows& rows, const ReadOptions& options) {
  if (rows.lengths.size() < kFewest + 2) return false;
  const bool two_rows = rows.lengths[0] == 1 && rows.lengths[1] == 1 && rows.lengths[2] >= 1;
  const bool one_row = rows.lengths[0] == 2 && rows.lengths[1] == 1;
  const double scale = rows.values[0], step = rows.values[1];
  const bool is_known_step = options.time_step && *options.time_step == step;
  // Raw counts are whole numbers too.
  const bool has_fractions = std::ranges::any_of(rows.values.begin() + 2, rows.values.end(),
                                                 [](double v) { return v != std::floor(v); });
  return (two_rows || one_row) && has_fractions && scale >= 1 &&
         (is_known_step || (scale == std::floor(scale) && is_usual_step(step)));
}

/// The first of several numbers may be the time step by its value.
std::string doubtful_step(const PlainRows& rows, const ReadOptions& options) {
  if (!options.time_step || rows.lengths.size() < kFewest || rows.lengths[0] != 1) return {};
  for (std::size_t i = 0; i < 2; ++i)
    if (rows.values[i] == *options.time_step)
      return fmt::format("sample {} equals the time step, {} s: is it a sample?", i + 1,
                         rows.values[i]);
  return {};
}

}  // namespace

LeadingNumbers take_leading_numbers(PlainRows& rows, const ReadOptions& options,
                                    FileErrors& errors) {
  if (rows.values.size() < 3 || rows.lengths.size() < 2 || rows.lengths[0] > 2) return {};
  LeadingNumbers found = count_and_step(rows);
  const bool all_samples = options.columns == "samples";
  if (found.line == 0) found = count_alone(rows);
  if (found.line == 0 && are_scale_and_step(rows, options)) {
    const std::string text = fmt::format(
        "the first two numbers, {} and {}, look like a scale "
        "factor and the time step",
        rows.values[0], rows.values[1]);
    if (all_samples) {
      found.warning = text + "; they were taken as samples";
      return found;
    }
    if (rows.values[0] != 1) {
      errors.add(rows.lines[0], 1,
                 text +
                     "; remove them and scale the samples, or state columns = \"samples\" if "
                     "they are samples");
      return {};
    }
    found = {0, rows.values[1], rows.lines[0], false, text + "; they were not taken as samples"};
  }
  if (found.line == 0) {
    found.warning = doubtful_step(rows, options);
    return found;
  }
  drop_rows(rows, rows.lengths[0] == 2 || found.time_step == 0 ? 1 : 2);
  return found;
}

}  // namespace gurney::groundmotions
