#include "studies/analysis/record_ranking.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include "engine/base/error.h"
#include "studies/analysis/demands.h"

namespace gurney::study {
namespace {

constexpr double kSame = 1.01;  // largest over smallest of a measure that is alike for all records

/// The points of a line by least squares, each with the value that a line through the others has
/// there: y - e / (1 - h), with the residual e and the leverage h (Allen 1974).
struct LeftOut {
  std::vector<double> predicted;
  double explained = 0;
};

LeftOut left_out(const std::vector<double>& x, const std::vector<double>& y) {
  const auto n = static_cast<double>(x.size());
  const double x_mean = std::reduce(x.begin(), x.end()) / n;
  const double y_mean = std::reduce(y.begin(), y.end()) / n;
  double xx = 0, xy = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    xx += (x[i] - x_mean) * (x[i] - x_mean);
    xy += (x[i] - x_mean) * (y[i] - y_mean);
  }
  LeftOut result;
  double of_line = 0, of_mean = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    const double off = x[i] - x_mean, leverage = 1 / n + off * off / xx;
    const double error = (y[i] - y_mean - xy / xx * off) / (1 - leverage);
    result.predicted.push_back(y[i] - error);
    of_line += error * error;
    of_mean += std::pow((y[i] - y_mean) * n / (n - 1), 2);
  }
  result.explained = of_mean > 0 ? 1 - of_line / of_mean : 0;
  return result;
}

class Ranker {
 public:
  Ranker(const ConfigurationView& side, const RankingRequest& request)
      : data_(*side.data), side_(side), levels_(data_) {
    require(data_.study().intensity.kind != IntensityPlan::Kind::kIda,
            data_.file().path() +
                ": an IDA has other levels for each record; gurney plot FILE ida "
                "compares their capacities");
    const std::size_t count = levels_.values().size();
    for (const std::size_t run : side.runs()) level_ = std::max(level_, levels_.of_run(run));
    level_ = request.level.value_or(level_);
    require(level_ < count, fmt::format("--level {}: the study has {} levels", level_ + 1, count));
    for (const std::size_t run : data_.runs_of(side.configuration))
      if (levels_.of_run(run) == level_) runs_.push_back(run);
  }

  RecordRanking of(const NamedDemand& demand) const {
    RecordRanking ranking{demand.quantity.part.empty()
                              ? demand.quantity.item
                              : demand.quantity.item + "/" + demand.quantity.part,
                          demand.quantity.column,
                          demand.units,
                          side_.configuration_name(),
                          levels_.name_of(level_),
                          ranked(demand),
                          {}};
    require(ranking.records.size() > 1,
            fmt::format("{}: has one record at {}; there is nothing to compare",
                        data_.file().path(), ranking.level));
    predict(ranking);
    return ranking;
  }

 private:
  std::vector<RankedRecord> ranked(const NamedDemand& demand) const {
    const std::vector<double> values = values_of_runs(data_, demand, runs_);
    const NamedDemand fall{
        "", "s", {Quantity::Of::kItem, "time_of_overturning", demand.quantity.item, ""}};
    const std::vector<double> falls = values_of_runs(data_, fall, runs_);
    const std::vector<std::string> names = record_names(side_);
    std::map<std::size_t, RankedRecord> by_record;
    for (std::size_t i = 0; i < runs_.size(); ++i) {
      if (!std::isfinite(values[i])) continue;
      const std::size_t record = data_.record_of(runs_[i]);
      RankedRecord& of = by_record[record];
      of.record = record;
      of.name = names.at(record);
      of.runs.push_back(runs_[i]);
      of.overturned += falls[i] >= 0 ? 1 : 0;
      of.demand += values[i];
    }
    std::vector<RankedRecord> records;
    for (auto& [record, of] : by_record) {
      of.demand /= static_cast<double>(of.runs.size());
      records.push_back(std::move(of));
    }
    std::ranges::stable_sort(records, [](const RankedRecord& a, const RankedRecord& b) {
      const std::size_t of_a = a.overturned * b.runs.size(), of_b = b.overturned * a.runs.size();
      return of_a != of_b ? of_a > of_b : a.demand > b.demand;
    });
    return records;
  }

  /// Measures by how they predict the records that overturn nothing and move the item.
  void predict(RecordRanking& ranking) const {
    std::vector<std::size_t> known;
    std::vector<double> y;
    for (std::size_t i = 0; i < ranking.records.size(); ++i)
      if (const RankedRecord& of = ranking.records[i]; of.overturned == 0 && of.demand > 0) {
        known.push_back(i);
        y.push_back(std::log(of.demand));
      }
    ranking.predicted = known.size();
    if (known.size() < kLeastRecords) return;
    double best = -std::numeric_limits<double>::infinity();
    for (const RunMeasure& measure : known_measures(data_)) {
      RankedMeasure row{measure.name, measure.units, {}};
      for (const RankedRecord& of : ranking.records) {
        double sum = 0;
        for (const std::size_t run : of.runs) sum += measure.values[run];
        row.values.push_back(sum / static_cast<double>(of.runs.size()));
      }
      std::vector<double> x;
      for (const std::size_t i : known) x.push_back(std::log(row.values[i]));
      const auto [low, high] = std::ranges::minmax(x);
      if (!std::ranges::all_of(x, [](double each) { return std::isfinite(each); }) ||
          high - low < std::log(kSame))
        continue;
      const LeftOut by = left_out(x, y);
      row.explained = by.explained;
      if (row.explained > best) {
        best = row.explained;
        for (std::size_t i = 0; i < known.size(); ++i)
          ranking.records[known[i]].predicted = std::exp(by.predicted[i]);
      }
      ranking.measures.push_back(std::move(row));
    }
    std::ranges::stable_sort(ranking.measures, std::ranges::greater(), &RankedMeasure::explained);
  }

  const StudyData& data_;
  const ConfigurationView& side_;
  Levels levels_;
  std::size_t level_ = 0;
  std::vector<std::size_t> runs_;
};

}  // namespace

std::vector<RecordRanking> rank_records(const ConfigurationView& side,
                                        const RankingRequest& request) {
  const Ranker ranker(side, request);
  std::vector<RecordRanking> rankings;
  for (const NamedDemand& demand : demands_named(*side.data, side.configuration, {request.demand}))
    rankings.push_back(ranker.of(demand));
  return rankings;
}

}  // namespace gurney::study
