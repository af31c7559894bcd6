#include "groundmotions/measures/summary.h"

#include <array>
#include <cmath>
#include <optional>

#include "engine/base/error.h"
#include "groundmotions/measures/combination.h"
#include "groundmotions/measures/measure.h"
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

/// The combinations of one measure; what several of them need is computed once.
class RecordValues {
 public:
  RecordValues(const Record& record, const Measure& measure)
      : record_(record), measure_(measure), periods_(spectral_periods(measure)) {}

  /// value_of() for the combinations of a row
  double of(Combination combination) {
    switch (combination) {
      case Combination::kH1:
        return of(Direction::kH1);
      case Combination::kH2:
        return of(Direction::kH2);
      case Combination::kVertical:
        return of(Direction::kVertical);
      case Combination::kGeometricMean:
        return is_spectral()
                   ? geometric_mean((spectrum(Direction::kH1) * spectrum(Direction::kH2)).sqrt())
                   : std::sqrt(of(Direction::kH1) * of(Direction::kH2));
      case Combination::kRotD50:
        return is_spectral() ? geometric_mean(rotated_spectra().rotd50) : percentile(rotated(), 50);
      case Combination::kRotD100:
        return is_spectral() ? geometric_mean(rotated_spectra().rotd100)
                             : percentile(rotated(), 100);
      default:
        return value_of(measure_, combination, record_);
    }
  }

 private:
  bool is_spectral() const { return periods_.size() > 0; }
  const Eigen::VectorXd& acceleration(Direction direction) const {
    return record_[direction]->acceleration;
  }

  double of(Direction direction) {
    auto& value = values_[static_cast<std::size_t>(direction)];
    if (!value)
      value = is_spectral() ? geometric_mean(spectrum(direction))
                            : value_of(measure_, record_.time_step(), acceleration(direction));
    return *value;
  }

  const Eigen::ArrayXd& spectrum(Direction direction) {
    auto& spectrum = spectra_[static_cast<std::size_t>(direction)];
    if (!spectrum)
      spectrum = response_spectrum(record_.time_step(), acceleration(direction), periods_,
                                   measure_.damping)
                     .pseudo_acceleration;
    return *spectrum;
  }

  const RotatedSpectrum& rotated_spectra() {
    if (!rotated_spectra_)
      rotated_spectra_ = rotated_spectrum(record_.time_step(), acceleration(Direction::kH1),
                                          acceleration(Direction::kH2), periods_, measure_.damping);
    return *rotated_spectra_;
  }

  const RotatedValues& rotated() {
    if (!rotated_)
      rotated_ = rotated_values(measure_, record_.time_step(), acceleration(Direction::kH1),
                                acceleration(Direction::kH2));
    return *rotated_;
  }

  const Record& record_;
  Measure measure_;
  Eigen::VectorXd periods_;
  std::array<std::optional<double>, 3> values_;
  std::array<std::optional<Eigen::ArrayXd>, 3> spectra_;
  std::optional<RotatedSpectrum> rotated_spectra_;
  std::optional<RotatedValues> rotated_;
};

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
    RecordValues values(record, measure);
    for (const Combination each : combinations(record, measure))
      add(row, result.warnings, name_of(each), [&] { return values.of(each); });
    warn_of_short_period(result, measure, record.time_step());
    result.rows.push_back(std::move(row));
  }
  return result;
}

}  // namespace gurney::groundmotions
