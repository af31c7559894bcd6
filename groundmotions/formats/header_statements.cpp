#include "groundmotions/formats/header_statements.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <chrono>
#include <cmath>
#include <vector>

#include "engine/base/units.h"
#include "groundmotions/formats/numbers.h"

namespace gurney {

namespace {

constexpr double kTooFar = 1.5;  ///< factor between what is stated and what is there
constexpr auto kNone = std::string_view::npos;

bool beyond(double a, double b) { return !(a <= kTooFar * b && b <= kTooFar * a); }

std::vector<std::string_view> words_of(std::string_view text, std::string_view separators) {
  std::vector<std::string_view> words;
  for (auto begin = text.find_first_not_of(separators); begin != kNone;) {
    const auto end = std::min(text.find_first_of(separators, begin), text.size());
    words.push_back(text.substr(begin, end - begin));
    begin = text.find_first_not_of(separators, end);
  }
  return words;
}

/// Azimuth in degrees of a bearing such as N08W or S45E.
std::optional<double> bearing(std::string_view word) {
  if (word.size() < 3 || word.size() > 6) return {};
  const char from = word.front(), towards = word.back();
  if ((from != 'N' && from != 'S') || (towards != 'E' && towards != 'W')) return {};
  const auto angle = number(word.substr(1, word.size() - 2));
  if (!angle || !(*angle >= 0 && *angle <= 90)) return {};
  const double start = from == 'N' ? 0 : 180;
  const double azimuth = (from == 'N') == (towards == 'E') ? start + *angle : start - *angle;
  return std::fmod(azimuth + 360, 360);
}

std::optional<double> azimuth_in(std::string_view label) {
  const auto words = words_of(label, " \t,;:()");
  for (std::size_t i = 0; i < words.size(); ++i) {
    const auto degrees = number(words[i]);
    const bool named =
        words.size() == 1 || (i + 1 < words.size() && words[i + 1].starts_with("DEG"));
    if (degrees && named && *degrees >= 0 && *degrees <= 360) return std::fmod(*degrees, 360);
    if (const auto result = bearing(words[i])) return result;
  }
  constexpr std::string_view kPoints = "NESW";
  const auto point = label.size() == 1 ? kPoints.find(label[0]) : kNone;
  return point == kNone ? std::nullopt : std::optional(90.0 * static_cast<double>(point));
}

}  // namespace

std::string upper(std::string_view text) {
  std::string result(text);
  for (char& c : result) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  return result;
}

std::optional<double> number_after(std::string_view line, std::string_view key) {
  const auto at = line.find(key);
  if (at == kNone) return {};
  auto rest = line.substr(at + key.size());
  rest.remove_prefix(std::min(rest.find_first_not_of(" \t=:"), rest.size()));
  return take_number(rest);
}

std::optional<AccelerationUnit> unit_in(std::string_view line) {
  const std::string text = upper(line);
  for (std::string_view word : words_of(text, " \t(),:;=")) {
    while (word.ends_with('.')) word.remove_suffix(1);
    if (word == "G/10") return AccelerationUnit{"g/10", kStandardGravity / 10};
    std::string spelling(word);
    for (auto at = spelling.find("SEC"); at != std::string::npos; at = spelling.find("SEC"))
      spelling.replace(at, 3, "S");
    if (spelling.starts_with("CMS/")) spelling.erase(2, 1);  // centimetres
    if (const auto unit = acceleration_unit(spelling)) return unit;
  }
  return {};
}

AccelerationUnit agreed_unit(const std::optional<AccelerationUnit>& stated, std::size_t line,
                             const ReadOptions& options, Mistakes& mistakes) {
  const auto given = acceleration_unit(options.unit);
  if (!stated && !given)
    mistakes.add(line, 1, "the header states no unit of acceleration; state it as unit = \"...\"");
  else if (stated && given && stated->to_si != given->to_si)
    mistakes.add(line, 1,
                 fmt::format("the file states the unit {}, but unit = \"{}\" was given",
                             stated->name, options.unit));
  return stated ? *stated : given.value_or(AccelerationUnit{"", 1});
}

double agreed_time_step(const std::optional<double>& stated, std::size_t line,
                        const ReadOptions& options, Mistakes& mistakes) {
  const double step = stated ? *stated : options.time_step.value_or(0);
  if (!stated && !options.time_step)
    mistakes.add(line, 1, "the header states no time step; state it as time_step_s");
  else if (!(step > 0 && step <= 1))
    mistakes.add(line, 1, fmt::format("the time step must be in (0, 1] s, got {}", step));
  else if (options.time_step && !(std::abs(*options.time_step - step) <= 1e-6 * step))
    mistakes.add(line, 1,
                 fmt::format("the file states a time step of {} s, but time_step_s = {} was given",
                             step, *options.time_step));
  return step;
}

void check_peak(const StatedPeak& peak, const Eigen::VectorXd& a, Component& component,
                Mistakes& mistakes) {
  const double raw = a.cwiseAbs().maxCoeff();
  const double centred = (a.array() - a.mean()).abs().maxCoeff();
  const double found = std::abs(raw - peak.size) <= std::abs(centred - peak.size) ? raw : centred;
  if (std::abs(found - peak.size) <= peak.rounding) return;
  const std::string text = fmt::format(
      "the header states a peak of {:.5g} m/s2, but the samples "
      "have {:.5g} m/s2",
      peak.size, found);
  if (beyond(found, peak.size))
    mistakes.add(peak.line, 1, text);
  else
    component.warnings.push_back(text);
}

void check_length(double length, std::size_t line, Component& component, Mistakes& mistakes) {
  const double found = static_cast<double>(component.acceleration.size()) * component.time_step;
  if (!(length > 0) || std::abs(found - length) <= 2.5 * component.time_step + 0.01) return;
  const std::string text =
      fmt::format("the header states a length of {:.6g} s, but {} samples at {} s have {:.6g} s",
                  length, component.acceleration.size(), component.time_step, found);
  if (beyond(found, length))
    mistakes.add(line, 1, text);
  else
    component.warnings.push_back(text);
}

bool orient_by_label(std::string_view text, Component& component) {
  const std::string label = upper(trimmed(text));
  if (const auto azimuth = azimuth_in(label)) {
    component.azimuth = *azimuth * kRadiansPerDegree;
    return true;
  }
  for (const std::string_view word : words_of(label, " \t,;:()=-")) {
    const bool alone = word == label;
    if (word == "UP" || word == "VERT" || word == "VERTICAL" || (alone && word == "V")) {
      component.direction = Direction::kVertical;
      return true;
    }
    if (word == "DOWN" || (alone && word == "DN")) {
      turn_up(word, component);
      return true;
    }
  }
  return false;
}

void turn_up(std::string_view why, Component& component) {
  component.direction = Direction::kVertical;
  component.acceleration = -component.acceleration;
  component.warnings.push_back(
      fmt::format("the component points down ({}): its sign was turned, up is positive", why));
}

std::optional<double> utc_seconds(int year, int month, int day, double hour, double minute,
                                  double second) {
  const std::chrono::year_month_day date(std::chrono::year(year),
                                         std::chrono::month(static_cast<unsigned>(month)),
                                         std::chrono::day(static_cast<unsigned>(day)));
  const bool is_time = hour >= 0 && hour < 24 && minute >= 0 && minute < 60 && second >= 0 &&
                       second <= 60;  // 60: a leap second
  if (!date.ok() || year < 1900 || !is_time) return {};
  const auto days = std::chrono::sys_days(date).time_since_epoch().count();
  return 86400.0 * static_cast<double>(days) + 3600 * hour + 60 * minute + second;
}

}  // namespace gurney
