#include "groundmotions/formats/spectrum_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string>

#include "groundmotions/formats/column_title.h"
#include "groundmotions/formats/file_errors.h"
#include "groundmotions/formats/words.h"

namespace gurney::groundmotions {

namespace {

/// "T (s) Sa (g)" as a sentence: words for a period or a frequency, then for an ordinate.
bool is_title_of_spectrum(const std::string& line) {
  constexpr std::array<std::string_view, 7> kFirst = {"t",      "tn",   "f",        "hz",
                                                      "period", "freq", "frequency"};
  constexpr std::array<std::string_view, 4> kOrdinates = {"sa", "psa", "rsa", "fas"};
  const auto is_in = [](const auto& names) {
    return [&](std::string_view word) { return std::ranges::find(names, word) != names.end(); };
  };
  const auto words = words_of(line, " \t,;:()[]#%*_-=./");
  return !words.empty() && is_in(kFirst)(words[0]) && std::ranges::any_of(words, is_in(kOrdinates));
}

}  // namespace

void refuse_spectra(const PlainRows& rows, const SourceFile& file) {
  constexpr std::array<const char*, 8> kWords = {"psa",     "rotd",  "spectral", "spectrum",
                                                 "spectra", "arias", "espectro", "spettro"};
  FileErrors errors(file);
  for (const std::string_view line : rows.header) {
    const std::string text = lower(line);
    const auto word = std::ranges::find_if(
        kWords, [&](const char* each) { return text.find(each) != std::string::npos; });
    if (word == kWords.end()) continue;
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
