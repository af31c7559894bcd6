#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/base/error.h"
#include "engine/base/names.h"
#include "engine/base/random/normal_draw.h"
#include "engine/config/nearest_name.h"
#include "studies/analysis/study_data.h"
#include "studies/hospital/outcomes.h"
#include "studies/statistics/bands.h"

namespace gurney::study {
namespace {

constexpr double kSameLevel = 1e-6;  // of the level: rounding of a file

/// Runs of one configuration at one level: states that each reaches, by record.
using RunsOfLevel = std::vector<std::vector<Reached>>;

class RunOutcomes : public OutcomeSource {
 public:
  RunOutcomes(const Hospital& hospital, const Consequences& consequences,
              const std::string& results)
      : hospital_(hospital), data_(results), values_(data_.file()) {
    require(data_.measure("").name == "PGV larger",
            fmt::format("{}: its levels are of {}; must be PGV, component \"larger\"", results,
                        data_.measure("").name));
    limit_states_ = consequences.limit_states();
    own_ = limit_states_.size();
    states_ = state_names(consequences, names_of(data_.limit_states()), results);
    // Storeys have motions of their own, of the same records: these are known by their names.
    for (const std::string& name : data_.file().strings("records/name")) {
      const auto known = std::ranges::find(records_, name);
      record_.push_back(static_cast<std::size_t>(known - records_.begin()));
      if (known == records_.end()) records_.push_back(name);
    }
  }

  const std::vector<std::string>& states() const override { return states_; }
  std::size_t records() const override { return records_.size(); }

  Outcome outcome(const HospitalItem& item, const Storey& storey, Brakes brakes) const override {
    const std::string name = configuration_of(item, storey, brakes);
    const auto found = std::ranges::find(data_.configurations(), name);
    require(found != data_.configurations().end(),
            fmt::format("{}: {} has no configuration '{}'{}", item.where, data_.file().path(), name,
                        config::suggestion(name, data_.configurations())));
    auto runs = std::make_shared<std::vector<RunsOfLevel>>(
        runs_of(static_cast<std::size_t>(found - data_.configurations().begin())));
    return [runs](std::size_t level, const MotionSample& motion, const PieceSample& piece,
                  const Replicate& replicate) {
      const RunsOfLevel& of = (*runs)[level];
      std::size_t record = drawn_index(motion.record, of.size());
      if (!replicate.records.empty()) record = replicate.records[record];
      return of[record][drawn_index(piece.draw, of[record].size())];
    };
  }

  std::vector<std::string> cautions() const override {
    std::size_t failed = 0;
    for (std::size_t i = 0; i < data_.configurations().size(); ++i) failed += data_.failed(i);
    std::vector<std::string> all;
    if (failed > 0) all.push_back(fmt::format("{} failed runs are excluded", failed));
    if (static_cast<double>(records_.size()) < statistics::kFewestGroups)
      all.push_back(
          fmt::format("{} records: intervals are over them, and too narrow with fewer "
                      "than {:g}",
                      records_.size(), statistics::kFewestGroups));
    return all;
  }

 private:
  std::vector<RunsOfLevel> runs_of(std::size_t configuration) const {
    std::vector<RunsOfLevel> runs(hospital_.levels.size(), RunsOfLevel(records_.size()));
    const std::vector<double> intensity = data_.measure("").values;
    for (const std::size_t run : data_.runs_of(configuration)) {
      const auto level = std::ranges::find_if(hospital_.levels, [&](double each) {
        return std::abs(each - intensity[run]) <= kSameLevel * each;
      });
      if (level == hospital_.levels.end()) continue;
      runs[static_cast<std::size_t>(level - hospital_.levels.begin())]
          [record_[data_.record_of(run)]]
              .push_back(reached(run));
    }
    for (std::size_t level = 0; level < runs.size(); ++level)
      for (std::size_t record = 0; record < records_.size(); ++record)
        require(!runs[level][record].empty(),
                fmt::format("{}: configuration '{}' has no run of record '{}' at {:g} m/s",
                            data_.file().path(), data_.configurations()[configuration],
                            records_[record], hospital_.levels[level]));
    return runs;
  }

  Reached reached(std::size_t run) const {
    Reached states = 0;
    const Values values = values_.of_run(run);
    for (std::size_t i = 0; i < own_; ++i)
      if (has(limit_states_[i]) && exceeded(limit_states_, i, values)) states |= Reached{1} << i;
    for (std::size_t i = 0; i < data_.limit_states().size(); ++i) {
      const auto bit = std::ranges::find(states_, data_.limit_states()[i].name) - states_.begin();
      if (static_cast<std::size_t>(bit) >= own_ && exceeded(data_.limit_states(), i, values))
        states |= Reached{1} << bit;
    }
    return states;
  }

  bool has(const LimitState& state) const {
    return !state.is_simple() ||
           data_.file().has_column(table_of(state.quantity.of) + "/" + state.quantity.column);
  }

  const Hospital& hospital_;
  StudyData data_;
  mutable FileValues values_;
  std::vector<LimitState> limit_states_;
  std::size_t own_ = 0;
  std::vector<std::string> states_, records_;  // names
  std::vector<std::size_t> record_;            // of each motion of the file, in records_
};

}  // namespace

std::string configuration_of(const HospitalItem& item, const Storey& storey, Brakes brakes) {
  return fmt::format("{} {}, {}, {}", item.equipment, item.place, storey.name,
                     brakes_names()[static_cast<std::size_t>(brakes)]);
}

std::unique_ptr<OutcomeSource> run_outcomes(const Hospital& hospital,
                                            const Consequences& consequences,
                                            const std::string& results) {
  return std::make_unique<RunOutcomes>(hospital, consequences, results);
}

}  // namespace gurney::study
