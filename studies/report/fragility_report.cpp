#include "studies/report/fragility_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "studies/analysis/fragility_result.h"
#include "studies/render/render.h"
#include "studies/report/formats.h"
#include "studies/report/json_values.h"
#include "studies/report/scale_factors.h"

namespace gurney::report {
namespace {

using Json = nlohmann::ordered_json;

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

/// What the limit states say, each once; one without a name of its own has said it already.
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

/// An end that the runs do not bound is null.
Json interval_json(const statistics::Interval& interval, double unit = 1) {
  return Json::array(
      {interval.low > 0 ? Json(interval.low / unit) : Json(), json_number(interval.high / unit)});
}

Json rate_json(const study::SiteRate& rate, const study::ReportUnit& unit) {
  Json json{{"per_year", json_number(rate.rate)},
            {"in_50_years", json_number(statistics::probability_in(50, rate.rate))},
            {"interval_per_year", rate.has_interval ? interval_json(rate.interval) : Json()},
            {"share_below_lowest_im", rate.share_below},
            {"share_above_highest_im", rate.share_above},
            {"at_most_more", rate.most_above},
            {"complete", rate.is_supported()},
            {"cautions", study::cautions(rate, unit)}};
  if (rate.of_lowest) json["hazard_rate_at_lowest_im"] = *rate.of_lowest;
  return json;
}

std::string status_text(const study::FragilityResult& result) {
  if (!result.by_cloud()) return text(result.status());
  return result.cloud ? text(result.cloud->status) : "no demand above a limit";
}

/// Of ln theta and ln beta.
Eigen::Matrix2d covariance_of(const study::FragilityResult& result) {
  if (result.by_cloud()) return result.cloud_covariance;
  return result.capacities ? result.capacities->covariance : result.fit.cluster_covariance;
}

const char* method_name(const study::FragilityResult& result) {
  return result.by_cloud() ? "cloud" : result.capacities ? "capacities" : "stripes";
}

Json curve_json(const std::optional<statistics::LognormalCurve>& curve, double unit) {
  if (!curve) return nullptr;
  return {{"theta", curve->theta / unit}, {"beta", curve->beta}};
}

Json audit_json(const study::CurveAudit& audit, double unit) {
  Json json{{"counted", audit.counted},
            {"outcomes", audit.outcomes},
            {"exceeded", audit.exceeded},
            {"lowest_im", audit.lowest / unit},
            {"highest_im", audit.highest / unit},
            {"extrapolated", !audit.theta                   ? Json()
                             : *audit.theta > audit.highest ? Json("above")
                             : *audit.theta < audit.lowest  ? Json("below")
                                                            : Json()}};
  if (audit.factors.any()) json["scale_factors"] = scale_factors_json(audit.factors);
  return json;
}

Json capacities_json(const study::FragilityResult& result, double unit) {
  Json of_records = Json::array();
  for (const statistics::Capacity& each : result.brackets)
    of_records.push_back({{"record", each.group},
                          {"above", each.low / unit},
                          {"at_most", json_number(each.high / unit)},
                          {"resurrections", each.resurrections}});
  return {{"records", result.records},
          {"analysis_cases", result.brackets.size()},
          {"censored", result.capacities->censored},
          {"resurrections", result.capacities->resurrections},
          {"brackets", of_records}};
}

constexpr const char* kSigmaConvention =
    "the maximum likelihood estimate times sqrt(n / (n - 2)), n all runs";

/// ln demand = a + b ln im, where both change their unit.
Json cloud_json(const study::FragilityResult& result, double unit,
                const study::ReportUnit& demand) {
  const statistics::CloudFit& fit = *result.cloud;
  return {{"status", text(fit.status)},
          {"demand_units", demand.name},
          {"a", json_number(fit.a + fit.b * std::log(unit) - std::log(demand.in_si))},
          {"b", json_number(fit.b)},
          {"sigma", json_number(fit.sigma)},
          {"sigma_is", kSigmaConvention},
          {"r_squared", json_number(fit.r_squared)},
          {"curve", curve_json(result.cloud_curve, unit)}};
}

Json json_of(const study::FragilityResult& result, const study::UnitSystem& units) {
  const study::ReportUnit unit = units.of(result.measure.units);
  const double in_si = unit.in_si;
  Json json{{"configuration", result.configuration},
            {"limit_state", result.state},
            {"says", result.words},
            {"measure", result.measure.name},
            {"units", unit.name},
            {"runs", result.runs},
            {"exceeded", result.exceeded},
            {"records", result.records},
            {"failed", result.failed},
            {"method", method_name(result)},
            {"status", status_text(result)},
            {"curve", curve_json(result.curve(), in_si)}};
  if (result.curve()) {
    const bool few = result.band.too_few;
    json["effective_records"] = result.band.effective;
    json["theta_interval"] = few ? Json() : interval_json(result.band.theta, in_si);
    json["beta_interval"] = few ? Json() : interval_json(result.band.beta);
    if (few) json["no_interval"] = study::few_records_text(result.audit);
    const Eigen::Matrix2d c = covariance_of(result);
    json["covariance_of_ln_theta_ln_beta"] = {{c(0, 0), c(0, 1)}, {c(1, 0), c(1, 1)}};
  } else {
    json["reason"] = study::no_curve_text(result, unit);
    if (!result.by_cloud()) json["median_between"] = json_interval(result.median(), in_si);
  }
  json["cautions"] = study::cautions(result.audit, unit);
  json["audit"] = audit_json(result.audit, in_si);
  if (result.profile)
    json["profile"] = {{"theta", json_interval(result.profile->theta, in_si)},
                       {"beta", json_interval(result.profile->beta)}};
  if (result.p_of_fit) json["p_of_fit"] = json_number(*result.p_of_fit);
  if (!result.fit_is_judged)
    json["fit_not_judged"] = "several runs of a record at one intensity are not independent";
  for (std::size_t i = 0; i < result.stripes.size(); ++i)
    json["stripes"].push_back({{"im", result.stripes[i].im / in_si},
                               {"runs", result.stripes[i].runs},
                               {"exceeded", result.stripes[i].exceeded},
                               {"isotonic", result.isotonic[i]}});
  if (result.band.of_curve.empty()) json["band"] = nullptr;
  for (std::size_t i = 0; i < result.band.of_curve.size(); ++i)
    json["band"].push_back(
        {result.im[i] / in_si, result.band.of_curve[i].low, result.band.of_curve[i].high});
  if (result.by_capacities()) json["capacities"] = capacities_json(result, in_si);
  if (result.cloud) json["cloud"] = cloud_json(result, in_si, units.of(result.demand_units));
  if (result.rate) json["rate"] = rate_json(*result.rate, unit);
  return json;
}

}  // namespace

std::vector<std::string> fragility_notes(const study::FragilityResult& result,
                                         const study::ReportUnit& unit) {
  std::vector<std::string> notes;
  const auto note = [&](const std::string& line) { notes.push_back(line); };
  if (result.failed > 0) note(fmt::format("{} failed runs are excluded", result.failed));
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
    note(study::rate_text(*result.rate, result.records));
    for (const std::string& caution : study::cautions(*result.rate, unit))
      note("caution: " + caution);
  }
  return notes;
}

