#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/config/document.h"
#include "equipment/catalogue/assumption.h"
#include "equipment/catalogue/uncertainty.h"

namespace gurney::equipment {

/// A number as its file states it: its value, what the value rests on, and how it may be.
struct StatedQuantity {
  double value = 0;                          ///< in the unit of its key
  std::optional<Uncertainty> uncertainty{};  ///< none: it has its value in a draw too
  std::string reason{};                      ///< assumption behind the value; empty: none
  double low = 0, high = 0;                  ///< its range, in the unit of its key
  config::Spot spot{};                       ///< its key; of a component with `.x` or `[2]`
  double factor = 1, divisor = 1;            ///< to SI

  double si(double in_unit) const { return in_unit * factor / divisor; }
};

/// Numbers or flags of equal parts. What they rest on is one entry for all.
struct QuantityList {
  std::vector<StatedQuantity> quantities;
  Assumption choice{};          ///< without a reason: none
  bool chosen_in_draws = true;  ///< false: a draw has an entry for each drawn number instead
};

/// A text as its file states it.
struct StatedText {
  std::string text;
  Assumption choice{};  ///< without a reason: none
};

}  // namespace gurney::equipment
