#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/base/units.h"
#include "studies/report/calibration_report.h"

namespace gurney::report {
namespace {

constexpr double kClear = 0.05;

std::string interval_text(const statistics::Interval& interval) {
  if (std::isfinite(interval.high))
    return fmt::format("{:.4g} to {:.4g}", interval.low, interval.high);
  return interval.low > 0 ? fmt::format("{:.4g} or more", interval.low) : "one trial: none";
}

std::string constants_text(const calibration::Calibration& c) {
  std::size_t width = 8;
  for (const calibration::Constant& each : c.constants)
    width = std::max(width, each.about().size());
  std::string text = fmt::format("{:<{}} {:>10}  {:<22} {:>8} {:>7}  {}\n", "constant", width,
                                 "value", "95 % interval", "scatter", "trials", "unit");
  for (const calibration::Constant& each : c.constants)
    text += fmt::format("{:<{}} {:>10.4g}  {:<22} {:>7.1f}% {:>7}  {}\n", each.about(), width,
                        each.value, interval_text(each.interval), 100 * each.scatter,
                        each.trials.size(), calibration::unit_of(each.kind));
  if (std::ranges::any_of(c.constants,
                          [](const calibration::Constant& each) { return each.at_least; }))
    text +=
        "mu_s is a lower bound: with all wheels locked they do not break away at once. Lock one "
        "axle.\n";
  return text;
}

std::string verdict(const calibration::RollingTest& test) {
  if (test.p_adjusted < kClear) return fmt::format("differs from {:.3g}", test.supposed);
  return test.interval.contains(test.supposed)
             ? fmt::format("no difference from {:.3g} seen", test.supposed)
             : "unclear, as one of several tests";
}

std::string tests_text(const calibration::Calibration& c) {
  if (c.tests.empty())
    return c.rolling.empty() ? ""
                             : "\nToo few trials to test what rolling resistance depends on.\n";
  std::size_t width = 4;
  for (const calibration::RollingTest& test : c.tests) width = std::max(width, test.name.size());
  std::string text = "\nDoes rolling resistance depend on ...\n";
  for (const calibration::RollingTest& test : c.tests) {
    text += fmt::format("  {:<{}}  {} = {:.3g} ({}), p {:.2g}, of all tests {:.2g}: {}", test.name,
                        width, test.quantity, test.estimate, interval_text(test.interval), test.p,
                        test.p_adjusted, verdict(test));
    if (test.p_without) text += fmt::format("; p that it has no influence {:.2g}", *test.p_without);
    text += "\n";
  }
  return text + "  A large p is no proof: look at the interval.\n";
}

std::string crosswise_text(const calibration::Calibration& c) {
  std::string text;
  for (const calibration::CrosswiseFit& fit : c.crosswise)
    text += fmt::format(
        "  {}: mu w {:.3g} mm, mu w/4 + T/N {:.4g} mm (+-{:.1g}), Cr/R {:.4g}, misfit {:.2g} mm\n",
        fit.trial, fit.friction_times_width * kMillimetersPerMeter,
        fit.torque_length * kMillimetersPerMeter, fit.torque_length_error * kMillimetersPerMeter,
        fit.resistance, fit.misfit * kMillimetersPerMeter);
  return text.empty()
             ? ""
             : "\nCrosswise pulls (only the sum of scrub and swivel friction is identifiable):\n" +
                   text;
}

std::string validation_text(const calibration::Calibration& c) {
  if (c.predictions.empty() && c.unpredicted.empty())
    return "\nNo trial is reserved for validation: the accuracy of predictions is unknown.\n";
  std::string text = "\nValidation, with trials that were not used for the estimates\n";
  int inside = 0;
  for (const calibration::Prediction& each : c.predictions) {
    inside += each.inside();
    text += fmt::format("  {}: {} measured {:.4g}, predicted {:.4g} ({}), misfit {:+.1f} %{}\n",
                        each.trial, each.constant, each.measured, each.predicted,
                        interval_text(each.interval), 100 * each.misfit(),
                        each.inside() ? "" : ", OUTSIDE");
  }
  for (const std::string& each : c.unpredicted) text += "  " + each + "\n";
  if (!c.predictions.empty())
    text += fmt::format("  {} of {} within their 95 % interval\n", inside, c.predictions.size());
  return text;
}

}  // namespace

std::string calibration_text(const calibration::Calibration& c) {
  std::string text =
      fmt::format("{}: {} trials, {} excluded\n", c.source, c.read, c.left_out.size());
  if (c.simulated > 0)
    text +=
        fmt::format("SIMULATED: {} of the trials are not measured, but computed\n", c.simulated);
  for (const calibration::TrialFault& fault : c.left_out)
    text += "excluded: " + fault.text() + "\n";
  text += "\n" + constants_text(c) + tests_text(c) + crosswise_text(c);
  if (!c.outliers.empty()) text += "\nOutliers (kept: examine the trial, then decide)\n";
  for (const calibration::Outlier& each : c.outliers)
    text +=
        fmt::format("  {}: {} {:.4g}, p {:.2g}\n", each.trial, each.constant, each.value, each.p);
  return text + validation_text(c);
}

}  // namespace gurney::report
