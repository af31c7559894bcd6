#include "studies/calibration/fit/crosswise.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <optional>

#include "engine/base/error.h"
#include "studies/calibration/fit/trial_model.h"
#include "studies/calibration/trials/trial_check.h"

namespace gurney::calibration {
namespace {

constexpr int kUnknowns = 5, kMaxIterations = 25;
constexpr double kConverged = 1e-2;        // of a step, in standard errors squared
constexpr double kMaxRelativeError = 0.5;  // relative error
constexpr double kLeastNoise = 1e-5;       // of any series [m, rad]
constexpr double kFarthest = 0.03;         // of start and release from those of the phases [s]
constexpr double kBeforeStop = 0.15;       // [s]

using Vector = Eigen::Matrix<double, kUnknowns, 1>;
using Square = Eigen::Matrix<double, kUnknowns, kUnknowns>;

/// Residuals of a trial in standard deviations of its noise.
class Residuals {
 public:
  Residuals(const Trial& trial, const Phases& phases, const TrialModel& model)
      : trial_(trial), model_(model) {
    begin_ = phases.held.end;
    end_ = index_at(trial.signals.time, phases.stop - kBeforeStop);
    rest_ = phases.held;
  }

  Eigen::VectorXd at(const Vector& x) const {
    const TrialModel::Motion motion = model_.run({x[0], x[1], x[2], x[3], x[4]});
    const TrialSignals& s = trial_.signals;
    std::vector<double> all;
    append(s.displacement, motion.displacement, all);
    append(s.lateral, motion.lateral, all);
    append(s.yaw, motion.yaw, all);
    return Eigen::Map<Eigen::VectorXd>(all.data(), static_cast<Eigen::Index>(all.size()));
  }

  Eigen::Index samples() const { return static_cast<Eigen::Index>(end_ - begin_); }
  double noise() const { return std::max(noise_of(trial_.signals.displacement), kLeastNoise); }

 private:
  void append(const std::vector<double>& measured, const std::vector<double>& modelled,
              std::vector<double>& all) const {
    if (measured.empty()) return;
    const double noise = std::max(noise_of(measured), kLeastNoise);
    double rest = 0;
    for (std::size_t i = rest_.begin; i < rest_.end; ++i)
      rest += (measured[i] - modelled[i]) / static_cast<double>(rest_.size());
    for (std::size_t i = begin_; i < end_; ++i)
      all.push_back((measured[i] - rest - modelled[i]) / noise);
  }

  const Trial& trial_;
  const TrialModel& model_;
  Span rest_;
  std::size_t begin_, end_;
};

struct Minimum {
  Vector x;
  Eigen::VectorXd residuals;
  Square covariance;
};

std::optional<Minimum> minimise(const Residuals& of, Vector x, double widest) {
  const Vector step{{1e-4, 2e-4, 1e-3, 1e-3, 0.05}};  // of differences: Cr / R, m, s, s, N
  Eigen::VectorXd r = of.at(x);
  for (int iteration = 0; iteration < kMaxIterations; ++iteration) {
    Eigen::MatrixXd slope(r.size(), kUnknowns);
    for (int k = 0; k < kUnknowns; ++k) {
      Vector moved = x;
      moved[k] += step[k];
      slope.col(k) = (of.at(moved) - r) / step[k];
    }
    const Square normal = slope.transpose() * slope;
    const Eigen::LDLT<Square> factor(normal);
    if (!factor.isPositive()) return {};
    const double variance =
        r.squaredNorm() / static_cast<double>(std::max<Eigen::Index>(r.size() - kUnknowns, 1));
    const Vector direction = -factor.solve(slope.transpose() * r);
    const auto allowed = [&](Vector y) {
      y[0] = std::clamp(y[0], 1e-4, 0.5);
      y[1] = std::clamp(y[1], 0.0, widest);
      y[2] = std::clamp(y[2], -kFarthest, kFarthest);
      y[3] = std::clamp(y[3], -kFarthest, kFarthest);
      return y;
    };
    double length = 1;
    Vector next = allowed(x + direction);
    Eigen::VectorXd r_next = of.at(next);
    while (r_next.squaredNorm() > r.squaredNorm() && length > 1e-3) {
      length /= 2;
      next = allowed(x + length * direction);
      r_next = of.at(next);
    }
    const Vector moved = next - x;
    const bool better = r_next.squaredNorm() < r.squaredNorm();
    if (better) {
      x = next;
      r = r_next;
    }
    if (!better || moved.dot(normal * moved) < kConverged * variance)
      return Minimum{x, r, variance * factor.solve(Square::Identity())};
  }
  return {};
}

}  // namespace

CrosswiseFit fit_crosswise(const Trial& trial) {
  const Phases phases = find_phases(trial);
  check_averages(averages_of(trial, phases, settled_of_pull(trial, phases)),
                 !trial.signals.displacement.empty());
  check_phases(trial, phases);
  try {
    const TrialModel model(trial, phases);
    const Residuals residuals(trial, phases, model);
    const TrialModel::Unknowns usual = model.usual();
    const auto found = minimise(
        residuals,
        Vector{{usual.resistance, usual.patch_width, usual.shift, usual.release, usual.force}},
        model.wheel_width());
    require(found.has_value(), "the engine's run does not come near the trial");
    CrosswiseFit fit;
    fit.trial = trial.name;
    fit.caster = trial.setup.caster;
    fit.floor = trial.setup.floor;
    fit.load = model.load_of_wheel();
    fit.resistance = found->x[0];
    fit.patch_width = found->x[1];
    fit.shift = found->x[2];
    fit.force = found->x[4];
    fit.friction_times_width = model.friction() * fit.patch_width;
    fit.torque_length = fit.friction_times_width / 4 + model.swivel_coulomb() / fit.load;
    fit.resistance_error = std::sqrt(found->covariance(0, 0));
    const double width_error = std::sqrt(found->covariance(1, 1));
    fit.torque_length_error = model.friction() * width_error / 4;
    fit.correlation = found->covariance(0, 1) / (fit.resistance_error * width_error);
    fit.misfit =
        residuals.noise() * std::sqrt(found->residuals.head(residuals.samples()).squaredNorm() /
                                      static_cast<double>(residuals.samples()));
    require(fit.torque_length_error < kMaxRelativeError * fit.torque_length,
            "it does not determine the swivel friction: are the casters in line?");
    return fit;
  } catch (const Error& error) {
    throw UnusableTrial({trial.file, 0, error.what()});
  }
}

}  // namespace gurney::calibration
