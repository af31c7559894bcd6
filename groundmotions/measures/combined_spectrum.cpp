#include "groundmotions/measures/combined_spectrum.h"

#include "engine/base/error.h"
#include "groundmotions/measures/response_spectrum.h"
#include "groundmotions/measures/rotation.h"

namespace gurney::groundmotions {

Eigen::VectorXd combined_spectrum(Combination combination, const Record& record,
                                  const Eigen::VectorXd& periods, double damping) {
  const double dt = record.time_step();
  const auto acceleration = [&](Direction direction) -> const Eigen::VectorXd& {
    return acceleration_of(record, direction,
                           std::string("a ") + name_of(combination) + " spectrum");
  };
  const auto psa = [&](Direction direction) -> Eigen::ArrayXd {
    return response_spectrum(dt, acceleration(direction), periods, damping).pseudo_acceleration;
  };
  const auto rotated = [&] {
    return rotated_spectrum(dt, acceleration(Direction::kH1), acceleration(Direction::kH2), periods,
                            damping);
  };
  switch (combination) {
    case Combination::kH1:
      return psa(Direction::kH1);
    case Combination::kH2:
      return psa(Direction::kH2);
    case Combination::kVertical:
      return psa(Direction::kVertical);
    case Combination::kGeometricMean:
      return (psa(Direction::kH1) * psa(Direction::kH2)).sqrt();
    case Combination::kLarger:
      return psa(Direction::kH1).max(psa(Direction::kH2));
    case Combination::kSrss:
      return (psa(Direction::kH1).square() + psa(Direction::kH2).square()).sqrt();
    case Combination::kRotD00:
      return rotated().rotd00;
    case Combination::kRotD50:
      return rotated().rotd50;
    case Combination::kRotD100:
      return rotated().rotd100;
    case Combination::kResultant:
      break;
  }
  throw Error("a spectrum has no resultant; RotD100 is its largest value over the angles");
}

}  // namespace gurney::groundmotions
