#include "studies/calibration/trials/phases.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace gurney::calibration {
namespace {

constexpr double kNoiseMultiples = 8;
constexpr double kPathShare = 1.0 / 2000;
constexpr double kLeastHeld = 0.05;  // [s]
constexpr std::size_t kAtRest = 6;   // samples whose median is where it stood
constexpr std::ptrdiff_t kHalfMean = 4;

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

std::vector<double> means_of_nine(const std::vector<double>& series) {
  const auto n = static_cast<std::ptrdiff_t>(series.size());
  std::vector<double> means;
  for (std::ptrdiff_t i = 0; i < n; ++i) {
    double sum = 0;
    const std::ptrdiff_t from = std::max<std::ptrdiff_t>(0, i - kHalfMean);
    const std::ptrdiff_t to = std::min(n - 1, i + kHalfMean);
    for (std::ptrdiff_t k = from; k <= to; ++k) sum += series[static_cast<std::size_t>(k)];
    means.push_back(sum / static_cast<double>(to - from + 1));
  }
  return means;
}

/// Time at which the line between samples i - 1 and i has the value.
double crossing(const std::vector<double>& t, const std::vector<double>& y, std::size_t i,
                double value) {
  const double step = y[i] - y[i - 1];
  return step == 0 ? t[i] : t[i - 1] + (t[i] - t[i - 1]) * (value - y[i - 1]) / step;
}

/// Index of the first sample whose force has fallen for good; 0 without a force.
std::size_t release_index(const std::vector<double>& force) {
  const std::vector<double> smooth = median_of_five(force);
  const double half = std::ranges::max(smooth) / 2;
  if (!(half > 0)) return 0;
  std::size_t i = smooth.size();
  while (i > 0 && !(smooth[i - 1] > half)) --i;
  return i;
}

/// Start of the motion, before `release`.
bool find_start(const std::vector<double>& t, const std::vector<double>& x, double mark,
                std::size_t release, Phases& phases) {
  const double rest = median({x.begin(), x.begin() + kAtRest});
  std::size_t near = release, far = release;
  while (near > 0 && x[near - 1] > rest + mark) --near;
  while (far > 0 && x[far - 1] > rest + 4 * mark) --far;
  if (near == 0 || far >= release) return false;
  phases.start = 2 * crossing(t, x, near, rest + mark) - crossing(t, x, far, rest + 4 * mark);
  return phases.start - t.front() >= kLeastHeld;
}

void find_stop(const std::vector<double>& t, const std::vector<double>& x, double mark,
               std::size_t release, Phases& phases) {
  const std::size_t n = x.size();
  const double rest = median({x.end() - kAtRest, x.end()});
  const double highest = std::ranges::max(x);
  std::size_t near = release, far = release;
  const double top = highest > rest + 8 * mark ? highest : rest;
  while (near < n && x[near] < top - mark) ++near;
  while (far < n && x[far] < top - 4 * mark) ++far;
  phases.stop = t.back();
  phases.end = Phases::End::kRecordEnds;
  if (near >= n || far >= n || far <= release) return;
  if (highest > rest + 8 * mark) {  // it came back
    phases.end = Phases::End::kEndOfFloor;
    phases.stop = crossing(t, x, far, top - 4 * mark);
    return;
  }
  const double t_near = crossing(t, x, near, top - mark);
  const double t_far = crossing(t, x, far, top - 4 * mark);
  const double rested = 2 * t_near - t_far;
  if (rested > t.back() - kLeastHeld) return;
  // Uniformly decelerated it passes the far mark with 4 d / (t_stop - t_far) * 2. Much faster, and
  // something else stopped it.
  const double speed = 3 * mark / (t_near - t_far);
  const std::size_t before = index_at(t, phases.release + 0.75 * (t_far - phases.release));
  const double mean_speed = (x[far] - x[before]) / std::max(t[far] - t[before], 1e-9);
  phases.end = speed > mean_speed / 2 ? Phases::End::kEndOfFloor : Phases::End::kRested;
  phases.stop = phases.end == Phases::End::kRested ? rested : t_far;
}

bool find_by_displacement(const Trial& trial, std::size_t release, Phases& phases) {
  const TrialSignals& s = trial.signals;
  phases.noise = noise_of(s.displacement);
  const auto [low, high] = std::ranges::minmax(s.displacement);
  const double mark = std::max(kNoiseMultiples * phases.noise, kPathShare * (high - low));
  if (!find_start(s.time, s.displacement, mark, release, phases)) return false;
  find_stop(s.time, s.displacement, mark, release, phases);
  return true;
}

/// Median from `from` to `to`, NaN where there is no sample between.
double level(const TrialSignals& s, const std::vector<double>& a, double from, double to) {
  const auto begin = static_cast<std::ptrdiff_t>(index_at(s.time, from));
  const auto end = static_cast<std::ptrdiff_t>(index_at(s.time, to));
  return end > begin ? median({a.begin() + begin, a.begin() + end}) : std::nan("");
}

bool find_by_acceleration(const Trial& trial, std::size_t release, Phases& phases) {
  constexpr double kWindow = 0.25, kAway = 0.05;  // [s]
  const TrialSignals& s = trial.signals;
  const std::vector<double> a = means_of_nine(s.acceleration);
  const double r = phases.release, first = s.time.front();
  const double rest = level(s, a, first, first + kLeastHeld);
  const double pull = level(s, a, r - kAway - kWindow, r - kAway) - rest;
  const double coast = level(s, a, r + kAway, r + kAway + kWindow) - rest;
  if (!(pull > 0) || !(coast < 0)) return false;
  std::size_t start = std::min(index_at(s.time, r - kAway), release);
  while (start > 0 && a[start - 1] - rest > pull / 2) --start;
  std::size_t stop = index_at(s.time, r + kAway);
  while (stop < a.size() && a[stop] - rest < coast / 2) ++stop;
  phases.start = s.time[start];
  phases.stop = stop < a.size() ? s.time[stop] : s.time.back();
  phases.end = stop < a.size() ? Phases::End::kRested : Phases::End::kRecordEnds;
  return phases.start - first >= kLeastHeld;
}

}  // namespace

