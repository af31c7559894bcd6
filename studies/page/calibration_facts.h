#pragma once

#include <string>
#include <vector>

#include "studies/page/json_value.h"

namespace gurney::page {

/// 95 %; not finite where there is none.
struct Ends {
  double low = 0, high = 0;

  bool bounded() const;
  std::string text() const;  ///< "0.0193 to 0.0203"
};

/// Two numbers; null: no bound.
Ends ends_in(const JsonValue& of, const std::string& key);

/// A trial against the constant that was fitted to it and others.
struct FittedTrial {
  std::string trial;
  bool validation = false;
  double value = 0, error = 0;  ///< of its measurement
};

/// A constant as `gurney calibrate` writes it.
struct FittedConstant {
  std::string about;  ///< "Cr/R of R100 on polyflor_mystique"
  std::string name, unit, caster, floor;
  double value = 0, scatter = 0;
  bool lower_bound = false;
  Ends interval, prediction;
  std::size_t degrees = 0, used = 0;  ///< used: trials
  std::vector<FittedTrial> trials;    ///< with those for validation; without mere bounds

  /// ln(value of a trial / constant) over its standard deviation: scatter between trials and error
  /// of measurement together.
  double standardised(const FittedTrial& trial) const;
};

std::vector<FittedConstant> constants_in(const JsonValue& calibration);

}  // namespace gurney::page
