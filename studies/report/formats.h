#pragma once

#include <string>

#include "studies/findings/findings.h"
#include "studies/units/unit_system.h"

namespace gurney::report {

/// A unit for people. JSON has SI, or what is chosen.
inline findings::Format format_of(const study::ReportUnit& unit, double json_unit,
                                  std::string digits = ".4g") {
  return {std::move(digits), unit.name == "1" ? "" : unit.name, unit.in_si, json_unit};
}
inline findings::Format format_of(const study::UnitSystem& units, const std::string& si,
                                  std::string digits = ".4g") {
  return format_of(units.of(si), units.or_else("si").of(si).in_si, std::move(digits));
}

/// Ends of an interval; nothing where there is none.
template <class Ends>
findings::Value ends(const Ends& of) {
  return findings::Numbers{of.low, of.high};
}

/// "95 % interval" of a column of ends().
inline findings::Format interval_format(findings::Format of) {
  of.between = findings::kTo;
  of.unit.clear();
  return of;
}

}  // namespace gurney::report
