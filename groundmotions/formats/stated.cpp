#include "groundmotions/formats/stated.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "groundmotions/formats/numbers.h"

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

/// @param line  0: of the whole file
void report(FileErrors& errors, std::size_t line, const std::string& message) {
  line > 0 ? errors.add(line, 1, message) : errors.add(message);
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

AccelerationUnit agreed_unit(const std::optional<AccelerationUnit>& stated, std::size_t line,
                             const ReadOptions& options, FileErrors& errors) {
  const auto given = acceleration_unit(options.unit);
  if (!stated && !given)
    report(errors, line,
           fmt::format("the file does not state its unit; state it as unit = \"...\" or gurney "
                       "records --unit ({})",
                       kAccelerationUnits));
  else if (stated && given && stated->to_si != given->to_si)
    report(errors, line,
           fmt::format("the file states the unit {}, but unit = \"{}\" was given", stated->name,
                       options.unit));
  return stated ? *stated : given.value_or(AccelerationUnit{"", 1});
}

AccelerationUnit checked_unit(std::string_view stated, std::size_t line, const ReadOptions& options,
                              FileErrors& errors) {
  if (const auto unit = acceleration_unit(trimmed(stated)))
    return agreed_unit(unit, line, options, errors);
  errors.add(line, 1,
             fmt::format("'{}' is not a unit of acceleration: {} are allowed", trimmed(stated),
                         kAccelerationUnits));
  return {"", 1};
}

double agreed_time_step(const std::optional<double>& stated, std::size_t line,
                        const ReadOptions& options, FileErrors& errors) {
  if (stated) return checked_time_step(*stated, "the time step", line, options, errors);
  if (!options.time_step)
    report(errors, line,
           "the file does not state its time step; state it as time_step_s or gurney records "
           "--time-step");
  return options.time_step.value_or(0);
}

double checked_time_step(double stated, std::string_view key, std::size_t line,
                         const ReadOptions& options, FileErrors& errors) {
  if (!is_time_step(stated))
    report(errors, line,
           fmt::format("{} must be in [{:g}, {:g}] s, got {}", key, kShortestTimeStep,
                       kLongestTimeStep, stated));
  else if (options.time_step && !(std::abs(*options.time_step - stated) <= 1e-6 * stated))
    errors.add(line, 1,
               fmt::format("the file states a time step of {} s, but time_step_s = {} was given",
                           stated, *options.time_step));
  return stated;
}

void check_count(double stated, std::string_view key, std::size_t line, std::size_t held,
                 FileErrors& errors) {
  if (!(stated >= 2 && stated == std::floor(stated)))
    errors.add(line, 1, fmt::format("{} must be a whole number above 1, got {}", key, stated));
  else if (stated != static_cast<double>(held))
    errors.add(line, 1,
               fmt::format("{} states {} samples, but the file holds {}", key, stated, held));
}

void check_enough(double samples, std::size_t line, FileErrors& errors) {
  if (!(samples >= 2))
    report(errors, line, fmt::format("a record needs at least 2 samples, got {}", samples));
}

void check_length(double length, std::size_t line, Component& component, FileErrors& errors) {
  const double held = static_cast<double>(component.acceleration.size()) * component.time_step;
  if (!(length > 0) || std::abs(held - length) <= 2.5 * component.time_step + 0.01) return;
  report_difference(length, held,
                    fmt::format("the file states a length of {:.6g} s, but its {} samples at {} s "
                                "have {:.6g} s",
                                length, component.acceleration.size(), component.time_step, held),
                    line, component, errors);
}

void check_peak(std::string_view stated, const AccelerationUnit& unit, std::size_t line,
                Component& component, FileErrors& errors) {
  const auto value = number(stated);
  if (!value) {
    errors.add(line, 1, fmt::format("the peak must be a number, got '{}'", trimmed(stated)));
    return;
  }
  const double stated_peak = std::abs(*value) * unit.to_si;
  const double held = component.acceleration.cwiseAbs().maxCoeff();
  if (std::abs(stated_peak - held) <= half_digit(stated) * unit.to_si + kPeakTolerance * held)
    return;
  report_difference(stated_peak, held,
                    fmt::format("the file states a peak of {} {}, but its samples have {:.6g} {}",
                                trimmed(stated), unit.name, held / unit.to_si, unit.name),
                    line, component, errors);
}

void check_peak(const StatedPeak& peak, const Eigen::VectorXd& a, Component& component,
                FileErrors& errors) {
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

void LayoutReader::state_facts(std::initializer_list<std::pair<const char*, const char*>> facts,
                               Component& component) const {
  std::size_t ignored = 0;
  for (const auto& [name, key] : facts)
    if (const auto text = value_behind(file_.lines(), key, ignored); text && !text->empty())
      component.header.emplace_back(name, *text);
}

}  // namespace gurney::groundmotions
