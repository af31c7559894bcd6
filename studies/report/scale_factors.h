#pragma once

#include <nlohmann/json.hpp>

#include "studies/analysis/scale_factors.h"
#include "studies/render/render.h"

namespace gurney::report {

inline findings::Section scale_factor_findings(const study::ScaleFactors& factors) {
  findings::Section all{"scale_factors"};
  all.json("lowest", factors.lowest()).json("highest", factors.highest());
  all.json("records", factors.records());
  all.json("limits", findings::Numbers{study::kSmallestFactor, study::kLargestFactor});
  all.json("records_above", factors.above()).json("records_below", factors.below());
  return all.text("scaling", "factors " + factors.text());
}

inline nlohmann::ordered_json scale_factors_json(const study::ScaleFactors& factors) {
  return nlohmann::ordered_json::parse(render::json(scale_factor_findings(factors)));
}

}  // namespace gurney::report
