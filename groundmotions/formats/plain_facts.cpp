#include "groundmotions/formats/plain_facts.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "groundmotions/formats/column_title.h"
#include "groundmotions/formats/header_text.h"
#include "groundmotions/formats/source_file.h"
#include "groundmotions/formats/words.h"

namespace gurney::groundmotions {

namespace {

constexpr double kStepTolerance = 0.01;
constexpr std::size_t kLongestLine = 2000;  ///< what stands behind that is no statement

void take_unit(std::string_view line, std::size_t index, PlainFacts& facts, FileErrors& errors) {
  const auto text = unit_text_in(line);
  if (!text) return;
  const auto unit = acceleration_unit(*text);
  const auto end = static_cast<std::size_t>(text->data() - line.data()) + text->size();
  if (const auto factor = factor_behind(line.substr(end)); unit && !factor.empty())
    errors.add(index, end + 1,
               fmt::format("a factor behind the unit ('{} {}'): does it belong to the numbers or "
                           "to the unit? Scale the numbers and leave the factor out",
                           *text, factor));
  if (const auto quantity = other_quantity(*text); !unit && quantity)
    errors.add(index, 1,
               fmt::format("a record must be acceleration, but the unit '{}' is that of a {}",
                           *text, *quantity));
  else if (!unit)
    errors.add(index, 1,
               fmt::format("'{}' is not a unit of acceleration: {} are allowed", *text,
                           kAccelerationUnits));
  else if (facts.unit && facts.unit->to_si != unit->to_si)
    errors.add(index, 1,
               fmt::format("this line states the unit {}, but line {} states {}", unit->name,
                           errors.line_in_file(facts.unit_line), facts.unit->name));
  if (!unit || facts.unit) return;
  facts.unit = unit;
  facts.unit_line = index;
}

void take_step(std::string_view line, std::size_t index, PlainFacts& facts, FileErrors& errors) {
  const auto step = time_step_in(line);
  if (!step) return;
  if (facts.time_step) {
    check_step(facts, *step, fmt::format("line {}", errors.line_in_file(index)), errors);
  } else {
    facts.time_step = step;
    facts.step_line = index;
  }
}

void take_count(std::string_view line, std::size_t index, PlainFacts& facts) {
  const auto count = count_in(line);
  if (!count || facts.count) return;
  facts.count = count;
  facts.count_line = index;
}

void refuse_other_quantities(const PlainRows& rows, const std::vector<std::size_t>& lines,
                             FileErrors& errors) {
  std::vector<std::string_view> texts;
  for (const std::size_t i : lines) texts.push_back(rows.header[i].substr(0, kLongestLine));
  if (const auto other = other_quantity_in(texts))
    errors.add(rows.header_lines[lines[other->line]], 1,
               fmt::format("a record must be acceleration, but the text speaks of {} ('{}')",
                           other->quantity, texts[other->line].substr(0, 80)));
}

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
  const bool two_rows = rows.lengths[0] == 1 && rows.lengths[1] == 1;
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

/// "T (s) Sa (g)" as a sentence: words for a period or a frequency, then for an ordinate.
bool is_title_of_spectrum(const std::string& line) {
  const auto words = words_of(line, " \t,;:()[]#%*_-=./");
  return !words.empty() && is_one_of(words[0], "t tn f hz period freq frequency") &&
         std::ranges::any_of(words, [](auto word) { return is_one_of(word, "sa psa rsa fas"); });
}

}  // namespace

PlainFacts plain_facts(const PlainRows& rows, const std::vector<std::size_t>& titles,
                       FileErrors& errors) {
  PlainFacts facts;
  std::vector<std::size_t> lines;
  for (std::size_t i = 0; i < rows.header.size(); ++i)
    if (std::ranges::find(titles, i) == titles.end()) lines.push_back(i);
  refuse_other_quantities(rows, lines, errors);
  for (const std::size_t i : lines) {
    const auto line = rows.header[i].substr(0, kLongestLine);
    take_unit(line, rows.header_lines[i], facts, errors);
    take_step(line, rows.header_lines[i], facts, errors);
    take_count(line, rows.header_lines[i], facts);
    if (const auto unit = time_unit_in(line)) facts.time_unit = *unit;
    if (facts.component.empty()) facts.component = component_in(line);
    if (factor_in(line) && facts.factor_line == 0) facts.factor_line = rows.header_lines[i];
  }
  return facts;
}

void check_step(const PlainFacts& facts, double step, std::string_view what, FileErrors& errors) {
  if (!facts.time_step || std::abs(*facts.time_step - step) <= kStepTolerance * step) return;
  errors.add(facts.step_line, 1,
             fmt::format("the text states a time step of {:.9g} s, but {} {:.9g} s",
                         *facts.time_step, what, step));
}

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

void refuse_spectra(const PlainRows& rows, const SourceFile& file) {
  FileErrors errors(file);
  for (const std::string_view line : rows.header) {
    const std::string text = lower(line);
    const auto words = words_of("psa rotd spectral spectrum spectra arias espectro spettro", " ");
    const auto word =
        std::ranges::find_if(words, [&](auto each) { return text.find(each) != kNone; });
    if (word == words.end()) continue;
    errors.add(fmt::format(
        "a record must be an acceleration history, but the header speaks of '{}' ('{}')", *word,
        line.substr(0, 80)));
    errors.throw_if_any();
  }
}

void refuse_spectra(const TableTitles& titles, bool all, const PlainRows& rows,
                    const SourceFile& file) {
  FileErrors errors(file);
  for (std::size_t i = 0; i < rows.header.size() && !titles.any(); ++i)
    if (rows.width() > 1 && is_title_of_spectrum(lower(rows.header[i].substr(0, 1000))))
      errors.add(rows.header_lines[i], 1,
                 fmt::format("a record must be an acceleration history, but this is the title of a "
                             "spectrum ('{}')",
                             rows.header[i].substr(0, 80)));
  errors.throw_if_any();
  if (titles.titles.size() < 2) return;
  const ColumnTitle& first = titles.titles[0];
  const bool beside_time = names_time(first) && lower(first.name) != "t";
  if (names_period(first))
    errors.add(titles.line, 1,
               fmt::format("a record must be a history, but the first column is '{}'", first.text));
  for (std::size_t i = 1; i < titles.titles.size() && all && !errors.any(); ++i)
    if (names_ordinate(titles.titles[i], beside_time))
      errors.add(titles.line, 1,
                 fmt::format("a record must be an acceleration history, but the column '{}' is "
                             "that of a spectrum",
                             titles.titles[i].text));
  errors.throw_if_any();
}

}  // namespace gurney::groundmotions
