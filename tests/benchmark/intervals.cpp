#include <fmt/core.h>

#include <array>
#include <cmath>
#include <vector>

#include "studies/statistics/hazard.h"
#include "tests/benchmark/sections.h"
#include "tests/studies/statistics/synthetic.h"

namespace gurney::benchmark {
namespace {

namespace st = statistics;

constexpr std::array<double, 5> kProbabilities{0.05, 0.16, 0.5, 0.84, 0.95};

/// How often the 95 % intervals of synthetic studies contain what the studies were made with.
struct Counts {
  int fitted = 0, theta = 0, beta = 0, of_table = 0, of_law = 0;
  std::array<int, kProbabilities.size()> band{};
};

/// A hazard that falls faster for stronger motions, from 0.05 to 2.
st::HazardCurve site() {
  std::vector<double> im, rate;
  for (const double x : {0.05, 0.1, 0.2, 0.4, 0.7, 1.0, 1.5, 2.0}) {
    im.push_back(x);
    rate.push_back(1e-3 * std::pow(x / 0.2, -1.5 - 0.5 * std::log(x / 0.05)));
  }
  return st::HazardCurve::table(im, rate);
}

std::vector<double> spaced(int count, double low, double high) {
  std::vector<double> levels;
  for (int i = 0; i < count; ++i) levels.push_back(low * std::pow(high / low, i / (count - 1.0)));
  return levels;
}

Counts count(const st::SyntheticStudy& study, int repeats) {
  const st::HazardCurve table = site(), law = st::HazardCurve::power_law(1e-4, 3);
  std::vector<double> im;
  for (const double p : kProbabilities) im.push_back(study.curve.quantile(p));
  Counts counts;
  for (int repeat = 0; repeat < repeats; ++repeat) {
    const auto seed = static_cast<std::uint64_t>(1000 + repeat);
    const auto band = st::fragility_band(st::StripeTable(study.outcomes(seed)), im);
    if (band.status != st::FragilityStatus::kFitted || band.too_few) continue;
    ++counts.fitted;
    for (std::size_t i = 0; i < im.size(); ++i)
      counts.band[i] += band.of_curve[i].contains(kProbabilities[i]);
    counts.theta += band.theta.contains(study.curve.theta);
    counts.beta += band.beta.contains(study.curve.beta);
    const auto contains = [&](const st::HazardCurve& hazard) {
      return st::rate_interval(band.outline, hazard)
          .contains(st::mean_rate(study.curve, hazard).rate);
    };
    counts.of_table += contains(table);
    counts.of_law += contains(law);
  }
  return counts;
}

}  // namespace

void print_intervals(int repeats) {
  fmt::print(
      "Coverage of 95 % intervals [%], {} synthetic studies each with theta = beta = 0.4\n\n"
      "| levels | r | records | with a curve | band at P = 5, 16, 50, 84, 95 % | theta | beta | "
      "rate, table | rate, k = 3 |\n"
      "| --- | --- | --- | --- | --- | --- | --- | --- | --- |\n",
      repeats);
  for (const std::vector<double>& levels : {spaced(6, 0.1, 1), spaced(9, 0.16, 1)})
    for (const double correlation : {0.0, 0.5, 1.0})
      for (const std::size_t records : {8u, 12u, 20u, 40u}) {
        const Counts of = count({{0.4, 0.4}, records, levels, correlation}, repeats);
        const auto share = [&](int each) { return 100.0 * each / of.fitted; };
        fmt::print(
            "| {} | {:g} | {} | {:.0f} | {:.1f} {:.1f} {:.1f} {:.1f} {:.1f} | {:.1f} | {:.1f} | "
            "{:.1f} | {:.1f} |\n",
            levels.size(), correlation, records, 100.0 * of.fitted / repeats, share(of.band[0]),
            share(of.band[1]), share(of.band[2]), share(of.band[3]), share(of.band[4]),
            share(of.theta), share(of.beta), share(of.of_table), share(of.of_law));
      }
}

}  // namespace gurney::benchmark
