#include "studies/report/fragility_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <set>

#include "engine/base/append_all.h"
#include "studies/analysis/fragility_result.h"
#include "studies/report/formats.h"
#include "studies/report/study_report.h"

namespace gurney::report {
namespace {

std::string exceed_text(const study::FragilityResult& result) {
  const study::CurveAudit& audit = result.audit;
  return fmt::format("{} of {} {}", audit.exceeded, audit.outcomes, audit.counted);
}

std::string fit_note(const study::FragilityResult& result) {
  return result.capacities
             ? fmt::format("the capacities are not lognormal (p = {:.2g})", *result.p_of_fit)
             : fmt::format(
                   "a lognormal curve fits badly (p = {:.2g}); see the fractions in the "
                   "figure",
                   *result.p_of_fit);
}

std::string curve_name(const study::FragilityResult& result) {
  return (result.configuration.empty() ? "" : result.configuration + ", ") + result.state;
}

/// Definitions of the limit states, each once; one without a name of its own has said it already.
findings::Texts definitions(const std::vector<study::FragilityResult>& results) {
  findings::Texts lines;
  std::vector<std::string> listed;
  for (const study::FragilityResult& each : results) {
    if (std::ranges::find(listed, each.state) != listed.end() || each.state == each.words) continue;
    listed.push_back(each.state);
    lines.push_back(each.state + ": " + each.words);
  }
  return lines;
}

using findings::Numbers;
using findings::Section;
using findings::Value;

/// An end that the runs do not bound is not a number.
Value interval_of(const statistics::Interval& interval, double unit = 1) {
  return Numbers{interval.low > 0 ? interval.low / unit : std::nan(""), interval.high / unit};
}

void add_rate(const study::SiteRate& rate, const study::ReportUnit& unit, Section& all) {
  Section of("rate");
  of.json("per_year", rate.rate).json("in_50_years", statistics::probability_in(50, rate.rate));
  of.json("interval_per_year", rate.has_interval ? interval_of(rate.interval) : Value());
  of.json("share_below_lowest_im", rate.share_below);
  of.json("share_above_highest_im", rate.share_above).json("at_most_more", rate.most_above);
  of.json("complete", rate.is_supported()).list("cautions", "", study::cautions(rate, unit));
  if (rate.of_lowest) of.json("hazard_rate_at_lowest_im", *rate.of_lowest);
  all.add(std::move(of));
}

std::string status_text(const study::FragilityResult& result) {
  if (!result.by_cloud()) return text(result.status());
  return result.cloud ? text(result.cloud->status) : "no demand above a limit";
}

const char* method_name(const study::FragilityResult& result) {
  return result.by_cloud() ? "cloud" : result.capacities ? "capacities" : "stripes";
}

/// null where there is none.
void add_curve(const std::optional<statistics::LognormalCurve>& curve, double unit, Section& all) {
  if (curve)
    all.add(
        std::move(Section("curve").json("theta", curve->theta / unit).json("beta", curve->beta)));
  else
    all.json("curve", {});
}

void add_audit(const study::CurveAudit& audit, double unit, Section& all) {
  Section of("audit");
  of.json("counted", audit.counted).json("outcomes", audit.outcomes);
  of.json("exceeded", audit.exceeded).json("lowest_im", audit.lowest / unit);
  of.json("highest_im", audit.highest / unit);
  of.json("extrapolated", !audit.theta                   ? Value()
                          : *audit.theta > audit.highest ? Value("above")
                          : *audit.theta < audit.lowest  ? Value("below")
                                                         : Value());
  if (audit.factors.any()) of.add(scale_factor_findings(audit.factors, "", false));
  all.add(std::move(of));
}

void add_capacities(const study::FragilityResult& result, double unit, Section& all) {
  Section of("capacities");
  of.json("records", result.records).json("analysis_cases", result.brackets.size());
  of.json("censored", result.capacities->censored);
  of.json("resurrections", result.capacities->resurrections);
  findings::Table brackets{"brackets", "",
                           json_columns({"record", "above", "at_most", "resurrections"})};
  for (const statistics::Capacity& each : result.brackets)
    brackets.add({each.group, each.low / unit, each.high / unit, each.resurrections});
  all.add(std::move(of.add(std::move(brackets))));
}

constexpr const char* kSigmaConvention =
    "the maximum likelihood estimate times sqrt(n / (n - 2)), n all runs";

/// ln demand = a + b ln im, where both change their unit.
void add_cloud(const study::FragilityResult& result, double unit, const study::ReportUnit& demand,
               Section& all) {
  const statistics::CloudFit& fit = *result.cloud;
  Section of("cloud");
  of.json("status", text(fit.status)).json("demand_units", demand.name);
  of.json("a", fit.a + fit.b * std::log(unit) - std::log(demand.in_si)).json("b", fit.b);
  of.json("sigma", fit.sigma).json("sigma_is", kSigmaConvention);
  add_curve(result.cloud_curve, unit, of.json("r_squared", fit.r_squared));
  all.add(std::move(of));
}

/// Whether there is a curve, and where it lies.
void add_fit(const study::FragilityResult& result, const study::ReportUnit& unit, Section& all) {
  add_curve(result.curve(), unit.in_si, all);
  if (!result.curve()) {
    all.json("reason", study::no_curve_text(result, unit));
    if (!result.by_cloud())
      all.json("median_between",
               Numbers{result.median.low / unit.in_si, result.median.high / unit.in_si});
    return;
  }
  const bool few = result.band.too_few;
  all.json("effective_records", result.band.effective);
  all.json("theta_interval", few ? Value() : interval_of(result.band.theta, unit.in_si));
  all.json("beta_interval", few ? Value() : interval_of(result.band.beta));
  if (few) all.json("no_interval", study::few_records_text(result.audit));
  const Eigen::Matrix2d c = result.covariance();
  all.json("covariance_of_ln_theta_ln_beta",
           std::vector<Numbers>{{c(0, 0), c(0, 1)}, {c(1, 0), c(1, 1)}});
}

/// Facts of a curve for programs.
Section json_of(const study::FragilityResult& result, const study::UnitSystem& units) {
  const study::ReportUnit unit = units.of(result.measure.units);
  const double in_si = unit.in_si;
  Section all("fragilities[]");
  all.json("configuration", result.configuration).json("limit_state", result.state);
  all.json("says", result.words).json("measure", result.measure.name).json("units", unit.name);
  all.json("runs", result.runs).json("exceeded", result.exceeded);
  all.json("records", result.records).json("failed", result.failed);
  all.json("method", method_name(result)).json("status", status_text(result));
  add_fit(result, unit, all);
  all.list("cautions", "", study::cautions(result.audit, unit));
  add_audit(result.audit, in_si, all);
  if (result.profile)
    all.add(std::move(Section("profile")
                          .json("theta", Numbers{result.profile->theta.low / in_si,
                                                 result.profile->theta.high / in_si})
                          .json("beta", ends(result.profile->beta))));
  if (result.p_of_fit) all.json("p_of_fit", *result.p_of_fit);
  if (!result.fit_is_judged)
    all.json("fit_not_judged", "several runs of a record at one intensity are not independent");
  findings::Table stripes{"stripes", "", json_columns({"im", "runs", "exceeded", "isotonic"})};
  for (std::size_t i = 0; i < result.stripes.size(); ++i)
    stripes.add({result.stripes[i].im / in_si, result.stripes[i].runs, result.stripes[i].exceeded,
                 result.isotonic[i]});
  if (!stripes.rows.empty()) all.add(std::move(stripes));
  std::vector<Numbers> band;
  for (std::size_t i = 0; i < result.band.of_curve.size(); ++i)
    band.push_back(
        {result.im[i] / in_si, result.band.of_curve[i].low, result.band.of_curve[i].high});
  all.json("band", band.empty() ? Value() : Value(band));
  if (result.by_capacities()) add_capacities(result, in_si, all);
  if (result.cloud) add_cloud(result, in_si, units.of(result.demand_units), all);
  if (result.rate) add_rate(*result.rate, unit, all);
  return all;
}

constexpr const char* kScaleNote = "caution: scale factors ";

/// One note for all curves with large factors, which differ where levels or failed runs do.
std::string scale_note(const std::vector<study::FragilityResult>& results) {
  std::set<std::string> texts;
  double low = std::numeric_limits<double>::infinity(), high = 0;
  std::size_t above = 0, records = 0;
  for (const study::FragilityResult& each : results) {
    const study::ScaleFactors& factors = each.audit.factors;
    if (!factors.any() || factors.above() == 0) continue;
    texts.insert(factors.text());
    low = std::min(low, factors.lowest());
    high = std::max(high, factors.highest());
    above = std::max(above, factors.above());
    records = std::max(records, factors.records());
  }
  if (texts.size() == 1) return kScaleNote + *texts.begin();
  return fmt::format("{}{:.3g} to {:.3g}; up to {} of {} records above {:g}", kScaleNote, low, high,
                     above, records, study::kLargestFactor);
}

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
  std::string exceed = fmt::format("{} of {}", fit.exceeded, fit.runs);
  if (result.audit.of_capacities) exceed += fmt::format(" {}", result.audit.counted);
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

/// `separation: median above 1 g` of `separation: only ..., so ...: median above 1 g`, for a column.
std::string short_reason(const std::string& reason) {
  const auto first = reason.find(": "), last = reason.rfind(": ");
  return first == last ? reason : reason.substr(0, first) + reason.substr(last);
}

/// Meaning of a row, where there is a fit.
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
  of.json("runs", result.runs.size()).json("of_capacities", result.audit.of_capacities);
  of.json("outcomes", fit.runs).json("exceeded", fit.exceeded).json("records", fit.groups);
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
  findings::Table alone{"alone", "", json_columns({"theta", "beta", "log_likelihood"})};
  for (const std::size_t i : {0, 1}) {
    const statistics::FragilityFit& each = result.alone[i];
    const bool known = each.status != statistics::FragilityStatus::kNoRuns;
    alone.add({each.curve ? Value(each.curve->theta / units[i].in_si) : Value(), beta_of(each),
               known ? Value(each.log_likelihood) : Value()});
  }
  return std::move(of.add(std::move(alone)));
}

}  // namespace

