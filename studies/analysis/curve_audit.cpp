#include "studies/analysis/curve_audit.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace gurney::study {
namespace {

std::string in(const ReportUnit& unit, double value) {
  return fmt::format("{:.3g}{}{}", value / unit.in_si, unit.name == "1" ? "" : " ",
                     unit.name == "1" ? "" : unit.name);
}

std::string extrapolation(const CurveAudit& audit, const ReportUnit& unit) {
  const bool above = *audit.theta > audit.highest;
  return fmt::format("theta {} is extrapolated {} the {} intensity of the runs, {}",
                     in(unit, *audit.theta), above ? "beyond" : "below",
                     above ? "highest" : "lowest", in(unit, above ? audit.highest : audit.lowest));
}

}  // namespace

CurveAudit outcome_audit(const statistics::FragilityFit& fit,
                         const std::vector<statistics::Observation>& observations,
                         const ScaleFactors& factors) {
  CurveAudit audit;
  if (fit.curve) audit.theta = fit.curve->theta;
  if (!observations.empty()) {
    const auto [low, high] = std::ranges::minmax(observations, {}, &statistics::Observation::im);
    audit.lowest = low.im;
    audit.highest = high.im;
  }
  audit.outcomes = fit.runs;
  audit.exceeded = fit.exceeded;
  audit.records = fit.groups;
  audit.effective = fit.effective_groups;
  audit.fewest = statistics::kFewestGroups;
  audit.factors = factors;
  return audit;
}

bool is_extrapolated(const CurveAudit& audit) {
  return audit.theta && (*audit.theta > audit.highest || *audit.theta < audit.lowest);
}

bool has_few_outcomes(const CurveAudit& audit) {
  const std::size_t rarer = std::min(audit.exceeded, audit.outcomes - audit.exceeded);
  return audit.theta && !audit.of_capacities && !audit.of_demands && rarer < kFewOutcomes;
}

bool has_few_records(const CurveAudit& audit) {
  return audit.theta && audit.effective < audit.fewest * (1 - 1e-9);
}

std::string few_records_text(const CurveAudit& audit) {
  return fmt::format("fewer than {:g} effective records ({:.3g} of {}): no usable interval",
                     audit.fewest, audit.effective, audit.records);
}

std::string no_rate_text(const std::string& hazard_over) {
  return fmt::format("no annual rate: the hazard of the job is over {}", hazard_over);
}

std::string interval_text(const statistics::Interval& interval, double in_si, int digits,
                          const CurveAudit& audit) {
  const bool low = interval.low > 0, high = std::isfinite(interval.high);
  if (!low && !high)
    return has_few_records(audit)
               ? fmt::format("none: fewer than {:g} effective records", audit.fewest)
               : fmt::format("unbounded ({} record{})", audit.records,
                             audit.records == 1 ? "" : "s");
  const auto end = [&](double value, bool known) {
    return known ? fmt::format("{:.{}g}", value / in_si, digits) : std::string("unbounded");
  };
  return end(interval.low, low) + " to " + end(interval.high, high);
}

std::vector<std::string> cautions(const CurveAudit& audit, const ReportUnit& unit) {
  std::vector<std::string> all;
  if (is_extrapolated(audit)) all.push_back(extrapolation(audit, unit));
  if (has_few_records(audit)) all.push_back(few_records_text(audit));
  if (has_few_outcomes(audit)) {
    const std::size_t rarer = std::min(audit.exceeded, audit.outcomes - audit.exceeded);
    all.push_back(fmt::format("only {} of {} {} {}; fewer than {} leave theta and beta uncertain",
                              rarer, audit.outcomes, audit.counted,
                              rarer == audit.exceeded ? "exceed" : "do not exceed", kFewOutcomes));
  }
  if (audit.overturned_short > 0)
    all.push_back(fmt::format(
        "{} {} overturned without having moved so far and {} not exceed it; a limit state with "
        "any_of counts both",
        audit.overturned_short, audit.overturned_short == 1 ? "run" : "runs",
        audit.overturned_short == 1 ? "does" : "do"));
  if (audit.of_capacities &&
      static_cast<double>(audit.ended) > kManyEnded * static_cast<double>(audit.outcomes))
    all.push_back(fmt::format(
        "{} of {} {} do not exceed and end where another limit state ended the IDA; such ends are "
        "not independent of the capacity, so theta and beta are biased: prefer an IDA that ends "
        "with this state, or multiple stripes",
        audit.ended, audit.outcomes, audit.counted));
  if (audit.chosen_by_response)
    all.push_back(
        "the runs of an IDA are chosen by their response, so a curve of their outcomes, as this "
        "one, is biased: prefer one measure that is scaled with the record, or multiple stripes");
  if (!audit.hazard_over.empty()) all.push_back(no_rate_text(audit.hazard_over));
  // Small factors are those of weak stripes: nothing is claimed beyond what was recorded.
  if (audit.factors.any() && audit.factors.above() > 0)
    all.push_back("scale factors " + audit.factors.text());
  if (audit.of_capacities && audit.overturned > 0)
    all.push_back(fmt::format(
        "{} {} of the IDA overturned; rocking is chaotic, so the capacity of a single record "
        "depends on the time step and on the intensities tried: prefer multiple stripes",
        audit.overturned, audit.overturned == 1 ? "run" : "runs"));
  return all;
}

std::string outcomes_text(statistics::FragilityStatus status, const statistics::Interval& change,
                          const ReportUnit& unit) {
  using enum statistics::FragilityStatus;
  const std::string status_text = statistics::text(status);
  switch (status) {
    case kNoneExceeds:
      return fmt::format("{} up to {}", status_text, in(unit, change.low));
    case kAllExceed:
      return fmt::format("{} from {} on", status_text, in(unit, change.high));
    case kSeparated:
      return fmt::format("{}: outcomes change between {:.3g} and {}", status_text,
                         change.low / unit.in_si, in(unit, change.high));
    case kQuasiSeparated:
      return fmt::format("{}: outcomes change at {}", status_text, in(unit, change.low));
    default:
      return status_text;
  }
}

std::string median_text(const statistics::MedianBounds& median, const ReportUnit& unit) {
  if (!median.known()) return {};
  if (median.low == 0) return "median below " + in(unit, median.high);
  if (std::isinf(median.high)) return "median above " + in(unit, median.low);
  return fmt::format("median between {:.3g} and {}", median.low / unit.in_si,
                     in(unit, median.high));
}

}  // namespace gurney::study
