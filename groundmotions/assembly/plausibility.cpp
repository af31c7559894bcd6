#include "groundmotions/assembly/plausibility.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/base/units.h"

namespace gurney::groundmotions {

namespace {

constexpr double kSmallestPeak = 0.001 * kStandardGravity;
constexpr double kLargestPeak = 3 * kStandardGravity;
constexpr double kLargestRatio = 100;
constexpr double kLargestMean = 0.1;   ///< of the peak
constexpr Eigen::Index kEnough = 100;  ///< samples for a mean to mean something

double peak(const Component& component) { return component.acceleration.cwiseAbs().maxCoeff(); }

/// The file of a component, before what is said of it; synthetic ones have none.
std::string said_of(const Component& component) {
  return component.file.empty() ? "" : component.file + ": ";
}

void check_component(const Component& component, const char* place,
                     std::vector<std::string>& findings) {
  const double largest = peak(component), mean = component.acceleration.mean();
  if (largest == 0) {
    findings.push_back(fmt::format("{}the {} component is all zero", said_of(component), place));
    return;
  }
  if (largest < kSmallestPeak || largest > kLargestPeak)
    findings.push_back(fmt::format(
        "{}the peak acceleration of {} is {:.3g} g, outside 0.001 to 3 g; check the unit ({})",
        said_of(component), place, largest / kStandardGravity, component.unit));
  const bool has_one_sign =
      component.acceleration.minCoeff() >= 0 || component.acceleration.maxCoeff() <= 0;
  if (component.acceleration.size() >= kEnough && has_one_sign)
    findings.push_back(
        fmt::format("{}all samples of {} have one sign (their mean is {:.3g} g): a spectrum, "
                    "times, or a history with an offset that a baseline step removes",
                    said_of(component), place, mean / kStandardGravity));
  else if (component.acceleration.size() >= kEnough && std::abs(mean) > kLargestMean * largest)
    findings.push_back(fmt::format(
        "{}the mean of {} is {:.3g} g at a peak of {:.3g} g: a constant offset; "
        "remove it with a baseline step",
        said_of(component), place, mean / kStandardGravity, largest / kStandardGravity));
}

void check_pair(const Component& a, const Component& b, std::vector<std::string>& findings) {
  const std::string both = a.file.empty() || b.file.empty()
                               ? fmt::format("{} and {}", a.name, b.name)
                               : fmt::format("{} and {}", a.file, b.file);
  const double smaller = std::min(peak(a), peak(b)), larger = std::max(peak(a), peak(b));
  if (smaller > 0 && larger > kLargestRatio * smaller)
    findings.push_back(
        fmt::format("{}: peak accelerations of {:.3g} and {:.3g} g; one record's components do not "
                    "differ by orders of magnitude",
                    both, peak(a) / kStandardGravity, peak(b) / kStandardGravity));
  if (larger > 0 && a.acceleration.size() == b.acceleration.size() &&
      a.acceleration == b.acceleration)
    findings.push_back(
        fmt::format("{}: components '{}' and '{}' are the same numbers", both, a.name, b.name));
}

}  // namespace

std::vector<std::string> implausible(const Record& record) {
  std::vector<std::string> findings;
  for (const Direction direction : kDirections)
    if (record[direction]) check_component(*record[direction], name_of(direction), findings);
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = i + 1; j < 3; ++j)
      if (record.components[i] && record.components[j])
        check_pair(*record.components[i], *record.components[j], findings);
  return findings;
}

}  // namespace gurney::groundmotions
