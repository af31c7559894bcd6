#include "studies/calibration/pulling/method_check.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace gurney::calibration {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

MeanAndScatter of(const std::vector<double>& values) {
  const auto n = static_cast<double>(values.size());
  double sum = 0, squares = 0;
  for (const double value : values) sum += value;
  for (const double value : values) squares += (value - sum / n) * (value - sum / n);
  return {sum / n, n > 1 ? std::sqrt(squares / (n - 1)) : kNaN};
}

PooledBias pooled(const std::vector<SimulatedTrial>& trials,
                  const std::vector<Alignment>& alignments) {
  PooledBias pool;
  for (const Alignment alignment : alignments)
    pool.trials_of += (pool.trials_of.empty() ? "" : ", ") + std::string(name_of(alignment));
  double weights = 0;
  for (const SimulatedTrial& trial : trials) {
    if (!trial.averages || std::ranges::find(alignments, trial.alignment) == alignments.end())
      continue;
    const double weight = trial.theory.normal_force * trial.theory.normal_force;
    ++pool.trials;
    weights += weight;
    pool.both += weight * trial.bias_mean();
    pool.coasting += weight * trial.bias_coasting();
  }
  pool.both /= weights;
  pool.coasting /= weights;
  return pool;
}

double displacement_at(const TrialSignals& s, double time) {
  const auto after = std::ranges::lower_bound(s.time, time) - s.time.begin();
  const auto i = static_cast<std::size_t>(after);
  if (i == 0 || i >= s.time.size()) return kNaN;
  const double share = (time - s.time[i - 1]) / (s.time[i] - s.time[i - 1]);
  return s.displacement[i - 1] + share * (s.displacement[i] - s.displacement[i - 1]);
}

}  // namespace

std::vector<AlignmentBias> bias_by_alignment(const std::vector<SimulatedTrial>& trials) {
  std::vector<AlignmentBias> rows;
  for (const Alignment alignment :
       {Alignment::kAligned, Alignment::kCrosswise, Alignment::kReversed}) {
    std::vector<double> pulled, coasting, mean;
    for (const SimulatedTrial& trial : trials) {
      if (trial.alignment != alignment || !trial.averages) continue;
      pulled.push_back(trial.bias_pulled());
      coasting.push_back(trial.bias_coasting());
      mean.push_back(trial.bias_mean());
    }
    if (!pulled.empty())
      rows.push_back({alignment, pulled.size(), of(pulled), of(coasting), of(mean)});
  }
  return rows;
}

std::vector<PooledBias> pooled_biases(const std::vector<SimulatedTrial>& trials) {
  std::vector<Alignment> there;
  for (const AlignmentBias& row : bias_by_alignment(trials)) there.push_back(row.alignment);
  std::vector<PooledBias> rows;
  if (there.size() < 2) return rows;
  rows.push_back(pooled(trials, {there[0]}));
  for (std::size_t i = 1; i < there.size(); ++i)
    rows.push_back(pooled(trials, {there[0], there[i]}));
  if (there.size() > 2) rows.push_back(pooled(trials, there));
  return rows;
}

std::vector<CasterFit> fits_by_caster(const std::vector<SimulatedTrial>& trials) {
  std::vector<CasterFit> fits;
  std::vector<double> squares;
  for (const SimulatedTrial& trial : trials) {
    if (trial.alignment != Alignment::kAligned || !trial.averages) continue;
    const std::string& caster = trial.trial.setup.caster;
    auto fit = std::ranges::find(fits, caster, &CasterFit::caster);
    if (fit == fits.end()) {
      fits.push_back({caster, trial.trial.setup.wheel_radius});
      squares.push_back(0);
      fit = fits.end() - 1;
    }
    const double n = trial.theory.normal_force;
    ++fit->trials;
    fit->found += mean_resistance(*trial.averages) * n;
    fit->known += trial.theory.resistance * n;
    squares[static_cast<std::size_t>(fit - fits.begin())] += n * n;
  }
  for (std::size_t i = 0; i < fits.size(); ++i) {
    fits[i].found /= squares[i];
    fits[i].known /= squares[i];
  }
  return fits;
}

TheoryError theory_error(const SimulatedTrial& trial) {
  const PullTheory& theory = trial.theory;
  const TrialSignals& s = trial.trial.signals;
  return {displacement_at(s, theory.release) / theory.release_displacement - 1,
          trial.left_flooring ? kNaN : s.displacement.back() / theory.rest_displacement - 1};
}

}  // namespace gurney::calibration
