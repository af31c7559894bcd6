#include "groundmotions/processing/rotate.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "engine/base/error.h"
#include "engine/base/units.h"

namespace gurney::groundmotions {

namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kRightAngle = kPi / 2;
constexpr double kSmallestAngle = 30 * kRadiansPerDegree;
constexpr double kSameAngle = 1e-6;  // [rad]

Component& component(Record& record, Direction direction) {
  return *record.components[static_cast<std::size_t>(direction)];
}

/// An angle in [0, 2 pi).
double wrapped(double azimuth) {
  const double turns = azimuth - 2 * kPi * std::floor(azimuth / (2 * kPi));
  return 2 * kPi - turns < kSameAngle / 1000 ? 0 : turns;
}

/// "030", or "030.5" where it is not a whole degree.
std::string degrees(double azimuth) {
  const double value = std::round(wrapped(azimuth) / kRadiansPerDegree * 10) / 10;
  const double shown = value >= 360 ? 0 : value;
  return shown == std::round(shown) ? fmt::format("{:03.0f}", shown)
                                    : fmt::format("{:05.1f}", shown);
}

bool has_horizontals(const Record& record) {
  return record[Direction::kH1] && record[Direction::kH2];
}

bool has_azimuths(const Record& record) {
  return has_horizontals(record) && record[Direction::kH1]->azimuth &&
         record[Direction::kH2]->azimuth;
}

}  // namespace

Record orthogonal_horizontals(Record record) {
  if (!has_azimuths(record)) return record;
  const Component& h1 = component(record, Direction::kH1);
  Component& h2 = component(record, Direction::kH2);
  const double z1 = *h1.azimuth, z2 = *h2.azimuth;
  const double apart = std::remainder(z1 - z2, 2 * kPi);  // counter-clockwise from h1 to h2
  if (std::abs(apart - kRightAngle) < kSameAngle) return record;
  if (std::abs(apart + kRightAngle) < kSameAngle) {
    record.processing.push_back(
        fmt::format("h2 ({}) negated: its azimuth {} is 90 degrees clockwise of h1 ({}), now {}",
                    h2.name, degrees(z2), degrees(z1), degrees(z2 + kPi)));
    h2.acceleration = -h2.acceleration;
  } else {
    require(std::abs(std::sin(apart)) >= std::sin(kSmallestAngle),
            fmt::format("{} and {}: the horizontals have azimuths of {} and {} degrees, less than "
                        "{:.0f} degrees from parallel: the motion across them cannot be determined",
                        h1.file, h2.file, degrees(z1), degrees(z2),
                        kSmallestAngle / kRadiansPerDegree));
    // a2 = cos(apart) a1 + sin(apart) a_h2
    h2.acceleration =
        ((h2.acceleration - std::cos(apart) * h1.acceleration) / std::sin(apart)).eval();
    record.processing.push_back(
        fmt::format("h2 resolved at a right angle to h1: azimuths {} and {} became {} and {}",
                    degrees(z1), degrees(z2), degrees(z1), degrees(z1 - kRightAngle)));
  }
  h2.azimuth = wrapped(z1 - kRightAngle);
  h2.name = degrees(*h2.azimuth);
  return record;
}

Record rotated_by(Record record, double angle) {
  require(std::isfinite(angle), "the angle to rotate by must be finite");
  require(has_horizontals(record), "only a record with h1 and h2 can be rotated");
  Component& h1 = component(record, Direction::kH1);
  Component& h2 = component(record, Direction::kH2);
  const Eigen::VectorXd a1 = h1.acceleration, a2 = h2.acceleration;
  h1.acceleration = std::cos(angle) * a1 + std::sin(angle) * a2;
  h2.acceleration = -std::sin(angle) * a1 + std::cos(angle) * a2;
  for (Component* each : {&h1, &h2}) {
    if (each->azimuth) each->azimuth = wrapped(*each->azimuth - angle);
    each->name = each->azimuth ? degrees(*each->azimuth) : "";
  }
  record.processing.push_back(fmt::format(
      "horizontals rotated by {:.6g} degrees counter-clockwise{}", angle / kRadiansPerDegree,
      h1.azimuth ? fmt::format(", h1 to azimuth {}", h1.name) : std::string()));
  return record;
}

Record rotate_to(Record record, double azimuth_of_h1) {
  require(std::isfinite(azimuth_of_h1), "the azimuth to rotate to must be finite");
  require(
      has_azimuths(record),
      "only a record with azimuths of h1 and h2 can be rotated to an azimuth; rotate by an angle "
      "instead");
  record = orthogonal_horizontals(std::move(record));
  const double azimuth = *record[Direction::kH1]->azimuth;
  return rotated_by(std::move(record), azimuth - azimuth_of_h1);
}

Record rotate_to_fault(Record record, double strike) {
  record = rotate_to(std::move(record), strike + kRightAngle);
  component(record, Direction::kH1).name = "fault-normal";
  component(record, Direction::kH2).name = "fault-parallel";
  record.processing.back() +=
      fmt::format(": h1 normal, h2 parallel to the fault of strike {}", degrees(strike));
  return record;
}

}  // namespace gurney::groundmotions
