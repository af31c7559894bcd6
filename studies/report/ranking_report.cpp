#include "studies/report/ranking_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "studies/report/formats.h"

namespace gurney::report {
namespace {

using findings::Table;
using findings::Value;
using study::RankedMeasure;
using study::RankedRecord;
using study::RecordRanking;

constexpr double kExplains = 0.5;  // of the scatter: an assumption, as kAsPredicted
constexpr double kAsPredicted = 1.25;

const RankedMeasure* explaining(const RecordRanking& ranking) {
  return !ranking.measures.empty() && ranking.measures.front().explained >= kExplains
             ? &ranking.measures.front()
             : nullptr;
}

std::string verdict(const RecordRanking& ranking) {
  if (ranking.predicted < study::kLeastRecords)
    return fmt::format(
        "{} records move the item and do not overturn it: too few to tell measures apart, which "
        "needs {}.",
        ranking.predicted, study::kLeastRecords);
  if (ranking.measures.empty())
    return "The records do not differ in any measure that the file contains (study.measures).";
  const RankedMeasure& best = ranking.measures.front();
  std::string words =
      explaining(ranking)
          ? fmt::format(
                "{} explains the order: it predicts {:.0f} % of the scatter of ln demand, each "
                "record from the other {}",
                best.name, 100 * best.explained, ranking.predicted - 1)
          : fmt::format(
                "No measure of the file explains the order: the best, {}, predicts {:.0f} % of "
                "the scatter of ln demand",
                best.name, 100 * std::max(0.0, best.explained));
  if (ranking.measures.size() > 1)
    words += fmt::format("; {} {:.0f} %", ranking.measures[1].name,
                         100 * std::max(0.0, ranking.measures[1].explained));
  return words + ".";
}

/// "largest", "3rd of 8"
std::string place_of(const std::vector<double>& values, std::size_t i) {
  const auto above = std::ranges::count_if(values, [&](double each) { return each > values[i]; });
  if (above == 0) return "the largest";
  if (above + 1 == std::ssize(values)) return "the smallest";
  const char* const ends[] = {"th", "st", "nd", "rd"};
  const auto place = above + 1;
  const auto digit = place % 10;
  return fmt::format("{}{} of {}", place,
                     ends[place / 10 % 10 == 1 || digit > 3 ? 0 : static_cast<std::size_t>(digit)],
                     values.size());
}

std::string reason(const RecordRanking& ranking, std::size_t i, const findings::Format& demand) {
  const RankedMeasure* const measure = explaining(ranking);
  if (!measure) return {};
  const RankedRecord& record = ranking.records[i];
  std::string words = fmt::format("{} is {}", measure->name, place_of(measure->values, i));
  if (std::isnan(record.predicted)) return words;
  const double ratio = record.demand / record.predicted;
  if (std::max(ratio, 1 / ratio) <= kAsPredicted) return words + ", which predicts the demand";
  return fmt::format("{}, which predicts {}: {} than that by a factor of {:.2g}", words,
                     with_unit(record.predicted, demand), ratio > 1 ? "more" : "less",
                     std::max(ratio, 1 / ratio));
}

}  // namespace

findings::Section ranking_findings(const study::StudyData& data, const RecordRanking& ranking) {
  const study::UnitSystem& units = data.units();
  const findings::Format demand = format_of(units, ranking.units, ".3g");
  findings::Section all{
      "", fmt::format("{} of {} at {}{}", ranking.demand, ranking.item, ranking.level,
                      ranking.configuration.empty() ? "" : ", " + ranking.configuration)};
  all.json("item", ranking.item).json("demand", ranking.demand);
  all.json("units", units.or_else("si").of(ranking.units).name);
  all.json("configuration", ranking.configuration).json("level", ranking.level);
  all.say(verdict(ranking)).json("verdict", verdict(ranking));
  Table records{"records",
                "",
                {{"name", "record"},
                 {"demand", ranking.demand, demand},
                 {"overturned", "overturned"},
                 {"runs", "runs"},
                 {"predicted", "", demand}}};
  const auto format = [&](const RankedMeasure& measure) {
    return format_of(report_unit(data, {measure.name, measure.units, {}}),
                     units.or_else("si").of(measure.units).in_si, ".3g");
  };
  const std::size_t shown = std::min<std::size_t>(ranking.measures.size(), 3);
  for (std::size_t k = 0; k < shown; ++k)  // for people; programs have them below
    records.columns.push_back({"", ranking.measures[k].name, format(ranking.measures[k])});
  records.columns.push_back({"reason", "reason"});
  for (std::size_t i = 0; i < ranking.records.size(); ++i) {
    const RankedRecord& record = ranking.records[i];
    records.add(
        {record.name, record.demand, record.overturned, record.runs.size(), record.predicted});
    for (std::size_t k = 0; k < shown; ++k)
      records.rows.back().push_back(ranking.measures[k].values[i]);
    records.rows.back().push_back(reason(ranking, i, demand));
  }
  all.add(records);
  Table measures{"measures", "", {{"name", ""}, {"explained", ""}, {"units", ""}, {"values", ""}}};
  for (const RankedMeasure& measure : ranking.measures)
    measures.add({measure.name,
                  measure.explained,
                  units.or_else("si").of(measure.units).name,
                  {findings::Numbers(measure.values), format(measure)}});
  return all.add(measures);
}

}  // namespace gurney::report
