#include "studies/units/unit_system.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "engine/base/error.h"
#include "engine/base/names.h"
#include "engine/base/unit_table.h"
#include "engine/config/nearest_name.h"

namespace gurney::study {
namespace {

/// A unit of the table with what is left of an SI unit: "rad/s" is "rad" and "/s".
ReportUnit with_rest(const char* unit, const std::string& rest) {
  return {unit + rest, in_si(unit)};
}

}  // namespace

struct UnitSystem::Row {
  const char *name, *length, *acceleration, *angle, *force, *energy, *mass;
};
const UnitSystem::Row UnitSystem::kRows[] = {
    {"si", "m", "m/s2", "rad", "N", "J", "kg"},       {"m", "m", "m/s2", "deg", "N", "J", "kg"},
    {"cm", "cm", "cm/s2", "deg", "N", "J", "kg"},     {"g-m", "m", "g", "deg", "N", "J", "kg"},
    {"g-cm", "cm", "g", "deg", "N", "J", "kg"},       {"g-mm", "mm", "g", "deg", "N", "J", "kg"},
    {"g-in", "in", "g", "deg", "lbf", "lbf in", "lb"}};

UnitSystem::UnitSystem(const std::string& name) {
  row_ = std::ranges::find(kRows, name, [](const Row& row) { return row.name; });
  if (row_ != std::end(kRows)) return;
  const std::vector<std::string> known = names();
  throw Error(fmt::format("no units '{}'{}", name, config::suggestion(name, known)));
}

std::vector<std::string> UnitSystem::names() { return names_of(kRows); }

UnitSystem UnitSystem::or_else(const char* name) const {
  return chosen() ? *this : UnitSystem(name);
}

ReportUnit UnitSystem::of(const std::string& si) const {
  const char* const acceleration = chosen() ? row_->acceleration : "g";
  const char* const angle = chosen() ? row_->angle : "deg";
  if (si == "m/s2") return with_rest(acceleration, "");
  if (si == "rad" || si == "rad/s" || si == "rad/s2") return with_rest(angle, si.substr(3));
  if (!chosen()) return {si, 1};
  if (si == "m" || si == "m/s") return with_rest(row_->length, si.substr(1));
  if (si == "N" || si == "N s") return with_rest(row_->force, si.substr(1));
  if (si == "J" || si == "N m")
    return in_si(row_->force) == 1 ? ReportUnit{si, 1} : with_rest(row_->energy, "");
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
