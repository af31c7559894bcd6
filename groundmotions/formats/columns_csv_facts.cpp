#include "groundmotions/formats/columns_csv_facts.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <optional>

#include "engine/base/units.h"
#include "groundmotions/formats/calendar.h"
#include "groundmotions/formats/numbers.h"

namespace gurney::groundmotions {

namespace {

constexpr std::string_view kAzimuth = "azimuth ", kDegrees = " deg", kStart = "start ";

/// 1994-01-17T12:30:55.000Z
std::string utc_text(double seconds) {
  using namespace std::chrono;
  const sys_time<milliseconds> time(milliseconds(std::llround(seconds * 1000)));
  const auto day = floor<days>(time);
  const year_month_day date(day);
  const hh_mm_ss clock(time - day);
  return fmt::format("{:04}-{:02}-{:02}T{:02}:{:02}:{:02}.{:03}Z", static_cast<int>(date.year()),
                     static_cast<unsigned>(date.month()), static_cast<unsigned>(date.day()),
                     clock.hours().count(), clock.minutes().count(), clock.seconds().count(),
                     clock.subseconds().count());
}

std::optional<double> azimuth_of(std::string_view text) {
  if (!text.ends_with(kDegrees)) return {};
  const auto degrees = number(trimmed(text.substr(0, text.size() - kDegrees.size())));
  if (!degrees || !(*degrees >= 0 && *degrees <= 360)) return {};
  return *degrees * kRadiansPerDegree;
}

std::string place_of(const Component& component) {
  return component.direction ? name_of(*component.direction) : "a";
}

/// One line; @returns what is wrong with it.
std::string read_fact(std::string_view fact, Component& component) {
  const bool is_start = fact.starts_with(kStart);
  auto& known = is_start ? component.start_time : component.azimuth;
  const std::string_view text = trimmed(fact.substr((is_start ? kStart : kAzimuth).size()));
  if (!is_start && component.direction == Direction::kVertical) return "a vertical has no azimuth";
  if (known) return fmt::format("'{}' is stated twice for {}", fact, place_of(component));
  known = is_start ? utc_seconds(text) : azimuth_of(text);
  if (known) return {};
  return is_start ? fmt::format("'{}': must be such as 1994-01-17T12:30:55.000Z", text)
                  : fmt::format("'{}': must be such as 318 deg, from 0 to 360", text);
}

}  // namespace

std::string columns_csv_facts(const Record& record) {
  std::string text;
  for (const Direction direction : kDirections) {
    const auto& component = record[direction];
    if (component && component->azimuth && direction != Direction::kVertical)
      text += fmt::format("# {}: {}{:.10g}{}\n", name_of(direction), kAzimuth,
                          *component->azimuth / kRadiansPerDegree, kDegrees);
    if (component && component->start_time)
      text +=
          fmt::format("# {}: {}{}\n", name_of(direction), kStart, utc_text(*component->start_time));
  }
  return text;
}

void read_columns_csv_facts(const SourceFile& file, std::size_t head,
                            std::vector<Component>& components, FileErrors& errors) {
  static constexpr std::array<std::string_view, 4> kPlaces = {"h1", "h2", "vertical", "a"};
  for (std::size_t i = 0; i < head; ++i) {
    std::string_view line = trimmed(file.lines()[i]);
    if (line.empty()) continue;
    line = trimmed(line.substr(1));
    const auto colon = std::min(line.find(':'), line.size());
    const std::string_view place = line.substr(0, colon);
    const std::string_view fact = trimmed(line.substr(std::min(colon + 1, line.size())));
    if (std::ranges::find(kPlaces, place) == kPlaces.end()) continue;
    if (!fact.starts_with(kAzimuth) && !fact.starts_with(kStart)) continue;
    const auto at = std::ranges::find(components, place, place_of);
    const std::string wrong = at == components.end()
                                  ? fmt::format("the file has no column of {}", place)
                                  : read_fact(fact, *at);
    if (!wrong.empty()) errors.add(i + 1, 1, wrong);
  }
}

}  // namespace gurney::groundmotions
