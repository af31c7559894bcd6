#include "studies/exports/chosen_curves.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>

#include "engine/base/error.h"
#include "engine/base/units.h"
#include "engine/config/nearest_name.h"
#include "groundmotions/measures/measure.h"
#include "studies/exports/export.h"
#include "studies/limit_states/limit_state_reader.h"

namespace gurney::study {
namespace {

std::vector<std::size_t> chosen_states(const StudyData& data, const ExportChoice& choice) {
  if (!choice.limit.empty()) return {index_of(data.limit_states(), choice.limit)};
  std::vector<std::size_t> all(data.limit_states().size());
  for (std::size_t i = 0; i < all.size(); ++i) all[i] = i;
  return all;
}

}  // namespace

std::vector<std::size_t> chosen_configurations(const StudyData& data, const ExportChoice& choice) {
  const std::vector<std::string>& names = data.configurations();
  std::vector<std::size_t> chosen;
  for (std::size_t i = 0; i < names.size(); ++i)
    if (choice.configuration.empty() || names[i] == choice.configuration) chosen.push_back(i);
  require(!chosen.empty(),
          fmt::format("{}: no configuration '{}'{}", data.file().path(), choice.configuration,
                      config::suggestion(choice.configuration, names)));
  return chosen;
}

std::string basis_text(const ChosenCurve& curve) {
  const CurveAudit& of = curve.audit;
  if (of.of_demands)
    return fmt::format("the demands of {} runs with {} records (cloud)", of.outcomes,
                       curve.records);
  return of.of_capacities ? fmt::format("capacities of {} {}, of which {} exceed", of.outcomes,
                                        of.counted, of.exceeded)
                          : fmt::format("{} runs with {} records, of which {} exceed", of.outcomes,
                                        curve.records, of.exceeded);
}

std::string caution_text(const ChosenCurve& curve, const ReportUnit& unit) {
  std::string text;
  for (const std::string& each : cautions(curve.audit, unit)) text += " Caution: " + each + ".";
  return text;
}

ChosenCurves chosen_curves(const StudyData& data, const ExportChoice& choice) {
  ChosenCurves chosen{data.measure(choice.measure), {}, {}};
  const std::vector<std::size_t> states = chosen_states(data, choice);
  for (const std::size_t configuration : chosen_configurations(data, choice))
    for (const std::size_t state : states) {
      const FittedCurve fitted =
          fitted_curve(data, state, configuration, chosen.measure, choice.method);
      const std::optional<statistics::LognormalCurve> curve = fitted.curve();
      const LimitState& limit = data.limit_states()[state];
      if (!curve) {
        chosen.left_out.push_back(
            fmt::format("{}{}'{}': {}", data.configurations()[configuration],
                        data.configurations()[configuration].empty() ? "" : ", ", limit.name,
                        no_curve_text(fitted, report_unit(data, chosen.measure))));
        continue;
      }
      chosen.curves.push_back({data.configurations()[configuration], limit, *curve,
                               fitted.fit.groups, data.failed(configuration), fitted.audit});
    }
  require(!chosen.curves.empty(),
          fmt::format("{}: no fragility curve over {} can be fitted; nothing was written\n  {}",
                      data.file().path(), chosen.measure.name, fmt::join(chosen.left_out, "\n  ")));
  return chosen;
}

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

namespace {

using Curves = std::vector<statistics::LognormalCurve>;

/// Probabilities are compared between these quantiles of all curves, in as many steps.
constexpr double kTail = 1e-4, kAllowed = 1e-3;
constexpr int kSteps = 1000;

bool crosses(const Curves& curves) {
  double low = INFINITY, high = 0;
  for (const auto& curve : curves) {
    low = std::min(low, curve.quantile(kTail));
    high = std::max(high, curve.quantile(1 - kTail));
  }
  for (int i = 0; i <= kSteps; ++i) {
    const double im = low * std::pow(high / low, double(i) / kSteps);
    for (std::size_t k = 1; k < curves.size(); ++k)
      if (curves[k].probability(im) >= curves[k - 1].probability(im) + kAllowed) return true;
  }
  return false;
}

/// Whether the limit of `b` is one of the same requirement as that of `a`, and stricter.
bool is_stricter(const LimitState& b, const LimitState& a) {
  if (!a.is_simple() || a.kind != b.kind || a.quantity != b.quantity || a.at_least != b.at_least)
    return false;
  return a.kind == LimitState::Kind::kAbove ? b.limit > a.limit : b.limit < a.limit;
}

void add(std::vector<CurveSequence>& all, const ChosenCurve& curve) {
  for (CurveSequence& each : all) {
    if (each.configuration != curve.configuration) continue;
    const auto place = std::ranges::find_if(each.curves, [&](const ChosenCurve& other) {
      return is_stricter(other.state, curve.state);
    });
    const bool after =
        place != each.curves.begin() && is_stricter(curve.state, std::prev(place)->state);
    const bool first = place == each.curves.begin();  // one that is stricter comes next
    if (!after && !first) continue;
    each.curves.insert(place, curve);
    return;
  }
  all.push_back({curve.configuration, "", {curve}, false});
}

void complete(CurveSequence& sequence) {
  Curves curves;
  std::vector<std::string> names;
  for (const ChosenCurve& each : sequence.curves) {
    curves.push_back(each.curve);
    names.push_back(plain_identifier(each.state.name, "limit"));
  }
  sequence.name = fmt::format("{}", fmt::join(names, "_"));
  sequence.fitted = sequence.curves;
  sequence.adjusted = in_order(curves);
  for (std::size_t i = 0; i < curves.size(); ++i) sequence.curves[i].curve = curves[i];
}

}  // namespace

bool in_order(Curves& curves) {
  if (!crosses(curves)) return false;
  double mean = 0;
  for (const auto& curve : curves) mean += curve.beta / static_cast<double>(curves.size());
  double milder = 0;
  for (auto& curve : curves) {
    curve = {std::max(milder, curve.theta * std::exp(1.28 * (mean - curve.beta))), mean};
    milder = curve.theta;
  }
  return true;
}

bool is_incomplete(const CurveSequence& sequence) {
  return !std::ranges::all_of(sequence.curves, &ChosenCurve::is_supported);
}

CurveSequence supported_part(const CurveSequence& sequence) {
  CurveSequence part{sequence.configuration, "", {}, false};
  std::ranges::copy_if(sequence.fitted, std::back_inserter(part.curves),
                       &ChosenCurve::is_supported);
  if (!part.curves.empty()) complete(part);
  return part;
}

std::vector<CurveSequence> sequences(const ChosenCurves& chosen, bool combine) {
  std::vector<CurveSequence> all;
  for (const ChosenCurve& each : chosen.curves)
    if (combine)
      add(all, each);
    else
      all.push_back({each.configuration, "", {each}, false});
  for (CurveSequence& each : all) complete(each);
  return all;
}

}  // namespace gurney::study
