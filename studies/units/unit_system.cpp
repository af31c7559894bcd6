#include "studies/units/unit_system.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "engine/base/error.h"
#include "engine/base/units.h"
#include "engine/config/nearest_name.h"

namespace gurney::study {
namespace {

// National Institute of Standards and Technology, Special Publication 811 (2008), appendix B.8:
// exact by definition.
constexpr double kInch = 0.0254, kPound = 0.45359237;
constexpr double kPoundForce = kPound * kStandardGravity;

struct Unit {
  const char* name;
  double in_si;
};

constexpr Unit kRadian{"rad", 1}, kDegree{"deg", kRadiansPerDegree};
constexpr Unit kMeter{"m", 1}, kCentimeter{"cm", 0.01}, kMillimeter{"mm", 0.001},
    kInches{"in", kInch};
constexpr Unit kG{"g", kStandardGravity};
constexpr Unit kNewton{"N", 1}, kJoule{"J", 1}, kKilogram{"kg", 1};

/// The quantity of an SI unit and what is left of it: "rad/s" is "rad" and "/s".
ReportUnit with_rest(const Unit& unit, const std::string& rest) {
  return {unit.name + rest, unit.in_si};
}

}  // namespace

struct UnitSystem::Row {
  const char* name;
  Unit length, acceleration, angle, force, energy, mass;
};

const UnitSystem::Row UnitSystem::kRows[] = {
    {"si", kMeter, {"m/s2", 1}, kRadian, kNewton, kJoule, kKilogram},
    {"m", kMeter, {"m/s2", 1}, kDegree, kNewton, kJoule, kKilogram},
    {"cm", kCentimeter, {"cm/s2", 0.01}, kDegree, kNewton, kJoule, kKilogram},
    {"g-m", kMeter, kG, kDegree, kNewton, kJoule, kKilogram},
    {"g-cm", kCentimeter, kG, kDegree, kNewton, kJoule, kKilogram},
    {"g-mm", kMillimeter, kG, kDegree, kNewton, kJoule, kKilogram},
    {"g-in",
     kInches,
     kG,
     kDegree,
     {"lbf", kPoundForce},
     {"lbf in", kPoundForce* kInch},
     {"lb", kPound}}};

UnitSystem::UnitSystem(const std::string& name) {
  row_ = std::ranges::find(kRows, name, [](const Row& row) { return row.name; });
  if (row_ != std::end(kRows)) return;
  const std::vector<std::string> known = names();
  throw Error(fmt::format("no units '{}'{}", name, config::suggestion(name, known)));
}

std::vector<std::string> UnitSystem::names() {
  std::vector<std::string> all;
  for (const Row& row : kRows) all.emplace_back(row.name);
  return all;
}

UnitSystem UnitSystem::or_else(const char* name) const {
  return chosen() ? *this : UnitSystem(name);
}

ReportUnit UnitSystem::of(const std::string& si) const {
  const Unit acceleration = chosen() ? row_->acceleration : kG;
  const Unit angle = chosen() ? row_->angle : kDegree;
  if (si == "m/s2") return with_rest(acceleration, "");
  if (si == "rad" || si == "rad/s" || si == "rad/s2") return with_rest(angle, si.substr(3));
  if (!chosen()) return {si, 1};
  if (si == "m" || si == "m/s") return with_rest(row_->length, si.substr(1));
  if (si == "N" || si == "N s") return with_rest(row_->force, si.substr(1));
  if (si == "J" || si == "N m")
    return row_->force.in_si == 1 ? ReportUnit{si, 1} : with_rest(row_->energy, "");
  if (si == "kg") return with_rest(row_->mass, "");
  return {si, 1};
}

std::string UnitSystem::number(double value, const std::string& si, int decimals) const {
  const ReportUnit unit = of(si);
  constexpr double kNearly = 0.01;  // 1 g is nearly 10 m/s2
  const double fewer = std::floor(std::log10(UnitSystem().of(si).in_si / unit.in_si) + kNearly);
  return fmt::format("{:.{}f}", value / unit.in_si,
                     std::max(0, decimals - static_cast<int>(fewer)));
}

std::string UnitSystem::fixed(double value, const std::string& si, int decimals) const {
  return number(value, si, decimals) + " " + of(si).name;
}

std::string UnitSystem::text(double value, const std::string& si) const {
  const ReportUnit unit = of(si);
  const double shown = value / unit.in_si, size = std::abs(shown);
  const std::string space = unit.name == "1" ? "" : " " + unit.name;
  if (size == 0 || !chosen()) return fmt::format("{:.3g}{}", shown, space);
  if (!(size >= 1e-4 && size < 1e6)) return fmt::format("{:.2e}{}", shown, space);
  const int decimals = std::clamp(2 - static_cast<int>(std::floor(std::log10(size))), 0, 6);
  return fmt::format("{:.{}f}{}", shown, decimals, space);
}

}  // namespace gurney::study
