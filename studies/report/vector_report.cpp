#include "studies/report/vector_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "studies/report/fragility_report.h"
#include "studies/report/json_values.h"

namespace gurney::report {
namespace {

using Json = nlohmann::ordered_json;

constexpr double kSignificant = 0.05;

Eigen::Matrix3d covariance_of(const statistics::VectorFit& fit) {
  return fit.groups > 1 ? fit.cluster_covariance : fit.covariance;
}

std::string slope_text(const statistics::VectorFit& fit, Eigen::Index slope) {
  return fmt::format("{:.2f} (+-{:.2f})", fit.plane[slope],
                     std::sqrt(covariance_of(fit)(slope, slope)));
}

std::string beta_of(const statistics::FragilityFit& fit) {
  return fit.curve ? fmt::format("{:.2f}", fit.curve->beta) : "-";
}

using Units = std::array<study::ReportUnit, 2>;

/// ln of both units and 1: what a plane over SI is multiplied by for that over other units.
Eigen::Vector3d ln_of(const Units& units) {
  return {std::log(units[0].in_si), std::log(units[1].in_si), 1};
}

std::string row(const study::VectorResult& result, const Units& units, std::size_t wide,
                std::size_t state_wide) {
  const statistics::VectorFit& fit = result.fit;
  std::string line = fmt::format("{:<{}}  {:<{}}  {:>5} of {:<5}  ", result.configuration, wide,
                                 result.state, state_wide, fit.exceeded, fit.runs);
  if (fit.status != statistics::VectorStatus::kFitted) return line + text(fit.status) + "\n";
  const double intercept = fit.plane.dot(ln_of(units));
  return line + fmt::format("{:<14}  {:<14}  {:>6.2f}  {:>8.2g} {:>8.2g}  {:>5.2f}  {:>7}  {:>7}\n",
                            slope_text(fit, 0), slope_text(fit, 1), intercept, fit.p_of(0),
                            fit.p_of(1), fit.beta(), beta_of(result.alone[0]),
                            beta_of(result.alone[1]));
}

std::string name_of(const study::VectorResult& result) {
  return result.configuration.empty() ? result.state : result.configuration + ", " + result.state;
}

std::string cautions_text(const study::VectorResult& result) {
  std::string text;
  for (const std::string& each : study::cautions(result.audit, {}))
    text += name_of(result) + ": caution: " + each + "\n";
  return text;
}

/// What a row means, where there is a fit.
std::string meaning(const study::VectorResult& result) {
  const statistics::VectorFit& fit = result.fit;
  if (fit.status != statistics::VectorStatus::kFitted) return "";
  const auto &first = result.measures[0].name, &second = result.measures[1].name;
  const bool of_first = fit.p_of(0) < kSignificant, of_second = fit.p_of(1) < kSignificant;
  std::string text = name_of(result) + ": ";
  if (of_first && of_second)
    text += fmt::format(
        "each adds information to the other; together they are one measure "
        "({})^{:.2f} ({})^{:.2f}",
        first, fit.share(), second, 1 - fit.share());
  else if (of_first)
    text += fmt::format("{} adds nothing beyond chance to {}", second, first);
  else if (of_second)
    text += fmt::format("{} adds nothing beyond chance to {}", first, second);
  else
    text += "neither adds beyond chance to the other; these runs do not settle which it is";
  if (result.left_out > 0) text += fmt::format("; {} runs lack a measure", result.left_out);
  if (result.failed > 0) text += fmt::format("; {} runs failed", result.failed);
  return text + "\n";
}

}  // namespace

std::string vector_report(const study::StudyData& data,
                          const std::vector<study::VectorResult>& results) {
  std::size_t wide = 13, state_wide = 11;
  for (const study::VectorResult& each : results) {
    wide = std::max(wide, each.configuration.size());
    state_wide = std::max(state_wide, each.state.size());
  }
  const auto& measures = results.front().measures;
  const Units units{study::report_unit(data, measures[0]), study::report_unit(data, measures[1])};
  std::string text = fmt::format(
      "P(limit state | a, b) = Phi(slope_a ln a + slope_b ln b + c), a = {} [{}], b = {} [{}]\n\n",
      measures[0].name, units[0].name, measures[1].name, units[1].name);
  text += fmt::format(
      "{:<{}}  {:<{}}  {:>14}  {:<14}  {:<14}  {:>6}  {:>8} {:>8}  {:>5}  {:>7}  {:>7}\n",
      "configuration", wide, "limit state", state_wide, "exceed", "slope of a", "slope of b", "c",
      "p of a", "p of b", "beta", "a alone", "b alone");
  for (const study::VectorResult& each : results) text += row(each, units, wide, state_wide);
  text += "\n";
  for (const study::VectorResult& each : results) text += meaning(each) + cautions_text(each);
  text +=
      "\np: how likely a slope so far from 0 is by chance, records being independent and runs of "
      "one "
      "not. beta = 1 / (slope_a + slope_b).\n";
  return text;
}

std::string vector_json(const std::vector<study::VectorResult>& results,
                        const study::UnitSystem& chosen) {
  Json json = Json::array();
  for (const study::VectorResult& each : results) {
    const statistics::VectorFit& fit = each.fit;
    const study::UnitSystem system = chosen.or_else("si");
    const Units units{system.of(each.measures[0].units), system.of(each.measures[1].units)};
    Json of{{"configuration", each.configuration},
            {"limit_state", each.state},
            {"measures", {each.measures[0].name, each.measures[1].name}},
            {"units", {units[0].name, units[1].name}},
            {"runs", fit.runs},
            {"exceeded", fit.exceeded},
            {"records", fit.groups},
            {"left_out", each.left_out},
            {"failed", each.failed},
            {"status", text(fit.status)},
            {"cautions", study::cautions(each.audit, {})}};
    const bool fitted = fit.status == statistics::VectorStatus::kFitted;
    if (fitted) {
      Eigen::Matrix3d other = Eigen::Matrix3d::Identity();
      other.row(2) = ln_of(units).transpose();
      const Eigen::Matrix3d covariance = other * covariance_of(fit) * other.transpose();
      const double unit =
          std::pow(units[0].in_si, fit.share()) * std::pow(units[1].in_si, 1 - fit.share());
      Json rows = Json::array();
      for (Eigen::Index i = 0; i < 3; ++i)
        rows.push_back({covariance(i, 0), covariance(i, 1), covariance(i, 2)});
      of["plane"] = {fit.plane[0], fit.plane[1], fit.plane.dot(ln_of(units))};
      of["covariance"] = rows;
      of["p"] = {json_number(fit.p_of(0)), json_number(fit.p_of(1))};
      of["log_likelihood"] = fit.log_likelihood;
      of["share"] = fit.share();
      of["theta"] = fit.theta() / unit;
      of["beta"] = fit.beta();
    } else {
      of["plane"] = nullptr;
    }
    for (const std::size_t i : {0, 1}) {
      const auto& curve = each.alone[i].curve;
      of["alone"].push_back({{"theta", curve ? Json(curve->theta / units[i].in_si) : Json()},
                             {"beta", curve ? Json(curve->beta) : Json()},
                             {"log_likelihood", json_number(each.alone[i].log_likelihood)}});
    }
    json.push_back(of);
  }
  return json.dump(2) + "\n";
}

}  // namespace gurney::report
