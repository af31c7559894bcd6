#include "groundmotions/measures/measure.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cassert>
#include <cmath>
#include <complex>
#include <optional>
#include <unsupported/Eigen/FFT>
#include <vector>

#include "engine/base/error.h"
#include "engine/base/names.h"
#include "engine/base/number_text.h"
#include "engine/base/units.h"
#include "engine/config/nearest_name.h"
#include "groundmotions/measures/cumulative.h"
#include "groundmotions/measures/fiv3.h"
#include "groundmotions/measures/peaks.h"
#include "groundmotions/measures/response_spectrum.h"

namespace gurney::groundmotions {
namespace {

using Kind = MeasureKind;

constexpr DisplayUnit kG = {"g", kStandardGravity};
constexpr DisplayUnit kMeters = {"m", 1};
constexpr DisplayUnit kMetersPerSecond = {"m/s", 1};
constexpr DisplayUnit kSeconds = {"s", 1};

struct Entry {
  Kind kind;
  const char* name;
  bool has_period;
  const char* si_unit;
  DisplayUnit display_unit;
  double scaling_power;
  const char* definition;
};

constexpr Entry kEntries[] = {
    {Kind::kPga, "PGA", false, "m/s2", kG, 1, "largest |acceleration| at the samples"},
    {Kind::kPgv, "PGV", false, "m/s", kMetersPerSecond, 1,
     "largest |velocity|, integrated from rest without any correction"},
    {Kind::kPgd, "PGD", false, "m", kMeters, 1,
     "largest |displacement|, integrated twice from rest without any correction"},
    {Kind::kPfa, "PFA", false, "m/s2", kG, 1, "peak floor acceleration: PGA of a floor's motion"},
    {Kind::kPfv, "PFV", false, "m/s", kMetersPerSecond, 1,
     "peak floor velocity: PGV of a floor's motion"},
    {Kind::kArias, "Arias", false, "m/s", kMetersPerSecond, 2,
     "pi / (2 g) times the integral of acceleration^2 (trapezoid)"},
    {Kind::kCav, "CAV", false, "m/s", kMetersPerSecond, 1,
     "integral of |acceleration| (trapezoid)"},
    {Kind::kD575, "D5-75", false, "s", kSeconds, 0,
     "time between 5 and 75 % of the Arias intensity"},
    {Kind::kD595, "D5-95", false, "s", kSeconds, 0,
     "time between 5 and 95 % of the Arias intensity"},
    {Kind::kTm, "Tm", false, "s", kSeconds, 0,
     "mean period of the Fourier spectrum, 0.25 to 20 Hz"},
    {Kind::kTp, "Tp", false, "s", kSeconds, 0,
     "period of the largest pseudo-acceleration, 0.02 to 10 s, 5 % damping"},
    {Kind::kSa, "Sa", true, "m/s2", kG, 1,
     "pseudo-acceleration at this period [s], peak at the samples"},
    {Kind::kSaAvg, "SaAvg", true, "m/s2", kG, 1, "geometric mean of Sa over periods"},
    {Kind::kFiv3, "FIV3", true, "m/s", kMetersPerSecond, 1,
     "three largest filtered incremental velocities for this period [s]"},
    {Kind::kSi, "SI", false, "m", kMeters, 1,
     "Housner's spectrum intensity: integral of PSV from 0.1 to 2.5 s, 5 % damping"},
};

const Entry& entry_of(const Measure& measure) {
  return *std::find_if(std::begin(kEntries), std::end(kEntries),
                       [&](const Entry& entry) { return entry.kind == measure.kind; });
}

/// Cuts `text` at the first `mark`; the part behind it is empty if there is none.
std::pair<std::string_view, std::string_view> cut(std::string_view text, char mark) {
  const auto at = text.find(mark);
  if (at == std::string_view::npos) return {text, {}};
  return {text.substr(0, at), text.substr(at + 1)};
}

/// The damping that "2%" or "0.02" is.
std::optional<double> damping_of(std::string_view text) {
  const bool percent = text.ends_with('%');
  if (percent) text.remove_suffix(1);
  const auto value = number(text);
  if (value && percent) return *value / 100;
  return value;
}

void read_arguments(Measure& measure, std::string_view arguments, const std::string& where) {
  const auto [periods, damping] = cut(arguments, ',');
  const auto [first, last] = cut(periods, ':');
  const auto period = number(first);
  require(period && (*period > 0 || (*period == 0 && measure.kind == Kind::kSa)),
          where + fmt::format("the period '{}' must be a number above 0 in seconds", first));
  measure.period = *period;
  if (periods.size() > first.size()) {
    require(measure.kind == Kind::kSaAvg, where + "only SaAvg takes a range of periods");
    const auto last_period = number(last);
    require(last_period && *last_period > *period,
            where + fmt::format("the last period '{}' must be a number above the first", last));
    measure.last_period = *last_period;
  }
  if (arguments.size() == periods.size()) return;
  require(measure.kind != Kind::kFiv3, where + "FIV3 takes no damping");
  const auto value = damping_of(damping);
  require(value && *value >= 0 && *value < 1,
          where + fmt::format("the damping '{}' must be at least 0% and below 100%", damping));
  measure.damping = *value;
}

constexpr double kLowestFrequency = 0.25, kHighestFrequency = 20;  // [Hz]
constexpr double kLargestFrequencyStep = 0.05;                     // [Hz]
constexpr double kShortestPeriod = 0.02, kLongestPeriod = 10;      // [s]
constexpr int kPeriods = 400;

constexpr double kLowFactor = 0.2, kHighFactor = 3, kSpacing = 0.01;  // of SaAvg
constexpr int kFewestPeriods = 10;
constexpr double kShortest = 0.1, kLongest = 2.5;  // of SI [s]
constexpr int kIntervals = 120;

}  // namespace

std::vector<std::string> known_measures() {
  std::vector<std::string> result;
  for (const Entry& entry : kEntries)
    result.push_back(entry.name + std::string(entry.has_period ? "(1.0)" : ""));
  return result;
}

Measure parse_measure(std::string_view text) {
  const std::string where = "measure '" + std::string(text) + "': ";
  const std::string all = plain_name(text);
  const auto [name, behind] = cut(all, '(');
  for (const Entry& entry : kEntries) {
    if (plain_name(entry.name) != name) continue;
    Measure measure{.kind = entry.kind};
    if (!entry.has_period) {
      require(name.size() == all.size(), where + entry.name + " takes nothing in brackets");
      return measure;
    }
    const std::size_t end = behind.find(')');
    require(
        end == std::string::npos || end + 1 == behind.size(),
        where + "nothing may follow the bracket; a measure is asked for, without its component");
    require(end != std::string::npos,
            where + "a period in seconds is needed, as in " + entry.name + "(1.0)");
    read_arguments(measure, behind.substr(0, behind.size() - 1), where);
    return measure;
  }
  for (const Entry& entry : kEntries) {
    const std::string begin = plain_name(entry.name);
    if (entry.has_period && all.starts_with(begin) &&
        number(std::string_view(all).substr(begin.size())))
      throw Error(where + fmt::format("the period stands in brackets: {}({})", entry.name,
                                      all.substr(begin.size())));
  }
  const std::vector<std::string> names = names_of(kEntries);
  const auto original = cut(text, '(').first;
  throw Error(where + "unknown measure" + config::suggestion(std::string(original), names));
}

std::string name_of(const Measure& measure) {
  const Entry& entry = entry_of(measure);
  if (!entry.has_period) return entry.name;
  std::string arguments = fmt::format("{:g}", measure.period);
  if (measure.last_period > 0) arguments += fmt::format(":{:g}", measure.last_period);
  if (measure.damping != Measure{}.damping)
    arguments += fmt::format(", {:g}%", 100 * measure.damping);
  return fmt::format("{}({})", entry.name, arguments);
}

std::string definition_of(const Measure& measure) {
  std::string text = entry_of(measure).definition;
  if (measure.kind == Kind::kSaAvg)
    text += measure.last_period > 0
                ? fmt::format(" from {:g} to {:g} s", measure.period, measure.last_period)
                : fmt::format(" from 0.2 to 3 times {:g} s", measure.period);
  if (measure.kind == Kind::kSa || measure.kind == Kind::kSaAvg)
    text += fmt::format(", {:g} % damping", 100 * measure.damping);
  return text;
}

const char* si_unit_of(const Measure& measure) { return entry_of(measure).si_unit; }
DisplayUnit display_unit_of(const Measure& measure) { return entry_of(measure).display_unit; }
double scaling_power(const Measure& measure) { return entry_of(measure).scaling_power; }

double value_of(const Measure& measure, double time_step, const Eigen::VectorXd& acceleration) {
  switch (measure.kind) {
    case Kind::kPga:
    case Kind::kPfa:
      return peaks(time_step, acceleration).acceleration;
    case Kind::kPgv:
    case Kind::kPfv:
      return peaks(time_step, acceleration).velocity;
    case Kind::kPgd:
      return peaks(time_step, acceleration).displacement;
    case Kind::kArias:
      return arias_intensity(time_step, acceleration);
    case Kind::kCav:
      return cumulative_absolute_velocity(time_step, acceleration);
    case Kind::kD575:
      return significant_part(time_step, acceleration, 0.05, 0.75).duration();
    case Kind::kD595:
      return significant_part(time_step, acceleration, 0.05, 0.95).duration();
    case Kind::kTm:
      return mean_period(time_step, acceleration);
    case Kind::kTp:
      return predominant_period(time_step, acceleration);
    case Kind::kSa:
    case Kind::kSaAvg:
      return geometric_mean(
          response_spectrum(time_step, acceleration, spectral_periods(measure), measure.damping)
              .pseudo_acceleration);
    case Kind::kFiv3:
      return fiv3(time_step, acceleration, measure.period);
    case Kind::kSi:
      return spectrum_intensity(time_step, acceleration);
  }
  return 0;
}

Eigen::VectorXd spectral_periods(const Measure& measure) {
  if (measure.kind == Kind::kSa) return Eigen::VectorXd::Constant(1, measure.period);
  if (measure.kind != Kind::kSaAvg) return {};
  if (measure.last_period > 0) return average_periods(measure.period, measure.last_period);
  return average_periods(measure.period);
}

double mean_period(double time_step, const Eigen::VectorXd& acceleration) {
  assert(time_step > 0);
  const double least = std::ceil(1 / (kLargestFrequencyStep * time_step));
  const std::size_t length = std::bit_ceil(
      std::max(2 * static_cast<std::size_t>(acceleration.size()), static_cast<std::size_t>(least)));
  std::vector<double> padded(length, 0.0);
  std::copy(acceleration.begin(), acceleration.end(), padded.begin());
  Eigen::FFT<double> fft;
  fft.SetFlag(Eigen::FFT<double>::HalfSpectrum);
  std::vector<std::complex<double>> amplitudes;
  fft.fwd(amplitudes, padded);

  const double frequency_step = 1 / (static_cast<double>(length) * time_step);
  double power = 0, weighted = 0;
  for (std::size_t i = 1; i < amplitudes.size(); ++i) {
    const double frequency = static_cast<double>(i) * frequency_step;
    if (frequency < kLowestFrequency || frequency > kHighestFrequency) continue;
    power += std::norm(amplitudes[i]);
    weighted += std::norm(amplitudes[i]) / frequency;
  }
  return power > 0 ? weighted / power : 0;
}

double predominant_period(double time_step, const Eigen::VectorXd& acceleration) {
  const auto periods = logarithmic_periods(kShortestPeriod, kLongestPeriod, kPeriods);
  const auto spectrum = response_spectrum(time_step, acceleration, periods);
  Eigen::Index largest = 0;
  return spectrum.pseudo_acceleration.maxCoeff(&largest) > 0 ? periods[largest] : 0;
}

Eigen::VectorXd average_periods(double period) {
  return average_periods(kLowFactor * period, kHighFactor * period);
}

Eigen::VectorXd average_periods(double from, double to) {
  assert(from > 0 && to > from);
  const int count = static_cast<int>(std::lround((to - from) / kSpacing)) + 1;
  return Eigen::VectorXd::LinSpaced(std::max(count, kFewestPeriods), from, to);
}

double geometric_mean(const Eigen::VectorXd& spectral_accelerations) {
  return std::exp(spectral_accelerations.array().log().mean());
}

double spectrum_intensity(double time_step, const Eigen::VectorXd& acceleration) {
  const Eigen::VectorXd periods = Eigen::VectorXd::LinSpaced(kIntervals + 1, kShortest, kLongest);
  const Eigen::VectorXd psv = response_spectrum(time_step, acceleration, periods).pseudo_velocity;
  const double ends = (psv[0] + psv[kIntervals]) / 2;
  return (kLongest - kShortest) / kIntervals * (psv.sum() - ends);
}

}  // namespace gurney::groundmotions
