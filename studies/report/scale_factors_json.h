#pragma once

#include <nlohmann/json.hpp>

#include "studies/study/analysis/scale_factors.h"

namespace gurney::report {

inline nlohmann::ordered_json scale_factors_json(const study::ScaleFactors& factors) {
  return {{"lowest", factors.lowest()},
          {"highest", factors.highest()},
          {"records", factors.records()},
          {"limits", {study::kSmallestFactor, study::kLargestFactor}},
          {"records_above", factors.above()},
          {"records_below", factors.below()}};
}

}  // namespace gurney::report
