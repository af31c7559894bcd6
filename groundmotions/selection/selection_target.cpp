#include "groundmotions/selection/selection_target.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "engine/base/error.h"
#include "engine/base/units.h"
#include "groundmotions/hazard/disaggregation.h"
#include "groundmotions/scaling/target_spectrum.h"

namespace gurney::groundmotions {
namespace {

using config::Range;
using config::Table;
using Eigen::Index;

/// Periods with T* among them, and where it stands.
struct Periods {
  Eigen::VectorXd values;
  std::optional<Index> conditioning;
};

/// Replaces a period that is T* but for rounding: two that are fully correlated have no partial
/// correlation.
Periods with_period(Eigen::VectorXd periods, double period) {
  constexpr double kSame = 1e-6;
  const Index at = std::ranges::lower_bound(periods, period * (1 - kSame)) - periods.begin();
  if (at < periods.size() && periods[at] <= period * (1 + kSame)) {
    periods[at] = period;
    return {periods, at};
  }
  Eigen::VectorXd all(periods.size() + 1);
  all << periods.head(at), period, periods.tail(periods.size() - at);
  return {all, at};
}

Range range_of(const Eigen::VectorXd& periods) {
  return Range::within(periods[0], periods[periods.size() - 1]);
}

/// T* of the key period_s, which lies among the periods.
Periods read_periods(Table& in, const Eigen::VectorXd& periods, bool required) {
  const Range range = range_of(periods);
  if (!required && !in.has("period_s")) return {periods, {}};
  return with_period(periods, in.number("period_s", range));
}

struct NamedScenario {
  Scenario scenario;
  std::string name;
};

constexpr double kSmallest = 3, kLargest = 8.5, kFarthest = 400;  // of the model; [km]

NamedScenario read_scenario(Table& in, const Disaggregation* of = nullptr) {
  Scenario s;
  s.magnitude = of ? of->magnitude : in.number("magnitude", Range::within(kSmallest, kLargest));
  s.distance = of ? of->distance : in.number("distance_km", Range::within(0, kFarthest));
  s.vs30 = in.number("vs30_m_per_s", Range::within(150, 1500), s.vs30);
  const std::size_t faulting = in.choice("faulting", faulting_names(), 0);
  s.faulting = static_cast<Faulting>(faulting);
  return {s,
          fmt::format("Boore et al. (2014), M {:g}, R_JB {:g} km, V_S30 {:g} m/s{}", s.magnitude,
                      s.distance, s.vs30, faulting == 0 ? "" : ", " + faulting_names()[faulting])};
}

SelectionTarget read_bssa14(Table& in, const Eigen::VectorXd& periods) {
  const NamedScenario of = read_scenario(in);
  return {of.name, bssa14_spectrum(of.scenario, periods)};
}

/// The spectra of a scenario with the Sa(T*) that `ln_sa` makes of mean and sigma of ln Sa(T*).
template <typename LnSa>
SelectionTarget given_acceleration(const NamedScenario& of, const Periods& periods,
                                   const LnSa& ln_sa_of) {
  const Index at = *periods.conditioning;
  const SpectrumDistribution all = bssa14_spectrum(of.scenario, periods.values);
  const double mean = all.mean[at], sigma = all.sigma()[at], ln_sa = ln_sa_of(mean, sigma);
  return {fmt::format("Sa({:g} s) = {:.4g} g, epsilon {:.3g}; {}", periods.values[at],
                      std::exp(ln_sa) / kStandardGravity, (ln_sa - mean) / sigma, of.name),
          conditioned(all, at, ln_sa), at};
}

SelectionTarget read_conditional(Table& in, const Eigen::VectorXd& range) {
  const NamedScenario of = read_scenario(in);
  const auto [periods, at] = read_periods(in, range, true);
  const bool by_epsilon = in.has("epsilon");
  if (by_epsilon == in.has("sa_g"))
    in.note("epsilon", ": a conditional spectrum needs epsilon or sa_g, one of the two");
  const double given = by_epsilon ? in.number("epsilon", Range::within(-6, 6))
                                  : in.number("sa_g", Range::positive(), 1) * kStandardGravity;
  return given_acceleration(of, {periods, at}, [&](double mean, double sigma) {
    return by_epsilon ? mean + sigma * given : std::log(given);
  });
}

SelectionTarget read_disaggregated(Table& in, const Eigen::VectorXd& range) {
  DisaggregationRequest request;
  if (in.has("period_s")) request.period = in.number("period_s", range_of(range));
  if (in.has("poe")) request.poe = in.number("poe", Range::within(0, 1).open_below().open_above());
  const std::string file = target_file(in).string();
  for (const char* key : {"vs30_m_per_s", "faulting"})
    in.has(key);  // known, even if the file is wrong
  const Disaggregation found = read_disaggregation(file, request);
  require(found.period >= range[0] && found.period <= range[range.size() - 1],
          fmt::format("T* = {:g} s: must be in the range of periods", found.period));
  require(
      found.magnitude >= kSmallest && found.magnitude <= kLargest && found.distance >= 0 &&
          found.distance <= kFarthest,
      fmt::format("M {:g} at {:g} km: the ground-motion model is for {:g} to {:g}, up to {:g} km",
                  found.magnitude, found.distance, kSmallest, kLargest, kFarthest));
  NamedScenario of = read_scenario(in, &found);
  of.name += fmt::format(
      "; mean of the disaggregation {}{}", std::filesystem::path(file).filename().string(),
      found.epsilon ? fmt::format(", whose epsilon is {:.3g}", *found.epsilon) : std::string());
  return given_acceleration(of, with_period(range, found.period),
                            [&](double, double) { return std::log(found.acceleration); });
}

/// Medians, and sigma where it is stated, of a spectrum.
SelectionTarget selection_of(Table& in, const TargetSpectrum& target,
                             const Eigen::VectorXd& range) {
  const auto [periods, at] = read_periods(in, range, false);
  const auto at_periods = [&](const auto& function) -> Eigen::VectorXd {
    return periods.unaryExpr(function);
  };
  const Eigen::VectorXd median = at_periods([&](double t) { return target.at(t); });
  const Eigen::VectorXd sigma =
      target.sigma ? at_periods(target.sigma) : Eigen::VectorXd::Zero(periods.size()).eval();
  return {
      at ? fmt::format("{}, conditional on Sa({:g} s)", target.name, periods[*at]) : target.name,
      correlated_spectrum(periods, median, sigma, at), at, target.damping};
}

SelectionTarget read_openquake(Table& in, const Eigen::VectorXd& periods) {
  std::optional<double> poe;
  if (in.has("poe")) poe = in.number("poe", Range::within(0, 1).open_below().open_above());
  return selection_of(in, openquake_spectrum(SourceFile(target_file(in)), poe), periods);
}

SelectionTarget read_one(Table& in, const Eigen::VectorXd& periods) {
  const std::string kind = in.is_text("target") ? in.text("target") : std::string();
  if (kind == "bssa14") return read_bssa14(in, periods);
  if (kind == "conditional") return read_conditional(in, periods);
  if (kind == "disaggregation") return read_disaggregated(in, periods);
  if (kind == "openquake") return read_openquake(in, periods);
  const auto target = read_target(in, {"bssa14", "conditional", "disaggregation", "openquake"});
  return target ? selection_of(in, *target, periods) : SelectionTarget{};
}

}  // namespace

std::optional<SelectionTarget> read_selection_target(Table& in, const Eigen::VectorXd& periods) {
  const std::size_t errors = in.document().errors();
  try {
    SelectionTarget target = read_one(in, periods);
    if (in.document().errors() == errors) return target;
  } catch (const Error& error) {
    if (in.document().errors() == errors) note_target(in, error);
  }
  return {};
}

}  // namespace gurney::groundmotions
