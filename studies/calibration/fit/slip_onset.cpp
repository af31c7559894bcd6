#include "studies/calibration/fit/slip_onset.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

#include "engine/base/linear_algebra.h"

namespace gurney::calibration {
namespace {

constexpr double kGrid = 1e-3, kCoarse = 1e-2, kBefore = 0.3;  // [s]
constexpr double kLeastLeft = 0.05;                            // of the window after an onset [s]

/// Once and twice integrated force from the window's begin.
class Integrals {
 public:
  Integrals(const TrialSignals& s, const Span& window) : t_(s.time), f_(s.force), window_(window) {
    once_.push_back(0);
    twice_.push_back(0);
    for (std::size_t i = window.begin; i + 1 < window.end; ++i) {
      const double dt = t_[i + 1] - t_[i];
      twice_.push_back(twice_.back() + dt * (once_.back() + dt * (2 * f_[i] + f_[i + 1]) / 6));
      once_.push_back(once_.back() + dt * (f_[i] + f_[i + 1]) / 2);
    }
  }

  struct At {
    double once, twice;
  };
  At at(double time) const {
    const auto first = t_.begin() + static_cast<std::ptrdiff_t>(window_.begin);
    const auto last = t_.begin() + static_cast<std::ptrdiff_t>(window_.end);
    const auto i = static_cast<std::size_t>(
        std::max<std::ptrdiff_t>(std::upper_bound(first, last, time) - first - 1, 0));
    const std::size_t k = window_.begin + std::min(i, window_.size() - 2);
    const double s = time - t_[k], slope = (f_[k + 1] - f_[k]) / (t_[k + 1] - t_[k]);
    const double g = once_[k - window_.begin], h = twice_[k - window_.begin];
    return {g + s * (f_[k] + s * slope / 2), h + s * (g + s * (f_[k] / 2 + s * slope / 6))};
  }
  const std::vector<double>& twice() const { return twice_; }

 private:
  const std::vector<double>&t_, &f_;
  Span window_;
  std::vector<double> once_, twice_;
};

struct Fit {
  double squares = 0;
  double scale = 1, scale_error = 0;
};

/// In motion, and when the force of the cable first is as large.
struct Resisting {
  double force, overcome;
};

/// Crosses `level` on the line through the 0.3 s on either side of where means of 0.1 s do; the
/// window's begin where it never is below.
double crossing_of(const TrialSignals& s, const Span& window, double level) {
  const auto half = static_cast<std::size_t>(0.05 * static_cast<double>(window.size()) /
                                             (s.time[window.end - 1] - s.time[window.begin]));
  std::size_t i = window.begin + half;
  for (; i + half < window.end; ++i) {
    double sum = 0;
    for (std::size_t k = i - half; k <= i + half; ++k) sum += s.force[k];
    if (sum > level * static_cast<double>(2 * half + 1)) break;
  }
  if (i == window.begin + half || i + half >= window.end) return s.time[window.begin];
  const auto index = [&](double time) {
    return std::clamp(
        static_cast<std::size_t>(std::ranges::lower_bound(s.time, time) - s.time.begin()),
        window.begin, window.end);
  };
  const PolynomialFit line =
      fit_polynomial(s.time, s.force, {index(s.time[i] - kBefore), index(s.time[i] + kBefore)}, 1);
  return line.middle + (level - line.c[0]) / line.c[1];
}

class Onset {
 public:
  Onset(const TrialSignals& s, const Span& window, double inertia)
      : s_(s), window_(window), inertia_(inertia), integrals_(s, window) {}

