#include "groundmotions/measures/combined_spectrum.h"

#include "engine/base/error.h"
#include "groundmotions/measures/response_spectrum.h"
#include "groundmotions/measures/rotation.h"

namespace gurney {

namespace {

Eigen::ArrayXd spectrum_of(const Record& record, Direction direction,
                           const Eigen::VectorXd& periods) {
  const auto& component = record[direction];
  require(component.has_value(),
          "record '" + record.name + "' has no " + name_of(direction) + " component");
  return response_spectrum(component->time_step, component->acceleration, periods)
      .pseudo_acceleration;
}

}  // namespace

Eigen::VectorXd combined_spectrum(Combination combination, const Record& record,
                                  const Eigen::VectorXd& periods) {
  switch (combination) {
    case Combination::kH1:
      return spectrum_of(record, Direction::kH1, periods);
    case Combination::kH2:
      return spectrum_of(record, Direction::kH2, periods);
    case Combination::kVertical:
      return spectrum_of(record, Direction::kVertical, periods);
    case Combination::kRotD00:
      return rot_d_spectrum(record, periods).d00;
    case Combination::kRotD50:
      return rot_d_spectrum(record, periods).d50;
    case Combination::kRotD100:
      return rot_d_spectrum(record, periods).d100;
    default:
      break;
  }
  const Eigen::ArrayXd a = spectrum_of(record, Direction::kH1, periods);
  const Eigen::ArrayXd b = spectrum_of(record, Direction::kH2, periods);
  if (combination == Combination::kGeometricMean) return (a * b).sqrt();
  if (combination == Combination::kLarger) return a.max(b);
  return (a.square() + b.square()).sqrt();
}

}  // namespace gurney
