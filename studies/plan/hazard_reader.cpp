#include "studies/plan/hazard_reader.h"

#include <cmath>

#include "engine/base/error.h"

namespace gurney::study {

using config::Range;

std::optional<statistics::HazardCurve> read_hazard(config::Table& in,
                                                   const IntensityPlan& intensity) {
  if (intensity.kind == IntensityPlan::Kind::kScales)
    in.note("im", ": a hazard needs study.intensity with a measure, in whose unit it is stated");
  const double unit = intensity.unit_in_si;
  if (in.has("im") == in.has("k0")) {
    in.note("im", ": must be given with rate_per_year, or k0 with k, not both");
    for (const char* key : {"im", "rate_per_year", "k0", "k"}) in.has(key);
    return {};
  }
  if (in.has("k0")) {
    const double k0 = in.number("k0", Range::positive()), k = in.number("k", Range::positive());
    return statistics::HazardCurve::power_law(k0 * std::pow(unit, k), k);
  }
  std::vector<double> im = in.numbers("im", Range::positive());
  for (double& value : im) value *= unit;
  const std::vector<double> rate = in.numbers("rate_per_year", Range::positive(), im.size());
  try {
    return statistics::HazardCurve::table(im, rate);
  } catch (const Error& error) {
    in.note("rate_per_year", std::string(": ") + error.what());
    return {};
  }
}

}  // namespace gurney::study
