#include "studies/report/comparison_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "studies/study/analysis/curve_audit.h"
#include "studies/study/analysis/report_unit.h"

namespace gurney::report {
namespace {

constexpr double kSignificant = 0.05;

constexpr double kRounding = 1e-12;  // of the values that a difference is of

std::string number(double value) { return std::isnan(value) ? "-" : fmt::format("{:.4g}", value); }

std::string probability(double p) {
  if (std::isnan(p)) return "-";
  return p < 0.0001 ? "<0.0001" : fmt::format("{:.4f}", p);
}

/// 0 where it is the rounding of sums of values as large as `size`.
double rounded(double value, double size) { return std::abs(value) < kRounding * size ? 0 : value; }

std::string interval(const statistics::Interval& of, double unit, double size) {
  if (!std::isfinite(of.low)) return "unknown";
  return fmt::format("{:.3g} to {:.3g}", rounded(of.low, size) / unit,
                     rounded(of.high, size) / unit);
}

std::string shown(const std::string& value) { return value.empty() ? "(not there)" : value; }

std::string differences_text(const char* title,
                             const std::vector<study::InputDifference>& differences,
                             const ComparisonReport& report) {
  if (differences.empty()) return fmt::format("{:<12} the same\n", title);
  std::string text = fmt::format("{:<46} {}  |  {}\n", title, report.label_a, report.label_b);
  for (const study::InputDifference& each : differences)
    text += fmt::format("  {:<44} {}  |  {}\n", each.key, shown(each.a), shown(each.b));
  return text;
}

std::string inputs_text(const ComparisonReport& report) {
  const study::InputDifferences& inputs = report.inputs;
  std::string text = differences_text("job", inputs.job, report) +
                     differences_text("assumptions", inputs.assumptions, report) +
                     differences_text("data files", inputs.data_files, report) +
                     differences_text("program", inputs.program, report);
  text += fmt::format("{:<12} {} in both", "records", inputs.records_common);
  const auto add = [&](const std::string& what, const std::vector<std::string>& names) {
    if (!names.empty())
      text += fmt::format("; {} {}: {}", names.size(), what, fmt::join(names, ", "));
  };
  add("only in " + report.label_a, inputs.records_of_a);
  add("only in " + report.label_b, inputs.records_of_b);
  add("with other files or processing", inputs.records_changed);
  return text + "\n";
}

std::string side_text(const char* title, const std::string& name,
                      const study::ConfigurationView& side, std::size_t paired,
                      std::size_t left_out) {
  std::string text = fmt::format("{:<12} {}: {} runs paired", title, name, paired);
  if (left_out > 0) text += fmt::format(", {} without a partner", left_out);
  if (const std::size_t failed = side.data->failed(side.configuration); failed > 0)
    text += fmt::format(", {} excluded because they failed", failed);
  return text + "\n";
}

std::string pairing_text(const study::StudyComparison& found) {
  const study::RunPairs& pairs = found.pairs;
  std::string by = "record and " + pairs.level;
  if (pairs.by_angle) by += ", angle";
  if (pairs.by_draw) by += ", draw";
  std::string text = fmt::format("{:<12} {} pairs by {}", "paired", pairs.pairs.size(), by);
  switch (pairs.group) {
    case study::RunPairs::Group::kRecord:
      text += fmt::format("; {} records, each counts once\n", pairs.groups);
      break;
    case study::RunPairs::Group::kDraw:
      text +=
          fmt::format("; {} draws, each counts once: one record, so nothing is known of others\n",
                      pairs.groups);
      break;
    case study::RunPairs::Group::kNone:
      return text + "; one record without draws: nothing is random, so there is no p\n";
  }
  const double smallest =
      found.smallest_p * static_cast<double>(std::max<std::size_t>(1, found.tests.largest()));
  if (smallest > kSignificant)
    text += fmt::format(
        "{:<12} so few groups give a p of {} or more, {} after Holm: whatever differs, this table "
        "cannot\n{:<12} show it; add records or draws, or compare fewer demands (--demand)\n",
        "caution", probability(found.smallest_p), probability(std::min(1.0, smallest)), "");
  return text;
}

std::string label(const study::ComparedQuantity& row, const study::UnitSystem& units) {
  if (!row.words.empty() && row.words != row.name) return row.name + ": " + row.words;
  return row.units == "1" ? row.name : row.name + " [" + units.of(row.units).name + "]";
}

std::string with_unit(const study::ComparedQuantity& row, const study::UnitSystem& units) {
  const study::ReportUnit unit = units.of(row.units);
  return number(row.a / unit.in_si) + (unit.name == "1" ? "" : " " + unit.name);
}

std::string quantities_text(const ComparisonReport& report, study::ComparedQuantity::Kind kind,
                            const std::string& title) {
  const study::StudyComparison& found = report.found;
  const study::UnitSystem& units = report.units();
  const std::size_t wide_a = std::max<std::size_t>(10, report.label_a.size()),
                    wide_b = std::max<std::size_t>(10, report.label_b.size());
  std::size_t width = title.size();
  for (const study::ComparedQuantity& row : found.quantities)
    width = std::max(width, label(row, units).size());
  const auto line = [&](const std::string& name, const auto& groups, const std::string& a,
                        const std::string& b, const std::string& difference,
                        const std::string& between, const std::string& p, const std::string& holm) {
    return fmt::format("{:<{}} {:>6} {:>{}} {:>{}} {:>11}  {:<22} {:>8} {:>8}", name, width, groups,
                       a, wide_a, b, wide_b, difference, between, p, holm);
  };
  const auto row_text = [&](const study::ComparedQuantity& row) {
    const double unit = units.of(row.units).in_si;
    const double size = std::max(std::abs(row.a), std::abs(row.b));
    return line(label(row, units), row.groups, number(row.a / unit), number(row.b / unit),
                number(rounded(row.difference, size) / unit), interval(row.interval, unit, size),
                probability(row.p), probability(row.p_holm));
  };
  std::string text, same;
  for (const study::ComparedQuantity& row : found.quantities) {
    if (row.kind != kind) continue;
    const double size = std::max(std::abs(row.a), std::abs(row.b));
    if (std::isnan(row.p) && rounded(row.difference, size) == 0 &&
        rounded(row.a - row.b, size) == 0)
      same += fmt::format("{}{} ({})", same.empty() ? "" : ", ", row.name, with_unit(row, units));
    else
      text += row_text(row) + (row.p_holm < kSignificant ? " *\n" : "\n");
  }
  if (text.empty() && same.empty()) return {};
  text = "\n" +
         line(title, "groups", report.label_a, report.label_b, "difference",
              fmt::format("{:g} % interval", 100 * report.confidence), "p", "Holm") +
         "\n" + text;
  return same.empty() ? text : text + "the same in every pair: " + same + "\n";
}

std::string curve_text(const statistics::FragilityFit& fit, const study::ReportUnit& unit) {
  if (fit.curve)
    return fmt::format("{:.4g}, {:.3g}", fit.curve->theta / unit.in_si, fit.curve->beta);
  const std::string known = study::median_text(fit.status, fit.median, unit);
  return known.empty() ? text(fit.status) : known;
}

/// Of the curves of one side; that of the scale factors once, since they are the same.
std::string side_cautions(const std::string& label, const study::StudyComparison& found,
                          study::CurveAudit study::ComparedCurves::*audit,
                          const study::ReportUnit& unit) {
  std::string text;
  study::CurveAudit of_records;
  for (const study::ComparedCurves& row : found.curves) {
    study::CurveAudit of_curve = row.*audit;
    of_records.factors = std::exchange(of_curve.factors, {});
    for (const std::string& each : study::cautions(of_curve, unit))
      text += fmt::format("{}, {}: caution: {}\n", label, row.name, each);
  }
  for (const std::string& each : study::cautions(of_records, unit))
    text += fmt::format("{}: caution: {}\n", label, each);
  return text;
}

std::string cautions_text(const ComparisonReport& report, const study::ReportUnit& unit) {
  return side_cautions(report.label_a, report.found, &study::ComparedCurves::audit_a, unit) +
         side_cautions(report.label_b, report.found, &study::ComparedCurves::audit_b, unit);
}

std::string curves_text(const ComparisonReport& report) {
  const study::StudyComparison& found = report.found;
  if (found.measure.empty())
    return "\nno fragility curves: the studies have different intensity measures\n";
  if (found.curves.empty())
    return "\nno fragility curves: all runs have one " + found.measure + "; see the shares\n";
  const std::string of_a = report.label_a + ": theta, beta",
                    of_b = report.label_b + ": theta, beta";
  const study::ReportUnit unit =
      study::report_unit(*report.a.data, {found.measure, found.units, {}});
  std::size_t wide = 24, wide_a = std::max<std::size_t>(28, of_a.size()),
              wide_b = std::max<std::size_t>(28, of_b.size());
  for (const study::ComparedCurves& row : found.curves) {
    wide = std::max(wide, row.name.size());
    wide_a = std::max(wide_a, curve_text(row.a, unit).size());
    wide_b = std::max(wide_b, curve_text(row.b, unit).size());
  }
  const auto line = [&](const std::string& name, const std::string& a, const std::string& b,
                        const std::string& ratio, const std::string& p, const std::string& holm) {
    return fmt::format("{:<{}} {:<{}} {:<{}} {:>9} {:>8} {:>8}", name, wide, a, wide_a, b, wide_b,
                       ratio, p, holm);
  };
  std::string text = "\n" + line("fragility curve", of_a, of_b, "LR", "p", "Holm") + "\n";
  for (const study::ComparedCurves& row : found.curves)
    text += line(row.name, curve_text(row.a, unit), curve_text(row.b, unit),
                 number(row.likelihood_ratio), probability(row.p), probability(row.p_holm)) +
            (row.p_holm < kSignificant ? " *\n" : "\n");
  return text + fmt::format("theta in {} ({})\n", unit.name, found.measure) +
         cautions_text(report, unit);
}

/// The findings in words.
std::string conclusion_text(const ComparisonReport& report) {
  std::string text;
  std::vector<std::string> less, more;
  for (const study::ComparedQuantity& row : report.found.quantities) {
    if (!(row.p_holm < kSignificant)) continue;
    if (row.kind == study::ComparedQuantity::Kind::kShare)
      text += fmt::format("* '{}' is exceeded {} often in {}: in {:.3g} % against {:.3g} %\n",
                          row.name, row.difference > 0 ? "more" : "less", report.label_b,
                          100 * row.b, 100 * row.a);
    std::vector<std::string>& list = row.difference > 0 ? more : less;
    if (row.kind != study::ComparedQuantity::Kind::kShare &&
        std::ranges::find(list, row.name) == list.end())
      list.push_back(row.name);
  }
  for (const study::ComparedCurves& row : report.found.curves)
    if (row.p_holm < kSignificant)
      text += fmt::format("* '{}' has another fragility curve in {}\n", row.name, report.label_b);
  if (!less.empty())
    text += fmt::format("* less in {}: {}\n", report.label_b, fmt::join(less, ", "));
  if (!more.empty())
    text += fmt::format("* more in {}: {}\n", report.label_b, fmt::join(more, ", "));
  return text.empty() ? "no difference is significant after Holm's adjustment\n" : text;
}

}  // namespace

std::string comparison_text(const ComparisonReport& report) {
  const study::StudyComparison& found = report.found;
  using Kind = study::ComparedQuantity::Kind;
  std::string text =
      side_text("reference", report.name_a, report.a, found.pairs.paired_a,
                found.pairs.left_out_a) +
      side_text("compared", report.name_b, report.b, found.pairs.paired_b, found.pairs.left_out_b) +
      fmt::format("{:<12} {} - {}\n", "difference", report.label_b, report.label_a) +
      pairing_text(found) + "\n" + inputs_text(report);
  text += quantities_text(report, Kind::kShare, "share of runs that exceed") + curves_text(report) +
          quantities_text(report, Kind::kMean, "mean") +
          quantities_text(report, Kind::kMedian, "median");
  if (found.overturned > 0)
    text += fmt::format(
        "\n{} of the paired runs overturned: their demands are those before overturning\n",
        found.overturned);
  if (!found.not_common.empty())
    text += fmt::format("\nnot in both: {}\n", fmt::join(found.not_common, ", "));
  return text +
         fmt::format(
             "\ntests: {} of shares, {} of curves, {} of means, {} of medians; Holm's "
             "adjustment within each of these families; * below {:g}\n",
             found.tests.shares, found.tests.curves, found.tests.means, found.tests.medians,
             kSignificant) +
         conclusion_text(report);
}

}  // namespace gurney::report
