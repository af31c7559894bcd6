#include "studies/calibration/fit/breakaway.h"

#include <fmt/format.h>

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <optional>

#include "engine/base/linear_algebra.h"
#include "engine/base/units.h"
#include "studies/calibration/trials/average_method.h"
#include "studies/calibration/trials/polynomial_fit.h"
#include "studies/calibration/trials/trial.h"
#include "studies/calibration/trials/trial_check.h"

namespace gurney::calibration {
namespace {

/// Force at which an item that is pulled ever harder begins to move.
struct SlipOnset {
  double force = 0, force_error = 0;  ///< of the cable at the onset, and its standard error [N]
};

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
    return std::clamp(index_at(s.time, time), window.begin, window.end);
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

/// Newton's law from the onset t_b on, with the measured force F and the resistance R in motion:
///
///     x(t) = x_b + v (t - t_b) + s int_{t_b}^t int_{t_b}^t' (F - R) / M dt'' dt',     s = 1
///
/// Least squares over `window` for every t_b on a grid of 1 ms; x_b and v (treads wind up) follow
/// linearly. F at t_b is a line through the 0.3 s before. Its error holds that of the line, the
/// line's slope times half of the range of t_b where the sum of squares is within one variance of
/// the least (a profile likelihood: Venzon & Moolgavkar 1988, Applied Statistics 37(1), 87-94), and
/// what `resisting_error` shifts.
///
/// A peak is no estimate of this force: the largest of noisy means is high, a mean over a rising
/// force low, and a winch pulls harder yet while the item gathers speed.
/// @param free  s is not 1: what accelerates the item loads or unloads the wheels that resist, in
///              proportion
/// @param window  0.6 s and more; the onset is found from 0.3 s after its begin on
/// @return nothing where the window is shorter
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
  const auto index = [&](double time) { return index_at(s.time, time); };
  const Span before{index(best.time - kBefore), index(best.time)};
  const PolynomialFit line = fit_polynomial(s.time, s.force, before, 1);
  SlipOnset result;
  result.force = line.value(best.time);
  const double lever = best.time - line.middle;
  const double of_line = std::sqrt(line.covariance(0, 0) + lever * lever * line.covariance(1, 1));
  result.force_error = std::hypot(of_line, line.c[1] * (best.high - best.low + kGrid) / 2,
                                  line.c[1] * (shifted - best.time));
  return result;
}

/// Newton's law between a force and a motion that were measured apart.
struct MotionLaw {
  double scale = 1, scale_error = 0;  ///< s: motion over what force and mass make of it
  double lag = 0;                     ///< of the force's clock behind the motion's, or 0 [s]
};

constexpr std::size_t kFewest = 24;
constexpr double kFarthest = 0.3, kClocks = 0.05;  // [s]
constexpr double kSure = 50;                       // variances
constexpr double kSureLag = 5;                     // standard errors
constexpr double kNear = 3;                        // a factor, of s from 1 with a lag
constexpr Eigen::Index kScale = 3;                 // column

struct LawFit {
  double squares = 0, scale = 1, scale_error = 0;
};

/// Displacement by the force alone, taken `shift` samples later: int int F dt dt / M. The force goes on
/// beyond its ends.
Eigen::VectorXd driven(const TrialSignals& s, const Span& span, double inertia,
                       std::ptrdiff_t shift) {
  const auto last = static_cast<std::ptrdiff_t>(s.force.size()) - 1;
  const auto force = [&](std::size_t k) {
    return s.force[static_cast<std::size_t>(
        std::clamp<std::ptrdiff_t>(static_cast<std::ptrdiff_t>(k) + shift, 0, last))];
  };
  Eigen::VectorXd moved(static_cast<Eigen::Index>(span.size()));
  double once = 0, twice = 0;
  moved[0] = 0;
  for (Eigen::Index i = 1; i < moved.size(); ++i) {
    const std::size_t k = span.begin + static_cast<std::size_t>(i);
    const double dt = s.time[k] - s.time[k - 1];
    twice += dt * (once + dt * (2 * force(k - 1) + force(k)) / 6);
    once += dt * (force(k - 1) + force(k)) / 2;
    moved[i] = twice / inertia;
  }
  return moved;
}

using LawColumns = Eigen::Matrix<double, Eigen::Dynamic, 4>;

LawColumns columns_of(const TrialSignals& s, const Span& span, const Eigen::VectorXd& moved) {
  const double whole = s.time[span.end - 1] - s.time[span.begin];
  LawColumns columns(moved.size(), 4);
  for (Eigen::Index i = 0; i < moved.size(); ++i) {
    const double t =
        (s.time[span.begin + static_cast<std::size_t>(i)] - s.time[span.begin]) / whole;
    columns.row(i) << 1, t, t * t, moved[i];
  }
  return columns;
}

LawFit fit(const TrialSignals& s, const Span& span, double inertia, std::ptrdiff_t shift) {
  const auto n = static_cast<Eigen::Index>(span.size());
  const LawColumns columns = columns_of(s, span, driven(s, span, inertia, shift));
  const Eigen::Map<const Eigen::VectorXd> x(&s.displacement[span.begin], n);
  const Eigen::Matrix4d normal = columns.transpose() * columns;
  const Eigen::LDLT<Eigen::Matrix4d> factor(normal);
  const Eigen::Vector4d c = factor.solve(columns.transpose() * x);
  const double squares = (x - columns * c).squaredNorm();
  const double variance = squares / static_cast<double>(n - 4);
  return {squares, c[kScale],
          std::sqrt(variance * factor.solve(Eigen::Vector4d::Unit(kScale))[kScale])};
}

/// Standard error of a lag, from what the noise of force and displacement does to the residuals in
/// the direction g of a lag, the columns of the law removed: force noise is integrated twice and so
/// is alike from sample to sample. On a force that only grows linearly nothing of g is left but
/// noise. var = (sigma_x^2 |g|^2 + sigma_F^2 |K' g|^2) / |g|^4, K the double integration over M.
double lag_error(const TrialSignals& s, const Span& span, double inertia, double step) {
  const LawColumns columns = columns_of(s, span, driven(s, span, inertia, 0));
  const Eigen::Matrix4d normal = columns.transpose() * columns;
  const Eigen::VectorXd per_second =
      (driven(s, span, inertia, 1) - driven(s, span, inertia, -1)) / (2 * step);
  const Eigen::Vector4d c = normal.ldlt().solve(columns.transpose() * per_second);
  const Eigen::VectorXd g = per_second - columns * c;
  double once = 0, twice = 0, of_force = 0;  // K' g: sums from the end
  for (Eigen::Index i = g.size() - 1; i >= 0; --i) {
    of_force += std::pow(twice * step * step / inertia, 2);
    once += g[i];
    twice += once;
  }
  const double x_noise = noise_of(s.displacement), f_noise = noise_of(s.force);
  return std::sqrt(x_noise * x_noise * g.squaredNorm() + f_noise * f_noise * of_force) /
         g.squaredNorm();
}

/// While it moves against a constant resistance R,
///
///     x(t) = x_0 + v_0 t + s / M (int int F(t + lag) dt dt - R t^2 / 2)
///
/// Least squares in x_0, v_0, s and s R for every lag within 0.3 s. `lag` is the best one with s
/// within a factor of 3 from 1, where the sum of squares without any is larger by more than 50
/// variances, and it is more than 0.05 s and five standard errors, and not the end of the range; 0
/// elsewhere, as where the force hardly changes, or changes linearly, and determines nothing. s is
/// that without a lag.
/// @return nothing where `span` has less than 24 samples
std::optional<MotionLaw> motion_law(const TrialSignals& s, const Span& span, double inertia) {
  if (span.size() < kFewest) return {};
  const double step = (s.time.back() - s.time.front()) / static_cast<double>(s.time.size() - 1);
  const LawFit plain = fit(s, span, inertia, 0);
  double least = plain.squares;
  std::ptrdiff_t best = 0;
  const auto most = static_cast<std::ptrdiff_t>(kFarthest / step);
  for (std::ptrdiff_t shift = -most; shift <= most; ++shift) {
    const LawFit shifted = fit(s, span, inertia, shift);
    if (std::abs(std::log(shifted.scale)) < std::log(kNear) && shifted.squares < least) {
      least = shifted.squares;
      best = shift;
    }
  }
  const double variance = least / static_cast<double>(span.size() - 5);
  const double lag = static_cast<double>(best) * step;
  const bool sure = plain.squares - least > kSure * variance && std::abs(lag) > kClocks &&
                    std::abs(best) < most &&
                    std::abs(lag) > kSureLag * lag_error(s, span, inertia, step);
  return MotionLaw{plain.scale, plain.scale_error, sure ? lag : 0};
}

constexpr double kGathered = 0.5;                               // of the path
constexpr double kMoves = 0.05, kRolls = 0.15, kSteady = 0.25;  // of the path
constexpr std::size_t kRest = 9;
constexpr double kStands = 5e-3;               // [m/s]
constexpr double kShortest = 0.2;              // [s]
constexpr double kNewton = 3, kSureScale = 4;  // a factor; standard errors
constexpr double kLeastFriction = 0.02, kMaxFriction = 3, kMaxRolling = 0.5;

/// First index of the last part of a record above a mark.
std::size_t beyond(const std::vector<double>& x, double mark) {
  std::size_t i = x.size();
  while (i > 0 && x[i - 1] > mark) --i;
  return i;
}

/// Means in motion, with their errors [N; m/s2].
struct Moving {
  double pull, pull_error;  ///< of the cable
  double acceleration, acceleration_error;
  double force, error;  ///< pull less inertia
  double at_end;        ///< pull of the last 0.2 s
};

/// Mean acceleration is that between the middles of the first and the last 0.2 s.
Moving moving_force(const TrialSignals& s, const Span& moving, double inertia) {
  const auto index = [&](double time) { return index_at(s.time, time); };
  const Span first{moving.begin, index(s.time[moving.begin] + kShortest)};
  const Span last{index(s.time[moving.end - 1] - kShortest), moving.end};
  const PolynomialFit in = fit_polynomial(s.time, s.displacement, first, 2);
  const PolynomialFit out = fit_polynomial(s.time, s.displacement, last, 2);
  const double length = out.middle - in.middle;
  const double acceleration = (out.c[1] - in.c[1]) / length;
  const double acceleration_error =
      std::hypot(in.rate_error(in.middle), out.rate_error(out.middle)) / length;
  // The growth of the pull is no noise: a straight line has the mean in its middle.
  const PolynomialFit force =
      fit_polynomial(s.time, s.force, {index(in.middle), index(out.middle)}, 1);
  const double force_error = std::sqrt(force.covariance(0, 0));
  return {force.c[0],
          force_error,
          acceleration,
          acceleration_error,
          force.c[0] - inertia * acceleration,
          std::hypot(force_error, inertia * acceleration_error),
          mean_of(s.force, last)};
}

/// Where the onset is looked for. Motions from rest need the time T and less than 0.63 T for the
/// whole and a quarter of a path (x ~ t^2 or t^3), so that T is below 2.7 times the difference.
Span onset_window(const TrialSignals& s, double rest, double mark) {
  const std::size_t moved = beyond(s.displacement, rest + mark);
  const std::size_t quarter = beyond(s.displacement, rest + mark / 4);
  const double whole = 3 * (s.time[moved] - s.time[quarter]) + 2 * kBefore;
  return {index_at(s.time, s.time[moved] - whole), moved};
}

/// Where it has 15 % of the speed that it has at `moved`, by differences over eight steps.
std::size_t gathers_from(const TrialSignals& s, std::size_t moved) {
  constexpr double kSlow = 0.15;
  constexpr std::size_t kHalf = 4;
  const auto step = [&](std::size_t i) {
    return s.displacement[i + kHalf] - s.displacement[i - kHalf];
  };
  std::size_t i = std::clamp(moved, kHalf, s.time.size() - 1 - kHalf);
  const double fast = step(i);
  while (i > kHalf && step(i) > kSlow * fast) --i;
  return i;
}

/// How force and motion contradict each other while it gathers speed; empty: nothing.
std::string wrong_motion(const TrialSignals& s, const Span& span, double inertia) {
  const auto law = motion_law(s, span, inertia);
  if (!law) return "";
  if (law->lag != 0)
    return fmt::format(
        "clock: the force is {:.2f} s {} the motion; force and motion must have one "
        "clock",
        std::abs(law->lag), law->lag > 0 ? "behind" : "ahead of");
  if (std::abs(law->scale - 1) > kSureScale * law->scale_error &&
      !(std::abs(std::log(law->scale)) < std::log(kNewton)))
    return fmt::format("it gathers speed {:.3g} times as fast as force and mass say, must be 1: {}",
                       law->scale, cause_of_ratio(law->scale, kNewton, !s.displacement.empty()));
  return "";
}

struct Ratio {
  double value, error;
};

/// Friction of the locked wheels, a force on the item over its weight where all are.
class LockedAxle {
 public:
  LockedAxle(const TrialSetup& setup, double inertia) : setup_(setup), inertia_(inertia) {}

