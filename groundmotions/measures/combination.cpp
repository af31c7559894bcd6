#include "groundmotions/measures/combination.h"

#include <algorithm>
#include <cmath>

#include "engine/base/config/nearest_name.h"
#include "engine/base/error.h"
#include "groundmotions/measures/peaks.h"
#include "groundmotions/measures/plain_name.h"
#include "groundmotions/measures/response_spectrum.h"
#include "groundmotions/measures/rotation.h"
#include "groundmotions/measures/spectral_averages.h"

namespace gurney {
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

const Eigen::VectorXd& acceleration(const Record& record, Direction direction, const Measure& m,
                                    Combination combination) {
  require(record[direction].has_value(),
          "record '" + record.name + "': " + name_of(m) + " " + name_of(combination) +
              " needs the component " + name_of(direction) + ", which the record does not have");
  return record[direction]->acceleration;
}

bool is_rotated(Combination combination) {
  return combination == Combination::kRotD00 || combination == Combination::kRotD50 ||
         combination == Combination::kRotD100;
}

double percent_of(Combination combination) {
  if (combination == Combination::kRotD00) return 0;
  return combination == Combination::kRotD50 ? 50 : 100;
}

double rotated(const Measure& measure, double percent, double time_step, const Eigen::VectorXd& h1,
               const Eigen::VectorXd& h2) {
  RotatedValues values;
  for (int i = 0; i < kRotationAngles; ++i) {
    const Eigen::Vector2d direction = rotation_direction(i);
    values[i] = value_of(measure, time_step, direction.x() * h1 + direction.y() * h2);
  }
  return percentile(values, percent);
}

/// Sa and SaAvg: the combination is taken at each period.
double combined_spectrum(const Measure& measure, Combination combination, double time_step,
                         const Eigen::VectorXd& h1, const Eigen::VectorXd& h2) {
  const Eigen::VectorXd periods = spectral_periods(measure);
  if (is_rotated(combination)) {
    const RotatedSpectrum s = rotated_spectrum(time_step, h1, h2, periods, measure.damping);
    if (combination == Combination::kRotD00) return geometric_mean(s.rotd00);
    return geometric_mean(combination == Combination::kRotD50 ? s.rotd50 : s.rotd100);
  }
  const auto psa = [&](const Eigen::VectorXd& a) {
    return response_spectrum(time_step, a, periods, measure.damping).pseudo_acceleration;
  };
  const Eigen::ArrayXd s1 = psa(h1), s2 = psa(h2);
  if (combination == Combination::kLarger) return geometric_mean(s1.max(s2));
  if (combination == Combination::kSrss) return geometric_mean((s1 * s1 + s2 * s2).sqrt());
  return geometric_mean((s1 * s2).sqrt());
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

double value_of(const Measure& measure, Combination combination, const Record& record) {
  const double dt = record.time_step();
  const auto component = [&](Direction direction) -> const Eigen::VectorXd& {
    return acceleration(record, direction, measure, combination);
  };
  if (combination == Combination::kH1) return value_of(measure, dt, component(Direction::kH1));
  if (combination == Combination::kH2) return value_of(measure, dt, component(Direction::kH2));
  if (combination == Combination::kVertical)
    return value_of(measure, dt, component(Direction::kVertical));

  const Eigen::VectorXd &h1 = component(Direction::kH1), &h2 = component(Direction::kH2);
  if (combination == Combination::kResultant) return resultant(measure, dt, h1, h2);
  require(combination != Combination::kSrss || scaling_power(measure) > 0,
          name_of(measure) + ": SRSS of durations and periods has no meaning");
  if (spectral_periods(measure).size() > 0)
    return combined_spectrum(measure, combination, dt, h1, h2);
  if (is_rotated(combination)) return rotated(measure, percent_of(combination), dt, h1, h2);
  const double v1 = value_of(measure, dt, h1), v2 = value_of(measure, dt, h2);
  if (combination == Combination::kLarger) return std::max(v1, v2);
  if (combination == Combination::kSrss) return std::hypot(v1, v2);
  return std::sqrt(v1 * v2);
}

}  // namespace gurney
