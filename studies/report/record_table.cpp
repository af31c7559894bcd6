#include "studies/report/record_table.h"

#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <vector>

#include "engine/base/hash/sha256.h"
#include "engine/base/units.h"
#include "groundmotions/measures/combination.h"
#include "groundmotions/measures/integrate.h"
#include "studies/report/record_report.h"

namespace gurney::report {
namespace {

constexpr std::size_t kHashDigits = 8;

/// What the components have, each once, in their order.
template <class Text>
std::vector<std::string> distinct(const groundmotions::Record& record, Text text) {
  std::vector<std::string> all;
  for (const auto& component : record.components)
    if (component && std::ranges::find(all, text(*component)) == all.end())
      all.push_back(text(*component));
  return all;
}

std::string cell(double value) { return fmt::format("{:.3g}", value); }

/// Of both horizontals by `combination`, or of the only component that there is.
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

std::string short_hash(const groundmotions::Record& record) {
  auto hashes = distinct(record, [](const groundmotions::Component& c) { return c.sha256; });
  std::erase(hashes, "");
  if (hashes.empty()) return "-";
  const std::string all = fmt::format("{}", fmt::join(hashes, ""));
  return (hashes.size() == 1 ? all : sha256(all)).substr(0, kHashDigits);
}

std::size_t table_width() {
  winsize window{};
  std::size_t found = 0;
  if (const char* stated = std::getenv("COLUMNS"))
    found = std::strtoul(stated, nullptr, 10);
  else if (ioctl(STDOUT_FILENO, TIOCGWINSZ, &window) == 0)
    found = window.ws_col;
  return found == 0 ? std::string::npos : found;
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
