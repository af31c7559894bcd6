#include "groundmotions/measures/summary.h"

#include "engine/base/error.h"
#include "groundmotions/measures/response_spectrum.h"

namespace gurney::groundmotions {
namespace {

SummaryRow empty_row(const Measure& measure) {
  return {measure, name_of(measure), si_unit_of(measure), definition_of(measure), {}};
}

/// Adds what `value` returns, or what it throws to the warnings.
template <class Value>
void add(SummaryRow& row, std::vector<std::string>& warnings, const std::string& name,
         Value value) {
  try {
    row.values.emplace_back(name, value());
  } catch (const Error& error) {
    if (warnings.empty() || warnings.back() != error.what()) warnings.emplace_back(error.what());
  }
}

void warn_of_short_period(Summary& summary, const Measure& measure, double time_step) {
  const Eigen::VectorXd periods = spectral_periods(measure);
  if (periods.size() == 0) return;
  const std::string warning = short_period_warning(time_step, periods[0]);
  if (!warning.empty()) summary.warnings.push_back(warning);
}

/// The combinations of a record's row.
std::vector<Combination> combinations(const Record& record, const Measure& measure) {
  std::vector<Combination> result;
  const bool h1 = record[Direction::kH1].has_value(), h2 = record[Direction::kH2].has_value();
  if (h1) result.push_back(Combination::kH1);
  if (h2) result.push_back(Combination::kH2);
  if (record[Direction::kVertical]) result.push_back(Combination::kVertical);
  if (!h1 || !h2) return result;
  result.push_back(Combination::kGeometricMean);
  const bool is_peak = has_resultant(measure);
  if (is_peak || spectral_periods(measure).size() > 0)
    result.insert(result.end(), {Combination::kRotD50, Combination::kRotD100});
  if (is_peak) result.push_back(Combination::kResultant);
  return result;
}

}  // namespace

std::vector<Measure> common_measures() {
  std::vector<Measure> result;
  for (const char* name : {"PGA", "PGV", "PGD", "Arias", "CAV", "D5-75", "D5-95", "Tm", "Tp",
                           "Sa(0.2)", "Sa(0.5)", "Sa(1)", "Sa(2)", "SaAvg(1)", "FIV3(1)", "SI"})
    result.push_back(parse_measure(name));
  return result;
}

Summary summary(const Component& component, const std::vector<Measure>& measures) {
  Summary result;
  for (const Measure& measure : measures) {
    SummaryRow row = empty_row(measure);
    add(row, result.warnings, "value",
        [&] { return value_of(measure, component.time_step, component.acceleration); });
    warn_of_short_period(result, measure, component.time_step);
    result.rows.push_back(std::move(row));
  }
  return result;
}

Summary summary(const Record& record, const std::vector<Measure>& measures) {
  Summary result;
  for (const Measure& measure : measures) {
    SummaryRow row = empty_row(measure);
    for (const Combination each : combinations(record, measure))
      add(row, result.warnings, name_of(each), [&] { return value_of(measure, each, record); });
    warn_of_short_period(result, measure, record.time_step());
    result.rows.push_back(std::move(row));
  }
  return result;
}

}  // namespace gurney::groundmotions
