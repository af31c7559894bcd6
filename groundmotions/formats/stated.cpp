#include "groundmotions/formats/stated.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>

#include "groundmotions/formats/numbers.h"

namespace gurney {

namespace {

constexpr double kPeakTolerance = 0.001;
constexpr double kPeakFactor = 1.5;

/// Half of the last digit of a decimal number: 0.0005 of "4.078", 0.005 of "1.2E-01".
double half_digit(std::string_view text) {
  text = trimmed(text);
  const auto letter = std::min(text.find_first_of("eE"), text.size());
  const auto mantissa = text.substr(0, letter);
  const auto point = mantissa.find('.');
  const auto places = point == std::string_view::npos ? 0 : mantissa.size() - point - 1;
  const double exponent = letter < text.size() ? number(text.substr(letter + 1)).value_or(0) : 0;
  return 0.5 * std::pow(10, exponent - static_cast<double>(places));
}

}  // namespace

AccelerationUnit checked_unit(std::string_view stated, std::size_t line, const ReadOptions& options,
                              Mistakes& mistakes) {
  const auto unit = acceleration_unit(trimmed(stated));
  const auto given = acceleration_unit(options.unit);
  if (!unit)
    mistakes.add(line, 1,
                 fmt::format("'{}' is not a unit of acceleration: {} are allowed", trimmed(stated),
                             kAccelerationUnits));
  else if (given && given->to_si != unit->to_si)
    mistakes.add(line, 1,
                 fmt::format("the file states the unit {}, but unit = \"{}\" was given", unit->name,
                             options.unit));
  return unit.value_or(AccelerationUnit{"", 1});
}

AccelerationUnit unit_of_user(const ReadOptions& options, Mistakes& mistakes) {
  const auto given = acceleration_unit(options.unit);
  if (!given)
    mistakes.add(fmt::format("the file does not state its unit; state it as unit = \"...\" ({})",
                             kAccelerationUnits));
  return given.value_or(AccelerationUnit{"", 1});
}

double checked_time_step(double stated, std::string_view key, std::size_t line,
                         const ReadOptions& options, Mistakes& mistakes) {
  if (!(stated > 0 && stated <= 1))
    mistakes.add(line, 1, fmt::format("{} must be in (0, 1] s, got {}", key, stated));
  else if (options.time_step && !(std::abs(*options.time_step - stated) <= 1e-6 * stated))
    mistakes.add(line, 1,
                 fmt::format("the file states a time step of {} s, but time_step_s = {} was given",
                             stated, *options.time_step));
  return stated;
}

void check_count(double stated, std::string_view key, std::size_t line, std::size_t held,
                 Mistakes& mistakes) {
  if (!(stated >= 2 && stated == std::floor(stated)))
    mistakes.add(line, 1, fmt::format("{} must be a whole number above 1, got {}", key, stated));
  else if (stated != static_cast<double>(held))
    mistakes.add(line, 1,
                 fmt::format("{} states {} samples, but the file holds {}", key, stated, held));
}

void check_peak(std::string_view stated, const AccelerationUnit& unit, std::size_t line,
                Component& component, Mistakes& mistakes) {
  const auto value = number(stated);
  if (!value) {
    mistakes.add(line, 1, fmt::format("the peak must be a number, got '{}'", trimmed(stated)));
    return;
  }
  const double told = std::abs(*value) * unit.to_si;
  const double held = component.acceleration.cwiseAbs().maxCoeff();
  if (std::abs(told - held) <= half_digit(stated) * unit.to_si + kPeakTolerance * held) return;
  const std::string message =
      fmt::format("the file states a peak of {} {}, but its samples have {:.6g} {}",
                  trimmed(stated), unit.name, held / unit.to_si, unit.name);
  if (!(held <= kPeakFactor * told && told <= kPeakFactor * held))
    mistakes.add(line, 1, message);
  else
    component.warnings.push_back(message);
}

void refuse_si_per_count(const ReadOptions& options, Mistakes& mistakes) {
  if (options.si_per_count)
    mistakes.add(fmt::format("si_per_count = {} was given, but the file does not hold raw counts",
                             *options.si_per_count));
}

void refuse_columns(const ReadOptions& options, Mistakes& mistakes) {
  if (!options.columns.empty())
    mistakes.add(fmt::format("columns = \"{}\" was given, but the layout of this file is known",
                             options.columns));
}

std::optional<std::string_view> other_quantity(std::string_view unit) {
  constexpr std::array kLengths = {"m", "cm", "mm", "in", "ft"};
  std::string text;
  for (const char c : trimmed(unit))
    text += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  if (std::ranges::find(kLengths, text) != kLengths.end()) return "displacement";
  for (const std::string_view second : {"/s", "/sec"})
    if (text.ends_with(second) &&
        std::ranges::find(kLengths, text.substr(0, text.size() - second.size())) != kLengths.end())
      return "velocity";
  return {};
}

Eigen::VectorXd scaled(const std::vector<double>& values, double factor) {
  return factor *
         Eigen::Map<const Eigen::VectorXd>(values.data(), static_cast<Eigen::Index>(values.size()));
}

}  // namespace gurney
