#include "studies/report/record_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <vector>

#include "engine/base/append_all.h"
#include "engine/base/hash/sha256.h"
#include "engine/base/units.h"
#include "groundmotions/assembly/plausibility.h"
#include "groundmotions/measures/combination.h"
#include "groundmotions/measures/peaks.h"
#include "groundmotions/measures/summary.h"
#include "groundmotions/record/record_motion.h"

namespace gurney::report {
namespace {

using findings::Section;
using findings::Table;
using groundmotions::Direction;

bool has_horizontals(const groundmotions::Record& record) {
  return record[Direction::kH1] && record[Direction::kH2];
}

/// Name and value of each fact of a header.
Section named(std::string key, const std::vector<RecordFact>& facts) {
  Section all{std::move(key)};
  for (const auto& [name, value] : facts) all.json(name, value);
  return all;
}

Section component(Direction direction, const groundmotions::Component& of) {
  const groundmotions::EndMotion end = groundmotions::end_motion(of.time_step, of.acceleration);
  Section all{name_of(direction)};
  all.json("name", of.name).json("file", of.file).json("format", of.format);
  all.json("unit", of.unit).json("sha256", of.sha256);
  all.json("azimuth_deg", of.azimuth, {.json_unit = kRadiansPerDegree});
  all.add(named("header", of.header)).json("residual_velocity_m_per_s", end.velocity);
  return all.json("residual_displacement_m", end.displacement);
}

/// One line for each component, and its hash.
void add_files(Section& to, const groundmotions::Record& record) {
  Section components{"components"};
  for (const Direction direction : groundmotions::kDirections) {
    if (!record[direction]) continue;
    const groundmotions::Component& c = *record[direction];
    components.add(component(direction, c));
    const std::string azimuth =
        c.azimuth ? fmt::format(", azimuth {:.0f}", *c.azimuth / kRadiansPerDegree) : "";
    to.text(name_of(direction),
            fmt::format("{}, '{}'{}, {}, {}", std::filesystem::path(c.file).filename().string(),
                        c.name, azimuth, c.format, c.unit));
    to.text(std::string("SHA-256 of ") + name_of(direction), c.sha256);
  }
  to.add(std::move(components));
}

/// Facts of the headers; those that all components share are stated once.
Section headers(const groundmotions::Record& record) {
  Section all{"", "header"};
  std::vector<RecordFact> stated;
  for (const auto& component : record.components) {
    if (!component) continue;
    for (const RecordFact& fact : component->header) {
      if (std::ranges::find(stated, fact) != stated.end()) continue;
      stated.push_back(fact);
      all.text(fact.first, fact.second);
    }
  }
  return all;
}

/// A column for each component and combination; how it moves at the end, from rest.
void add_measures(Section& to, const groundmotions::Record& record,
                  const groundmotions::Summary& measures) {
  Table table{"measures{}", "", {{"", "measure"}, {"unit", ""}}},
      ends{"", "", {{"", "at the end"}}};
  std::vector<std::string> names;
  for (const Direction direction : groundmotions::kDirections)
    if (record[direction]) names.emplace_back(name_of(direction));
  for (const std::string& name : names) ends.columns.push_back({"", name, {".2g"}});
  if (has_horizontals(record)) names.insert(names.end(), {"RotD50", "RotD100"});
  const std::size_t shown = names.size();
  for (const groundmotions::SummaryRow& row : measures.rows)
    for (const auto& [name, value] : row.values)
      if (std::ranges::find(names, name) == names.end()) names.push_back(name);
  for (std::size_t i = 0; i < names.size(); ++i)
    table.columns.push_back({"values." + names[i], i < shown ? names[i] : ""});
  table.columns.insert(table.columns.end(), {{"", "unit"}, {"definition", "definition"}});
  for (const groundmotions::SummaryRow& row : measures.rows) {
    const groundmotions::DisplayUnit unit = groundmotions::display_unit_of(row.measure);
    table.add({row.name, row.unit});
    for (const std::string& name : names) {
      const auto value =
          std::ranges::find(row.values, name, &std::pair<std::string, double>::first);
      table.rows.back().emplace_back(
          value == row.values.end() ? findings::Value() : findings::Value(value->second),
          findings::Format{".4g", "", unit.in_si});
    }
    table.rows.back().insert(table.rows.back().end(), {unit.name, row.definition});
  }
  ends.columns.push_back({"", "unit"});
  ends.add({"residual velocity, from rest"});
  ends.add({"residual displacement, from rest"});
  for (const auto& component : record.components)
    if (component) {
      const auto end = groundmotions::end_motion(component->time_step, component->acceleration);
      ends.rows[0].emplace_back(end.velocity);
      ends.rows[1].emplace_back(end.displacement);
    }
  ends.rows[0].emplace_back("m/s");
  ends.rows[1].emplace_back("m");
  to.add(std::move(table)).add(std::move(ends));
}

constexpr std::size_t kHashDigits = 8;

/// Texts of the components, each once, in their order.
template <class Text>
std::vector<std::string> distinct(const groundmotions::Record& record, Text text) {
  std::vector<std::string> all;
  for (const auto& component : record.components)
    if (component && std::ranges::find(all, text(*component)) == all.end())
      all.push_back(text(*component));
  return all;
}

std::string cell(double value) { return fmt::format("{:.3g}", value); }

/// Measure of both horizontals by `combination`, or of the only component that there is.
double of_horizontals(const groundmotions::Measure& measure, groundmotions::Combination combination,
                      const groundmotions::Record& record) {
  if (record[groundmotions::Direction::kH1] && record[groundmotions::Direction::kH2])
    return value_of(measure, combination, record);
  const auto first = std::ranges::find_if(record.components, [](auto& c) { return c.has_value(); });
  return value_of(measure, (*first)->time_step, (*first)->acceleration);
}

double largest_end_velocity(const groundmotions::Record& record) {
  double largest = 0;
  for (const auto& c : record.components)
    if (c)
      largest = std::max(
          largest, std::abs(groundmotions::end_motion(c->time_step, c->acceleration).velocity));
  return largest;
}

struct Column {
  const char *above, *title;
  int width;
  int rank;  ///< the highest is left out first
  bool is_left = false;
};

constexpr std::size_t kNameWidth = 26;
constexpr std::array kColumns = {Column{"", "record", kNameWidth, 0, true},
                                 Column{"", "format", 12, 5, true},
                                 Column{"", "unit", 6, 4, true},
                                 Column{"", "dt [s]", 6, 1},
                                 Column{"", "T [s]", 7, 0},
                                 Column{"", "h1", 7, 0},
                                 Column{"PGA [g]", "h2", 7, 0},
                                 Column{"", "vertical", 8, 0},
                                 Column{"RotD50", "Sa(1) g", 8, 0},
                                 Column{"geom.", "PGV m/s", 7, 0},
                                 Column{"mean of", "D5-95", 7, 2},
                                 Column{"h1, h2", "Ia m/s", 7, 7},
                                 Column{"", "CAV m/s", 7, 8},
                                 Column{"", "v at end", 8, 6},
                                 Column{"", " SHA-256", 9, 3, true},
                                 Column{"", " warnings", 9, 0, true}};
using Cells = std::array<std::string, kColumns.size()>;

/// Columns of a higher rank are left out.
int highest_rank(std::size_t width) {
  for (int rank = 8; rank > 0; --rank) {
    std::size_t used = 0;
    for (const Column& column : kColumns)
      if (column.rank <= rank) used += static_cast<std::size_t>(column.width) + 1;
    if (used - 1 <= width) return rank;
  }
  return 0;
}

std::string line_of(const Cells& cells, std::size_t width) {
  const int rank = highest_rank(width);
  std::string line;
  for (std::size_t i = 0; i < kColumns.size(); ++i) {
    const Column& column = kColumns[i];
    if (column.rank > rank) continue;
    if (!line.empty()) line += " ";
    line += column.is_left ? fmt::format("{:<{}}", cells[i], column.width)
                           : fmt::format("{:>{}}", cells[i], column.width);
  }
  return line + "\n";
}

/// A long text without its middle: what distinguishes names is often their end.
std::string without_middle(const std::string& text) {
  std::vector<std::size_t> starts;  // of characters in UTF-8
  for (std::size_t i = 0; i < text.size(); ++i)
    if ((static_cast<unsigned char>(text[i]) & 0xC0) != 0x80) starts.push_back(i);
  if (starts.size() <= kNameWidth) return text;
  constexpr std::size_t kFront = 12, kBack = kNameWidth - 2 - kFront;
  return text.substr(0, starts[kFront]) + ".." + text.substr(starts[starts.size() - kBack]);
}

}  // namespace

std::vector<std::string> record_findings(const groundmotions::Record& record) {
  std::vector<std::string> findings = record.warnings;
  const bool h1 = record[groundmotions::Direction::kH1].has_value(),
             h2 = record[groundmotions::Direction::kH2].has_value();
  if (!h1 && !h2)
    findings.push_back("h1 and h2 are missing: the record has no horizontal");
  else if (!h1 || !h2)
    findings.push_back(
        fmt::format("{} is missing: the record has one horizontal", h1 ? "h2" : "h1"));
  for (std::string& finding : implausible(record)) findings.push_back(std::move(finding));
  for (std::string& finding : groundmotions::residual(groundmotions::floor_motion(record)).warnings)
    findings.push_back(std::move(finding));
  return findings;
}

findings::Section record_report(const groundmotions::Record& record,
                                const std::vector<RecordFact>& facts,
                                const std::vector<groundmotions::Measure>& wanted) {
  Section all{"", record.name};
  all.json("name", record.name);
  add_files(all, record);
  all.json("time_step_s", record.time_step());
  all.fact("samples", "samples", record.samples(), {},
           fmt::format("{:g} s apart, {:.2f} s", record.time_step(),
                       static_cast<double>(record.samples() - 1) * record.time_step()));
  all.add(headers(record)).add(named("facts", facts));
  Section suite{"", "from the suite"};
  for (const auto& [name, value] : facts) suite.text(name, value);
  all.add(std::move(suite)).list("processing", "processing", record.processing);
  const groundmotions::Summary measures = summary(record, wanted);
  add_measures(all, record, measures);
  std::vector<std::string> warnings = record_findings(record);
  append_all(warnings, measures.warnings);
  return all.list("warnings", "warnings", std::move(warnings));
}

std::string short_hash(const groundmotions::Record& record) {
  auto hashes = distinct(record, [](const groundmotions::Component& c) { return c.sha256; });
  std::erase(hashes, "");
  if (hashes.empty()) return "-";
  const std::string all = fmt::format("{}", fmt::join(hashes, ""));
  return (hashes.size() == 1 ? all : sha256(all)).substr(0, kHashDigits);
}

std::string record_table_head(std::size_t width) {
  Cells above, titles;
  for (std::size_t i = 0; i < kColumns.size(); ++i) {
    above[i] = kColumns[i].above;
    titles[i] = kColumns[i].title;
  }
  return line_of(above, width) + line_of(titles, width);
}

std::string record_table_line(const groundmotions::Record& record, std::size_t width) {
  const auto mean = [&](groundmotions::MeasureKind kind) {
    return cell(of_horizontals({kind}, groundmotions::Combination::kGeometricMean, record));
  };
  const auto pga = [&](groundmotions::Direction direction) {
    const auto& c = record[direction];
    return c ? cell(groundmotions::value_of({groundmotions::MeasureKind::kPga}, c->time_step,
                                            c->acceleration) /
                    kStandardGravity)
             : std::string("-");
  };
  const auto duration = static_cast<double>(record.samples() - 1) * record.time_step();
  const double sa = of_horizontals({groundmotions::MeasureKind::kSa, 1},
                                   groundmotions::Combination::kRotD50, record);
  const auto findings = record_findings(record).size();
  const auto joined = [](const std::vector<std::string>& texts) {
    return fmt::format("{}", fmt::join(texts, "+"));
  };
  return line_of({without_middle(record.name),
                  joined(distinct(record, [](auto& c) { return c.format; })).substr(0, 12),
                  joined(distinct(record, [](auto& c) { return c.unit; })),
                  fmt::format("{:.4g}", record.time_step()), fmt::format("{:.2f}", duration),
                  pga(groundmotions::Direction::kH1), pga(groundmotions::Direction::kH2),
                  pga(groundmotions::Direction::kVertical), cell(sa / kStandardGravity),
                  mean(groundmotions::MeasureKind::kPgv), mean(groundmotions::MeasureKind::kD595),
                  mean(groundmotions::MeasureKind::kArias), mean(groundmotions::MeasureKind::kCav),
                  fmt::format("{:.1g}", largest_end_velocity(record)), " " + short_hash(record),
                  findings ? " " + std::to_string(findings) : ""},
                 width);
}

}  // namespace gurney::report
