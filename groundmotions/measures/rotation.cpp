#include "groundmotions/measures/rotation.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>
#include <vector>

#include "engine/base/units.h"
#include "groundmotions/measures/oscillator_pack.h"
#include "groundmotions/measures/response_spectrum.h"

namespace gurney {
namespace {

void raise_to_peaks(RotatedValues& peaks, const Eigen::Vector2d& point) {
  for (int i = 0; i < kRotationAngles; ++i)
    peaks[static_cast<std::size_t>(i)] =
        std::max(peaks[static_cast<std::size_t>(i)], std::abs(point.dot(rotation_direction(i))));
}

/// The histories of the displacement of `lanes` oscillators, one in each column.
Eigen::MatrixXd displacements(const OscillatorPack& pack, const Eigen::VectorXd& load) {
  Eigen::MatrixXd result(load.size(), OscillatorPack::kLanes);
  OscillatorPack::Lanes u = OscillatorPack::Lanes::Zero(), v = u;
  for (Eigen::Index i = 0; i < load.size(); ++i) {
    if (i > 0) pack.step(load[i - 1], load[i], u, v);
    result.row(i) = u.transpose();
  }
  return result;
}

}  // namespace

Eigen::Vector2d rotation_direction(int index) {
  static const auto directions = [] {
    std::array<Eigen::Vector2d, kRotationAngles> result;
    for (int i = 0; i < kRotationAngles; ++i)
      result[static_cast<std::size_t>(i)] = {std::cos(i * kRadiansPerDegree),
                                             std::sin(i * kRadiansPerDegree)};
    return result;
  }();
  return directions[static_cast<std::size_t>(index)];
}

double percentile(RotatedValues values, double percent) {
  assert(percent >= 0 && percent <= 100);
  std::sort(values.begin(), values.end());
  const double place = percent / 100 * (kRotationAngles - 1);
  const auto below = static_cast<std::size_t>(place);
  const auto above = std::min<std::size_t>(below + 1, kRotationAngles - 1);
  return values[below] + (place - static_cast<double>(below)) * (values[above] - values[below]);
}

// The extreme points in a few directions bound the peaks from below. A point that lies nearer to
// the origin than the smallest of these bounds cannot be a peak; few points are left.
RotatedValues rotated_peaks(const Eigen::Ref<const Eigen::VectorXd>& x,
                            const Eigen::Ref<const Eigen::VectorXd>& y) {
  assert(x.size() == y.size());
  RotatedValues peaks{};
  if (x.size() == 0) return peaks;
  constexpr int kStride = 15;  // degrees between the few directions
  for (int i = 0; i < kRotationAngles; i += kStride) {
    const Eigen::Vector2d direction = rotation_direction(i);
    Eigen::Index at = 0;
    (direction.x() * x.array() + direction.y() * y.array()).abs().maxCoeff(&at);
    raise_to_peaks(peaks, {x[at], y[at]});
  }
  const double bound = *std::min_element(peaks.begin(), peaks.end());
  for (Eigen::Index i = 0; i < x.size(); ++i)
    if (x[i] * x[i] + y[i] * y[i] > bound * bound) raise_to_peaks(peaks, {x[i], y[i]});
  return peaks;
}

RotatedSpectrum rotated_spectrum(double time_step, const Eigen::VectorXd& h1,
                                 const Eigen::VectorXd& h2, const Eigen::VectorXd& periods,
                                 double damping) {
  // Checks the arguments, and serves T = 0.
  response_spectrum(time_step, Eigen::VectorXd(), periods, damping);
  constexpr Eigen::Index kLanes = OscillatorPack::kLanes;
  RotatedSpectrum result{periods, periods, periods, periods};
  const auto keep = [&](Eigen::Index at, const RotatedValues& peaks, double factor) {
    result.rotd00[at] = factor * percentile(peaks, 0);
    result.rotd50[at] = factor * percentile(peaks, 50);
    result.rotd100[at] = factor * percentile(peaks, 100);
  };
  std::vector<Eigen::Index> swinging;
  for (Eigen::Index i = 0; i < periods.size(); ++i) {
    if (periods[i] > 0)
      swinging.push_back(i);
    else
      keep(i, rotated_peaks(h1, h2), 1);
  }
  for (std::size_t first = 0; first < swinging.size(); first += kLanes) {
    const std::size_t count = std::min<std::size_t>(kLanes, swinging.size() - first);
    OscillatorPack pack;
    for (std::size_t i = 0; i < kLanes; ++i)
      pack.set(static_cast<int>(i),
               oscillator_step(2 * std::numbers::pi / periods[swinging[first + i % count]], damping,
                               time_step));
    const Eigen::MatrixXd u1 = displacements(pack, h1), u2 = displacements(pack, h2);
    for (std::size_t i = 0; i < count; ++i) {
      const double omega = 2 * std::numbers::pi / periods[swinging[first + i]];
      const auto lane = static_cast<Eigen::Index>(i);
      keep(swinging[first + i], rotated_peaks(u1.col(lane), u2.col(lane)), omega * omega);
    }
  }
  return result;
}

}  // namespace gurney