  Ratio friction(const Ratio& pull, const Ratio& acceleration) const {
    return friction(pull, acceleration, setup_.center_height.value_or(setup_.pull_height));
  }

  /// The largest change of it by another height of the center of mass; 0 where that is stated.
  double uncertainty(const Ratio& pull, const Ratio& acceleration) const {
    if (setup_.center_height) return 0;
    const double as_stated = friction(pull, acceleration).value;
    double largest = 0;
    for (const double height : {0.0, kHighestCenter})
      largest = std::max(largest, std::abs(friction(pull, acceleration, height).value - as_stated));
    return largest;
  }

 private:
  /// @param acceleration  in g
  Ratio friction(const Ratio& pull, const Ratio& acceleration, double center) const {
    const double inertia = inertia_ / setup_.mass;  // over M
    const double value = pull.value - inertia * acceleration.value;
    if (setup_.locked == LockedWheels::kAll)
      return {value, std::hypot(pull.error, inertia * acceleration.error)};
    const bool front = setup_.locked == LockedWheels::kFront;
    const double of_pull = (front ? 1 : -1) * setup_.pull_height / setup_.wheelbase;
    const double of_acceleration = (front ? -1 : 1) * center / setup_.wheelbase;
    const double share = (front ? setup_.front_share : 1 - setup_.front_share) +
                         of_pull * pull.value + of_acceleration * acceleration.value;
    const double rolling = setup_.rolling_ratio;
    const double friction = (value - (1 - share) * rolling) / share;
    const auto change = [&](double direct, double by_share) {
      return (direct - (friction - rolling) * by_share) / share;
    };
    return {friction, std::hypot(change(1, of_pull) * pull.error,
                                 change(-inertia, of_acceleration) * acceleration.error)};
  }

