#include "engine/base/unit_table.h"

#include <algorithm>
#include <iterator>
#include <limits>
#include <string>

#include "engine/base/error.h"
#include "engine/base/units.h"

namespace gurney {
namespace {

// Inch and pound are exact by definition (National Institute of Standards and Technology, Special
// Publication 811, 2008, appendix B.8).
constexpr double kInch = 0.0254, kPound = 0.45359237;
constexpr bool kPrintedOnly = false;

struct Unit {
  const char* name;
  const char* si;  ///< the SI unit of its quantity
  double in_si;
  bool in_files = true;  ///< limits and levels may be stated in it; else it is printed only
};

constexpr Unit kUnits[] = {
    {"m", "m", 1},
    {"cm", "m", 0.01},
    {"mm", "m", 0.001},
    {"in", "m", kInch, kPrintedOnly},
    {"m/s", "m/s", 1},
    {"cm/s", "m/s", 0.01},
    {"m/s2", "m/s2", 1},
    {"cm/s2", "m/s2", 0.01},
    {"g", "m/s2", kStandardGravity},
    {"rad", "rad", 1},
    {"deg", "rad", kRadiansPerDegree},
    {"s", "s", 1},
    {"N", "N", 1},
    {"kN", "N", 1000},
    {"lbf", "N", kPound* kStandardGravity, kPrintedOnly},
    {"N s", "N s", 1},
    {"J", "J", 1, kPrintedOnly},
    {"lbf in", "J", kPound* kStandardGravity* kInch, kPrintedOnly},
    {"kg", "kg", 1, kPrintedOnly},
    {"lb", "kg", kPound, kPrintedOnly},
};

constexpr double kTimeStep = std::numeric_limits<double>::quiet_NaN();

constexpr SiUnit kSiUnits[] = {
    {"m", "m", 1e-4},        {"m/s", "mps", 1e-3}, {"m/s2", "mps2", 1e-2}, {"rad", "rad", 1e-4},
    {"s", "sec", kTimeStep}, {"N", "N", 0.1},      {"N s", "", 0.1},       {"1", "unitless", 0},
};

}  // namespace

std::vector<std::string> units_in_files(std::string_view si) {
  std::vector<std::string> names;
  for (const Unit& unit : kUnits)
    if (unit.in_files && unit.si == si) names.emplace_back(unit.name);
  return names;
}

double in_si(std::string_view unit) {
  const auto* const found =
      std::ranges::find(kUnits, unit, [](const Unit& each) { return std::string_view(each.name); });
  require(found != std::end(kUnits), "no unit " + std::string(unit));
  return found->in_si;
}

const SiUnit* si_unit(std::string_view name) {
  const auto* const found = std::ranges::find(
      kSiUnits, name, [](const SiUnit& each) { return std::string_view(each.name); });
  return found == std::end(kSiUnits) ? nullptr : found;
}

}  // namespace gurney
