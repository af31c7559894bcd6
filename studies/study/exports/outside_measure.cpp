#include "studies/study/exports/outside_measure.h"

#include <fmt/format.h>

#include <cmath>

#include "engine/base/error.h"
#include "engine/base/units.h"
#include "groundmotions/measures/measure.h"

namespace gurney {
namespace {

constexpr double kCentimetersPerMeter = 100;

/// A measure of the study without its combination: "Sa(1) RotD50" is Sa(1).
Measure kind_of(const std::string& measure) {
  if (measure == "pfa") return {.kind = MeasureKind::kPfa};
  if (measure == "pfv") return {.kind = MeasureKind::kPfv};
  return parse_measure(measure.substr(0, measure.rfind(' ')));
}

std::string period_text(double period) {
  const std::string text = fmt::format("{}", period);
  return text.find('.') == std::string::npos ? text + ".0" : text;
}

bool has_usual_damping(const Measure& measure) { return std::abs(measure.damping - 0.05) < 1e-9; }

}  // namespace

std::optional<OutsideMeasure> dlml_measure(const std::string& measure) {
  const Measure of = kind_of(measure);
  switch (of.kind) {
    case MeasureKind::kPga:
      return OutsideMeasure{"Peak Ground Acceleration", "g", kStandardGravity};
    case MeasureKind::kPgv:
      return OutsideMeasure{"Peak Ground Velocity", "mps", 1};
    case MeasureKind::kPfa:
      return OutsideMeasure{"Peak Floor Acceleration", "g", kStandardGravity};
    case MeasureKind::kPfv:
      return OutsideMeasure{"Peak Floor Velocity", "mps", 1};
    case MeasureKind::kSa:
      if (!has_usual_damping(of)) return {};
      return OutsideMeasure{"Spectral Acceleration|" + period_text(of.period), "g",
                            kStandardGravity};
    default:
      return {};
  }
}

std::optional<OutsideMeasure> nrml_measure(const std::string& measure) {
  const Measure of = kind_of(measure);
  switch (of.kind) {
    case MeasureKind::kPga:
      return OutsideMeasure{"PGA", "g", kStandardGravity};
    case MeasureKind::kPgv:
      return OutsideMeasure{"PGV", "cm/s", 1 / kCentimetersPerMeter};
    case MeasureKind::kSa:
      if (!has_usual_damping(of) || !(of.period > 0)) return {};
      return OutsideMeasure{"SA(" + period_text(of.period) + ")", "g", kStandardGravity};
    default:
      return {};
  }
}

OutsideMeasure outside_measure(const StudyData& data, const std::string& measure,
                               const std::string& format, NameMeasure name) {
  if (const auto found = name(measure)) return *found;
  std::vector<std::string> named;
  for (const std::string& each : data.measures())
    if (name(each)) named.push_back("'" + each + "'");
  throw Error(fmt::format(
      "{}: {} has no name for the intensity measure '{}'; {}", data.file().path(), format, measure,
      named.empty() ? "nor for any other of this study"
                    : fmt::format("take one of these with --measure: {}", fmt::join(named, ", "))));
}

}  // namespace gurney
