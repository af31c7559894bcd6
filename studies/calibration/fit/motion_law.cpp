#include "studies/calibration/fit/motion_law.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

namespace gurney::calibration {
namespace {

constexpr std::size_t kFewest = 24;
constexpr double kFarthest = 0.3, kClocks = 0.05;  // [s]
constexpr double kSure = 50;                       // variances
constexpr double kNear = 3;                        // a factor, of s from 1 with a lag
constexpr Eigen::Index kScale = 3;                 // column

struct Fit {
  double squares = 0, scale = 1, scale_error = 0;
};

/// The force `shift` samples later; its ends go on.
Fit fit(const TrialSignals& s, const Span& span, double inertia, std::ptrdiff_t shift) {
  const auto n = static_cast<Eigen::Index>(span.size());
  const auto last = static_cast<std::ptrdiff_t>(s.force.size()) - 1;
  const auto force = [&](std::size_t k) {
    return s.force[static_cast<std::size_t>(
        std::clamp<std::ptrdiff_t>(static_cast<std::ptrdiff_t>(k) + shift, 0, last))];
  };
  const double whole = s.time[span.end - 1] - s.time[span.begin];
  Eigen::Matrix<double, Eigen::Dynamic, 4> columns(n, 4);
  Eigen::VectorXd x(n);
  double once = 0, twice = 0;
  for (Eigen::Index i = 0; i < n; ++i) {
    const std::size_t k = span.begin + static_cast<std::size_t>(i);
    const double t = (s.time[k] - s.time[span.begin]) / whole;
    if (i > 0) {
      const double dt = s.time[k] - s.time[k - 1];
      twice += dt * (once + dt * (2 * force(k - 1) + force(k)) / 6);
      once += dt * (force(k - 1) + force(k)) / 2;
    }
    columns.row(i) << 1, t, t * t, twice / inertia;
    x[i] = s.displacement[k];
  }
  const Eigen::Matrix4d normal = columns.transpose() * columns;
  const Eigen::LDLT<Eigen::Matrix4d> factor(normal);
  const Eigen::Vector4d c = factor.solve(columns.transpose() * x);
  const double squares = (x - columns * c).squaredNorm();
  const double variance = squares / static_cast<double>(n - 4);
  return {squares, c[kScale],
          std::sqrt(variance * factor.solve(Eigen::Vector4d::Unit(kScale))[kScale])};
}

}  // namespace

std::optional<MotionLaw> motion_law(const TrialSignals& s, const Span& span, double inertia) {
  if (span.size() < kFewest) return {};
  const double step = (s.time.back() - s.time.front()) / static_cast<double>(s.time.size() - 1);
  const Fit plain = fit(s, span, inertia, 0);
  double least = plain.squares;
  std::ptrdiff_t best = 0;
  const auto most = static_cast<std::ptrdiff_t>(kFarthest / step);
  for (std::ptrdiff_t shift = -most; shift <= most; ++shift) {
    const Fit shifted = fit(s, span, inertia, shift);
    if (std::abs(std::log(shifted.scale)) < std::log(kNear) && shifted.squares < least) {
      least = shifted.squares;
      best = shift;
    }
  }
  const double variance = least / static_cast<double>(span.size() - 5);
  const double lag = static_cast<double>(best) * step;
  const bool sure = plain.squares - least > kSure * variance && std::abs(lag) > kClocks;
  return MotionLaw{plain.scale, plain.scale_error, sure ? lag : 0};
}

}  // namespace gurney::calibration