std::vector<std::string> fragility_notes(const study::FragilityResult& result,
                                         const study::ReportUnit& unit) {
  std::vector<std::string> notes;
  const auto note = [&](const std::string& line) { notes.push_back(line); };
  if (result.failed > 0) note(fmt::format("{} failed runs are excluded", result.failed));
  if (const std::string reason = result.curve() ? "" : study::no_curve_text(result, unit);
      reason != short_reason(reason))
    note(reason);
  if (result.p_of_fit && *result.p_of_fit < 0.05) note(fit_note(result));
  if (result.by_capacities() && result.capacities->resurrections > 0)
    note(fmt::format("{} runs above the capacity of their record do not exceed (resurrections)",
                     result.capacities->resurrections));
  if (result.by_capacities() && result.capacities->censored > 0)
    note(fmt::format("{} of {} never exceed: right-censored at their highest intensity",
                     result.capacities->censored,
                     result.brackets.size() == result.records
                         ? fmt::format("{} records", result.records)
                         : fmt::format("{} analysis cases", result.brackets.size())));
  for (const std::string& caution : study::cautions(result.audit, unit))
    note("caution: " + caution);
  if (result.cloud && result.cloud_curve)
    note(fmt::format(
        "cloud: theta {:.3g}, beta {:.2f}, R2 {:.2f} ({} demands uncensored, {} "
        "right-censored, {} left-censored; sigma {:.2f} is {}){}",
        result.cloud_curve->theta / unit.in_si, result.cloud_curve->beta, result.cloud->r_squared,
        result.cloud->exact, result.cloud->at_least, result.cloud->at_most, result.cloud->sigma,
        kSigmaConvention, result.by_cloud() ? "" : "; to use it: --method cloud"));
  if (result.rate) {
    note(study::rate_text(*result.rate, result.audit));
    for (const std::string& caution : study::cautions(*result.rate, unit))
      note("caution: " + caution);
  }
  return notes;
}