  /// Before the force reaches the resistance the motion is the mirror image, about that of an
  /// onset at this time, of the one as long after it.
  Fit fit(double onset, const Resisting& resisting, bool free) const {
    const auto n = static_cast<Eigen::Index>(window_.size());
    const double overcome = resisting.overcome;
    const auto moves = [&](double from, Eigen::Index i) {
      const double t = s_.time[window_.begin + static_cast<std::size_t>(i)] - from;
      if (t <= 0) return 0.0;
      const Integrals::At at = integrals_.at(from);
      return (integrals_.twice()[static_cast<std::size_t>(i)] - at.twice - at.once * t -
              resisting.force * t * t / 2) /
             inertia_;
    };
    Eigen::MatrixXd columns(n, free ? 3 : 2);
    Eigen::VectorXd x(n), moved(n);
    for (Eigen::Index i = 0; i < n; ++i) {
      const std::size_t k = window_.begin + static_cast<std::size_t>(i);
      const double t = s_.time[k] - onset;
      columns(i, 0) = 1;
      columns(i, 1) = t;
      x[i] = s_.displacement[k];
      moved[i] = onset < overcome ? 2 * moves(overcome, i) - moves(2 * overcome - onset, i)
                                  : moves(onset, i);
    }
    if (free)
      columns.col(2) = moved;
    else
      x -= moved;
    const Eigen::MatrixXd normal = columns.transpose() * columns;
    const SymmetricFactors factors(normal);
    const Eigen::VectorXd c = factors.solve(Eigen::VectorXd(columns.transpose() * x));
    const double squares = (x - columns * c).squaredNorm();
    if (!free) return {squares};
    const double variance = squares / static_cast<double>(n - 4);
    return {squares, c[2],
            std::sqrt(variance * factors.solve(Eigen::VectorXd(Eigen::Vector3d::UnitZ()))[2])};
  }

  struct Best {
    double time = 0, low = 0, high = 0;
    Fit fit;
  };
  /// The least on a grid of 10 ms, then of 1 ms about it.
  Best best(double from, double to, const Resisting& resisting, bool free) const {
    const auto squares = [&](double onset) { return fit(onset, resisting, free).squares; };
    const auto least_of = [&](double begin, double end, double step) {
      double at = begin, least = squares(begin);
      for (double t = begin + step; t <= end; t += step)
        if (const double here = squares(t); here < least) {
          at = t;
          least = here;
        }
      return at;
    };
    const double coarse = least_of(from, to, kCoarse);
    const double time =
        least_of(std::max(from, coarse - kCoarse), std::min(to, coarse + kCoarse), kGrid);
    const Fit least = fit(time, resisting, free);
    const double allowed = least.squares * (1 + 1 / static_cast<double>(window_.size() - 4));
    double low = time, high = time;
    while (low - kGrid > from && squares(low - kGrid) < allowed) low -= kGrid;
    while (high + kGrid < to && squares(high + kGrid) < allowed) high += kGrid;
    return {time, low, high, least};
  }

 private:
  const TrialSignals& s_;
  Span window_;
  double inertia_;
  Integrals integrals_;
};

}  // namespace

std::optional<SlipOnset> find_onset(const TrialSignals& s, const Span& window, double inertia,
                                    double resisting, double resisting_error, bool free) {
  if (window.size() < 24) return {};
  const double from = s.time[window.begin] + kBefore, to = s.time[window.end - 1] - kLeastLeft;
  if (!(to - from > kBefore - kLeastLeft)) return {};
  const Onset onset(s, window, inertia);
  const auto with = [&](double force) { return Resisting{force, crossing_of(s, window, force)}; };
  const Onset::Best best = onset.best(from, to, with(resisting), free);
  const double shifted =
      onset
          .best(std::max(from, best.time - kBefore), std::min(to, best.time + kBefore),
                with(resisting + resisting_error), free)
          .time;
  const auto index = [&](double time) {
    return static_cast<std::size_t>(std::ranges::lower_bound(s.time, time) - s.time.begin());
  };
  const Span before{index(best.time - kBefore), index(best.time)};
  const PolynomialFit line = fit_polynomial(s.time, s.force, before, 1);
  SlipOnset result;
  result.time = best.time;
  result.force = line.value(best.time);
  const double lever = best.time - line.middle;
  const double of_line = std::sqrt(line.covariance(0, 0) + lever * lever * line.covariance(1, 1));
  result.force_error = std::hypot(of_line, line.c[1] * (best.high - best.low + kGrid) / 2,
                                  line.c[1] * (shifted - best.time));
  return result;
}

}  // namespace gurney::calibration
