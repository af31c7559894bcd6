#include "studies/analysis/assessment.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "engine/base/diagnostics.h"
#include "engine/base/error.h"
#include "engine/response/response.h"
#include "studies/analysis/study_data.h"
#include "studies/limit_states/limit_state_reader.h"

namespace gurney::study {
namespace {

/// The names in the rows of one run.
class StoredPlaces {
 public:
  explicit StoredPlaces(const StudyReader& file) {
    for (const char* table : {"items", "points", "zones", "tethers"})
      if (file.has(table)) rows_.emplace(table, file.rows_of_runs(table));
    for (const char* column :
         {"items/item", "points/item", "points/point", "zones/zone", "tethers/tether"})
      if (file.has_column(column)) names_.emplace(column, file.strings(column));
  }

  Places of_run(std::size_t run) const {
    Places places{names("items", "item", run),
                  names("zones", "zone", run),
                  names("tethers", "tether", run),
                  {}};
    const std::vector<std::string> items = names("points", "item", run),
                                   points = names("points", "point", run);
    for (std::size_t i = 0; i < points.size(); ++i) places.points.emplace_back(items[i], points[i]);
    return places;
  }

 private:
  std::vector<std::string> names(const std::string& table, const std::string& column,
                                 std::size_t run) const {
    const auto all = names_.find(table + "/" + column);
    if (all == names_.end()) return {};
    const auto [first, last] = rows_.at(table)[run];
    return {all->second.begin() + static_cast<std::ptrdiff_t>(first),
            all->second.begin() + static_cast<std::ptrdiff_t>(last)};
  }

  std::map<std::string, std::vector<std::pair<std::size_t, std::size_t>>> rows_;
  std::map<std::string, std::vector<std::string>> names_;
};

/// Places of each configuration that has a run which did not fail.
std::vector<std::pair<std::string, Places>> places_by_configuration(const StudyReader& file) {
  const StoredPlaces stored(file);
  const std::vector<std::string> names = file.strings("configurations/name"),
                                 outcomes = file.strings("runs/outcome");
  const std::vector<double> configurations = file.numbers("runs/configuration");
  std::map<std::size_t, Places> found;
  for (std::size_t run = 0; run < outcomes.size(); ++run) {
    const auto configuration = static_cast<std::size_t>(configurations[run]);
    if (!is_failure(outcomes[run]) && !found.contains(configuration))
      found.emplace(configuration, stored.of_run(run));
  }
  std::vector<std::pair<std::string, Places>> result;
  for (const auto& [configuration, places] : found)
    result.emplace_back(names[configuration], places);
  return result;
}

/// Each name of any configuration, once.
Places together(const std::vector<std::pair<std::string, Places>>& all) {
  Places places;
  const auto add = [](auto& to, const auto& from) {
    for (const auto& each : from)
      if (std::ranges::find(to, each) == to.end()) to.push_back(each);
  };
  for (const auto& [configuration, of] : all) {
    add(places.items, of.items);
    add(places.zones, of.zones);
    add(places.tethers, of.tethers);
    add(places.points, of.points);
  }
  return places;
}

void check_stored(const LimitState& state, const StudyReader& file) {
  if (!state.is_simple()) return;
  const std::string table = table_of(state.quantity.of);
  require(file.has(table), fmt::format("{} holds no /{}; {}", file.path(), table,
                                       "the job did not keep it, or has none"));
  require(file.has_column(table + "/" + state.quantity.column),
          fmt::format("{} holds no {}; /{} has {}", file.path(), state.quantity.column, table,
                      fmt::join(file.columns_of(table), ", ")));
}

void check(const LimitState& state, const StudyReader& file,
           const std::vector<std::pair<std::string, Places>>& all) {
  check_stored(state, file);
  for (const auto& [configuration, places] : all)
    check_names(state, places,
                file.path() + (configuration.empty() ? "" : ", configuration " + configuration));
}

void refuse_second_names(const std::vector<LimitState>& states) {
  for (std::size_t i = 0; i < states.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      require(states[i].name != states[j].name,
              fmt::format("two limit states have the name '{}'", states[i].name));
}

void take_limit_states(const StudyReader& file, const AssessmentRequest& request,
                       Assessment& assessment) {
  if (request.limit_states.empty() && request.limit_states_file.empty()) return;
  LimitStatesFile given;
  if (!request.limit_states_file.empty())
    given = read_limit_states_file(request.limit_states_file, assessment.limit_states);
  const auto places = places_by_configuration(file);
  const Places all = together(places);
  Diagnostics errors;
  const auto collect = [&](const std::string& where, const auto& work) {
    try {
      work();
    } catch (const Error& error) {
      errors.add_new(where + error.what());
    }
  };
  for (std::size_t i = 0; i < given.where.size(); ++i)
    collect(given.where[i] + ": limit_state[" + std::to_string(i) + "]: ",
            [&] { check(given.states[i], file, places); });
  for (const std::string& line : request.limit_states) {
    std::optional<LimitState> state;
    collect("", [&] { state = read_limit_state_expression(line, all); });
    if (!state) continue;
    collect(option_of(line) + ": ", [&] { check(*state, file, places); });
    given.states.push_back(*state);
  }
  errors.raise();
  refuse_second_names(given.states);
  assessment.limit_states = std::move(given.states);
  assessment.performance = std::move(given.performance);
}

}  // namespace

Assessment assessment_of(const StudyReader& file, const Study& job,
                         const AssessmentRequest& request) {
  Assessment assessment{job.limit_states, job.performance, {}};
  if (job.hazard)
    assessment.hazard = SiteHazard{*job.hazard, file.text_attribute("intensity_measure"), ""};
  take_limit_states(file, request, assessment);
  if (!request.hazard_file.empty()) assessment.hazard = read_hazard_file(request.hazard_file);
  return assessment;
}

}  // namespace gurney::study