std::vector<std::string> notes_on_curves(const std::vector<study::FragilityResult>& results,
                                         const study::ReportUnit& unit) {
  std::vector<std::string> order;
  std::map<std::string, std::vector<std::string>> curves;  // of each note
  const std::string of_all_factors = scale_note(results);
  for (const study::FragilityResult& each : results)
    for (std::string note : fragility_notes(each, unit)) {
      if (note.starts_with(kScaleNote)) note = of_all_factors;
      if (!curves.contains(note)) order.push_back(note);
      curves[note].push_back(curve_name(each));
    }
  std::vector<std::string> all;
  for (const std::string& note : order) {
    const std::vector<std::string>& names = curves[note];
    const bool of_all = names.size() > 1 && names.size() == results.size();
    all.push_back((of_all ? "all curves" : fmt::format("{}", fmt::join(names, "; "))) + ": " +
                  note);
  }
  return all;
}

findings::Table fragility_table(const std::vector<study::FragilityResult>& results,
                                const study::ReportUnit& unit, bool rates) {
  const findings::Format theta = format_of(unit, 1, ".3g"), two{".2g"};
  const auto intervals = [&](const study::FragilityResult& each, double in_si, int digits,
                             const statistics::Interval& of) {
    return each.curve() ? study::interval_text(of, in_si, digits, each.audit) : std::string();
  };
  findings::Table table{"",
                        "",
                        {{"", "configuration"},
                         {"", "limit state"},
                         {"", "exceed"},
                         {"", "theta", theta, "median"},
                         {"", "beta", {".2f"}, "dispersion"},
                         {"", "95 % of theta"},
                         {"", "95 % of beta"}}};
  if (rates)
    table.columns.insert(table.columns.end(),
                         {{"", "rate", {".3g", "1/year"}, "mean annual rate of exceedance"},
                          {"", "95 % of the rate"},
                          {"", "in 50 years", {".2g", "%", 0.01}}});
  for (const study::FragilityResult& each : results) {
    const auto curve = each.curve();
    table.add({each.configuration.empty() ? "all runs" : each.configuration, each.state,
               exceed_text(each), curve ? findings::Value(curve->theta) : findings::Value(),
               curve ? findings::Value(curve->beta) : findings::Value(),
               curve ? intervals(each, unit.in_si, 3, each.band.theta)
                     : short_reason(study::no_curve_text(each, unit)),
               intervals(each, 1, 2, each.band.beta)});
    if (rates && each.rate)
      table.rows.back().insert(table.rows.back().end(),
                               {each.rate->rate, study::rate_interval_text(*each.rate, each.audit),
                                statistics::probability_in(50, each.rate->rate)});
    else if (rates)
      table.rows.back().resize(table.columns.size(), findings::Value());
  }
  return table;
}

