#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <map>

#include "engine/base/error.h"
#include "studies/analysis/configuration_view.h"
#include "studies/analysis/suite_spectra.h"
#include "studies/figures/record_figures.h"
#include "studies/page/html.h"
#include "studies/page/study_page.h"

namespace gurney::page {
namespace {

struct Span {
  double low = std::numeric_limits<double>::infinity(), high = -low;
  void add(double value) {
    if (std::isnan(value)) return;
    low = std::min(low, value);
    high = std::max(high, value);
  }
};

findings::Cell cell_of(const Span& span, const findings::Format& format) {
  if (span.low > span.high) return findings::Value();
  if (written(span.low, format) == written(span.high, format)) return span.high;
  findings::Format ends = format;
  ends.between = findings::kTo;
  return {findings::Numbers{span.low, span.high}, ends};
}

/// A record as its name and its files: sets of ground motions may share it.
using Key = std::pair<std::string, std::string>;

std::string short_hashes(const std::vector<std::string>& files) {
  std::vector<std::string> names;
  for (const std::string& each : files) {  // "SHA-256 name"
    const std::size_t space = each.find(' ');
    names.push_back(space == std::string::npos
                        ? each
                        : each.substr(space + 1) + " (" +
                              each.substr(0, std::min<std::size_t>(space, 12)) + ")");
  }
  return names.empty() ? "synthetic" : fmt::format("{}", fmt::join(names, ", "));
}

/// The suite at the highest level, of the first configuration that was run.
Html spectra_of(const StudyPage& page) {
  constexpr int kPeriods = 26;
  const figures::PlotPage small{
      .width = kNarrow, .most_marks = 8, .units = page.overview.units, .apart = true};
  std::size_t first = 0;
  while (first + 1 < page.data.configurations().size() && page.data.runs_of(first).empty()) ++first;
  try {
    const auto suites = study::suite_spectra(
        page.data, {.job = page.job, .level = {}, .configurations = {first}, .periods = kPeriods});
    const bool scaled = std::ranges::any_of(suites.front().records,
                                            [](const auto& record) { return record.factor != 1; });
    return side_by_side(html(Drawing{
        "spectra", figures::spectra_figure(small, "", suites, {scaled ? "scaled" : "records"}),
        "Response spectra of the records with their median, 16 and 84 % fractiles.",
        "Pseudo-acceleration over the period, 5 % damping, on logarithmic axes."}));
  } catch (const Error& error) {
    return paragraph(std::string("No spectra: ") + error.what());
  }
}

}  // namespace

Section study_records(const StudyPage& page) {
  const study::StudyReader& file = page.data.file();
  if (page.overview.file.motions.empty())
    return {"records", "Records", paragraph("The floor is at rest.")};
  std::vector<study::RunMeasure> measures = study::known_measures(page.data);
  const auto names = file.strings("records/name"), files = file.strings("records/files");
  const auto scales = file.numbers("runs/scale");
  std::map<Key, std::vector<Span>> spans;  // the factor, then the measures
  for (std::size_t run = 0; run < scales.size(); ++run) {
    const std::size_t row = page.data.row_of(run);
    std::vector<Span>& of = spans[{names[row], files[row]}];
    of.resize(measures.size() + 1);
    of[0].add(scales[run]);
    for (std::size_t i = 0; i < measures.size(); ++i) of[i + 1].add(measures[i].values[run]);
  }
  findings::Table table{
      "",
      "Records, and the range of their factors and intensity measures over the runs",
      {{"", "record"}, {"", "runs\u2019 factor", {".3g"}}}};
  for (const study::RunMeasure& each : measures) {
    const study::ReportUnit unit = study::report_unit(page.data, each);
    table.columns.push_back(
        {"", each.name, {".3g", unit.name == "1" ? "" : unit.name, unit.in_si}});
  }
  table.columns.push_back({"", "files (start of SHA-256)"});
  std::vector<std::string> warnings;
  for (const auto& motion : page.overview.file.motions) {
    const auto of = spans.find({motion.name, fmt::format("{}", fmt::join(motion.files, "\n"))});
    std::vector<findings::Cell> row{motion.name};
    for (std::size_t i = 0; i <= measures.size(); ++i)
      row.push_back(of == spans.end() ? findings::Cell(findings::Value())
                                      : cell_of(of->second[i], table.columns[i + 1].format));
    row.emplace_back(short_hashes(motion.files));
    table.add(std::move(row));
    for (const std::string& each : motion.warnings) warnings.push_back(motion.name + ": " + each);
  }
  constexpr std::size_t kShown = 12;
  const Html of_records = html(table);
  Html content = spectra_of(page) + (table.rows.size() > kShown
                                         ? folded(counted(table.rows.size(), "record") +
                                                      ": files, factors and intensity measures",
                                                  of_records)
                                         : of_records);
  if (!warnings.empty())
    content += folded(counted(warnings.size(), "warning") + " on records", list(warnings));
  return {"records", "Records", content};
}

}  // namespace gurney::page
