#include "groundmotions/measures/rotation.h"

#include <algorithm>
#include <cmath>

#include "engine/base/error.h"
#include "engine/base/units.h"
#include "groundmotions/measures/response_spectrum.h"

namespace gurney {

namespace {

constexpr int kAngles = 180;

struct Direction2 {
  double cosine, sine;
};

const std::array<Direction2, kAngles>& directions() {
  static const auto table = [] {
    std::array<Direction2, kAngles> result{};
    for (int i = 0; i < kAngles; ++i) {
      const double angle = i * kRadiansPerDegree;
      result[static_cast<std::size_t>(i)] = {std::cos(angle), std::sin(angle)};
    }
    return result;
  }();
  return table;
}

double peak_along(const Eigen::ArrayXd& x, const Eigen::ArrayXd& y, const Direction2& d) {
  return x.size() == 0 ? 0 : (d.cosine * x + d.sine * y).abs().maxCoeff();
}

/// The samples that can be a peak in some direction. The peak along any angle is at least the peak
/// along the nearest of some directions 15 degrees apart, times cos(7.5 degrees), less what lies
/// across; a sample shorter than the least such peak cannot be one, as its projection is no longer
/// than itself.
void keep_candidates(Eigen::ArrayXd& x, Eigen::ArrayXd& y) {
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i < kAngles; i += 1)
    if (i % 15 == 0) least = std::min(least, peak_along(x, y, directions()[std::size_t(i)]));
  const Eigen::ArrayXd radius = (x.square() + y.square()).sqrt();
  // |p(a + b)| <= |p(a)| cos b + |p_across| sin b: a peak at an angle between can be smaller than
  // at its neighbours by this much at most.
  const double allowance = radius.maxCoeff() * std::sin(7.5 * kRadiansPerDegree);
  const double shortest = least * std::cos(7.5 * kRadiansPerDegree) - allowance;
  Eigen::Index kept = 0;
  for (Eigen::Index i = 0; i < x.size(); ++i) {
    if (radius[i] < shortest) continue;
    x[kept] = x[i];
    y[kept] = y[i];
    ++kept;
  }
  x.conservativeResize(kept);
  y.conservativeResize(kept);
}

}  // namespace

RotD rot_d(std::vector<double> peaks) {
  require(!peaks.empty(), "RotD needs at least one peak");
  std::ranges::sort(peaks);
  const std::size_t n = peaks.size();
  return {peaks.front(), (peaks[(n - 1) / 2] + peaks[n / 2]) / 2, peaks.back()};
}

RotD rot_d_of_histories(const Eigen::VectorXd& x, const Eigen::VectorXd& y) {
  require(x.size() == y.size(), "RotD needs two histories of equal length");
  Eigen::ArrayXd a = x.array(), b = y.array();
  if (a.size() > 0) keep_candidates(a, b);
  std::vector<double> peaks;
  for (const Direction2& direction : directions()) peaks.push_back(peak_along(a, b, direction));
  return rot_d(std::move(peaks));
}

RotDSpectrum rot_d_spectrum(const Record& record, const Eigen::VectorXd& periods, double damping) {
  require(record[Direction::kH1] && record[Direction::kH2],
          "RotD needs both horizontals; record '" + record.name + "' has not");
  const Component& h1 = *record[Direction::kH1];
  const Component& h2 = *record[Direction::kH2];
  const Eigen::Index count = periods.size();
  RotDSpectrum result{periods, Eigen::VectorXd(count), Eigen::VectorXd(count),
                      Eigen::VectorXd(count)};
  for (Eigen::Index i = 0; i < count; ++i) {
    const double period = periods[i];
    RotD peaks;
    double stiffness = 1;
    if (period == 0) {
      peaks = rot_d_of_histories(h1.acceleration, h2.acceleration);
    } else {
      stiffness = std::pow(2 * std::numbers::pi / period, 2);
      peaks = rot_d_of_histories(
          oscillator_displacement(h1.time_step, h1.acceleration, period, damping),
          oscillator_displacement(h2.time_step, h2.acceleration, period, damping));
    }
    result.d00[i] = stiffness * peaks.d00;
    result.d50[i] = stiffness * peaks.d50;
    result.d100[i] = stiffness * peaks.d100;
  }
  return result;
}

}  // namespace gurney
