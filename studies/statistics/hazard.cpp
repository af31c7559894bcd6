#include "studies/statistics/hazard.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "engine/base/error.h"
#include "engine/base/random/normal_draw.h"
#include "studies/statistics/special.h"

namespace gurney::statistics {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kPanel = 0.05;

double rate_at(const HazardCurve::Piece& piece, double im) {
  return im == kInfinity ? 0 : std::exp(piece.log_factor - piece.exponent * std::log(im));
}

double rate_of_piece(const LognormalCurve& curve, const HazardCurve::Piece& piece) {
  const auto product = [&](double im) {  // P times rate, 0 at both infinite ends
    return im > 0 && im < kInfinity ? curve.probability(im) * rate_at(piece, im) : 0;
  };
  const double k = piece.exponent, shift = k * curve.beta;
  const double low = std::log(piece.low / curve.theta) / curve.beta;
  const double high = std::log(piece.high / curve.theta) / curve.beta;
  const double log_scale = piece.log_factor - k * std::log(curve.theta) + shift * shift / 2;
  return product(piece.low) - product(piece.high) +
         std::exp(log_scale + log_normal_between(low + shift, high + shift));
}

template <typename Probability>
MeanRate with_ends(const Probability& probability, const HazardCurve& hazard) {
  MeanRate result;
  const HazardCurve::Piece& first = hazard.pieces().front();
  const HazardCurve::Piece& last = hazard.pieces().back();
  if (first.low > 0) result.below = probability(first.low);
  if (last.high < kInfinity) {
    const double end = rate_at(last, last.high);
    result.rate = probability(last.high) * end;
    result.most_above = (1 - probability(last.high)) * end;
  }
  return result;
}

}  // namespace

HazardCurve HazardCurve::table(std::vector<double> im, std::vector<double> rate) {
  require(im.size() == rate.size() && im.size() >= 2,
          fmt::format("{} intensities have {} rates: must be 2 or more of each", im.size(),
                      rate.size()));
  HazardCurve hazard;
  for (std::size_t i = 0; i < im.size(); ++i) {
    require(im[i] > 0 && std::isfinite(im[i]), fmt::format("im[{}] = {:g} must be > 0", i, im[i]));
    require(rate[i] > 0 && std::isfinite(rate[i]),
            fmt::format("rate[{}] = {:g} must be > 0", i, rate[i]));
    if (i == 0) continue;
    require(im[i] > im[i - 1],
            fmt::format("im[{}] = {:g} must be above {:g}", i, im[i], im[i - 1]));
    require(rate[i] < rate[i - 1],
            fmt::format("rate[{}] = {:g} must be below {:g}", i, rate[i], rate[i - 1]));
    const double k = std::log(rate[i - 1] / rate[i]) / std::log(im[i] / im[i - 1]);
    hazard.pieces_.push_back({im[i - 1], im[i], std::log(rate[i]) + k * std::log(im[i]), k});
  }
  return hazard;
}

HazardCurve HazardCurve::power_law(double k0, double k) {
  require(k0 > 0 && std::isfinite(k0), fmt::format("k0 = {:g} must be > 0", k0));
  require(k > 0 && std::isfinite(k), fmt::format("k = {:g} must be > 0", k));
  HazardCurve hazard;
  hazard.pieces_.push_back({0, kInfinity, std::log(k0), k});
  return hazard;
}

std::optional<double> HazardCurve::rate(double im) const {
  for (const Piece& piece : pieces_)
    if (im > 0 && piece.low <= im && im <= piece.high) return rate_at(piece, im);
  return {};
}

MeanRate mean_rate(const LognormalCurve& curve, const HazardCurve& hazard) {
  MeanRate result = with_ends([&](double im) { return curve.probability(im); }, hazard);
  for (const HazardCurve::Piece& piece : hazard.pieces())
    result.rate += rate_of_piece(curve, piece);
  return result;
}

double rate_between(const LognormalCurve& curve, const HazardCurve& hazard, double low,
                    double high) {
  double rate = 0;
  for (HazardCurve::Piece piece : hazard.pieces()) {
    piece.low = std::max(piece.low, low);
    piece.high = std::min(piece.high, high);
    if (piece.low < piece.high) rate += rate_of_piece(curve, piece);
  }
  return rate;
}

MeanRate mean_rate(const std::function<double(double)>& probability, const HazardCurve& hazard) {
  require(hazard.pieces().back().high < kInfinity,
          "a curve that is not lognormal needs a hazard table, not a power law");
  // Abramowitz & Stegun 1964, table 25.4, n = 3
  const double root = std::sqrt(0.6);
  const std::array<double, 3> places{-root, 0, root}, weights{5 / 9.0, 8 / 9.0, 5 / 9.0};
  MeanRate result = with_ends(probability, hazard);
  for (const HazardCurve::Piece& piece : hazard.pieces()) {
    const double width = std::log(piece.high / piece.low);
    const int panels = static_cast<int>(std::ceil(width / kPanel));
    const double half = width / panels / 2;
    for (int panel = 0; panel < panels; ++panel) {
      for (std::size_t i = 0; i < places.size(); ++i) {
        const double im = piece.low * std::exp(half * (2 * panel + 1 + places[i]));
        result.rate += weights[i] * half * probability(im) * piece.exponent * rate_at(piece, im);
      }
    }
  }
  return result;
}

double probability_in(double years, double rate) { return -std::expm1(-rate * years); }

namespace {

double rate_of(const Eigen::Vector2d& line, const HazardCurve& hazard) {
  if (line[0] > 0) {
    const LognormalCurve curve{std::exp(-line[1] / line[0]), 1 / line[0]};
    // A slope so small that theta or the rate overflows is one of 0.
    const double rate = std::isnormal(curve.theta) ? mean_rate(curve, hazard).rate : kInfinity;
    if (std::isfinite(rate)) return rate;
  }
  if (hazard.pieces().front().low == 0) return kInfinity;
  return mean_rate([&](double im) { return normal_cdf(line[0] * std::log(im) + line[1]); }, hazard)
      .rate;
}

}  // namespace

Interval rate_interval(const std::vector<Eigen::Vector2d>& outline, const HazardCurve& hazard) {
  if (outline.empty()) return {0, kInfinity};
  Interval interval{kInfinity, 0};
  for (const Eigen::Vector2d& line : outline) {
    const double rate = rate_of(line, hazard);
    interval = {std::min(interval.low, rate), std::max(interval.high, rate)};
  }
  return interval;
}

namespace {

void require_probabilities(const std::vector<double>& probabilities) {
  for (std::size_t i = 0; i < probabilities.size(); ++i)
    require(probabilities[i] >= 0 && probabilities[i] <= 1,
            fmt::format("probability[{}] = {:g} must be within [0, 1]", i, probabilities[i]));
}

}  // namespace

LevelProbabilities level_probabilities(const std::vector<double>& exceedance) {
  require_probabilities(exceedance);
  LevelProbabilities result;
  double better = 1;
  for (const double probability : exceedance) {
    result.crossed = result.crossed || probability > better;
    const double here = std::min(better, probability);
    result.of_level.push_back(better - here);
    better = here;
  }
  result.of_level.push_back(better);
  return result;
}

}  // namespace gurney::statistics
