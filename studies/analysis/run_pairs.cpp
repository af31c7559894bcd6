#include "studies/analysis/run_pairs.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <set>

#include "engine/base/error.h"

namespace gurney::study {
namespace {

/// What makes runs of two files the same, as text: numbers are rounded there.
struct RunKey {
  std::size_t run;
  std::string record, level, angle, draw;
};

std::string rounded(double value) { return fmt::format("{:.9g}", value + 0.0); }

std::string intensity_of(const StudyData& data) {
  return data.file().text_attribute("intensity_measure");
}

/// A Latin hypercube of another size is another plan.
std::size_t size_of_plan(const StudyData& data) {
  if (data.study().sampling == Sampling::kMonteCarlo) return 0;
  std::map<std::string, std::size_t> records;
  std::size_t most = 0;
  for (const std::string& set : data.file().strings("records/set"))
    most = std::max(most, ++records[set]);
  return most;
}

/// Whether a draw of a number is the same draw in both.
bool same_draws(const StudyData& a, const StudyData& b) {
  const Study &of_a = a.study(), &of_b = b.study();
  return of_a.draws > 0 && of_a.draws == of_b.draws && of_a.seed == of_b.seed &&
         of_a.sampling == of_b.sampling && size_of_plan(a) == size_of_plan(b);
}

std::vector<RunKey> keys_of(const ConfigurationView& side, bool by_intensity) {
  const StudyReader& file = side.data->file();
  const std::vector<double> level = file.numbers(by_intensity ? "runs/intensity" : "runs/scale");
  const std::vector<double> angle = file.numbers("runs/angle"), draw = file.numbers("runs/draw");
  const std::vector<std::string> records = record_names(side);
  std::vector<RunKey> keys;
  for (const std::size_t run : side.runs())
    keys.push_back({run, records.at(side.data->record_of(run)), rounded(level[run]),
                    rounded(angle[run]), rounded(draw[run])});
  return keys;
}

std::set<std::string> values_of_key(const std::vector<RunKey>& keys, std::string RunKey::*part) {
  std::set<std::string> values;
  for (const RunKey& key : keys) values.insert(key.*part);
  return values;
}

std::set<std::string> common_values(const std::vector<RunKey>& a, const std::vector<RunKey>& b,
                                    std::string RunKey::*part) {
  const std::set<std::string> of_a = values_of_key(a, part), of_b = values_of_key(b, part);
  std::set<std::string> both;
  std::ranges::set_intersection(of_a, of_b, std::inserter(both, both.end()));
  return both;
}

void require_common(const std::set<std::string>& common, const char* what,
                    const ConfigurationView& a, const ConfigurationView& b) {
  require(!common.empty(),
          fmt::format("{} '{}' and {} '{}' have no {} in common: nothing can be compared with each "
                      "other",
                      a.data->file().path(), a.configuration_name(), b.data->file().path(),
                      b.configuration_name(), what));
}

}  // namespace

RunPairs pair_runs(const ConfigurationView& a, const ConfigurationView& b) {
  RunPairs result;
  const std::string measure = intensity_of(*a.data);
  result.by_intensity = !measure.empty() && measure == intensity_of(*b.data);
  result.level = result.by_intensity ? measure : "scale";
  const std::array<std::vector<RunKey>, 2> keys{keys_of(a, result.by_intensity),
                                                keys_of(b, result.by_intensity)};
  const auto records = common_values(keys[0], keys[1], &RunKey::record);
  require_common(records, "record", a, b);
  require_common(common_values(keys[0], keys[1], &RunKey::level), "level", a, b);
  result.by_angle = !common_values(keys[0], keys[1], &RunKey::angle).empty();
  result.by_draw = same_draws(*a.data, *b.data);
  result.group = records.size() > 1 ? RunPairs::Group::kRecord
                 : result.by_draw   ? RunPairs::Group::kDraw
                                    : RunPairs::Group::kNone;

  std::map<std::string, std::size_t> groups;
  const auto group_of = [&](const RunKey& key) {
    const bool of_draw = result.group == RunPairs::Group::kDraw;
    return groups.try_emplace(of_draw ? key.draw : key.record, groups.size()).first->second;
  };
  std::map<std::array<std::string, 4>, std::array<std::vector<std::size_t>, 2>> together;
  std::map<std::array<std::string, 4>, std::size_t> group_of_pair;
  for (const std::size_t side : {0, 1})
    for (const RunKey& key : keys[side]) {
      if (!records.contains(key.record)) continue;
      (side == 0 ? result.common_a : result.common_b).emplace_back(key.run, group_of(key));
      const std::array<std::string, 4> common{
          key.record, key.level, result.by_angle ? key.angle : "", result.by_draw ? key.draw : ""};
      together[common][side].push_back(key.run);
      group_of_pair[common] = group_of(key);
    }
  std::set<std::size_t> paired;
  for (const auto& [common, runs] : together) {
    if (runs[0].empty() || runs[1].empty()) continue;
    result.pairs.push_back({runs[0], runs[1], group_of_pair[common]});
    paired.insert(group_of_pair[common]);
    result.paired_a += runs[0].size();
    result.paired_b += runs[1].size();
  }
  require(!result.pairs.empty(),
          fmt::format("{} and {}: no run of one had the same record, level, angle and draw as one "
                      "of the other",
                      a.data->file().path(), b.data->file().path()));
  result.groups = paired.size();
  result.left_out_a = a.runs().size() - result.paired_a;
  result.left_out_b = b.runs().size() - result.paired_b;
  return result;
}

}  // namespace gurney::study
