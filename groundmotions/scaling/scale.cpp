#include "groundmotions/scaling/scale.h"

#include <fmt/format.h>

#include <cmath>

#include "engine/base/error.h"

namespace gurney::groundmotions {

std::string dubious_factor(double factor) {
  if (factor <= kDubiousFactor) return {};
  return fmt::format(
      "scaled by {:.3g}, more than {:g}: the record is too weak for this intensity, its noise is "
      "amplified with it; take another record",
      factor, kDubiousFactor);
}

Record scaled(Record record, double factor, const VerticalScaling& vertical,
              const std::string& reason) {
  using Rule = VerticalScaling::Rule;
  const double up = vertical.rule == Rule::kAlike  ? factor
                    : vertical.rule == Rule::kKept ? 1
                                                   : vertical.factor;
  require(factor > 0 && std::isfinite(factor) && up > 0 && std::isfinite(up),
          fmt::format("{}: factors {:g} and {:g} (vertical): must be finite numbers > 0",
                      record.name, factor, up));
  if (const std::string warning = dubious_factor(factor); !warning.empty())
    record.warnings.push_back(warning);
  for (const Direction direction : kDirections)
    if (auto& component = record.components[static_cast<std::size_t>(direction)]) {
      const double own = direction == Direction::kVertical ? up : factor;
      component->acceleration *= own;
      component->scale *= own;
    }
  std::string step = fmt::format("scaled by {:.6g}", factor);
  if (record[Direction::kVertical] && up != factor) step += fmt::format(", vertical by {:.6g}", up);
  record.processing.push_back(step + (reason.empty() ? "" : ": " + reason));
  return record;
}

Record scale_to(const Record& record, const ScalingMeasure& measure, double value,
                const VerticalScaling& vertical, const FactorLimits& limits) {
  constexpr double kReached = 1e-6;
  const double before = measure.value(record);
  require(before > 0 && std::isfinite(before) && value > 0,
          fmt::format("{}: {} is {:g}, to be scaled to {:g}: both must be > 0", record.name,
                      measure.name, before, value));
  const double factor = std::pow(value / before, 1 / measure.power);
  require(factor >= limits.smallest && !(limits.largest && factor > *limits.largest),
          fmt::format("{}: {} is {:.4g}; to reach {:.4g} the record must be scaled by {:.4g}; "
                      "allowed: {:g} to {:g}",
                      record.name, measure.name, before, value, factor, limits.smallest,
                      limits.largest.value_or(INFINITY)));
  Record result = scaled(record, factor, vertical,
                         fmt::format("{} from {:.4g} to {:.4g}", measure.name, before, value));
  const double after = measure.value(result);
  require(std::abs(after - value) <= kReached * value,
          fmt::format("{}: {} is {:.6g} after scaling by {:.4g}, not {:.6g}: it does not grow with "
                      "the power {:g} of the factor under this rule for the vertical",
                      record.name, measure.name, after, factor, value, measure.power));
  return result;
}

}  // namespace gurney::groundmotions
