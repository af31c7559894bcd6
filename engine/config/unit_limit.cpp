#include "engine/config/unit_limit.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <string_view>

namespace gurney::config {
namespace {

/// An ending stands before those it ends with.
constexpr std::array<UnitLimit, 33> kLimits = {{{"_n_m_s_per_rad", 1e-12, 1e9},
                                                {"_n_s_per_m", 1e-9, 1e12},
                                                {"_n_per_m", 1e-6, 1e13},
                                                {"_hz_per_s", 1e-9, 1e6},
                                                {"_deg_per_s", 1e-9, 1e6},
                                                {"_m_per_s2", 1e-15, 1e4},
                                                {"_m_per_s", 1e-9, 1e4},
                                                {"_s_per_m", 1e-9, 1e4},
                                                {"_per_year", 1e-30, 1e4},
                                                {"_kg_m2", 1e-12, 1e12},
                                                {"_n_m", 1e-12, 1e9},
                                                {"_mps2", 1e-9, 1e4},
                                                {"_mps", 1e-9, 1e4},
                                                {"_mm", 1e-3, 1e7},
                                                {"_cm", 1e-4, 1e6},
                                                {"_km", 1e-6, 1e5},
                                                {"_kn", 1e-9, 1e6},
                                                {"_kg", 1e-6, 1e9},
                                                {"_hz", 1e-6, 1e6},
                                                {"_deg", 1e-9, 1e6},
                                                {"_rad", 1e-9, 1e5},
                                                {"_ms", 1e-3, 1e8},
                                                {"_g", 1e-9, 1e3},
                                                {"_m", 1e-6, 1e4},
                                                {"_s", 1e-6, 1e5},
                                                {"_n", 1e-9, 1e10},
                                                {"_j", 1e-9, 1e12},
                                                {"friction", 1e-9, 100},
                                                {"ratio", 1e-9, 1e4},
                                                {"factor", 1e-9, 1e4},
                                                {"scale", 1e-9, 1e6},
                                                {"scales", 1e-9, 1e6},
                                                {"", 1e-300, 1e15}}};

}  // namespace

std::span<const UnitLimit> unit_limits() { return kLimits; }

const UnitLimit& unit_limit(const std::string& name) {
  std::string_view rest = name;
  while (!rest.empty()) {
    const std::size_t dot = rest.rfind('.');
    std::string_view part = rest.substr(dot == rest.npos ? 0 : dot + 1);
    part = part.substr(0, part.find('['));
    for (const UnitLimit& each : kLimits)
      if (*each.ending != '\0' && part.ends_with(each.ending)) return each;
    rest = rest.substr(0, dot == rest.npos ? 0 : dot);
  }
  return kLimits.back();
}

std::string beyond_unit(const std::string& name, const Range& range, double value) {
  const UnitLimit& limit = unit_limit(name);
  const double size = std::abs(value);
  const bool too_large = size > limit.largest && !std::isinf(value);
  const bool too_small = size < limit.smallest && !range.contains(0);
  if (!too_large && !too_small) return {};
  return too_large ? fmt::format("at most {:g} in magnitude", limit.largest)
                   : fmt::format("at least {:g}", limit.smallest);
}

}  // namespace gurney::config
