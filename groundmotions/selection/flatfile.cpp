#include "groundmotions/selection/flatfile.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <optional>

#include "engine/base/csv_row.h"
#include "engine/base/error.h"
#include "engine/base/number_text.h"
#include "engine/base/units.h"

namespace gurney::groundmotions {
namespace {

constexpr const char* kNumber = "Record Sequence Number";
constexpr std::array kFiles = {"File Name (Horizontal 1)", "File Name (Horizontal 2)",
                               "File Name (Vertical)"};
constexpr std::array kFacts = {
    std::pair("Earthquake Name", "event"), std::pair("Station Name", "station"),
    std::pair("Lowest Usable Freq - Ave. Component (Hz)", "lowest usable frequency [Hz]")};

/// The period of a column of Sa: 0.01 of "T0.010S".
std::optional<double> period_of(const std::string& title) {
  if (title.size() < 3 || title.front() != 'T' || title.back() != 'S') return {};
  return number(title.substr(1, title.size() - 2));
}

struct Columns {
  std::size_t count = 0, number = 0;
  std::array<std::size_t, 3> files;
  std::vector<std::pair<const char*, std::size_t>> facts;
  std::vector<std::pair<double, std::size_t>> spectrum;  ///< by growing period
};

Columns columns_of(const SourceFile& file) {
  const std::vector<CsvCell> titles = csv_row(file.lines()[0]);
  const auto column = [&](const char* title) {
    const auto found = std::ranges::find(titles, title, &CsvCell::text);
    require(found != titles.end(),
            fmt::format("{}:{}:1: no column '{}'", file.name(), 1 + file.blank_lines(), title));
    return static_cast<std::size_t>(found - titles.begin());
  };
  Columns columns;
  columns.count = titles.size();
  columns.number = column(kNumber);
  for (std::size_t i = 0; i < 3; ++i) columns.files[i] = column(kFiles[i]);
  for (const auto& [title, name] : kFacts) columns.facts.emplace_back(name, column(title));
  for (std::size_t i = 0; i < titles.size(); ++i)
    if (const auto period = period_of(titles[i].text)) columns.spectrum.emplace_back(*period, i);
  std::ranges::sort(columns.spectrum);
  return columns;
}

/// The columns of Sa around a period, and the share of the way between them in ln T.
struct Between {
  std::size_t below, above;
  double share;
};

std::vector<Between> places_of(const SourceFile& file, const Columns& columns,
                               const Eigen::VectorXd& periods) {
  const auto& at = columns.spectrum;
  require(at.front().first <= periods[0] && periods[periods.size() - 1] <= at.back().first,
          fmt::format("{}: spectra from {:g} to {:g} s, needed from {:g} to {:g} s", file.name(),
                      at.front().first, at.back().first, periods[0], periods[periods.size() - 1]));
  std::vector<Between> places;
  for (const double period : periods) {
    const auto next = std::ranges::lower_bound(at, period, {}, [](auto& p) { return p.first; });
    if (next->first == period)
      places.push_back({next->second, next->second, 0});
    else
      places.push_back(
          {(next - 1)->second, next->second,
           std::log(period / (next - 1)->first) / std::log(next->first / (next - 1)->first)});
  }
  return places;
}

SuiteRecord record_of(const std::vector<CsvCell>& row, const Columns& columns,
                      const std::filesystem::path& folder) {
  const std::string name = "RSN" + row[columns.number].text;
  SuiteRecord record{.name = name, .files = {}, .facts = {}};
  for (const std::size_t column : columns.files) {
    std::string file = row[column].text;
    if (file.empty() || file.front() == '-') continue;  // -999 and dashes: missing
    std::ranges::replace(file, '\\', '_');
    std::ranges::replace(file, '/', '_');
    record.files.push_back({.path = folder / (name + "_" + file)});
  }
  for (const auto& [fact, column] : columns.facts)
    if (!row[column].text.empty()) record.facts.emplace_back(fact, row[column].text);
  return record;
}

}  // namespace

bool recognises_flatfile(const SourceFile& file) {
  if (!file.is_text()) return false;
  const std::vector<CsvCell> titles = csv_row(file.lines()[0]);
  return std::ranges::find(titles, kNumber, &CsvCell::text) != titles.end() &&
         std::ranges::any_of(titles,
                             [](const CsvCell& cell) { return period_of(cell.text).has_value(); });
}

Flatfile read_flatfile(const SourceFile& file, const Eigen::VectorXd& periods) {
  const Columns columns = columns_of(file);
  const std::vector<Between> places = places_of(file, columns, periods);
  const auto folder = std::filesystem::path(file.name()).parent_path();
  FileErrors errors(file);
  Flatfile flatfile;
  std::vector<Eigen::VectorXd> spectra;
  std::size_t without = 0;
  for (std::size_t line = 1; line < file.lines().size(); ++line) {
    if (trimmed(file.lines()[line]).empty()) continue;
    const std::vector<CsvCell> row = csv_row(file.lines()[line]);
    if (row.size() != columns.count) {
      errors.add(line + 1, 1,
                 fmt::format("{} cells, the header has {} columns", row.size(), columns.count));
      continue;
    }
    std::map<std::size_t, double> values;  // by column, of which several periods need the same
    const auto value = [&](std::size_t column) {
      const auto [at, is_new] = values.try_emplace(column, 0);
      if (!is_new) return at->second;
      const auto sa = number(row[column].text);
      if (!sa)
        errors.add(line + 1, row[column].column,
                   fmt::format("Sa '{}': must be a number [g]", row[column].text));
      return at->second = sa.value_or(0);
    };
    Eigen::VectorXd spectrum(periods.size());
    for (Eigen::Index k = 0; k < periods.size(); ++k) {
      const Between& place = places[static_cast<std::size_t>(k)];
      const double below = value(place.below), above = value(place.above);
      spectrum[k] = std::lerp(std::log(below), std::log(above), place.share);
    }
    if (!spectrum.allFinite()) {  // -999 where there is none
      ++without;
      continue;
    }
    spectra.push_back(spectrum.array() + std::log(kStandardGravity));
    flatfile.suite.records.push_back(record_of(row, columns, folder));
  }
  if (!errors.any() && spectra.empty()) errors.add("no record has a spectrum at the periods");
  errors.throw_if_any();
  if (without > 0)
    flatfile.suite.notes.push_back(fmt::format(
        "{}: {} records without a spectrum at the periods are excluded", file.name(), without));
  flatfile.ln_spectra.resize(std::ssize(spectra), periods.size());
  for (std::size_t i = 0; i < spectra.size(); ++i)
    flatfile.ln_spectra.row(static_cast<Eigen::Index>(i)) = spectra[i];
  return flatfile;
}

}  // namespace gurney::groundmotions