std::vector<findings::Table> worst_level_tables(
    const study::StudyData& data, const std::vector<study::FragilityResult>& results,
    const std::vector<study::PerformanceTable>& performance) {
  std::vector<findings::Table> tables;
  for (const study::PerformanceTable& of : performance) {
    const study::RunMeasure& measure = results.front().measure;
    const findings::Format percent{".1f", "%", 0.01};
    findings::Table table{
        "",
        (of.configuration.empty() ? "" : of.configuration + ": ") + "P(worst level reached)",
        {{"", measure.name, format_of(study::report_unit(data, measure), 1, ".3g")},
         {"", "none", percent}}};
    for (const std::string& level : of.levels) table.columns.push_back({"", level, percent});
    table.columns.push_back({"", "remark"});
    for (std::size_t i = 0; i < of.im.size(); ++i) {
      table.add({of.im[i]});
      for (const double probability : of.at[i].of_level)
        table.rows.back().emplace_back(probability);
      table.rows.back().emplace_back(
          of.at[i].crossed ? "curves cross: the worse is cut to the milder" : "");
    }
    tables.push_back(std::move(table));
  }
  return tables;
}

/// Performance levels as arrays, for programs.
Section performance_json(const study::PerformanceTable& of) {
  Section all{"performance[]"};
  all.json("configuration", of.configuration).json("im", of.im);
  std::vector<std::string> levels{"none"};
  append_all(levels, of.levels);
  for (std::size_t k = 0; k < levels.size(); ++k) {
    std::vector<double> probability;
    for (const auto& at : of.at) probability.push_back(at.of_level[k]);
    Section level{"worst_level[]"};
    level.json("level", levels[k]).json("probability", probability);
    all.add(std::move(level));
  }
  return all;
}

Section fragility_findings(const study::StudyData& data,
                           const std::vector<study::FragilityResult>& results) {
  Section all;
  if (results.empty()) return std::move(all.list("fragilities", "", {}));
  const study::ReportUnit unit = study::report_unit(data, results.front().measure);
  all.say(fmt::format("P(limit state | {} [{}]) = Phi(ln(im / theta) / beta){}",
                      results.front().measure.name, unit.name,
                      results.front().by_cloud() ? ", by regression of demands (cloud)" : ""));
  all.add(fragility_table(results, unit, false));
  all.list("", "notes", notes_on_curves(results, unit));
  const auto performance = study::performance_tables(data, results);
  for (findings::Table& each : worst_level_tables(data, results, performance))
    all.add(std::move(each));
  all.list("", "limit states", definitions(results));
  for (const study::FragilityResult& each : results)
    all.add(json_of(each, data.units().or_else("si")));
  for (const study::PerformanceTable& each : performance) all.add(performance_json(each));
  return all;
}

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
