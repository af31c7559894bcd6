#include "studies/analysis/measure_choice.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>

#include "engine/base/random/normal_draw.h"
#include "studies/analysis/demands.h"

namespace gurney::study {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kTie = 1e-6;  // ln likelihoods that are equal but for rounding

using Points = std::vector<statistics::CloudPoint>;

/// Fitted on all runs, fitted on some, not fitted.
int rank_of(const statistics::IntensityRow& row) {
  return row.status != statistics::CloudStatus::kFitted ? 2 : row.left_out > 0 ? 1 : 0;
}

bool is_better(const statistics::IntensityRow& a, const statistics::IntensityRow& b) {
  if (rank_of(a) != rank_of(b)) return rank_of(a) < rank_of(b);
  if (rank_of(a) == 0)
    return std::round(a.log_likelihood / kTie) > std::round(b.log_likelihood / kTie);
  return rank_of(a) == 1 && a.efficiency < b.efficiency;
}

/// The points of drawn records, with replacement.
Points resampled(const std::vector<Points>& of_record, std::uint64_t seed, int resample) {
  Points points;
  for (std::size_t i = 0; i < of_record.size(); ++i) {
    const double u = uniform_draw(seed, static_cast<std::uint64_t>(resample), i);
    const std::size_t record = drawn_index(u, of_record.size());
    for (statistics::CloudPoint point : of_record[record]) {
      point.group = i;
      points.push_back(point);
    }
  }
  return points;
}

double likelihood_of(const Points& points) {
  const statistics::CloudFit fit = statistics::fit_cloud(points);
  return fit.status == statistics::CloudStatus::kFitted ? fit.log_likelihood : kNan;
}

std::vector<Points> by_record(const Points& demands, const std::vector<double>& im) {
  std::map<std::size_t, Points> records;
  for (std::size_t i = 0; i < demands.size(); ++i) {
    statistics::CloudPoint point = demands[i];
    point.im = im[i];
    records[point.group].push_back(point);
  }
  std::vector<Points> result;
  for (const auto& [record, points] : records) result.push_back(points);
  return result;
}

/// Share of resamples in which the first of the measures keeps the largest likelihood.
double share_that_stays(const Points& demands, const std::vector<std::vector<double>>& measures,
                        int resamples, std::uint64_t seed) {
  std::vector<std::vector<Points>> of_measure;
  for (const std::vector<double>& im : measures) of_measure.push_back(by_record(demands, im));
  if (of_measure.size() < 2 || of_measure.front().size() < 2) return kNan;
  int stays = 0, fitted = 0;
  for (int i = 0; i < resamples; ++i) {
    const double best = likelihood_of(resampled(of_measure[0], seed, i));
    if (std::isnan(best)) continue;
    ++fitted;
    bool first = true;
    for (std::size_t k = 1; first && k < of_measure.size(); ++k)
      first = !(likelihood_of(resampled(of_measure[k], seed, i)) > best + kTie);
    stays += first;
  }
  return fitted > 0 ? static_cast<double>(stays) / fitted : kNan;
}

std::vector<double> of_runs(const std::vector<double>& values,
                            const std::vector<std::size_t>& runs) {
  std::vector<double> result;
  for (const std::size_t run : runs) result.push_back(values[run]);
  return result;
}

/// Properties of the records that each of the runs has: the factor, and of their sources.
std::vector<statistics::NamedValues> properties_of(const StudyData& data,
                                                   const std::vector<std::size_t>& runs) {
  const StudyReader& file = data.file();
  std::vector<statistics::NamedValues> all{
      {"factor on the record", of_runs(data.factors_on_records(), runs)}};
  for (const char* name : {"magnitude", "distance"})
    if (const std::string column = std::string("runs/") + name; file.has_column(column))
      all.push_back({name, of_runs(file.numbers(column), runs)});
  for (statistics::NamedValues& each : all)
    if (each.name != "magnitude")
      for (double& value : each.values) value = std::log(value);
  std::erase_if(all, [](const statistics::NamedValues& each) {
    return each.name != "factor on the record" &&
           !std::ranges::all_of(each.values, [](double value) { return std::isfinite(value); });
  });
  return all;
}

}  // namespace

std::vector<std::size_t> sized_states(const StudyData& data) {
  std::vector<std::size_t> states;
  for (std::size_t i = 0; i < data.limit_states().size(); ++i) {
    const LimitState& state = data.limit_states()[i];
    if (state.kind == LimitState::Kind::kAbove && state.at_least == 1 && state.limit > 0)
      states.push_back(i);
  }
  return states;
}

MeasureChoice rank_measures(const ConfigurationView& side, std::size_t state, int resamples,
                            std::uint64_t seed) {
  const StudyData& data = *side.data;
  const std::vector<std::size_t>& runs = side.runs();
  MeasureChoice choice;
  choice.floor = kFloorOfLimit * data.limit_states().at(state).limit;
  choice.demand_units = units_of(data.limit_states()[state].quantity);
  const RunMeasure any{"", "", std::vector<double>(data.file().runs(), 1)};
  const Points demands = data.cloud(state, side.configuration, any, choice.floor);
  std::map<std::size_t, int> records;
  for (const statistics::CloudPoint& point : demands) {
    ++records[point.group];
    choice.overturned += point.known == statistics::CloudPoint::Known::kAtLeast;
    choice.at_floor += point.known == statistics::CloudPoint::Known::kAtMost;
  }
  choice.runs = demands.size();
  choice.records = records.size();

  const std::vector<RunMeasure> known = known_measures(data);
  std::vector<statistics::NamedValues> measures;
  for (const RunMeasure& each : known) measures.push_back({each.name, of_runs(each.values, runs)});
  for (const std::string& name : data.measures())
    if (std::ranges::find(known, name, &RunMeasure::name) == known.end())
      choice.unknown.push_back(name);
  const std::vector<statistics::NamedValues> properties = properties_of(data, runs);
  for (const statistics::NamedValues& each : properties) choice.properties.push_back(each.name);
  const std::vector<statistics::IntensityRow> rows =
      statistics::compare_intensities(demands, measures, properties);

  std::vector<std::size_t> order(rows.size());
  std::iota(order.begin(), order.end(), 0);
  std::ranges::stable_sort(
      order, [&](std::size_t a, std::size_t b) { return is_better(rows[a], rows[b]); });
  std::vector<std::vector<double>> comparable;
  for (const std::size_t i : order) {
    choice.rows.push_back(rows[i]);
    choice.units.push_back(known[i].units);
    if (rank_of(rows[i]) == 0) comparable.push_back(measures[i].values);
  }
  const double best = choice.rows.empty() ? kNan : choice.rows.front().log_likelihood;
  choice.lead = kNan;
  for (std::size_t i = 1; i < comparable.size() && std::isnan(choice.lead); ++i) {
    const double lead = best - choice.rows[i].log_likelihood;
    if (lead > kTie)
      choice.lead = lead;
    else
      ++choice.ties;
  }
  choice.stays_best = share_that_stays(demands, comparable, resamples, seed);
  return choice;
}

}  // namespace gurney::study
