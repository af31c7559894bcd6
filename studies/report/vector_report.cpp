#include "studies/report/vector_report.h"

#include <fmt/format.h>

#include <array>
#include <cmath>

namespace gurney::report {
namespace {

using findings::Numbers;
using findings::Section;
using findings::Value;

constexpr double kSignificant = 0.05;

using Units = std::array<study::ReportUnit, 2>;

Units units_of(const study::UnitSystem& system, const study::VectorResult& result) {
  return {system.of(result.measures[0].units), system.of(result.measures[1].units)};
}

bool is_fitted(const statistics::VectorFit& fit) {
  return fit.status == statistics::VectorStatus::kFitted;
}

Eigen::Matrix3d covariance_of(const statistics::VectorFit& fit) {
  return fit.groups > 1 ? fit.cluster_covariance : fit.covariance;
}

/// ln of both units and 1: what a plane over SI is multiplied by for that over other units.
Eigen::Vector3d ln_of(const Units& units) {
  return {std::log(units[0].in_si), std::log(units[1].in_si), 1};
}

std::string slope_text(const statistics::VectorFit& fit, Eigen::Index slope) {
  return fmt::format("{:.2f} (+-{:.2f})", fit.plane[slope],
                     std::sqrt(covariance_of(fit)(slope, slope)));
}

Value beta_of(const statistics::FragilityFit& fit) {
  return fit.curve ? Value(fit.curve->beta) : Value();
}

std::vector<findings::Cell> row_of(const study::VectorResult& result, const Units& units) {
  const statistics::VectorFit& fit = result.fit;
  const std::string exceed = fmt::format("{} of {}", fit.exceeded, fit.runs);
  if (!is_fitted(fit)) {
    std::vector<findings::Cell> row{result.configuration, result.state, exceed,
                                    std::string(text(fit.status))};
    row.resize(11, Value());
    return row;
  }
  return {result.configuration,
          result.state,
          exceed,
          slope_text(fit, 0),
          slope_text(fit, 1),
          fit.plane.dot(ln_of(units)),
          fit.p_of(0),
          fit.p_of(1),
          fit.beta(),
          beta_of(result.alone[0]),
          beta_of(result.alone[1])};
}

/// What a row means, where there is a fit.
std::string meaning(const study::VectorResult& result) {
  const statistics::VectorFit& fit = result.fit;
  if (!is_fitted(fit)) return "";
  const auto &first = result.measures[0].name, &second = result.measures[1].name;
  const bool of_first = fit.p_of(0) < kSignificant, of_second = fit.p_of(1) < kSignificant;
  std::string text =
      of_first && of_second
          ? fmt::format(
                "each adds information to the other; together they are one measure ({})^{:.2f} "
                "({})^{:.2f}",
                first, fit.share(), second, 1 - fit.share())
      : of_first  ? fmt::format("{} adds nothing beyond chance to {}", second, first)
      : of_second ? fmt::format("{} adds nothing beyond chance to {}", first, second)
                  : "neither adds beyond chance to the other; these runs do not settle which it is";
  if (result.left_out > 0) text += fmt::format("; {} runs lack a measure", result.left_out);
  if (result.failed > 0) text += fmt::format("; {} runs failed", result.failed);
  return text;
}

Section json_of(const study::VectorResult& result, const Units& units) {
  const statistics::VectorFit& fit = result.fit;
  Section of("fragilities[]");
  of.json("configuration", result.configuration).json("limit_state", result.state);
  of.json("measures", findings::Texts{result.measures[0].name, result.measures[1].name});
  of.json("units", findings::Texts{units[0].name, units[1].name});
  of.json("runs", fit.runs).json("exceeded", fit.exceeded).json("records", fit.groups);
  of.json("left_out", result.left_out).json("failed", result.failed);
  of.json("status", text(fit.status)).list("cautions", "", study::cautions(result.audit, {}));
  if (is_fitted(fit)) {
    Eigen::Matrix3d other = Eigen::Matrix3d::Identity();
    other.row(2) = ln_of(units).transpose();
    const Eigen::Matrix3d covariance = other * covariance_of(fit) * other.transpose();
    std::vector<Numbers> rows;
    for (const auto& row : covariance.rowwise()) rows.push_back({row[0], row[1], row[2]});
    of.json("plane", Numbers{fit.plane[0], fit.plane[1], fit.plane.dot(ln_of(units))});
    of.json("covariance", rows).json("p", Numbers{fit.p_of(0), fit.p_of(1)});
    of.json("log_likelihood", fit.log_likelihood).json("share", fit.share());
    of.json("theta", fit.theta() / (std::pow(units[0].in_si, fit.share()) *
                                    std::pow(units[1].in_si, 1 - fit.share())));
    of.json("beta", fit.beta());
  } else {
    of.json("plane", {});
  }
  findings::Table alone{"alone", "", {{"theta", ""}, {"beta", ""}, {"log_likelihood", ""}}};
  for (const std::size_t i : {0, 1}) {
    const statistics::FragilityFit& each = result.alone[i];
    alone.add({each.curve ? Value(each.curve->theta / units[i].in_si) : Value(), beta_of(each),
               each.log_likelihood});
  }
  return std::move(of.add(std::move(alone)));
}

}  // namespace

Section vector_findings(const study::StudyData& data,
                        const std::vector<study::VectorResult>& results) {
  const auto& measures = results.front().measures;
  const Units units{study::report_unit(data, measures[0]), study::report_unit(data, measures[1])};
  Section all;
  all.say(fmt::format(
      "P(limit state | a, b) = Phi(slope_a ln a + slope_b ln b + c), a = {} [{}], b = {} [{}]",
      measures[0].name, units[0].name, measures[1].name, units[1].name));
  findings::Table table{"",
                        "",
                        {{"", "configuration"},
                         {"", "limit state"},
                         {"", "exceed"},
                         {"", "slope of a"},
                         {"", "slope of b"},
                         {"", "c", {".2f"}},
                         {"", "p of a", {".2g"}},
                         {"", "p of b", {".2g"}},
                         {"", "beta", {".2f"}},
                         {"", "a alone", {".2f"}},
                         {"", "b alone", {".2f"}}}};
  for (const study::VectorResult& each : results) table.add(row_of(each, units));
  all.add(std::move(table)).list("fragilities", "", {});
  for (const study::VectorResult& each : results) {
    const std::string name =
        each.configuration.empty() ? each.state : each.configuration + ", " + each.state;
    if (const std::string means = meaning(each); !means.empty()) all.say(name + ": " + means);
    for (const std::string& caution : study::cautions(each.audit, {}))
      all.say(name + ": caution: " + caution);
    all.add(json_of(each, units_of(data.units().or_else("si"), each)));
  }
  return std::move(
      all.say("p: how likely a slope so far from 0 is by chance, records being independent and "
              "runs of one not. beta = 1 / (slope_a + slope_b)."));
}

}  // namespace gurney::report
