#pragma once

#include <functional>
#include <optional>
#include <string>

#include "groundmotions/record/record.h"

namespace gurney::groundmotions {

/// A factor beyond which a record is reported by name. An assumption: the literature cautions from
/// factors of 4 to 10 on (docs/theory/statistics.md, Scale factors); at 20 a peak of 0.5 g comes
/// from a record of 0.025 g, in which the noise of the instrument is amplified too.
inline constexpr double kDubiousFactor = 20;

/// `scaled by 387000, more than 20: ...`; empty for a smaller factor
std::string dubious_factor(double factor);

/// Effect of scaling on the vertical component.
struct VerticalScaling {
  enum class Rule {
    kAlike,  ///< by the factor of the horizontals
    kKept,   ///< not at all
    kOwn     ///< by `factor`
  };
  Rule rule = Rule::kAlike;
  double factor = 1;  ///< > 0, of kOwn
};

/// The record with its horizontals multiplied by `factor` and its vertical by the rule; a line in
/// `processing` says so.
/// @param factor  > 0
/// @param reason  behind the numbers in that line, may be empty
/// @throws Error unless the factors are > 0 and finite.
Record scaled(Record record, double factor, const VerticalScaling& vertical = {},
              const std::string& reason = {});

/// An intensity measure of a record: PGA, Sa(1 s), Arias intensity, ...
struct ScalingMeasure {
  std::string name;                            ///< with unit, for messages: "PGA of h1 [m/s2]"
  std::function<double(const Record&)> value;  ///< >= 0
  double power = 1;  ///< value of a record times f is f^power times the value; 2 for Arias
};

/// The range of factors that the user allows.
struct FactorLimits {
  double smallest = 0;
  std::optional<double> largest = {};
};

/// Scales a record so that a measure reaches a value. The measure is taken again afterwards.
/// @param value  > 0
/// @throws Error if the measure is zero or no number, if the factor is outside the limits, and if
///         the measure does not come out within 1e-6 of the value: it does not grow with the power
///         that it states, or depends on a vertical that is scaled by another rule.
Record scale_to(const Record& record, const ScalingMeasure& measure, double value,
                const VerticalScaling& vertical = {}, const FactorLimits& limits = {});

}  // namespace gurney::groundmotions
