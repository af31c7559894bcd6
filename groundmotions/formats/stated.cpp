#include "groundmotions/formats/stated.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "groundmotions/formats/numbers.h"
#include "groundmotions/formats/words.h"

namespace gurney::groundmotions {

namespace {

constexpr double kPeakTolerance = 0.001;
constexpr double kTooFar = 1.5;  ///< factor between what is stated and what is there

/// Half of the last digit of a decimal number: 0.0005 of "4.078", 0.005 of "1.2E-01".
double half_digit(std::string_view text) {
  text = trimmed(text);
  const auto letter = std::min(text.find_first_of("eEdD"), text.size());
  const auto mantissa = text.substr(0, letter);
  const auto point = mantissa.find('.');
  const auto places = point == std::string_view::npos ? 0 : mantissa.size() - point - 1;
  const double exponent = letter < text.size() ? number(text.substr(letter + 1)).value_or(0) : 0;
  return 0.5 * std::pow(10, exponent - static_cast<double>(places));
}

/// An error if what is held is not within a factor of 1.5 of what is stated, else a warning.
void report_difference(double stated, double held, const std::string& message, std::size_t line,
                       Component& component, FileErrors& errors) {
  if (!(held <= kTooFar * stated && stated <= kTooFar * held))
    errors.add(line, 1, message);
  else
    component.warnings.push_back(message);
}

}  // namespace

HeaderLine find_line(TextLines lines, std::string_view key) {
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const auto text = trimmed(lines[i]);
    if (!text.starts_with(key)) continue;
    const auto rest = text.substr(key.size());
    if (key.ends_with(':')) return {trimmed(rest), i + 1};
    const auto colon = rest.find(':');
    return {colon == kNone ? std::string_view() : trimmed(rest.substr(colon + 1)), i + 1};
  }
  return {};
}

Component component_of(const Eigen::Ref<const Eigen::VectorXd>& samples,
                       const AccelerationUnit& unit, double time_step) {
  Component component;
  component.unit = unit.name;
  component.time_step = time_step;
  component.acceleration = unit.to_si * samples;
  return component;
}

Component component_of(const std::vector<double>& samples, const AccelerationUnit& unit,
                       double time_step) {
  return component_of(scaled(samples, 1), unit, time_step);
}

LayoutReader::LayoutReader(const SourceFile& source, const ReadOptions& given)
    : file(source), options(given), errors(source), fields(source, errors) {
  if (source.is_text()) header = source.lines();
}

void LayoutReader::error(std::size_t line, const std::string& message) {
  line > 0 ? errors.add(line, 1, message) : errors.add(message);
}

void LayoutReader::refuse(std::size_t line, const std::string& message) {
  error(line, message);
  errors.throw_if_any();
  std::abort();  // not reached
}

std::vector<Component> LayoutReader::checked(std::vector<Component> components) const {
  errors.throw_if_any();
  return components;
}

HeaderLine LayoutReader::needed(std::string_view key) {
  const HeaderLine found = find(key);
  if (found.line == 0) errors.add(fmt::format("the header lacks '{}'", key));
  return found;
}

double LayoutReader::number_of(const HeaderLine& stated, std::string_view key,
                               std::string_view unit) {
  std::string_view rest = stated.text;
  const auto value = take_number(rest);
  rest = trimmed(rest);
  if (value && (rest.empty() || lower(rest) == lower(unit))) return *value;
  error(stated.line, stated.line > 0
                         ? fmt::format("{} must be a number, got '{}'", key, stated.text)
                         : fmt::format("the header has no line '{}'", key));
  return 0;
}

void LayoutReader::state_facts(std::initializer_list<std::pair<const char*, const char*>> facts,
                               Component& component) const {
  for (const auto& [name, key] : facts)
    if (const auto text = find(key).text; !text.empty()) component.header.emplace_back(name, text);
}

AccelerationUnit LayoutReader::agreed_unit(const std::optional<AccelerationUnit>& stated,
                                           std::size_t line) {
  const auto given = acceleration_unit(options.unit);
  if (!stated && !given)
    error(line,
          fmt::format("the file does not state its unit; state it as unit = \"...\" or gurney "
                      "records --unit ({})",
                      kAccelerationUnits));
  else if (stated && given && stated->to_si != given->to_si)
    error(line, fmt::format("the file states the unit {}, but unit = \"{}\" was given",
                            stated->name, options.unit));
  return stated ? *stated : given.value_or(AccelerationUnit{"", 1});
}

