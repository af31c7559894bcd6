#include "groundmotions/synthetic/ac156.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/base/error.h"
#include "groundmotions/measures/response_spectrum.h"
#include "groundmotions/synthetic/component.h"
#include "groundmotions/synthetic/noise.h"

namespace gurney::groundmotions {

namespace {

using std::numbers::pi;

constexpr double kDamping = 0.05;
constexpr int kPerOctave = 24, kIterations = 20;
/// A spectrum of damping zeta changes by at most a share of 1 / (2 zeta) of a change of ln f: the
/// steepest place of an oscillator's resonance. Halfway between points of the last grid it may be
/// lower by (ln 2 / 768 / 2) / (2 zeta) = 0.0045.
constexpr int kPerOctaveAtLast = 768;
/// Points of the last grid come first: between two of them the ratio to the required spectrum, whose
/// own slope is at most 1 in logarithms, is lower than at the lower one by less than
/// (1 / (2 zeta) + 1) times half their distance. Twice that is kept.
constexpr std::size_t kStride = 8;
constexpr double kDip = (1 / (2 * kDamping) + 1) * kStride * std::numbers::ln2 / kPerOctaveAtLast;
constexpr double kMargin = 1.005;
constexpr double kHighestFrequency = 50;  // of the motion's own content [Hz]

/// Straight in logarithms from (x0, y0) to (x1, y1).
double log_line(double x, double x0, double y0, double x1, double y1) {
  return y0 * std::pow(y1 / y0, std::log(x / x0) / std::log(x1 / x0));
}

/// Ratio of the spectrum of a motion to the required one.
Eigen::VectorXd ratios(double time_step, const Eigen::VectorXd& acceleration,
                       const RequiredSpectrum& required, const std::vector<double>& frequencies) {
  const auto count = static_cast<Eigen::Index>(frequencies.size());
  const Eigen::ArrayXd f = Eigen::ArrayXd::Map(frequencies.data(), count);
  return response_spectrum(time_step, acceleration, f.inverse(), kDamping)
             .absolute_acceleration.array() /
         f.unaryExpr([&](double each) { return required.at(each); });
}

/// The smallest of ratios() on a dense grid: first at every kStride-th point, then between those where a
/// smaller one can be.
double smallest_ratio(double time_step, const Eigen::VectorXd& acceleration,
                      const RequiredSpectrum& required, const std::vector<double>& grid) {
  std::vector<std::size_t> points;
  for (std::size_t i = 0; i < grid.size(); i += kStride) points.push_back(i);
  if (points.back() != grid.size() - 1) points.push_back(grid.size() - 1);
  std::vector<double> first;
  for (const std::size_t i : points) first.push_back(grid[i]);
  const Eigen::VectorXd at_first = ratios(time_step, acceleration, required, first);
  const double smallest = at_first.minCoeff();

  std::vector<double> between;
  for (std::size_t i = 1; i < points.size(); ++i) {
    const auto right = static_cast<Eigen::Index>(i);
    if (std::min(at_first[right - 1], at_first[right]) <= smallest * (1 + kDip))
      between.insert(between.end(), grid.begin() + static_cast<std::ptrdiff_t>(points[i - 1]) + 1,
                     grid.begin() + static_cast<std::ptrdiff_t>(points[i]));
  }
  if (between.empty()) return smallest;
  return std::min(smallest, ratios(time_step, acceleration, required, between).minCoeff());
}

struct Fit {
  Eigen::VectorXd acceleration;
  double smallest = 0, largest = 0;  ///< ratio to the required spectrum; largest: up to 8.3 Hz
};

class Matching {
 public:
  Matching(const Ac156Motion& motion, const RequiredSpectrum& required, std::uint64_t stream)
      : motion_(motion),
        required_(required),
        frequencies_(ac156_frequencies(kPerOctave)),
        envelope_(sampled(motion.time_step, motion.build + motion.hold + motion.decay,
                          [&](double t) { return envelope_at(t); })),
        noise_(motion.seed, stream, envelope_.size(), motion.time_step),
        amplitude_(frequencies_.size()) {
    // A first guess: Fourier amplitude in proportion to Sa / sqrt(f), as for long white noise.
    for (std::size_t k = 0; k < amplitude_.size(); ++k)
      amplitude_[k] = required.at(frequencies_[k]) / std::sqrt(frequencies_[k]);
  }

  Fit best() {
    Fit best;
    for (int i = 0; i < kIterations; ++i) {
      Fit fit = this_one();
      if (best.acceleration.size() == 0 || fit.largest < best.largest) best = std::move(fit);
      for (std::size_t k = 0; k < amplitude_.size(); ++k)
        amplitude_[k] /= ratio_[static_cast<Eigen::Index>(k)];
    }
    const double smallest = smallest_ratio(motion_.time_step, best.acceleration, required_,
                                           ac156_frequencies(kPerOctaveAtLast));
    best.acceleration *= kMargin / smallest;
    best.largest *= kMargin / smallest;
    best.smallest = kMargin;
    return best;
  }

 private:
  double envelope_at(double t) const {
    const double to_end = motion_.build + motion_.hold + motion_.decay - t;
    const double ramp = std::clamp(std::min(t / motion_.build, to_end / motion_.decay), 0., 1.);
    return std::pow(std::sin(pi / 2 * ramp), 2);
  }

