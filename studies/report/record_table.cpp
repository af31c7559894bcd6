#include "studies/report/record_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
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

constexpr const char* kColumns =
    "{:<26.26} {:<12.12} {:<6} {:>6} {:>7} {:>7} {:>7} {:>8} {:>8} {:>7} {:>6} {:>7} {:>7} {:>8}  "
    "{:<8}  {}\n";

}  // namespace

std::string short_hash(const groundmotions::Record& record) {
  auto hashes = distinct(record, [](const groundmotions::Component& c) { return c.sha256; });
  std::erase(hashes, "");
  if (hashes.empty()) return "-";
  const std::string all = fmt::format("{}", fmt::join(hashes, ""));
  return (hashes.size() == 1 ? all : sha256(all)).substr(0, kHashDigits);
}

std::string record_table_head() {
  return fmt::format(kColumns, "", "", "", "", "", "", "PGA [g]", "", "RotD50", "geom.", "mean of",
                     "h1, h2", "", "", "", "") +
         fmt::format(kColumns, "record", "format", "unit", "dt [s]", "T [s]", "h1", "h2",
                     "vertical", "Sa(1) g", "PGV m/s", "D5-95", "Ia m/s", "CAV m/s", "v at end",
                     "SHA-256", "warnings");
}

std::string record_table_line(const groundmotions::Record& record) {
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
  return fmt::format(
      kColumns, record.name,
      fmt::format("{}", fmt::join(distinct(record, [](auto& c) { return c.format; }), "+")),
      fmt::format("{}", fmt::join(distinct(record, [](auto& c) { return c.unit; }), "+")),
      fmt::format("{:.4g}", record.time_step()), fmt::format("{:.2f}", duration),
      pga(groundmotions::Direction::kH1), pga(groundmotions::Direction::kH2),
      pga(groundmotions::Direction::kVertical), cell(sa / kStandardGravity),
      mean(groundmotions::MeasureKind::kPgv), mean(groundmotions::MeasureKind::kD595),
      mean(groundmotions::MeasureKind::kArias), mean(groundmotions::MeasureKind::kCav),
      fmt::format("{:.1g}", largest_end_velocity(record)), short_hash(record),
      findings ? std::to_string(findings) : "");
}

}  // namespace gurney::report
