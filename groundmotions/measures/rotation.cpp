#include "groundmotions/measures/rotation.h"

#include <algorithm>
#include <cassert>
#include <cstring>
#include <numbers>
#include <vector>

#include "engine/base/units.h"
#include "groundmotions/measures/response_spectrum.h"

namespace gurney::groundmotions {
namespace {

struct Directions {
  RotatedValues cosine, sine;
};

const Directions& directions() {
  static const Directions all = [] {
    const RotatedValues angle =
        RotatedValues::LinSpaced(0, kRotationAngles - 1) * kRadiansPerDegree;
    return Directions{angle.cos(), angle.sin()};
  }();
  return all;
}

/// The place of a known value; faster than a search for the largest together with its place.
template <class Values>
Eigen::Index first_with(const Values& values, double value) {
  Eigen::Index i = 0;
  while (i + 1 < values.size() && values.coeff(i) != value) ++i;
  return i;
}

/// A column for each sample, a row for each oscillator.
using Histories = Eigen::Matrix<double, kLanes, Eigen::Dynamic>;

void find_displacements(const OscillatorPack& pack, const Eigen::VectorXd& load,
                        Histories& result) {
  result.resize(kLanes, load.size());
  Lanes u{}, v{};
  for (Eigen::Index i = 0; i < load.size(); ++i) {
    if (i > 0) pack.step(load[i - 1], load[i], u, v);
    std::memcpy(result.col(i).data(), &u, sizeof u);
  }
}

}  // namespace

Eigen::Vector2d rotation_direction(int index) {
  return {directions().cosine[index], directions().sine[index]};
}

double percentile(const RotatedValues& values, double percent) {
  assert(percent >= 0 && percent <= 100);
  RotatedValues ordered = values;
  std::sort(ordered.begin(), ordered.end());
  const double place = percent / 100 * (kRotationAngles - 1);
  const int below = static_cast<int>(place);
  const int above = std::min(below + 1, kRotationAngles - 1);
  return ordered[below] + (place - below) * (ordered[above] - ordered[below]);
}

// A point nearer to the origin than the peak of every angle changes none. What is known first of
// these peaks: let P be the farthest point and Q that with the largest distance from the line OP;
// the peaks of the parallelogram +-P, +-Q are at least the distance of its sides from the origin,
// |P x Q| / |P -+ Q|. Some of the points that are left then show nearly all peaks.
RotatedValues rotated_peaks(const Eigen::Ref<const Eigen::VectorXd>& x,
                            const Eigen::Ref<const Eigen::VectorXd>& y) {
  assert(x.size() == y.size());
  RotatedValues peaks = RotatedValues::Zero();
  if (x.size() == 0) return peaks;
  const auto squares = x.array().square() + y.array().square();  // never stored
  const double farthest = squares.maxCoeff();
  if (farthest == 0) return peaks;
  const Eigen::Index far = first_with(squares, farthest);
  const auto distances = (x[far] * y.array() - y[far] * x.array()).abs();
  const double cross = distances.maxCoeff();
  const Eigen::Index aside = first_with(distances, cross);
  const Eigen::Vector2d p(x[far], y[far]), q(x[aside], y[aside]);
  // The last factor keeps points that rounding would leave out.
  const double bound = cross / std::max((p - q).norm(), (p + q).norm()) * (1 - 1e-9);

  std::vector<Eigen::Index> points;
  for (Eigen::Index i = 0; i < x.size(); ++i)
    if (squares.coeff(i) >= bound * bound) points.push_back(i);
  const auto take = [&](Eigen::Index i) {
    peaks = peaks.max((x[i] * directions().cosine + y[i] * directions().sine).abs());
  };
  constexpr std::size_t kStride = 16;
  for (std::size_t k = 0; k < points.size(); k += kStride) take(points[k]);
  const double smallest = peaks.minCoeff();
  for (const Eigen::Index i : points)
    if (squares.coeff(i) >= smallest * smallest) take(i);
  return peaks;
}

RotatedSpectrum rotated_spectrum(double time_step, const Eigen::VectorXd& h1,
                                 const Eigen::VectorXd& h2, const Eigen::VectorXd& periods,
                                 double damping) {
  // Checks the arguments, and serves T = 0.
  response_spectrum(time_step, Eigen::VectorXd(), periods, damping);
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
  Histories u1, u2;
  for (std::size_t first = 0; first < swinging.size(); first += kLanes) {
    const std::size_t count = std::min<std::size_t>(kLanes, swinging.size() - first);
    OscillatorPack pack;
    for (std::size_t i = 0; i < kLanes; ++i)
      pack.set(i, oscillator_step(2 * std::numbers::pi / periods[swinging[first + i % count]],
                                  damping, time_step));
    find_displacements(pack, h1, u1);
    find_displacements(pack, h2, u2);
    for (std::size_t i = 0; i < count; ++i) {
      const double omega = 2 * std::numbers::pi / periods[swinging[first + i]];
      const auto lane = static_cast<Eigen::Index>(i);
      keep(swinging[first + i], rotated_peaks(u1.row(lane).transpose(), u2.row(lane).transpose()),
           omega * omega);
    }
  }
  return result;
}

}  // namespace gurney::groundmotions
