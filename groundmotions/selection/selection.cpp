#include "groundmotions/selection/selection.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>

#include "engine/base/error.h"
#include "engine/base/linear_algebra.h"
#include "engine/base/random/normal_draw.h"
#include "engine/base/random/sampling.h"

namespace gurney::groundmotions {
namespace {

using Eigen::Index;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// How many of the records of one event, or of one station, are selected.
class GroupLimit {
 public:
  /// @param limit  0: none
  GroupLimit(const std::vector<std::string>& groups, int limit) : limit_(limit) {
    std::map<std::string, std::size_t> known;
    for (const std::string& group : groups)
      group_.push_back(known.try_emplace(group, known.size()).first->second);
    if (const auto unknown = known.find(""); unknown != known.end()) unlimited_ = unknown->second;
    taken_.assign(known.size(), 0);
  }

  bool allows(Index record) const {
    const std::size_t group = group_[static_cast<std::size_t>(record)];
    return limit_ == 0 || group == unlimited_ || taken_[group] < limit_;
  }
  void change(Index record, int by) { taken_[group_[static_cast<std::size_t>(record)]] += by; }

 private:
  int limit_;
  std::vector<std::size_t> group_;
  std::size_t unlimited_ = std::numeric_limits<std::size_t>::max();
  std::vector<int> taken_;
};

class Selector {
 public:
  Selector(const SelectionTarget& target, const Candidates& candidates,
           const SelectionOptions& options)
      : target_(target),
        spectra_(candidates.ln_spectra),
        options_(options),
        simulated_(simulated_spectra(target.spectrum, options)),
        chosen_(options.count, spectra_.cols()),
        events_(candidates.events, options.per_event),
        stations_(candidates.stations, options.per_station) {
    for (Index j = 0; j < spectra_.rows(); ++j)
      if (is_usable(j)) usable_.push_back(j);
  }

  Selection run() {
    const Index excluded = spectra_.rows() - std::ssize(usable_);
    require(
        std::ssize(usable_) >= options_.count,
        fmt::format("{} of {} records {}: {} are to be selected", usable_.size(), spectra_.rows(),
                    excluded == 0 ? "are there"
                                  : fmt::format("have a factor from {:g} to {:g}",
                                                options_.smallest_factor, options_.largest_factor),
                    options_.count));
    take_nearest();
    const double nearest = total();
    improve();
    Selection result = sorted();
    result.nearest_total = nearest;
    result.excluded = excluded;
    return result;
  }

 private:
  /// ln f of a candidate for the simulated spectrum of a place.
  double ln_factor(Index place, Index j) const {
    if (!options_.scaled) return 0;
    if (target_.conditioning)
      return target_.spectrum.mean[*target_.conditioning] - spectra_(j, *target_.conditioning);
    return std::clamp((simulated_.row(place) - spectra_.row(j)).mean(),
                      std::log(options_.smallest_factor), std::log(options_.largest_factor));
  }

  bool is_usable(Index j) const {
    if (!options_.scaled || !target_.conditioning) return true;
    const double factor = std::exp(ln_factor(0, j));
    return options_.smallest_factor <= factor && factor <= options_.largest_factor;
  }

  bool is_free(Index j) const {
    return std::ranges::find(records_, j) == records_.end() && events_.allows(j) &&
           stations_.allows(j);
  }

  Eigen::RowVectorXd scaled(Index place, Index j) const {
    return spectra_.row(j).array() + ln_factor(place, j);
  }

  void put(Index place, Index j) {
    records_[static_cast<std::size_t>(place)] = j;
    chosen_.row(place) = scaled(place, j);
    events_.change(j, 1);
    stations_.change(j, 1);
  }

  /// Takes the record of a place out, and returns it.
  Index take_out(Index place) {
    const Index j = std::exchange(records_[static_cast<std::size_t>(place)], -1);
    events_.change(j, -1);
    stations_.change(j, -1);
    return j;
  }

  double total() const {
    return spectra_errors(chosen_, target_.spectrum).total(options_.sigma_weight);
  }

  void take_nearest() {
    records_.assign(static_cast<std::size_t>(options_.count), -1);
    for (Index place = 0; place < options_.count; ++place) {
      Index nearest = -1;
      double smallest = kInfinity;
      for (const Index j : usable_) {
        const double distance = (scaled(place, j) - simulated_.row(place)).squaredNorm();
        if (distance < smallest && is_free(j)) {
          smallest = distance;
          nearest = j;
        }
      }
      require(nearest >= 0,
              fmt::format("only {} of {} records found, with at most {} of one event and {} of one "
                          "station (0: any number)",
                          place, options_.count, options_.per_event, options_.per_station));
      put(place, nearest);
    }
  }

  /// Replaces the record of a place by the one that lowers the total error most.
  ///
  /// With the sums A and B of x = ln Sa - mu and x^2 of the others, a candidate y gives the mean m
  /// = (A + y) / N and the variance (B + y^2 - N m^2) / (N - 1).
  void improve(Index place) {
    const auto n = static_cast<double>(options_.count);
    const Index before = take_out(place);
    const Eigen::RowVectorXd mu = target_.spectrum.mean.transpose();
    const Eigen::RowVectorXd sigma = target_.spectrum.sigma().transpose();
    Eigen::MatrixXd others = chosen_.rowwise() - mu;
    others.row(place).setZero();
    const Eigen::ArrayXXd a = others.colwise().sum();
    const Eigen::ArrayXXd b = others.colwise().squaredNorm();
    const auto error = [&](Index j) {
      const Eigen::ArrayXXd y = scaled(place, j) - mu;
      const Eigen::ArrayXXd m = (a + y) / n;
      const Eigen::ArrayXXd s = ((b + y.square() - n * m.square()) / (n - 1)).max(0).sqrt();
      return m.square().sum() + options_.sigma_weight * (s - sigma.array()).square().sum();
    };
    Index best = before;
    double smallest = error(before);
    for (const Index j : usable_) {
      const double with_j = error(j);
      if (with_j < smallest && is_free(j)) {
        smallest = with_j;
        best = j;
      }
    }
    put(place, best);
  }

