#include "groundmotions/hazard/published_measure.h"

#include <algorithm>

#include "engine/base/number_text.h"
#include "groundmotions/measures/measure.h"

namespace gurney::groundmotions {

PublishedMeasure published_measure(const std::string& imt) {
  if (imt == "PGA") return {"PGA", "g"};
  if (imt == "PGV") return {"PGV", "cm/s"};
  if (!imt.starts_with("SA")) return {};
  std::string period = imt.substr(2);
  if (period.starts_with('(') && period.ends_with(')'))
    period = period.substr(1, period.size() - 2);
  else
    std::ranges::replace(period, 'P', '.');
  const auto value = number(period);
  if (!value || !(*value > 0)) return {};
  return {name_of(Measure{.kind = MeasureKind::kSa, .period = *value}), "g", *value};
}

}  // namespace gurney::groundmotions
