#include "studies/report/fragility_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "engine/base/units.h"
#include "studies/analysis/performance.h"

namespace gurney {
namespace {

using Json = nlohmann::ordered_json;

std::string interval_text(const Interval& interval, double unit, int digits) {
  const auto end = [&](double value) {
    return std::isfinite(value) ? fmt::format("{:.{}g}", value / unit, digits) : std::string("inf");
  };
  return end(interval.low) + " to " + end(interval.high);
}

/// What is known of theta where there is no curve.
std::string bound_text(const FragilityResult& result, const IntensityUnit& unit) {
  const double low = result.capacities ? result.capacities->low : result.fit.low;
  const double high = result.capacities ? result.capacities->high : result.fit.high;
  switch (result.capacities ? result.capacities->status : result.fit.status) {
    case FragilityStatus::kAllExceed:
      return fmt::format("theta below {:.3g}", high / unit.in_si);
    case FragilityStatus::kNoneExceeds:
      return fmt::format("theta above {:.3g}", low / unit.in_si);
    case FragilityStatus::kSeparated:
      return fmt::format("theta between {:.3g} and {:.3g}", low / unit.in_si, high / unit.in_si);
    case FragilityStatus::kQuasiSeparated:
      return fmt::format("theta at {:.3g}", low / unit.in_si);
    default:
      return "";
  }
}

std::string row(const FragilityResult& result, const IntensityUnit& unit, std::size_t wide,
                std::size_t state_wide) {
  std::string line = fmt::format("{:<{}}  {:<{}}  {:>5} of {:<5}  ", result.configuration, wide,
                                 result.state, state_wide, result.exceeded, result.runs);
  if (const auto curve = result.curve()) {
    line += fmt::format("{:>8.3g}  {:>5.2f}  ", curve->theta / unit.in_si, curve->beta);
    if (!result.capacities)
      line += fmt::format("{:<16}  {}", interval_text(result.band.theta, unit.in_si, 3),
                          interval_text(result.band.beta, 1, 2));
  } else {
    const FragilityStatus status =
        result.capacities ? result.capacities->status : result.fit.status;
    const std::string bound = bound_text(result, unit);
    line += text(status) + (bound.empty() ? "" : ": " + bound);
  }
  return line + "\n";
}

/// One line for each thing a reader should know before using a row.
std::string notes(const FragilityResult& result, const IntensityUnit& unit) {
  std::string text;
  const std::string name =
      (result.configuration.empty() ? "" : result.configuration + ", ") + result.state;
  const auto note = [&](const std::string& line) { text += name + ": " + line + "\n"; };
  if (result.failed > 0) note(fmt::format("{} failed runs are left out", result.failed));
  if (result.fit.curve && result.check && result.check->p_simulated < 0.05)
    note(fmt::format("a lognormal curve fits badly (p = {:.2g}); see the fractions in the figure",
                     result.check->p_simulated));
  if (result.capacities && result.capacities->resurrections > 0)
    note(fmt::format("{} runs above the capacity of their record did not exceed again",
                     result.capacities->resurrections));
  if (result.capacities && result.capacities->censored > 0)
    note(fmt::format("{} of {} records never exceed; they count as above their highest intensity",
                     result.capacities->censored, result.records));
  if (result.cloud && result.cloud_curve)
    note(fmt::format(
        "cloud: theta {:.3g}, beta {:.2f}, R2 {:.2f} ({} demands, {} at least, {} at "
        "most)",
        result.cloud_curve->theta / unit.in_si, result.cloud_curve->beta, result.cloud->r_squared,
        result.cloud->exact, result.cloud->at_least, result.cloud->at_most));
  if (result.rate) {
    note(fmt::format("{:.3g} times a year, {:.2g} % in 50 years", result.rate->rate,
                     100 * probability_in(50, result.rate->rate)));
    if (!result.rate->complete())
      note(
          fmt::format("the hazard curve is too short: stronger motions add at most {:.2g} a year, "
                      "and P is {:.2g} at its lower end",
                      result.rate->most_above, result.rate->below));
  }
  return text;
}

std::string performance_text(const StudyData& data, const std::vector<FragilityResult>& results,
                             const IntensityUnit& unit) {
  std::string text;
  for (const PerformanceTable& table : performance_tables(data, results)) {
    text += fmt::format("\n{}P(worst level reached), %\n{:>10}  {:>10}",
                        table.configuration.empty() ? "" : table.configuration + ": ",
                        results.front().measure.name, "none");
    for (const std::string& level : table.levels) text += fmt::format("  {:>10}", level);
    text += "\n";
    for (std::size_t i = 0; i < table.im.size(); ++i) {
      text += fmt::format("{:>10}", fmt::format("{:.3g} {}", table.im[i] / unit.in_si, unit.name));
      for (const double probability : table.at[i].of_level)
        text += fmt::format("  {:>10.1f}", 100 * probability);
      text += table.at[i].crossed ? "  curves cross: the worse is cut to the milder\n" : "\n";
    }
  }
  return text;
}

template <class Take>
std::size_t widest(const std::vector<FragilityResult>& results, std::size_t least, Take take) {
  for (const FragilityResult& each : results) least = std::max(least, take(each).size());
  return least;
}

Json number(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

Json interval(const Interval& of) { return Json::array({number(of.low), number(of.high)}); }

Json curve_json(const std::optional<LognormalCurve>& curve) {
  if (!curve) return nullptr;
  return {{"theta", curve->theta}, {"beta", curve->beta}};
}

Json json_of(const FragilityResult& result) {
  Json json{{"configuration", result.configuration},
            {"limit_state", result.state},
            {"says", result.words},
            {"measure", result.measure.name},
            {"units", result.measure.units},
            {"runs", result.runs},
            {"exceeded", result.exceeded},
            {"records", result.records},
            {"failed", result.failed},
            {"method", result.capacities ? "capacities" : "stripes"},
            {"status", text(result.capacities ? result.capacities->status : result.fit.status)},
            {"curve", curve_json(result.curve())}};
  if (result.fit.curve && !result.capacities) {
    json["theta_interval"] = interval(result.band.theta);
    json["beta_interval"] = interval(result.band.beta);
    const Eigen::Matrix2d& c = result.fit.cluster_covariance;
    json["covariance_of_ln_theta_ln_beta"] = {{c(0, 0), c(0, 1)}, {c(1, 0), c(1, 1)}};
  }
  if (result.profile)
    json["profile"] = {{"theta", interval(result.profile->theta)},
                       {"beta", interval(result.profile->beta)}};
  if (result.check) json["p_of_fit"] = number(result.check->p_simulated);
  for (std::size_t i = 0; i < result.stripes.size(); ++i)
    json["stripes"].push_back({{"im", result.stripes[i].im},
                               {"runs", result.stripes[i].runs},
                               {"exceeded", result.stripes[i].exceeded},
                               {"isotonic", result.isotonic[i]}});
  for (std::size_t i = 0; i < result.im.size(); ++i)
    json["band"].push_back(
        {result.im[i], result.band.of_curve[i].low, result.band.of_curve[i].high});
  if (result.capacities)
    json["capacities"] = {{"censored", result.capacities->censored},
                          {"resurrections", result.capacities->resurrections}};
  if (result.cloud)
    json["cloud"] = {{"status", text(result.cloud->status)},
                     {"a", number(result.cloud->a)},
                     {"b", number(result.cloud->b)},
                     {"sigma", number(result.cloud->sigma)},
                     {"curve", curve_json(result.cloud_curve)}};
  if (result.rate)
    json["rate"] = {{"per_year", result.rate->rate},
                    {"in_50_years", probability_in(50, result.rate->rate)},
                    {"at_most_more", result.rate->most_above},
                    {"complete", result.rate->complete()}};
  return json;
}

}  // namespace

IntensityUnit unit_to_tell(const StudyData& data, const RunMeasure& measure) {
  const IntensityPlan& plan = data.study().intensity;
  if (plan.unit_in_si != 1 && measure.name == data.file().text_attribute("intensity_measure"))
    return {plan.unit, plan.unit_in_si};
  if (measure.units == "m/s2") return {"g", kStandardGravity};
  return {measure.units, 1};
}

std::string fragility_report(const StudyData& data, const std::vector<FragilityResult>& results) {
  if (results.empty()) return "";
  const IntensityUnit unit = unit_to_tell(data, results.front().measure);
  const std::size_t wide =
      widest(results, 13, [](const FragilityResult& each) { return each.configuration; });
  const std::size_t state_wide =
      widest(results, 11, [](const FragilityResult& each) { return each.state; });
  std::string text = fmt::format("P(limit state | {} [{}]) = Phi(ln(im / theta) / beta)\n\n",
                                 results.front().measure.name, unit.name);
  text += fmt::format("{:<{}}  {:<{}}  {:>14}  {:>8}  {:>5}  {:<16}  {}\n", "configuration", wide,
                      "limit state", state_wide, "exceed", "theta", "beta", "95 % of theta",
                      "95 % of beta");
  for (const FragilityResult& each : results) text += row(each, unit, wide, state_wide);
  std::string below;
  for (const FragilityResult& each : results) below += notes(each, unit);
  text += below.empty() ? "" : "\n" + below;
  text += performance_text(data, results, unit);
  text += "\n";
  std::vector<std::string> told;
  for (const FragilityResult& each : results) {
    if (std::ranges::find(told, each.state) != told.end()) continue;
    told.push_back(each.state);
    text += fmt::format("{}: {}\n", each.state, each.words);
  }
  return text;
}

std::string fragility_json(const std::vector<FragilityResult>& results) {
  Json all = Json::array();
  for (const FragilityResult& each : results) all.push_back(json_of(each));
  return Json{{"fragilities", all}}.dump(2) + "\n";
}

}  // namespace gurney
