#include <fmt/format.h>

#include <algorithm>

#include "groundmotions/formats/leading_numbers.h"
#include "groundmotions/formats/plain_cells.h"
#include "groundmotions/formats/plain_columns.h"
#include "groundmotions/formats/plain_facts.h"
#include "groundmotions/formats/plain_rows.h"
#include "groundmotions/formats/plain_table.h"
#include "groundmotions/formats/readers.h"
#include "groundmotions/formats/spectrum_text.h"
#include "groundmotions/formats/stated.h"
#include "groundmotions/formats/table_titles.h"

namespace gurney::groundmotions {

namespace {

void set_header(const PlainRows& rows, Component& component) {
  constexpr std::size_t kShown = 20;
  for (std::size_t i = 0; i < std::min(kShown, rows.header.size()); ++i)
    component.header.emplace_back(fmt::format("text {}", i + 1), rows.header[i]);
}

void warn_of_text(const PlainRows& rows, Component& component) {
  std::size_t count = 0;
  for (const auto line : rows.header) count += std::string_view("#%/").find(line[0]) == line.npos;
  if (count > 0)
    component.warnings.push_back(
        fmt::format("{} {} of text before the numbers, skipped; the last is '{}'", count,
                    count == 1 ? "line" : "lines", rows.header.back().substr(0, 60)));
  if (!rows.end.empty())
    component.warnings.push_back(
        fmt::format("{} {} after the numbers, skipped: '{}'", rows.end.size(),
                    rows.end.size() == 1 ? "line" : "lines", rows.end[0].substr(0, 60)));
}

/// The text may state how many samples there are; fewer were cut off, which must be said.
void warn_of_count(const PlainFacts& facts, const FileErrors& errors, Component& component) {
  const auto held = static_cast<double>(component.acceleration.size());
  if (facts.count && *facts.count != held)
    component.warnings.push_back(fmt::format("line {} states {} samples, but the file holds {}",
                                             errors.line_in_file(facts.count_line), *facts.count,
                                             held));
}

/// Samples may still have to be multiplied by what the text states.
void warn_of_factor(const PlainFacts& facts, const SourceFile& file, const FileErrors& errors,
                    Component& component) {
  if (facts.factor_line == 0) return;
  component.warnings.push_back(fmt::format(
      "line {} states a factor ('{}'): it was not applied", errors.line_in_file(facts.factor_line),
      trimmed(file.lines()[facts.factor_line - 1]).substr(0, 60)));
}

void check_leading_count(const LeadingNumbers& leading, const PlainRows& rows, FileErrors& errors) {
  if (leading.count > 0 && !errors.any())
    check_count(leading.count, "the first row", leading.line,
                leading.of_rows ? rows.lengths.size() : rows.values.size(), errors);
}

bool states_a_unit(const ColumnTitle& title) { return acceleration_unit(title.unit).has_value(); }

/// No other error matters before the decimal mark is known.
void refuse_doubtful_marks(const PlainCells& cells, const PlainRows& rows,
                           const ReadOptions& options, FileErrors& errors) {
  if (rows.lines.empty()) return;
  if (cells.mixed_marks)
    errors.add(rows.lines[0], 1,
               "semicolons part the cells, but the numbers have commas and points: which is the "
               "decimal mark? Write points only");
  if (rows.doubtful_commas && !options.si_per_count)
    errors.add(rows.lines[0], 1,
               "commas between whole numbers: decimal commas are read only where semicolons or "
               "tabs part the cells; write points (and whole numbers as 12.)");
  if (cells.mixed_marks || (rows.doubtful_commas && !options.si_per_count)) errors.throw_if_any();
}

}  // namespace

bool recognises_plain_text(const SourceFile& file) { return has_plain_rows(file); }

/// @throws Error if unit, time step or the meaning of the columns are neither stated by the file
///         nor by the options, for spectra, velocities and displacements that say so, what is no
///         number, rows of unequal length, and times that are not even.
std::vector<Component> read_plain_text(const SourceFile& original, const ReadOptions& options) {
  const PlainCells cells = plain_cells(original);
  const SourceFile& file = cells.file ? *cells.file : original;
  FileErrors errors(file);
  PlainRows rows = plain_rows(file, errors);
  refuse_spectra(rows, file);
  refuse_doubtful_marks(cells, rows, options, errors);
  const LeadingNumbers leading = take_leading_numbers(rows, options, errors);
  check_leading_count(leading, rows, errors);
  const std::size_t width = rows.width();
  const bool has_columns =
      width > 1 && options.columns != "samples" && (leading.count == 0 || leading.of_rows);
  const TableTitles titles = has_columns ? table_titles(rows, width) : TableTitles();
  refuse_spectra(titles, options.columns.empty(), rows, file);
  const PlainColumns columns =
      plain_columns(rows, titles, leading.count > 0 && !leading.of_rows, options, errors);
  const std::size_t samples = columns.samples ? rows.values.size() : rows.lengths.size();
  check_enough(static_cast<double>(samples), 0, errors);

  const bool is_table = !columns.samples && !errors.any();
  const PlainFacts facts =
      plain_facts(rows, is_table ? titles.lines : std::vector<std::size_t>(), errors);
  const PlainTable table{.rows = rows,
                         .facts = facts,
                         .leading = leading,
                         .options = options,
                         .errors = errors,
                         .title_line = titles.any()                ? titles.line
                                       : rows.header_lines.empty() ? 1
                                                                   : rows.header_lines.back(),
                         .some_state_a_unit = std::ranges::any_of(titles.titles, states_a_unit)};
  auto components =
      is_table ? table_components(columns, titles.titles, table) : only_component(table);
  errors.throw_if_any();
  for (Component& component : components) set_header(rows, component);
  warn_of_text(rows, components[0]);
  warn_of_count(facts, errors, components[0]);
  if (!options.si_per_count) warn_of_factor(facts, file, errors, components[0]);
  if (!leading.warning.empty()) components[0].warnings.push_back(leading.warning);
  if (!cells.first_time.empty())
    components[0].warnings.push_back(fmt::format(
        "the first row is of {}; the motion starts there, at 0 s of the run", cells.first_time));
  return components;
}

}  // namespace gurney::groundmotions
