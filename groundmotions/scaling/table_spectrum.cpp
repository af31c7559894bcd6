#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <vector>

#include "engine/base/csv_row.h"
#include "engine/base/error.h"
#include "engine/base/number_text.h"
#include "engine/base/units.h"
#include "groundmotions/formats/source_file.h"
#include "groundmotions/scaling/target_spectrum.h"

namespace gurney::groundmotions {

namespace {

struct Row {
  double period, acceleration, sigma = 0;
};

/// Lines of a table that are neither empty nor comments.
struct Line {
  std::size_t number;  ///< from 1
  std::vector<CsvCell> cells;
};

std::vector<Line> lines_of(const SourceFile& file) {
  std::vector<Line> lines;
  for (std::size_t i = 0; i < file.lines().size(); ++i) {
    const std::string_view line = trimmed(file.lines()[i]);
    if (!line.empty() && line.front() != '#') lines.push_back({i + 1, csv_row(file.lines()[i])});
  }
  return lines;
}

/// The cells of a row as numbers, in the order of `columns`; empty after an error.
std::vector<double> numbers_of(const Line& line, const std::vector<std::string>& titles,
                               const std::vector<std::size_t>& columns, FileErrors& errors) {
  if (line.cells.size() != titles.size()) {
    errors.add(
        line.number, 1,
        fmt::format("{} cells, the header has {} columns", line.cells.size(), titles.size()));
    return {};
  }
  std::vector<double> values;
  for (const std::size_t column : columns) {
    const CsvCell& cell = line.cells[column];
    if (const auto value = number(cell.text))
      values.push_back(*value);
    else
      errors.add(line.number, cell.column,
                 fmt::format("{} '{}': must be a number", titles[column], cell.text));
  }
  return values.size() == columns.size() ? values : std::vector<double>();
}

void add_row(const Row& row, const Line& line, FileErrors& errors, std::vector<Row>& rows) {
  if (!(row.period >= 0) || (!rows.empty() && !(row.period > rows.back().period)))
    errors.add(line.number, 1, fmt::format("period {:g} s: must be >= 0 and grow", row.period));
  else if (!(row.acceleration > 0))
    errors.add(line.number, 1,
               fmt::format("spectral acceleration {:g}: must be > 0", row.acceleration));
  else if (!(row.sigma >= 0))
    errors.add(line.number, 1, fmt::format("sigma {:g}: must be >= 0", row.sigma));
  else
    rows.push_back(row);
}

/// The row at or below a period and the one above it, and the share of the way in ln T.
struct Place {
  const Row &below, &above;
  double share;
};

Place place_of(const std::vector<Row>& rows, double period) {
  const auto next = std::upper_bound(rows.begin(), rows.end() - 1, period,
                                     [](double t, const Row& row) { return t < row.period; });
  const Row &a = *(next - 1), &b = *next;
  return {a, b,
          a.period == 0 ? period / b.period
                        : std::log(period / a.period) / std::log(b.period / a.period)};
}

TargetSpectrum spectrum_of(std::string name, const std::vector<Row>& rows, bool has_sigma,
                           FileErrors& errors) {
  if (!errors.any() && rows.size() < 2)
    errors.add("a spectrum needs a header 'period_s, sa_g' and at least two rows");
  errors.throw_if_any();
  TargetSpectrum spectrum{
      std::move(name), rows.front().period, rows.back().period, [rows](double t) {
        const auto [a, b, share] = place_of(rows, t);
        return a.period == 0 ? std::lerp(a.acceleration, b.acceleration, share)
                             : a.acceleration * std::pow(b.acceleration / a.acceleration, share);
      }};
  if (has_sigma)
    spectrum.sigma = [rows](double t) {
      const auto [a, b, share] = place_of(rows, t);
      return std::lerp(a.sigma, b.sigma, share);
    };
  return spectrum;
}

std::vector<std::string> titles_of(const Line& line) {
  std::vector<std::string> titles;
  for (const CsvCell& cell : line.cells) titles.push_back(cell.text);
  return titles;
}

const std::vector<std::string> kOpenQuake = {"poe", "stat", "period", "mea", "std"};

}  // namespace

TargetSpectrum table_spectrum(const SourceFile& file) {
  FileErrors errors(file);
  std::vector<Row> rows;
  std::vector<std::string> titles;
  double unit = 0;
  for (const Line& line : lines_of(file)) {
    if (titles.empty()) {
      titles = titles_of(line);
      if (titles.size() >= 2 && titles[0] == "period_s")
        unit = titles[1] == "sa_g" ? kStandardGravity : titles[1] == "sa_m_per_s2" ? 1 : 0;
      if (titles.size() > 3 || (titles.size() == 3 && titles[2] != "sigma_ln")) unit = 0;
      if (unit == 0) {
        errors.add(line.number, 1,
                   fmt::format("header '{}': must be 'period_s, sa_g' or 'period_s, "
                               "sa_m_per_s2', and 'sigma_ln' may follow",
                               trimmed(file.lines()[line.number - 1])));
        break;
      }
      continue;
    }
    const std::vector<std::size_t> columns =
        titles.size() == 3 ? std::vector<std::size_t>{0, 1, 2} : std::vector<std::size_t>{0, 1};
    if (const auto values = numbers_of(line, titles, columns, errors); !values.empty())
      add_row({values[0], values[1] * unit, values.size() == 3 ? values[2] : 0}, line, errors,
              rows);
  }
  return spectrum_of("table " + file.name(), rows, titles.size() == 3, errors);
}

TargetSpectrum openquake_spectrum(const SourceFile& file, std::optional<double> poe) {
  FileErrors errors(file);
  const std::vector<Line> lines = lines_of(file);
  if (lines.empty() || titles_of(lines[0]) != kOpenQuake)
    errors.add(lines.empty() ? 1 : lines[0].number, 1,
               fmt::format("header: must be '{}', as OpenQuake writes conditional spectra",
                           fmt::join(kOpenQuake, ",")));
  errors.throw_if_any();
  std::set<double> probabilities;
  std::vector<Row> rows;
  for (const Line& line : std::vector(lines.begin() + 1, lines.end())) {
    const auto values = numbers_of(line, kOpenQuake, {0, 2, 3, 4}, errors);
    if (values.empty() || line.cells[1].text != "mean") continue;
    probabilities.insert(values[0]);
    // The file has six digits.
    if (!poe || std::abs(values[0] - *poe) <= 1e-5 * *poe)
      if (poe || probabilities.size() == 1)
        add_row({values[1], values[2] * kStandardGravity, values[3]}, line, errors, rows);
  }
  if (!errors.any() && (poe ? rows.empty() : probabilities.size() > 1))
    errors.add(fmt::format("{}: must be one of {}",
                           poe ? fmt::format("poe {:g}", *poe) : "poe is not stated",
                           fmt::join(probabilities, ", ")));
  return spectrum_of(fmt::format("OpenQuake {}{}", file.name(),
                                 poe ? fmt::format(", poe {:g}", *poe) : std::string()),
                     rows, true, errors);
}

}  // namespace gurney::groundmotions