double noise_of(const std::vector<double>& series) {
  if (series.size() < 5) return 0;
  std::vector<double> differences;
  for (std::size_t i = 3; i < series.size(); ++i)
    differences.push_back(
        std::abs(series[i] - 3 * series[i - 1] + 3 * series[i - 2] - series[i - 3]));
  constexpr double kMedianOfNormal = 0.674489750196082;            // of |z|
  return median(differences) / kMedianOfNormal / std::sqrt(20.0);  // 1 + 9 + 9 + 1
}

std::vector<double> median_of_five(const std::vector<double>& series) {
  std::vector<double> result(series);
  for (std::size_t i = 2; i + 2 < series.size(); ++i)
    result[i] = median({series[i - 2], series[i - 1], series[i], series[i + 1], series[i + 2]});
  return result;
}

const char* name_of(Phases::End end) {
  constexpr std::array kNames = {"rested", "end of floor", "record ends"};
  return kNames[static_cast<std::size_t>(end)];
}

Phases find_phases(const Trial& trial) {
  const TrialSignals& s = trial.signals;
  constexpr std::size_t kFewest = 30;
  const std::size_t n = s.time.size();
  if (n < kFewest) refuse(trial, 0, fmt::format("{} samples, at least {} are needed", n, kFewest));
  Phases phases;
  const std::size_t release = release_index(s.force);
  if (release < 2) refuse(trial, 0, "phase II is missing: the force is never above zero");
  if (release >= n)
    refuse(trial, n - 1, "phase III is missing: the force does not fall before the record ends");
  phases.release = s.time[release - 1] + (s.time[release] - s.time[release - 1]) / 2;
  const bool found = s.displacement.empty() ? find_by_acceleration(trial, release, phases)
                                            : find_by_displacement(trial, release, phases);
  if (!found) {
    const bool backwards = !s.displacement.empty() && s.displacement[release] < s.displacement[0];
    refuse(trial, 0,
           backwards ? "displacement falls while the force pulls: it must count in the "
                       "direction of the pull"
                     : "phase I is missing: it does not stand still before it is pulled, or "
                       "never moves");
  }
  const std::size_t start = std::min(index_at(s.time, phases.start), release);
  const std::size_t stop = std::max(index_at(s.time, phases.stop), release);
  phases.held = {0, start};
  phases.pulled = {start, release};
  phases.coasting = {release, stop};
  phases.stopped = {stop, n};
  return phases;
}

}  // namespace gurney::calibration