namespace {

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

}  // namespace

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
    return each.curve() ? study::interval_text(of, in_si, digits, each.records) : std::string();
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
    table.add(
        {each.configuration.empty() ? "all runs" : each.configuration, each.state,
         exceed_text(each), curve ? findings::Value(curve->theta) : findings::Value(),
         curve ? findings::Value(curve->beta) : findings::Value(),
         curve ? intervals(each, unit.in_si, 3, each.band.theta) : study::no_curve_text(each, unit),
         intervals(each, 1, 2, each.band.beta)});
    if (rates && each.rate)
      table.rows.back().insert(
          table.rows.back().end(),
          {each.rate->rate, study::rate_interval_text(*each.rate, each.records),
           statistics::probability_in(50, each.rate->rate)});
    else if (rates)
      table.rows.back().resize(table.columns.size(), findings::Value());
  }
  return table;
}

std::vector<findings::Table> worst_level_tables(
    const study::StudyData& data, const std::vector<study::FragilityResult>& results) {
  std::vector<findings::Table> tables;
  for (const study::PerformanceTable& of : study::performance_tables(data, results)) {
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

std::string fragility_report(const study::StudyData& data,
                             const std::vector<study::FragilityResult>& results) {
  if (results.empty()) return "";
  const study::ReportUnit unit = study::report_unit(data, results.front().measure);
  findings::Section all;
  all.say(fmt::format("P(limit state | {} [{}]) = Phi(ln(im / theta) / beta){}",
                      results.front().measure.name, unit.name,
                      results.front().by_cloud() ? ", by regression of demands (cloud)" : ""));
  all.add(fragility_table(results, unit, false));
  all.list("", "notes", notes_on_curves(results, unit));
  for (findings::Table& each : worst_level_tables(data, results)) all.add(std::move(each));
  return render::text(all.list("", "limit states", definitions(results)));
}

std::string fragility_json(const std::vector<study::FragilityResult>& results,
                           const study::UnitSystem& units) {
  Json all = Json::array();
  for (const study::FragilityResult& each : results)
    all.push_back(json_of(each, units.or_else("si")));
  return Json{{"fragilities", all}}.dump(2) + "\n";
}

}  // namespace gurney::report
