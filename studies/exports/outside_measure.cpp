#include "studies/exports/outside_measure.h"

#include <fmt/format.h>

#include <cmath>

#include "engine/base/error.h"
#include "engine/base/units.h"
#include "groundmotions/measures/measure.h"

namespace gurney::study {
namespace {

constexpr double kCentimetersPerMeter = 100;

/// A measure of the study without its combination: "Sa(1) RotD50" is Sa(1).
groundmotions::Measure kind_of(const std::string& measure) {
  if (measure == "pfa") return {.kind = groundmotions::MeasureKind::kPfa};
  if (measure == "pfv") return {.kind = groundmotions::MeasureKind::kPfv};
  return groundmotions::parse_measure(measure.substr(0, measure.rfind(' ')));
}

std::string period_text(double period) {
  const std::string text = fmt::format("{}", period);
  return text.find('.') == std::string::npos ? text + ".0" : text;
}

bool has_usual_damping(const groundmotions::Measure& measure) {
  return std::abs(measure.damping - 0.05) < 1e-9;
}

}  // namespace

std::optional<OutsideMeasure> dlml_measure(const std::string& measure) {
  const groundmotions::Measure of = kind_of(measure);
  switch (of.kind) {
    case groundmotions::MeasureKind::kPga:
      return OutsideMeasure{"Peak Ground Acceleration", "g", kStandardGravity};
    case groundmotions::MeasureKind::kPgv:
      return OutsideMeasure{"Peak Ground Velocity", "mps", 1};
    case groundmotions::MeasureKind::kPfa:
      return OutsideMeasure{"Peak Floor Acceleration", "g", kStandardGravity};
    case groundmotions::MeasureKind::kPfv:
      return OutsideMeasure{"Peak Floor Velocity", "mps", 1};
    case groundmotions::MeasureKind::kSa:
      if (!has_usual_damping(of)) return {};
      return OutsideMeasure{"Spectral Acceleration|" + period_text(of.period), "g",
                            kStandardGravity};
    default:
      return {};
  }
}

std::optional<OutsideMeasure> nrml_measure(const std::string& measure) {
  const groundmotions::Measure of = kind_of(measure);
  switch (of.kind) {
    case groundmotions::MeasureKind::kPga:
      return OutsideMeasure{"PGA", "g", kStandardGravity};
    case groundmotions::MeasureKind::kPgv:
      return OutsideMeasure{"PGV", "cm/s", 1 / kCentimetersPerMeter};
    case groundmotions::MeasureKind::kSa:
      if (!has_usual_damping(of) || !(of.period > 0)) return {};
      return OutsideMeasure{"SA(" + period_text(of.period) + ")", "g", kStandardGravity};
    case groundmotions::MeasureKind::kPgd:
      return OutsideMeasure{"PGD", "cm", 1 / kCentimetersPerMeter};
    case groundmotions::MeasureKind::kArias:
      return OutsideMeasure{"IA", "m/s", 1};
    case groundmotions::MeasureKind::kCav:
      return OutsideMeasure{"CAV", "g s", kStandardGravity};
    case groundmotions::MeasureKind::kD575:
      return OutsideMeasure{"RSD575", "s", 1};
    case groundmotions::MeasureKind::kD595:
      return OutsideMeasure{"RSD595", "s", 1};
    case groundmotions::MeasureKind::kFiv3:
      return OutsideMeasure{"FIV3(" + period_text(of.period) + ")", "cm/s",
                            1 / kCentimetersPerMeter};
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

}  // namespace gurney::study
