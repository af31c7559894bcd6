#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "engine/base/csv_row.h"
#include "engine/base/number_text.h"
#include "engine/base/units.h"
#include "groundmotions/formats/source_file.h"
#include "groundmotions/scaling/target_spectrum.h"

namespace gurney::groundmotions {

namespace {

struct Row {
  double period, acceleration;
};

/// m/s2 in one unit of the second column; 0 for a header that is none.
double unit_of(const std::vector<CsvCell>& header) {
  if (header.size() != 2 || header[0].text != "period_s") return 0;
  if (header[1].text == "sa_g") return kStandardGravity;
  return header[1].text == "sa_m_per_s2" ? 1 : 0;
}

double interpolated(const std::vector<Row>& rows, double period) {
  const auto next = std::upper_bound(rows.begin(), rows.end(), period,
                                     [](double t, const Row& row) { return t < row.period; });
  if (next == rows.end()) return rows.back().acceleration;
  const Row &a = *(next - 1), &b = *next;
  if (a.period == 0) return a.acceleration + (b.acceleration - a.acceleration) * period / b.period;
  const double share = std::log(period / a.period) / std::log(b.period / a.period);
  return a.acceleration * std::pow(b.acceleration / a.acceleration, share);
}

}  // namespace

TargetSpectrum table_spectrum(const SourceFile& file) {
  FileErrors errors(file);
  std::vector<Row> rows;
  double unit = 0;
  for (std::size_t i = 0; i < file.lines().size(); ++i) {
    const std::string_view line = trimmed(file.lines()[i]);
    if (line.empty() || line.front() == '#') continue;
    const std::vector<CsvCell> cells = csv_row(line);
    if (unit == 0) {
      unit = unit_of(cells);
      if (unit == 0) {
        errors.add(i + 1, 1,
                   fmt::format("header '{}': must be 'period_s, sa_g' or 'period_s, "
                               "sa_m_per_s2'",
                               line));
        break;
      }
      continue;
    }
    const auto period = cells.size() == 2 ? number(cells[0].text) : std::nullopt;
    const auto value = cells.size() == 2 ? number(cells[1].text) : std::nullopt;
    if (!period || !value)
      errors.add(i + 1, 1, fmt::format("'{}': must be two numbers apart by a comma", line));
    else if (!(*period >= 0) || (!rows.empty() && !(*period > rows.back().period)))
      errors.add(i + 1, 1, fmt::format("period {:g} s: must be >= 0 and grow", *period));
    else if (!(*value > 0))
      errors.add(i + 1, 1, fmt::format("spectral acceleration {:g}: must be > 0", *value));
    else
      rows.push_back({*period, *value * unit});
  }
  if (!errors.any() && rows.size() < 2)
    errors.add("a spectrum needs a header 'period_s, sa_g' and at least two rows");
  errors.throw_if_any();
  const double first = rows.front().period, last = rows.back().period;
  return {"table " + file.name(), first, last,
          [rows = std::move(rows)](double t) { return interpolated(rows, t); }};
}

}  // namespace gurney::groundmotions
