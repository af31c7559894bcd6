#include "studies/report/comparison_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "studies/analysis/curve_audit.h"
#include "studies/analysis/study_data.h"
#include "studies/report/formats.h"

namespace gurney::report {
namespace {

using findings::Format;
using findings::Section;
using findings::Table;
using findings::Texts;
using findings::Value;
using Kind = study::ComparedQuantity::Kind;

constexpr double kSignificant = 0.05;

constexpr double kRounding = 1e-12;  // of the values that a difference is of

/// 0 where it is the rounding of sums of values as large as `size`.
double rounded(double value, double size) { return std::abs(value) < kRounding * size ? 0 : value; }

const char* mark(double p) { return p < kSignificant ? "*" : ""; }

Section side(const char* key, const char* label, const std::string& name,
             const study::ConfigurationView& of, std::size_t paired, std::size_t left_out) {
  const std::size_t failed = of.data->failed(of.configuration);
  std::string text = fmt::format("{}: {} runs paired", name, paired);
  if (left_out > 0) text += fmt::format(", {} without a partner", left_out);
  if (failed > 0) text += fmt::format(", {} excluded because they failed", failed);
  Section all{key};
  all.json("name", name).json("file", of.data->file().path());
  all.json("configuration", of.configuration_name()).json("runs_paired", paired);
  all.json("runs_without_partner", left_out).json("runs_failed", failed);
  return all.text(label, text);
}

const char* name_of(study::RunPairs::Group group) {
  switch (group) {
    case study::RunPairs::Group::kRecord:
      return "record";
    case study::RunPairs::Group::kDraw:
      return "draw";
    case study::RunPairs::Group::kNone:
      break;
  }
  return "none";
}

std::string groups_text(const study::RunPairs& pairs) {
  switch (pairs.group) {
    case study::RunPairs::Group::kRecord:
      return fmt::format("{} records, each counts once", pairs.groups);
    case study::RunPairs::Group::kDraw:
      return fmt::format("{} draws, each counts once: one record, so nothing is known of others",
                         pairs.groups);
    case study::RunPairs::Group::kNone:
      break;
  }
  return "one record without draws: nothing is random, so there is no p";
}

Section pairing(const study::StudyComparison& found) {
  const study::RunPairs& pairs = found.pairs;
  Section all{"pairs"};
  all.json("count", pairs.pairs.size()).json("level", pairs.level);
  all.json("by_angle", pairs.by_angle).json("by_draw", pairs.by_draw);
  all.json("group", name_of(pairs.group)).json("groups", pairs.groups);
  all.json("runs_overturned", found.overturned);
  all.text("paired", fmt::format("{} pairs by record and {}{}{}; {}", pairs.pairs.size(),
                                 pairs.level, pairs.by_angle ? ", angle" : "",
                                 pairs.by_draw ? ", draw" : "", groups_text(pairs)));
  const double smallest =
      found.smallest_p * static_cast<double>(std::max<std::size_t>(1, found.tests.largest()));
  if (pairs.group != study::RunPairs::Group::kNone && smallest > kSignificant)
    all.say(fmt::format(
        "caution: so few groups give a p of {:.4f} or more, {:.4f} after Holm: whatever differs, "
        "this table cannot show it; add records or draws, or compare fewer demands (--demand)",
        found.smallest_p, std::min(1.0, smallest)));
  return all;
}

Table differences(const char* key, const char* title, const std::vector<study::InputDifference>& of,
                  const ComparisonReport& report) {
  Table table{key, title, {}};
  const auto value = [](const std::string& text) { return text.empty() ? Value() : Value(text); };
  const auto shown = [](const std::string& text) { return text.empty() ? "(not there)" : text; };
  for (const study::InputDifference& each : of)
    add_row(table, {{{"key", "key"}, each.key},
                    {"a", value(each.a)},
                    {"b", value(each.b)},
                    {{"", report.label_a}, shown(each.a)},
                    {{"", report.label_b}, shown(each.b)}});
  return table;
}

Section inputs(const ComparisonReport& report) {
  const study::InputDifferences& of = report.inputs;
  Section all{"inputs", "inputs that differ"};
  all.fact("records_in_both", "records in both", of.records_common);
  all.fact("records_of_a_only", "only in " + report.label_a, of.records_of_a);
  all.fact("records_of_b_only", "only in " + report.label_b, of.records_of_b);
  all.fact("records_changed", "with other files or processing", of.records_changed);
  Texts same;
  const auto add = [&](const char* key, const char* title, const auto& list) {
    if (list.empty()) same.emplace_back(title);
    all.add(differences(key, title, list, report));
  };
  add("job", "job", of.job);
  add("assumptions", "assumptions", of.assumptions);
  add("data_files", "data files", of.data_files);
  add("program", "program", of.program);
  if (!same.empty()) all.say(fmt::format("the same: {}", fmt::join(same, ", ")));
  return all;
}

std::string label(const study::ComparedQuantity& row, const study::UnitSystem& units) {
  if (!row.words.empty() && row.words != row.name) return row.name + ": " + row.words;
  return row.units == "1" ? row.name : row.name + " [" + units.of(row.units).name + "]";
}

/// Differences that are rounding are shown as zero.
Table quantities(const ComparisonReport& report, Kind kind, const char* key, const char* title) {
  const study::UnitSystem& units = report.units();
  const Format p{".2g"};
  Table table{key, "", {}};
  for (const study::ComparedQuantity& row : report.found.quantities) {
    if (row.kind != kind) continue;
    const Format number = format_of(units, row.units),
                 interval = interval_format(format_of(units, row.units, ".3g"));
    const double size = std::max(std::abs(row.a), std::abs(row.b));
    const bool known = std::isfinite(row.interval.low);
    add_row(table, {{{"", title}, label(row, units)},
                    {"name", row.name},
                    {"words", row.words},
                    {"units", units.or_else("si").of(row.units).name},
                    {{"groups", "groups"}, row.groups},
                    {{"a", report.label_a}, {row.a, number}},
                    {{"b", report.label_b}, {row.b, number}},
                    {"difference", {row.difference, number}},
                    {{"", "difference"}, {rounded(row.difference, size), number}},
                    {"interval", {ends(row.interval), interval}},
                    {{"", fmt::format("{:g} % interval", 100 * report.confidence)},
                     {known ? Value(findings::Numbers{rounded(row.interval.low, size),
                                                      rounded(row.interval.high, size)})
                            : Value("unknown"),
                      interval}},
                    {{"p", "p", p}, row.p},
                    {{"p_holm", "Holm", p}, row.p_holm},
                    {{"", "*"}, mark(row.p_holm)}});
  }
  return table;
}

std::string curve_text(const study::FittedCurve& of, const study::ReportUnit& unit) {
  if (const auto curve = of.curve())
    return fmt::format("{:.4g}, {:.3g}", curve->theta / unit.in_si, curve->beta);
  const std::string known = study::median_text(of.median, unit);
  return known.empty() ? study::outcomes_text(of.status(), of.change(), unit) : known;
}

/// Cautions on the curves of one side; that of the scale factors once, since they are the same.
void add_cautions(Section& to, const std::string& label, const study::StudyComparison& found,
                  study::FittedCurve study::ComparedCurves::*side, const study::ReportUnit& unit) {
  study::CurveAudit of_records;
  for (const study::ComparedCurves& row : found.curves) {
    study::CurveAudit of_curve = (row.*side).audit;
    of_records.factors = std::exchange(of_curve.factors, {});
    for (const std::string& each : study::cautions(of_curve, unit))
      to.say(fmt::format("{}, {}: caution: {}", label, row.name, each));
  }
  for (const std::string& each : study::cautions(of_records, unit))
    to.say(fmt::format("{}: caution: {}", label, each));
}

void add_curve(std::vector<findings::Cell>& row, const study::FittedCurve& side,
               const study::ReportUnit& shown, const study::ReportUnit& unit) {
  const Format of = format_of(shown, unit.in_si);
  const auto curve = side.curve();
  row.insert(row.end(), {text(side.status()),
                         side.fit.runs,
                         side.fit.exceeded,
                         {curve ? Value() : ends(side.median), of},
                         {curve ? Value(curve->theta) : Value(), of},
                         curve ? Value(curve->beta) : Value(),
                         study::cautions(side.audit, unit),
                         curve_text(side, shown)});
}

/// Without curves: why there are none.
Section curves(const ComparisonReport& report) {
  const study::StudyComparison& found = report.found;
  const study::ReportUnit unit = report.units().or_else("si").of(found.units);
  Section all;
  all.json("measure", found.measure).json("measure_units", unit.name);
  Table table{"curves", "", {{"name", "fragility curve"}}};
  for (const bool first : {true, false}) {
    for (const char* key :
         {"status", "runs", "exceeded", "median_between", "theta", "beta", "cautions"})
      table.columns.push_back({std::string(first ? "a." : "b.") + key, ""});
    table.columns.push_back({"", (first ? report.label_a : report.label_b) + ": theta, beta"});
  }
  const Format p{".2g"};
  table.columns.insert(
      table.columns.end(),
      {{"likelihood_ratio", "LR"}, {"p", "p", p}, {"p_holm", "Holm", p}, {"", "*"}});
  const study::ReportUnit shown =
      found.measure.empty() ? unit
                            : study::report_unit(*report.a.data, {found.measure, found.units, {}});
  for (const study::ComparedCurves& row : found.curves) {
    std::vector<findings::Cell> cells{row.name};
    add_curve(cells, row.a, shown, unit);
    add_curve(cells, row.b, shown, unit);
    cells.insert(cells.end(), {row.likelihood_ratio, row.p, row.p_holm, mark(row.p_holm)});
    table.add(std::move(cells));
  }
  all.add(std::move(table));
  if (found.measure.empty())
    return all.say("no fragility curves: the studies have different intensity measures");
  if (found.curves.empty())
    return all.say("no fragility curves: all runs have one " + found.measure + "; see the shares");
  all.say(fmt::format("theta in {} ({})", shown.name, found.measure));
  add_cautions(all, report.label_a, found, &study::ComparedCurves::a, shown);
  add_cautions(all, report.label_b, found, &study::ComparedCurves::b, shown);
  return all;
}

/// The findings in words.
Texts conclusions(const ComparisonReport& report) {
  Texts lines, less, more;
  for (const study::ComparedQuantity& row : report.found.quantities) {
    if (!(row.p_holm < kSignificant)) continue;
    if (row.kind == Kind::kShare)
      lines.push_back(fmt::format("'{}' is exceeded {} often in {}: in {:.3g} % against {:.3g} %",
                                  row.name, row.difference > 0 ? "more" : "less", report.label_b,
                                  100 * row.b, 100 * row.a));
    Texts& list = row.difference > 0 ? more : less;
    if (row.kind != Kind::kShare && std::ranges::find(list, row.name) == list.end())
      list.push_back(row.name);
  }
  for (const study::ComparedCurves& row : report.found.curves)
    if (row.p_holm < kSignificant)
      lines.push_back(
          fmt::format("'{}' has another fragility curve in {}", row.name, report.label_b));
  if (!less.empty())
    lines.push_back(fmt::format("less in {}: {}", report.label_b, fmt::join(less, ", ")));
  if (!more.empty())
    lines.push_back(fmt::format("more in {}: {}", report.label_b, fmt::join(more, ", ")));
  if (lines.empty()) lines.emplace_back("no difference is significant after Holm's adjustment");
  return lines;
}

}  // namespace

findings::Section comparison_findings(const ComparisonReport& report) {
  const study::StudyComparison& found = report.found;
  Section all;
  all.add(side("a", "reference", report.name_a, report.a, found.pairs.paired_a,
               found.pairs.left_out_a));
  all.add(
      side("b", "compared", report.name_b, report.b, found.pairs.paired_b, found.pairs.left_out_b));
  all.text("difference", report.label_b + " - " + report.label_a);
  all.add(pairing(found)).list("", "in short", conclusions(report));
  all.add(inputs(report)).json("confidence", report.confidence);
  all.add(quantities(report, Kind::kShare, "shares", "share of runs that exceed"));
  all.add(curves(report));
  all.add(quantities(report, Kind::kMean, "means", "mean"));
  all.add(quantities(report, Kind::kMedian, "medians", "median"));
  if (std::ranges::any_of(found.quantities, [](const study::ComparedQuantity& row) {
        return std::isinf(row.interval.low);
      }))
    all.say(
        "interval unknown: too few groups, or all of them differ alike (as where no run of either "
        "side exceeds): without scatter nothing is known of its width");
  if (found.overturned > 0)
    all.say(fmt::format(
        "{} of the paired runs overturned: their demands contain what they do on the floor, "
        "unless settings.follow_overturning = false",
        found.overturned));
  all.list("not_in_both", "not in both", found.not_common);
  all.json("smallest_p_possible", found.smallest_p);
  Section tests{"tests"};
  tests.json("shares", found.tests.shares).json("curves", found.tests.curves);
  tests.json("means", found.tests.means).json("medians", found.tests.medians);
  all.add(tests);
  all.say(fmt::format(
      "Holm's adjustment within each of these families of tests: {} of shares, {} of curves, {} of "
      "means, {} of medians; * below {:g}",
      found.tests.shares, found.tests.curves, found.tests.means, found.tests.medians,
      kSignificant));
  return all;
}

}  // namespace gurney::report