AccelerationUnit LayoutReader::checked_unit(std::string_view stated, std::size_t line) {
  if (const auto unit = acceleration_unit(trimmed(stated))) return agreed_unit(unit, line);
  error(line, fmt::format("'{}' is not a unit of acceleration: {} are allowed", trimmed(stated),
                          kAccelerationUnits));
  return {"", 1};
}

double LayoutReader::agreed_time_step(const std::optional<double>& stated, std::size_t line) {
  if (stated) return checked_time_step({*stated, "the time step", line});
  if (!options.time_step)
    error(line,
          "the file does not state its time step; state it as time_step_s or gurney records "
          "--time-step");
  return options.time_step.value_or(0);
}

double LayoutReader::checked_time_step(const StatedNumber& stated) {
  const auto& [value, key, line] = stated;
  if (!is_time_step(value))
    error(line, fmt::format("{} must be in [{:g}, {:g}] s, got {}", key, kShortestTimeStep,
                            kLongestTimeStep, value));
  else if (options.time_step && !(std::abs(*options.time_step - value) <= 1e-6 * value))
    error(line, fmt::format("the file states a time step of {} s, but time_step_s = {} was given",
                            value, *options.time_step));
  return value;
}

void LayoutReader::check_count(const StatedNumber& stated, std::size_t held) {
  const auto& [value, key, line] = stated;
  if (!(value >= 2 && value == std::floor(value)))
    error(line, fmt::format("{} must be a whole number above 1, got {}", key, value));
  else if (value != static_cast<double>(held))
    error(line, fmt::format("{} states {} samples, but the file holds {}", key, value, held));
}

void LayoutReader::check_enough(double samples, std::size_t line) {
  if (!(samples >= 2))
    error(line, fmt::format("a record needs at least 2 samples, got {}", samples));
}

void LayoutReader::check_length(double length, std::size_t line, Component& component) {
  const double held = static_cast<double>(component.acceleration.size()) * component.time_step;
  if (!(length > 0) || std::abs(held - length) <= 2.5 * component.time_step + 0.01) return;
  report_difference(length, held,
                    fmt::format("the file states a length of {:.6g} s, but its {} samples at {} s "
                                "have {:.6g} s",
                                length, component.acceleration.size(), component.time_step, held),
                    line, component, errors);
}

void LayoutReader::check_peak(const HeaderLine& stated, const AccelerationUnit& unit,
                              Component& component) {
  const auto& [text, line] = stated;
  const auto value = number(text);
  if (!value) {
    error(line, fmt::format("the peak must be a number, got '{}'", trimmed(text)));
    return;
  }
  const double stated_peak = std::abs(*value) * unit.to_si;
  const double held = component.acceleration.cwiseAbs().maxCoeff();
  if (std::abs(stated_peak - held) <= half_digit(text) * unit.to_si + kPeakTolerance * held) return;
  report_difference(stated_peak, held,
                    fmt::format("the file states a peak of {} {}, but its samples have {:.6g} {}",
                                trimmed(text), unit.name, held / unit.to_si, unit.name),
                    line, component, errors);
}

void LayoutReader::check_peak(const StatedPeak& peak, const Eigen::VectorXd& a,
                              Component& component) {
  const double raw = a.cwiseAbs().maxCoeff();
  const double centred = (a.array() - a.mean()).abs().maxCoeff();
  const double held = std::abs(raw - peak.size) <= std::abs(centred - peak.size) ? raw : centred;
  if (std::abs(held - peak.size) <= peak.rounding) return;
  report_difference(
      peak.size, held,
      fmt::format("the file states a peak of {:.5g} m/s2, but its samples have {:.5g} "
                  "m/s2",
                  peak.size, held),
      peak.line, component, errors);
}

Component LayoutReader::read_to_end(std::size_t first, const AccelerationUnit& unit,
                                    double time_step, const StatedNumber& count) {
  NumberReader reader(file, errors);
  groundmotions::read_to_end(file, first, reader);
  if (!errors.any()) check_count(count, reader.values().size());
  errors.throw_if_any();
  return component_of(reader.values(), unit, time_step);
}

}  // namespace gurney::groundmotions