  double amplitude_at(double frequency) const {
    if (frequency <= motion_.low_cut || frequency >= kHighestFrequency) return 0;
    if (frequency < frequencies_.front())
      return amplitude_.front() * std::pow(std::sin(pi / 2 * (frequency - motion_.low_cut) /
                                                    (frequencies_.front() - motion_.low_cut)),
                                           2);
    if (frequency >= frequencies_.back())
      return amplitude_.back() * std::pow(std::sin(pi / 2 * (kHighestFrequency - frequency) /
                                                   (kHighestFrequency - frequencies_.back())),
                                          2);
    const auto next = static_cast<std::size_t>(
        std::upper_bound(frequencies_.begin(), frequencies_.end(), frequency) -
        frequencies_.begin());
    return log_line(frequency, frequencies_[next - 1], amplitude_[next - 1], frequencies_[next],
                    amplitude_[next]);
  }

  /// The motion of the present amplitudes, scaled to envelope at frequencies_; fills ratio_ before
  /// the scaling.
  Fit this_one() {
    Fit fit;
    fit.acceleration = noise_.acceleration([&](double f) { return amplitude_at(f); }, envelope_);
    ratio_ = ratios(motion_.time_step, fit.acceleration, required_, frequencies_);
    const double smallest = ratio_.minCoeff();
    for (std::size_t k = 0; k < frequencies_.size() && frequencies_[k] <= kAc156Corner; ++k)
      fit.largest = std::max(fit.largest, ratio_[static_cast<Eigen::Index>(k)] / smallest);
    fit.acceleration /= smallest;
    fit.smallest = 1;
    return fit;
  }

  const Ac156Motion& motion_;
  const RequiredSpectrum& required_;
  std::vector<double> frequencies_;
  Eigen::VectorXd envelope_;
  FourierNoise noise_;
  std::vector<double> amplitude_;  ///< of the noise, at frequencies_
  Eigen::VectorXd ratio_;          ///< of the motion's spectrum to the required one
};

double correlation(const Eigen::VectorXd& a, const Eigen::VectorXd& b) {
  return a.dot(b) / (a.norm() * b.norm());
}

}  // namespace

double RequiredSpectrum::at(double frequency) const {
  if (frequency < kAc156Lowest)
    return log_line(frequency, 0.1, 0.1 * flexible, kAc156Lowest, flexible);
  if (frequency <= kAc156Corner) return flexible;
  if (frequency >= kAc156Highest) return rigid;
  return log_line(frequency, kAc156Corner, flexible, kAc156Highest, rigid);
}

RequiredSpectrum required_horizontal(double short_period_acceleration, double height_ratio) {
  const double amplified = short_period_acceleration * (1 + 2 * height_ratio);
  return {std::min(amplified, 1.6 * short_period_acceleration), 0.4 * amplified};
}

RequiredSpectrum required_vertical(double short_period_acceleration) {
  return {0.67 * short_period_acceleration, 0.27 * short_period_acceleration};
}

std::vector<double> ac156_frequencies(int per_octave) {
  std::vector<double> frequencies;
  for (int k = 0;; ++k) {
    const double f = kAc156Lowest * std::exp2(static_cast<double>(k) / per_octave);
    if (f > kAc156Highest * 0.999) break;
    frequencies.push_back(f);
  }
  frequencies.push_back(kAc156Highest);
  return frequencies;
}

Record ac156_motion(const Ac156Motion& motion) {
  constexpr double kLongestStep = 0.005;  // six samples in a period of 33.3 Hz
  constexpr double kIndependent = 0.3, kRecommended = 1.3;
  constexpr std::uint64_t kMaxStreams = 20;
  require(motion.time_step > 0 && motion.time_step <= kLongestStep,
          fmt::format("time step {:g} s: must be > 0 and at most {:g} s", motion.time_step,
                      kLongestStep));
  const RequiredSpectrum horizontal =
      required_horizontal(motion.short_period_acceleration, motion.height_ratio);
  const RequiredSpectrum vertical = required_vertical(motion.short_period_acceleration);
  Record record;
  std::uint64_t stream = 0;
  for (const Direction direction : kDirections) {
    const bool up = direction == Direction::kVertical;
    Fit fit;
    double worst = 1;
    for (const std::uint64_t last = stream + kMaxStreams; worst >= kIndependent;) {
      require(stream < last,
              fmt::format("{}: none of {} noises has a correlation below {:g} with the other "
                          "components; another seed may, or a longer motion",
                          name_of(direction), kMaxStreams, kIndependent));
      fit = Matching(motion, up ? vertical : horizontal, stream++).best();
      worst = 0;
      for (const auto& other : record.components)
        if (other)
          worst = std::max(worst, std::abs(correlation(other->acceleration, fit.acceleration)));
    }
    Component component =
        synthetic_component(direction, motion.time_step, std::move(fit.acceleration));
    component.header = {
        {"required spectrum, A_FLX and A_RIG [m/s2]",
         fmt::format("{:.4g}, {:.4g}", (up ? vertical : horizontal).flexible,
                     (up ? vertical : horizontal).rigid)},
        {"smallest ratio to the required spectrum, 1.3-33.3 Hz",
         fmt::format("{:.3f}", fit.smallest)},
        {"largest ratio to the required spectrum, 1.3-8.3 Hz", fmt::format("{:.3f}", fit.largest)},
        {"peak acceleration, as a share of A_RIG",
         fmt::format("{:.3f}", component.acceleration.cwiseAbs().maxCoeff() /
                                   (up ? vertical : horizontal).rigid)},
        {"largest correlation with another component", fmt::format("{:.3f}", worst)}};
    if (fit.largest > kRecommended)
      component.warnings.push_back(
          fmt::format("{}: its spectrum is up to {:.0f} % above the required one between 1.3 and "
                      "8.3 Hz; AC156 recommends at most 30 %. Another seed may fit better",
                      component.name, 100 * (fit.largest - 1)));
    record.components[static_cast<std::size_t>(direction)] = std::move(component);
  }
  return record;
}

}  // namespace gurney::groundmotions
