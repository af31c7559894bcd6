#include "groundmotions/measures/combination.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/base/error.h"
#include "engine/config/nearest_name.h"
#include "groundmotions/measures/measure.h"
#include "groundmotions/measures/peaks.h"
#include "groundmotions/measures/response_spectrum.h"
#include "groundmotions/measures/rotation.h"

namespace gurney::groundmotions {
namespace {

constexpr std::pair<Combination, const char*> kNames[] = {
    {Combination::kH1, "h1"},
    {Combination::kH2, "h2"},
    {Combination::kVertical, "vertical"},
    {Combination::kGeometricMean, "geomean"},
    {Combination::kLarger, "larger"},
    {Combination::kSrss, "SRSS"},
    {Combination::kRotD00, "RotD00"},
    {Combination::kRotD50, "RotD50"},
    {Combination::kRotD100, "RotD100"},
    {Combination::kResultant, "resultant"},
};

bool is_rotated(Combination combination) {
  return combination == Combination::kRotD00 || combination == Combination::kRotD50 ||
         combination == Combination::kRotD100;
}

double percent_of(Combination combination) {
  if (combination == Combination::kRotD00) return 0;
  return combination == Combination::kRotD50 ? 50 : 100;
}

double resultant(const Measure& measure, double time_step, const Eigen::VectorXd& h1,
                 const Eigen::VectorXd& h2) {
  require(has_resultant(measure),
          name_of(measure) + ": only PGA, PGV, PGD, PFA and PFV have a resultant");
  const Peaks largest = peaks(time_step, h1, h2);
  if (measure.kind == MeasureKind::kPgd) return largest.displacement;
  const bool is_velocity = measure.kind == MeasureKind::kPgv || measure.kind == MeasureKind::kPfv;
  return is_velocity ? largest.velocity : largest.acceleration;
}

}  // namespace

const Eigen::VectorXd& acceleration_of(const Record& record, Direction direction,
                                       const std::string& what) {
  require(record[direction].has_value(),
          fmt::format("record '{}' has no component {}, needed for {}", record.name,
                      name_of(direction), what));
  return record[direction]->acceleration;
}

const char* name_of(Combination combination) {
  for (const auto& [each, name] : kNames)
    if (each == combination) return name;
  return "";
}

bool has_resultant(const Measure& measure) {
  switch (measure.kind) {
    case MeasureKind::kPga:
    case MeasureKind::kPgv:
    case MeasureKind::kPgd:
    case MeasureKind::kPfa:
    case MeasureKind::kPfv:
      return true;
    default:
      return false;
  }
}

std::vector<std::string> known_combinations() {
  std::vector<std::string> result;
  for (const auto& [combination, name] : kNames) result.push_back(name);
  return result;
}

Combination parse_combination(std::string_view text) {
  for (const auto& [combination, name] : kNames)
    if (plain_name(name) == plain_name(text)) return combination;
  throw Error("component '" + std::string(text) + "': unknown component or combination" +
              config::suggestion(std::string(text), known_combinations()));
}

// Integration is linear: the velocity of a turned motion is the turned velocity.
RotatedValues rotated_values(const Measure& measure, double time_step, const Eigen::VectorXd& h1,
                             const Eigen::VectorXd& h2) {
  switch (measure.kind) {
    case MeasureKind::kPga:
    case MeasureKind::kPfa:
      return rotated_peaks(h1, h2);
    case MeasureKind::kPgv:
    case MeasureKind::kPfv:
      return rotated_peaks(integrated(time_step, h1).velocity, integrated(time_step, h2).velocity);
    case MeasureKind::kPgd:
      return rotated_peaks(integrated(time_step, h1).displacement,
                           integrated(time_step, h2).displacement);
    default:
      break;
  }
  RotatedValues values;
  for (int i = 0; i < kRotationAngles; ++i) {
    const Eigen::Vector2d direction = rotation_direction(i);
    values[i] = value_of(measure, time_step, direction.x() * h1 + direction.y() * h2);
  }
  return values;
}

double value_of(const Measure& measure, Combination combination, const Record& record) {
  const double dt = record.time_step();
  const auto acceleration = [&](Direction direction) -> const Eigen::VectorXd& {
    return acceleration_of(record, direction, name_of(measure) + " " + name_of(combination));
  };
  if (combination == Combination::kH1) return value_of(measure, dt, acceleration(Direction::kH1));
  if (combination == Combination::kH2) return value_of(measure, dt, acceleration(Direction::kH2));
  if (combination == Combination::kVertical)
    return value_of(measure, dt, acceleration(Direction::kVertical));

  const Eigen::VectorXd &h1 = acceleration(Direction::kH1), &h2 = acceleration(Direction::kH2);
  if (combination == Combination::kResultant) return resultant(measure, dt, h1, h2);
  require(combination != Combination::kSrss || scaling_power(measure) > 0,
          name_of(measure) + ": SRSS of durations and periods has no meaning");
  if (const Eigen::VectorXd periods = spectral_periods(measure); periods.size() > 0)
    return geometric_mean(combined_spectrum(combination, record, periods, measure.damping));
  if (is_rotated(combination))
    return percentile(rotated_values(measure, dt, h1, h2), percent_of(combination));
  const double v1 = value_of(measure, dt, h1), v2 = value_of(measure, dt, h2);
  if (combination == Combination::kLarger) return std::max(v1, v2);
  if (combination == Combination::kSrss) return std::hypot(v1, v2);
  return std::sqrt(v1 * v2);
}

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
