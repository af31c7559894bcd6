#include "studies/exports/sequences.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "studies/exports/export.h"

namespace gurney::study {
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