  const TrialSetup& setup_;
  double inertia_;
};

constexpr double kLeastChange = 0.01;  // of mu_k

double turning_mass(const Trial& trial) {
  if (trial.kind != TrialKind::kLockedPull) return trial.setup.added_mass;
  return trial.setup.locked == LockedWheels::kAll ? 0 : trial.setup.added_mass / 2;
}

}  // namespace

Breakaway breakaway_of(const Trial& trial) {
  const TrialSignals& s = trial.signals;
  const std::size_t n = s.time.size();
  if (n < 2 * kFewest) refuse(trial, 0, fmt::format("only {} samples", n));
  const double rest = mean_of(s.displacement, {0, kRest});
  const double path = s.displacement.back() - rest;
  if (!(path > 50 * noise_of(s.displacement)) || !(path > 0))
    refuse(trial, 0,
           path < 0 ? "displacement falls while the force pulls: it must count in the "
                      "direction of the pull"
                    : "it never breaks away");
  const TrialSetup& setup = trial.setup;
  const bool locked = trial.kind == TrialKind::kLockedPull;
  const bool axle = locked && setup.locked != LockedWheels::kAll;
  const std::size_t moved = beyond(s.displacement, rest + kMoves * path);
  const std::size_t steady = axle ? beyond(s.displacement, rest + kSteady * path) : moved;
  std::size_t end = 0;
  while (end < n && s.displacement[end] < rest + (1 - kMoves) * path) ++end;
  const PolynomialFit begin = fit_polynomial(s.time, s.displacement, {0, kFewest}, 1);
  if (moved < kRest || std::abs(begin.c[1]) > kStands + 6 * begin.rate_error(begin.middle))
    refuse(trial, 0, "it does not stand still before it is pulled");
  const Span moving{steady, end};
  if (moving.size() < kFewest || s.time[end - 1] - s.time[steady] < 2 * kShortest)
    refuse(trial, steady, fmt::format("it moves for less than {} s", 2 * kShortest));

  const double normal = normal_force(setup), inertia = setup.mass + turning_mass(trial);
  const Span gathering{gathers_from(s, moved), beyond(s.displacement, rest + kGathered * path)};
  if (const std::string wrong = wrong_motion(s, gathering, inertia); !wrong.empty())
    refuse(trial, moved, wrong);
  const Moving motion = moving_force(s, moving, inertia);
  if (!(motion.at_end > motion.force / 2))
    refuse(trial, end - 1,
           fmt::format("the force falls to {:.3g} N while it moves: is it kind = "
                       "pull?",
                       motion.at_end));
  const double mark = (locked ? kMoves : kRolls) * path;
  const auto onset =
      find_onset(s, onset_window(s, rest, mark), inertia, motion.force, motion.error, axle);
  if (!onset) refuse(trial, 0, "it does not stand still before it is pulled");
  const double string = setup.string_tension;
  const LockedAxle locked_axle(setup, inertia);
  const Ratio peak =
      locked_axle.friction({(onset->force - string) / normal, onset->force_error / normal}, {0, 0});
  const Ratio pull{(motion.pull - string) / normal, motion.pull_error / normal};
  const Ratio acceleration{motion.acceleration / kStandardGravity,
                           motion.acceleration_error / kStandardGravity};
  const Ratio kinetic = locked_axle.friction(pull, acceleration);
  const double least = locked ? kLeastFriction : 0, most = locked ? kMaxFriction : kMaxRolling;
  for (const double value : {peak.value, kinetic.value})
    if (!(value > least && value < most))
      refuse(trial, moved,
             fmt::format("{} is {:.3g} at the start and {:.3g} in motion: must be > {} "
                         "and < {}; are mass, force and units right, and is the kind?",
                         locked ? "friction" : "force over weight", peak.value, kinetic.value,
                         least, most));
  const double unknown = axle ? locked_axle.uncertainty(pull, acceleration) : 0;
  std::string lost;
  if (unknown > kLeastChange * kinetic.value)
    lost = fmt::format(
        "mu_k is excluded: it accelerates by {:.2g} m/s2, so that mu_k depends on the height of "
        "the center of mass, {:.2g} % for one of 0 to {:g} m: center_of_mass_height_mm states it",
        motion.acceleration, 100 * unknown / kinetic.value, kHighestCenter);
  return {peak.value, locked && !axle, kinetic.value, peak.error, kinetic.error, lost};
}

}  // namespace gurney::calibration
