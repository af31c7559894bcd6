#include "groundmotions/measures/measure.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <numbers>

#include "engine/base/config/nearest_name.h"
#include "engine/base/error.h"
#include "engine/base/units.h"
#include "groundmotions/formats/numbers.h"
#include "groundmotions/measures/duration.h"
#include "groundmotions/measures/fiv3.h"
#include "groundmotions/measures/peaks.h"
#include "groundmotions/measures/response_spectrum.h"
#include "groundmotions/measures/rotation.h"
#include "groundmotions/processing/integrate.h"

namespace gurney {

namespace {

using Kind = Measure::Kind;

struct Row {
  Kind kind;
  const char* name;
  const char* unit;
  double power;
  bool has_period;
  const char* meaning;
};

constexpr std::array kRows = {
    Row{Kind::kPga, "PGA", "m/s2", 1, false, "peak acceleration at samples"},
    Row{Kind::kPgv, "PGV", "m/s", 1, false, "peak velocity from rest, no baseline correction"},
    Row{Kind::kPgd, "PGD", "m", 1, false, "peak displacement from rest, no baseline correction"},
    Row{Kind::kArias, "Arias", "m/s", 2, false, "Arias intensity, trapezoidal rule"},
    Row{Kind::kCav, "CAV", "m/s", 1, false, "cumulative absolute velocity, trapezoidal rule"},
    Row{Kind::kD5_75, "D5-75", "s", 0, false, "time from 5 to 75 % of the Arias intensity"},
    Row{Kind::kD5_95, "D5-95", "s", 0, false, "time from 5 to 95 % of the Arias intensity"},
    Row{Kind::kTm, "Tm", "s", 0, false, "mean period of the Fourier amplitudes, 0.25 to 20 Hz"},
    Row{Kind::kTp, "Tp", "s", 0, false, "period of the largest pseudo-acceleration (5 %)"},
    Row{Kind::kSi, "SI", "m", 1, false, "spectrum intensity: PSV (5 %) over 0.1 to 2.5 s"},
    Row{Kind::kSa, "Sa", "m/s2", 1, true, "pseudo-acceleration (5 %), peak at samples"},
    Row{Kind::kSaAvg, "SaAvg", "m/s2", 1, true, "geometric mean of Sa from 0.2 T to 3 T"},
    Row{Kind::kFiv3, "FIV3", "m/s", 1, true, "filtered incremental velocity"},
};

constexpr std::array kCombinations = {"h1",   "h2",     "vertical", "geometric mean", "larger",
                                      "SRSS", "RotD00", "RotD50",   "RotD100"};

const Row& row_of(const Measure& measure) {
  return *std::ranges::find(kRows, measure.kind, &Row::kind);
}

std::string lower_without_blanks(std::string_view text) {
  std::string result;
  for (const unsigned char c : text)
    if (!std::isspace(c)) result += static_cast<char>(std::tolower(c));
  return result;
}

Eigen::VectorXd log_spaced(double first, double last, Eigen::Index count) {
  return Eigen::VectorXd::LinSpaced(count, std::log(first), std::log(last)).array().exp();
}

Eigen::VectorXd averaging_periods(double period) {
  return Eigen::VectorXd::LinSpaced(10, 0.2 * period, 3 * period);
}

double geometric_mean(const Eigen::VectorXd& values) {
  return std::exp(values.array().log().mean());
}

double predominant_period(double time_step, const Eigen::VectorXd& acceleration) {
  const ResponseSpectrum spectrum =
      response_spectrum(time_step, acceleration, log_spaced(0.02, 5, 200));
  Eigen::Index at = 0;
  spectrum.pseudo_acceleration.maxCoeff(&at);
  return spectrum.period[at];
}

/// Trapezoidal rule over 121 periods.
double spectrum_intensity(double time_step, const Eigen::VectorXd& acceleration) {
  const Eigen::VectorXd periods = Eigen::VectorXd::LinSpaced(121, 0.1, 2.5);
  const ResponseSpectrum spectrum = response_spectrum(time_step, acceleration, periods);
  const Eigen::ArrayXd velocity =
      2 * std::numbers::pi * spectrum.displacement.array() / periods.array();
  return (periods[1] - periods[0]) *
         (velocity.sum() - (velocity[0] + velocity[velocity.size() - 1]) / 2);
}

double sa(double time_step, const Eigen::VectorXd& acceleration, double period) {
  return response_spectrum(time_step, acceleration, Eigen::VectorXd::Constant(1, period))
      .pseudo_acceleration[0];
}

const Component& component_of(const Record& record, Direction direction) {
  const auto& component = record[direction];
  require(component.has_value(),
          fmt::format("record '{}' has no {} component", record.name, name_of(direction)));
  return *component;
}

double of_component(const Measure& measure, const Record& record, Direction direction) {
  const Component& component = component_of(record, direction);
  return value_of(measure, component.time_step, component.acceleration);
}

RotD of_rotated_motions(const Measure& measure, const Component& h1, const Component& h2) {
  std::vector<double> values;
  for (int degree = 0; degree < 180; ++degree) {
    const double angle = degree * kRadiansPerDegree;
    values.push_back(
        value_of(measure, h1.time_step,
                 std::cos(angle) * h1.acceleration + std::sin(angle) * h2.acceleration));
  }
  return rot_d(std::move(values));
}

RotD rot_d_of(const Measure& measure, const Record& record) {
  const Component& h1 = component_of(record, Direction::kH1);
  const Component& h2 = component_of(record, Direction::kH2);
  const auto integrals = [](const Component& c) { return integrated(c.time_step, c.acceleration); };
  switch (measure.kind) {
    case Kind::kPga:
      return rot_d_of_histories(h1.acceleration, h2.acceleration);
    case Kind::kPgv:
      return rot_d_of_histories(integrals(h1).velocity, integrals(h2).velocity);
    case Kind::kPgd:
      return rot_d_of_histories(integrals(h1).displacement, integrals(h2).displacement);
    case Kind::kSa:
    case Kind::kSaAvg: {
      const RotDSpectrum spectrum = rot_d_spectrum(
          record, measure.kind == Kind::kSa ? Eigen::VectorXd::Constant(1, measure.period)
                                            : averaging_periods(measure.period));
      return {geometric_mean(spectrum.d00), geometric_mean(spectrum.d50),
              geometric_mean(spectrum.d100)};
    }
    default:
      return of_rotated_motions(measure, h1, h2);
  }
}

}  // namespace

Measure parse_measure(std::string_view text) {
  const std::string plain = lower_without_blanks(text);
  const auto bracket = plain.find('(');
  std::vector<std::string> names;
  for (const Row& row : kRows) {
    names.push_back(row.has_period ? fmt::format("{}(1.0)", row.name) : row.name);
    if (lower_without_blanks(row.name) != plain.substr(0, bracket)) continue;
    if (row.has_period != (bracket != std::string::npos)) continue;
    if (!row.has_period) return {row.kind, 0};
    require(plain.back() == ')', fmt::format("'{}': a closing bracket is missing", text));
    const auto period = number(plain.substr(bracket + 1, plain.size() - bracket - 2));
    require(period && (*period > 0 || (*period == 0 && row.kind == Kind::kSa)) && *period <= 100,
            fmt::format("'{}': the period must be a number of seconds in (0, 100]", text));
    return {row.kind, *period};
  }
  throw Error(fmt::format("'{}' is not an intensity measure{}; allowed are {}", text,
                          config::suggestion(std::string(text), names), fmt::join(names, ", ")));
}

std::string name_of(const Measure& measure) {
  const Row& row = row_of(measure);
  return row.has_period ? fmt::format("{}({})", row.name, measure.period) : row.name;
}

std::string unit_of(const Measure& measure) { return row_of(measure).unit; }
std::string meaning_of(const Measure& measure) { return row_of(measure).meaning; }
double scaling_power(const Measure& measure) { return row_of(measure).power; }

const char* name_of(Combination combination) {
  return kCombinations[static_cast<std::size_t>(combination)];
}

std::vector<std::string> combination_names() {
  return {kCombinations.begin(), kCombinations.end()};
}

double value_of(const Measure& measure, double time_step, const Eigen::VectorXd& acceleration) {
  switch (measure.kind) {
    case Kind::kPga:
      return peaks(time_step, acceleration).acceleration;
    case Kind::kPgv:
      return peaks(time_step, acceleration).velocity;
    case Kind::kPgd:
      return peaks(time_step, acceleration).displacement;
    case Kind::kArias:
      return arias_intensity(time_step, acceleration);
    case Kind::kCav:
      return cumulative_absolute_velocity(time_step, acceleration);
    case Kind::kD5_75:
      return significant_duration(time_step, acceleration, 0.05, 0.75);
    case Kind::kD5_95:
      return significant_duration(time_step, acceleration, 0.05, 0.95);
    case Kind::kTm:
      return mean_period(time_step, acceleration);
    case Kind::kTp:
      return predominant_period(time_step, acceleration);
    case Kind::kSi:
      return spectrum_intensity(time_step, acceleration);
    case Kind::kSa:
      return sa(time_step, acceleration, measure.period);
    case Kind::kSaAvg:
      return geometric_mean(
          response_spectrum(time_step, acceleration, averaging_periods(measure.period))
              .pseudo_acceleration);
    case Kind::kFiv3:
      return fiv3(time_step, acceleration, measure.period);
  }
  return 0;
}

double value_of(const Measure& measure, Combination combination, const Record& record) {
  switch (combination) {
    case Combination::kH1:
      return of_component(measure, record, Direction::kH1);
    case Combination::kH2:
      return of_component(measure, record, Direction::kH2);
    case Combination::kVertical:
      return of_component(measure, record, Direction::kVertical);
    case Combination::kRotD00:
      return rot_d_of(measure, record).d00;
    case Combination::kRotD50:
      return rot_d_of(measure, record).d50;
    case Combination::kRotD100:
      return rot_d_of(measure, record).d100;
    default:
      break;
  }
  const double a = of_component(measure, record, Direction::kH1);
  const double b = of_component(measure, record, Direction::kH2);
  if (combination == Combination::kGeometricMean) return std::sqrt(a * b);
  return combination == Combination::kLarger ? std::max(a, b) : std::hypot(a, b);
}

std::vector<Measure> usual_measures() {
  std::vector<Measure> measures;
  for (const char* name :
       {"PGA", "PGV", "PGD", "Sa(0.2)", "Sa(0.5)", "Sa(1.0)", "Sa(2.0)", "SaAvg(1.0)", "FIV3(1.0)",
        "SI", "Arias", "CAV", "D5-75", "D5-95", "Tm", "Tp"})
    measures.push_back(parse_measure(name));
  return measures;
}

}  // namespace gurney