  void improve() {
    constexpr double kConverged = 1e-3;
    double last, now = total();
    do {
      const Eigen::MatrixXd spectra = chosen_;
      const std::vector<Index> records = records_;
      for (Index place = 0; place < options_.count; ++place) improve(place);
      last = now;
      now = total();
      if (now > last) {  // by rounding alone, in the last round
        chosen_ = spectra;
        records_ = records;
      }
    } while (last - now > kConverged * last);
  }

  Selection sorted() const {
    std::vector<Index> places(static_cast<std::size_t>(options_.count));
    std::iota(places.begin(), places.end(), 0);
    std::ranges::sort(places, {}, [&](Index p) { return records_[static_cast<std::size_t>(p)]; });
    Selection result;
    result.ln_spectra.resize(chosen_.rows(), chosen_.cols());
    result.factors.resize(options_.count);
    for (const Index place : places) {
      const auto i = std::ssize(result.records);
      result.records.push_back(records_[static_cast<std::size_t>(place)]);
      result.factors[i] = std::exp(ln_factor(place, result.records.back()));
      result.ln_spectra.row(i) = chosen_.row(place);
    }
    const Eigen::MatrixXd apart = result.ln_spectra.rowwise() - target_.spectrum.mean.transpose();
    result.misfits = apart.array().square().rowwise().mean().sqrt();
    result.errors = spectra_errors(result.ln_spectra, target_.spectrum);
    result.total = result.errors.total(options_.sigma_weight);
    return result;
  }

  const SelectionTarget& target_;
  const Eigen::MatrixXd& spectra_;
  const SelectionOptions& options_;
  Eigen::MatrixXd simulated_, chosen_;
  GroupLimit events_, stations_;
  std::vector<Index> usable_;
  std::vector<Index> records_;  ///< of each place
};

void check(const SelectionTarget& target, const Candidates& candidates,
           const SelectionOptions& options) {
  const auto rows = static_cast<std::size_t>(candidates.ln_spectra.rows());
  require(candidates.events.size() == rows && candidates.stations.size() == rows &&
              (rows == 0 || candidates.ln_spectra.cols() == target.spectrum.periods.size()),
          "selection: spectra, events, stations and periods do not go together");
  require(candidates.ln_spectra.allFinite(), "selection: a spectrum is not finite");
  require(options.count >= 2, fmt::format("{} records to select: must be >= 2", options.count));
  require(0 < options.smallest_factor && options.smallest_factor < options.largest_factor,
          fmt::format("factors from {:g} to {:g}: must be > 0 and increase",
                      options.smallest_factor, options.largest_factor));
  require(options.per_event >= 0 && options.per_station >= 0 && options.trials >= 1 &&
              options.sigma_weight >= 0,
          "selection: limits and the weight of sigma must be >= 0, trials >= 1");
}

}  // namespace

double SpectraErrors::total(double sigma_weight) const {
  return mean.squaredNorm() + sigma_weight * sigma.squaredNorm();
}

SpectraErrors spectra_errors(const Eigen::MatrixXd& ln_spectra,
                             const SpectrumDistribution& target) {
  const Eigen::RowVectorXd mean = ln_spectra.colwise().mean();
  const Eigen::MatrixXd apart = ln_spectra.rowwise() - mean;
  const Eigen::VectorXd sigma =
      (apart.colwise().squaredNorm() / static_cast<double>(ln_spectra.rows() - 1)).cwiseSqrt();
  return {mean.transpose() - target.mean, sigma - target.sigma()};
}

Eigen::MatrixXd simulated_spectra(const SpectrumDistribution& target,
                                  const SelectionOptions& options) {
  const Index periods = target.periods.size();
  const NaturalModes axes =
      natural_modes(target.covariance, Eigen::MatrixXd::Identity(periods, periods));
  const Eigen::MatrixXd factor =
      axes.shapes * axes.squared_frequencies.cwiseMax(0).cwiseSqrt().asDiagonal();
  Eigen::MatrixXd best;
  double smallest = kInfinity;
  for (int trial = 0; trial < options.trials; ++trial) {
    const auto score = [&](Index i, Index k) {
      return normal_quantile(latin_hypercube_draw(
          options.seed, static_cast<std::uint64_t>(trial * periods + k),
          static_cast<std::uint64_t>(i), static_cast<std::uint64_t>(options.count)));
    };
    const Eigen::MatrixXd z = Eigen::MatrixXd::NullaryExpr(options.count, periods, score);
    const Eigen::MatrixXd spectra = (z * factor.transpose()).rowwise() + target.mean.transpose();
    const double total = spectra_errors(spectra, target).total(options.sigma_weight);
    if (total < smallest) {
      smallest = total;
      best = spectra;
    }
  }
  return best;
}

Selection select_records(const SelectionTarget& target, const Candidates& candidates,
                         const SelectionOptions& options) {
  check(target, candidates, options);
  return Selector(target, candidates, options).run();
}

}  // namespace gurney::groundmotions
