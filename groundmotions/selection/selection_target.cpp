#include "groundmotions/selection/selection_target.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "engine/base/error.h"
#include "engine/base/units.h"
#include "groundmotions/scaling/target_spectrum.h"

namespace gurney::groundmotions {
namespace {

using config::Range;
using config::Table;
using Eigen::Index;

const std::vector<std::string> kFaulting = {"unspecified", "strike-slip", "normal", "reverse"};

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

/// T* of the key period_s, which lies among the periods.
Periods read_periods(Table& in, const Eigen::VectorXd& periods, bool required) {
  const Range range = Range::within(periods[0], periods[periods.size() - 1]);
  if (!required && !in.has("period_s")) return {periods, {}};
  return with_period(periods, in.number("period_s", range));
}

struct NamedScenario {
  Scenario scenario;
  std::string name;
};

NamedScenario read_scenario(Table& in) {
  Scenario s;
  s.magnitude = in.number("magnitude", Range::within(3, 8.5));
  s.distance = in.number("distance_km", Range::within(0, 400));
  s.vs30 = in.number("vs30_m_per_s", Range::within(150, 1500), s.vs30);
  const std::size_t faulting = in.choice("faulting", kFaulting, 0);
  s.faulting = static_cast<Faulting>(faulting);
  return {s, fmt::format("Boore et al. (2014), M {:g}, R_JB {:g} km, V_S30 {:g} m/s{}", s.magnitude,
                         s.distance, s.vs30, faulting == 0 ? "" : ", " + kFaulting[faulting])};
}

SelectionTarget read_bssa14(Table& in, const Eigen::VectorXd& periods) {
  const NamedScenario of = read_scenario(in);
  return {of.name, bssa14_spectrum(of.scenario, periods)};
}

SelectionTarget read_conditional(Table& in, const Eigen::VectorXd& range) {
  const NamedScenario of = read_scenario(in);
  const auto [periods, at] = read_periods(in, range, true);
  const bool by_epsilon = in.has("epsilon");
  if (by_epsilon == in.has("sa_g"))
    in.note("epsilon", ": a conditional spectrum needs epsilon or sa_g, one of the two");
  const double given = by_epsilon ? in.number("epsilon", Range::within(-6, 6))
                                  : in.number("sa_g", Range::positive(), 1) * kStandardGravity;
  const SpectrumDistribution all = bssa14_spectrum(of.scenario, periods);
  const double mean = all.mean[*at], sigma = all.sigma()[*at];
  const double ln_sa = by_epsilon ? mean + sigma * given : std::log(given);
  return {fmt::format("Sa({:g} s) = {:.4g} g, epsilon {:.3g}; {}", periods[*at],
                      std::exp(ln_sa) / kStandardGravity, (ln_sa - mean) / sigma, of.name),
          conditioned(all, *at, ln_sa), at};
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

SourceFile file_of(Table& in) {
  const auto folder = std::filesystem::path(in.document().path()).parent_path();
  return SourceFile(folder / in.text("file"));
}

SelectionTarget read_openquake(Table& in, const Eigen::VectorXd& periods) {
  std::optional<double> poe;
  if (in.has("poe")) poe = in.number("poe", Range::within(0, 1).open_below().open_above());
  return selection_of(in, openquake_spectrum(file_of(in), poe), periods);
}

SelectionTarget read_one(Table& in, const Eigen::VectorXd& periods) {
  const std::string kind = in.is_text("target") ? in.text("target") : std::string();
  if (kind == "bssa14") return read_bssa14(in, periods);
  if (kind == "conditional") return read_conditional(in, periods);
  if (kind == "openquake") return read_openquake(in, periods);
  const auto target = read_target(in, {"bssa14", "conditional", "openquake"});
  return target ? selection_of(in, *target, periods) : SelectionTarget{};
}

}  // namespace

std::optional<SelectionTarget> read_selection_target(Table& in, const Eigen::VectorXd& periods) {
  const std::size_t errors = in.document().errors();
  try {
    SelectionTarget target = read_one(in, periods);
    if (in.document().errors() == errors) return target;
  } catch (const Error& error) {
    if (in.document().errors() == errors) in.note("target", std::string(": ") + error.what());
  }
  return {};
}

}  // namespace gurney::groundmotions
