#include "studies/plan/study.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <sstream>
#include <tuple>

#include "engine/base/error.h"
#include "engine/base/names.h"
#include "engine/base/units.h"
#include "engine/config/nearest_name.h"
#include "studies/job/scale_reader.h"
#include "studies/limit_states/limit_state_reader.h"
#include "studies/plan/study_job.h"

namespace gurney::study {

using config::Range;

std::optional<statistics::HazardCurve> read_hazard(config::Table& in,
                                                   const IntensityPlan& intensity) {
  if (intensity.kind == IntensityPlan::Kind::kScales)
    in.note("im", ": a hazard needs study.intensity with a measure, in whose unit it is stated");
  const double unit = intensity.unit_in_si;
  if (in.has("im") == in.has("k0")) {
    in.note("im", ": must be given with rate_per_year, or k0 with k, not both");
    for (const char* key : {"im", "rate_per_year", "k0", "k"}) in.has(key);
    return {};
  }
  if (in.has("k0")) {
    const double k0 = in.number("k0", Range::positive()), k = in.number("k", Range::positive());
    return statistics::HazardCurve::power_law(k0 * std::pow(unit, k), k);
  }
  const std::size_t errors = in.document().errors();
  std::vector<double> im = in.numbers("im", Range::positive());
  if (in.is_array("im") && im.size() < 2) in.note("im", ": must have 2 or more values");
  if (in.document().errors() > errors) {
    in.has("rate_per_year");
    return {};
  }
  const std::vector<double> rate = in.numbers("rate_per_year", Range::positive(), im.size());
  for (std::size_t i = 1; in.document().errors() == errors && i < im.size(); ++i) {
    if (!(im[i] > im[i - 1]))
      in.note_element("im", i,
                      fmt::format(": must be more than the value before it, {:g}", im[i - 1]));
    if (!(rate[i] < rate[i - 1]))
      in.note_element("rate_per_year", i,
                      fmt::format(": must be less than the value before it, {:g}", rate[i - 1]));
  }
  if (in.document().errors() > errors) return {};
  for (double& value : im) value *= unit;
  return statistics::HazardCurve::table(im, rate);
}

namespace {

using config::Node;
using config::Range;
using config::Table;

constexpr int kMax = std::numeric_limits<int>::max();
constexpr int kMaxReplicas = 10000;  // the last is still within 1e-5 of the item

/// Positive numbers in an array, each more than the one before it.
std::vector<double> increasing(Table& in, const std::string& key,
                               const std::optional<std::vector<double>>& fallback) {
  const std::size_t errors = in.document().errors();
  const std::vector<double> values = in.numbers(key, Range::positive(), {}, fallback);
  if (in.document().errors() > errors || !in.is_array(key)) return values;
  if (values.empty()) in.note(key, " = []: must have 1 or more values");
  for (std::size_t i = 1; i < values.size(); ++i)
    if (!(values[i] > values[i - 1])) {
      in.note(key, fmt::format("[{}] = {:g}: must be more than the value before it, {:g}", i,
                               values[i], values[i - 1]));
      break;
    }
  return values;
}

/// The patch that sets one dotted key, such as `item.brakes` or `item.bed.variant`.
/// @param stated  where the key stands
Node patch_of(const std::string& key, const config::Place& stated, const Node& value) {
  Node patch;
  patch.place = value.place;
  const auto dot = key.find('.');
  Node element = dot == std::string::npos ? value : patch_of(key.substr(dot + 1), stated, value);
  element.key = key.substr(0, dot);
  element.key_place = stated;
  patch.elements.push_back(std::move(element));
  return patch;
}

std::string label_of(const Node& value) {
  return value.kind == Node::Kind::kText ? value.text : config::describe(value);
}

/// In the order of the file; a tree has tables in the order of their keys.
std::vector<const Node*> by_place(const Node& table) {
  std::vector<const Node*> elements;
  for (const Node& each : table.elements) elements.push_back(&each);
  std::ranges::stable_sort(elements, {}, [](const Node* node) {
    return std::tuple(node->key_place.line, node->key_place.column);
  });
  return elements;
}

void mark_read(const Node& node) {
  node.read = true;
  for (const Node& each : node.elements) {
    if (node.kind == Node::Kind::kTable) node.asked.insert(each.key);
    mark_read(each);
  }
}

/// The dotted keys that a level sets, with their values.
std::map<std::string, std::string> entries_of(const FactorLevel& level) {
  std::map<std::string, std::string> entries;
  flatten(level.patch, "", entries);
  return entries;
}

/// Notes levels that are one another's copy, and keys that change no run.
/// @param factor  loses levels that set a key of the study, which no job of a run has
void note_idle_levels(Table& in, const std::string& key, Factor& factor) {
  std::map<std::map<std::string, std::string>, std::string> seen;
  for (const FactorLevel& level : factor.levels) {
    const auto entries = entries_of(level);
    if (const auto [same, is_new] = seen.emplace(entries, level.name); !is_new)
      in.note(key, ": the levels '" + same->second + "' and '" + level.name + "' are the same");
    if (entries.contains("title"))
      in.note(key, ": sets the title, which changes no run; a level has a name of its own");
    const auto of_study = entries.lower_bound("study.");
    if (of_study == entries.end() || !of_study->first.starts_with("study.")) continue;
    in.note(key, ": sets " + of_study->first + ", which is of the whole study");
    factor.levels.clear();
    return;
  }
}

/// `key` and `values`, or `level` with a table for each.
Factor read_factor(Table in, const Node& node, std::size_t index) {
  Factor factor;
  factor.name = in.text("name", fmt::format("factor {}", index + 1));
  if (in.has("level") == in.has("values")) {
    in.note("level", ": must be given, tables [study.factor.level.NAME], or key and values");
    return factor;
  }
  if (const Node* levels = node.find("level")) {
    if (!in.table("level")) return factor;
    for (const Node* level : by_place(*levels)) {
      if (level->kind == Node::Kind::kTable)
        factor.levels.push_back({level->key, *level});
      else
        in.note("level", fmt::format(".{} = {}: must be a table", level->key, describe(*level)));
    }
    mark_read(*levels);
  } else {
    const std::string key = in.text("key");
    if (in.has("key") && key.empty()) in.note("key", " = \"\": must name a key of the job");
    const Node* values = node.find("values");
    if (!in.is_array("values") || values->elements.empty())
      in.note("values", " = " + describe(*values) + ": must be an array of 1 or more values");
    else if (!key.empty())
      for (const Node& value : values->elements)
        factor.levels.push_back({label_of(value), patch_of(key, node.find("key")->place, value)});
    mark_read(*values);
  }
  const std::string stated = in.has("level") ? "level" : "values";
  const std::size_t errors = in.document().errors();
  std::set<std::string> names;
  for (const FactorLevel& level : factor.levels)
    if (!names.insert(level.name).second)
      in.note(stated, ": two levels are named '" + level.name + "'");
  if (in.document().errors() == errors) note_idle_levels(in, stated, factor);
  return factor;
}

/// Whether setting one of two dotted keys sets the other as well, or a part of it. `*` is any name.
bool overlap(const std::string& one, const std::string& other) {
  std::istringstream first(one), second(other);
  for (std::string a, b; std::getline(first, a, '.') && std::getline(second, b, '.');)
    if (a != b && a != "*" && b != "*") return false;
  return true;
}

/// A key that both factors set, of the second; empty: none.
std::string shared_key(const Factor& first, const Factor& second) {
  for (const FactorLevel& of_first : first.levels)
    for (const auto& [key, value] : entries_of(of_first))
      for (const FactorLevel& of_second : second.levels)
        for (const auto& [other, other_value] : entries_of(of_second))
          if (overlap(key, other)) return other;
  return {};
}

/// Notes each factor that sets a key of one before it, whose level would not be what its name says.
void note_shared_keys(std::vector<Table>& tables, const std::vector<Factor>& factors) {
  for (std::size_t i = 1; i < factors.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (const std::string key = shared_key(factors[j], factors[i]); !key.empty())
        tables[i].note(tables[i].has("level") ? "level" : "key",
                       ": sets '" + key + "', as the factor '" + factors[j].name +
                           "' does; must not set a key of another factor, or a part of it");
}

void read_factors(Table& in, const Node& node, Study& study) {
  std::vector<Table> tables = in.tables("factor");
  std::set<std::string> names;
  for (std::size_t i = 0; i < tables.size(); ++i) {
    study.factors.push_back(read_factor(tables[i], node.find("factor")->elements[i], i));
    const std::string& name = study.factors.back().name;
    if (!names.insert(name).second)
      tables[i].note("name", " = \"" + name + "\": two factors have this name");
    static const std::set<std::string> kTaken = {"", ".", "name", "row"};
    if (kTaken.contains(name) || name.find('/') != std::string::npos)
      tables[i].note("name", " = \"" + name +
                                 "\": names a column of the results: must not be empty, '.', "
                                 "'name' or 'row', or have a '/'");
  }
  note_shared_keys(tables, study.factors);
}

/// One row: a level of each factor; empty with an error.
std::vector<std::size_t> read_combination(Table& in, const Node& row, std::size_t index,
                                          const std::vector<Factor>& factors) {
  const std::string at = fmt::format("combinations[{}] = ", index);
  if (row.kind != Node::Kind::kArray || row.elements.size() != factors.size()) {
    in.document().note(row.place, fmt::format("study.{}{}: must name a level of each of the {} "
                                              "factors, in their order",
                                              at, describe(row), factors.size()));
    return {};
  }
  std::vector<std::size_t> levels;
  for (std::size_t i = 0; i < factors.size(); ++i) {
    const std::vector<std::string> names = names_of(factors[i].levels);
    const std::string label = label_of(row.elements[i]);
    const auto found = std::ranges::find(names, label);
    if (found == names.end())
      in.document().note(row.elements[i].place,
                         fmt::format("study.combinations[{}][{}] = {}: no level of factor '{}'{}",
                                     index, i, describe(row.elements[i]), factors[i].name,
                                     config::suggestion(label, names)));
    else
      levels.push_back(static_cast<std::size_t>(found - names.begin()));
  }
  return levels.size() == factors.size() ? levels : std::vector<std::size_t>();
}

void read_combinations(Table& in, const Node& node, Study& study) {
  if (!in.has("combinations")) return;
  const Node& rows = *node.find("combinations");
  mark_read(rows);
  if (!in.is_array("combinations") || rows.elements.empty() || study.factors.empty()) {
    in.note("combinations", " = " + describe(rows) +
                                ": must be an array of 1 or more rows of levels, and needs "
                                "[[study.factor]]");
    return;
  }
  std::set<std::vector<std::size_t>> seen;
  for (std::size_t i = 0; i < rows.elements.size(); ++i) {
    std::vector<std::size_t> levels = read_combination(in, rows.elements[i], i, study.factors);
    if (levels.empty()) continue;
    if (!seen.insert(levels).second)
      in.document().note(rows.elements[i].place,
                         fmt::format("study.combinations[{}] = {}: is there twice", i,
                                     describe(rows.elements[i])));
    study.combinations.push_back(std::move(levels));
  }
}

void read_ida(Table ida, const std::vector<LimitState>& states, IntensityPlan& plan) {
  plan.kind = IntensityPlan::Kind::kIda;
  plan.first = ida.number("first", Range::positive()) * plan.unit_in_si;
  plan.increment = ida.number("increment", Range::positive()) * plan.unit_in_si;
  plan.most_runs = ida.integer("most_runs", 3, 1000, 12);
  plan.resolution = ida.number("resolution", Range::within(0, 10).open_below(), 0.1);
  plan.fill = ida.integer("fill", 0, 1000, 0);
  plan.until = ida.choice("until", names_of(states));
}

void read_adaptive(Table adaptive, const std::vector<LimitState>& states, IntensityPlan& plan) {
  plan.more_stages = adaptive.integer("stages", 1, 100);
  plan.until = adaptive.choice("limit_state", names_of(states));
}

IntensityPlan read_intensity(Table in, const std::vector<LimitState>& states) {
  IntensityPlan plan;
  if (!in.has("measure")) {
    plan.levels = increasing(in, "scales", plan.levels);
    std::vector<std::string> unclear;
    for (const char* const key : {"levels", "ida", "adaptive", "component", "unit"})
      if (in.has(key)) unclear.push_back(key), in.set_aside(key);
    if (!unclear.empty())
      in.note("measure", fmt::format(": missing; needed for {}", fmt::join(unclear, ", ")));
    plan.vertical = read_vertical_scaling(in);
    return plan;
  }
  const ScalingTarget target = read_scaling_target(in);
  plan.measure = target.measure;
  plan.combination = target.combination;
  plan.unit = target.unit;
  plan.unit_in_si = target.unit_in_si;
  plan.vertical = read_vertical_scaling(in);
  if (in.has("scales"))
    in.note("scales", ": must go without a measure, which has levels or an IDA");
  if (in.has("levels") == in.has("ida"))
    in.note("levels", ": must be given, or a table ida, not both");
  if (in.has("adaptive") && in.has("ida"))
    in.note("adaptive", ": must not be combined with an IDA, which finds its own levels");
  if (auto adaptive = in.table("adaptive")) read_adaptive(*adaptive, states, plan);
  if (auto ida = in.table("ida")) {
    read_ida(*ida, states, plan);
    return plan;
  }
  plan.kind = IntensityPlan::Kind::kStripes;
  if (!in.has("levels")) return plan;
  plan.levels = increasing(in, "levels", {});
  for (double& level : plan.levels) level *= plan.unit_in_si;
  return plan;
}

/// "Sa(1.0) RotD50": the measure, and how the horizontals become one number.
std::optional<KeptMeasure> parse_kept(const std::string& text) {
  const auto blank = text.rfind(' ');
  KeptMeasure kept;
  if (blank != std::string::npos && text.find(')', blank) == std::string::npos) {
    kept.combination = groundmotions::parse_combination(text.substr(blank + 1));
    kept.measure = groundmotions::parse_measure(text.substr(0, blank));
  } else {
    kept.measure = groundmotions::parse_measure(text);
  }
  require(kept.combination != groundmotions::Combination::kResultant ||
              groundmotions::has_resultant(kept.measure),
          name_of(kept.measure) + " has no resultant; PGA, PGV and PGD have");
  return kept;
}

void read_measures(Table& in, Study& study) {
  const bool given = in.has("measures");
  std::set<std::string> names;
  for (const std::string& text :
       given ? in.texts("measures")
             : std::vector<std::string>{"PGA", "PGV", "PGD", "Sa(0.5)", "Sa(1.0)", "Sa(2.0)",
                                        "FIV3(1.0)"}) {
    try {
      const KeptMeasure kept = *parse_kept(text);
      const std::string name = name_of(kept.measure) + " " + name_of(kept.combination);
      if (!names.insert(name).second) in.note("measures", ": " + name + " is there twice");
      study.measures.push_back(kept);
    } catch (const Error& error) {
      in.note("measures", " = \"" + text + "\": " + error.what());
    }
  }
}

/// [rad]
std::vector<double> read_angles(Table& in) {
  std::vector<double> angles = in.numbers("angles_deg", Range::any());
  if (in.is_array("angles_deg") && angles.empty())
    in.note("angles_deg", " = []: must have 1 or more values");
  std::map<double, std::size_t> seen;  // by direction
  for (std::size_t i = 0; i < angles.size(); ++i) {
    const double turns = angles[i] / 360;
    // Decimal angles of up to a million degrees are those of others to 1e-9.
    const auto [same, is_new] =
        seen.emplace(std::round((turns - std::floor(turns)) * 360e9) / 1e9, i);
    if (!is_new)
      in.note_element("angles_deg", i,
                      fmt::format(": is the direction of angles_deg[{}] = {:g} again", same->second,
                                  angles[same->second]));
  }
  for (double& angle : angles) angle *= kRadiansPerDegree;
  return angles;
}

OutputOptions read_keep(Table in) {
  OutputOptions keep;
  keep.histories = static_cast<Histories>(
      in.choice("histories", {"none", "failed", "overturned", "all"}, std::size_t{0}));
  keep.events = in.boolean("events", keep.events);
  keep.zones = in.boolean("zones", keep.zones);
  keep.tethers = in.boolean("tethers", keep.tethers);
  keep.wheels = in.boolean("wheels", keep.wheels);
  keep.energy = in.boolean("energy", keep.energy);
  return keep;
}

}  // namespace

Study read_study(Table& in, const Node& node) {
  Study study;
  read_factors(in, node, study);
  read_combinations(in, node, study);
  if (in.has("angles_deg")) study.angles = read_angles(in);
  if (in.has("synthetic_records"))
    study.synthetic_records = in.integer("synthetic_records", 1, 10000);
  study.limit_states = read_limit_states(in);
  if (auto table = in.table("intensity"))
    study.intensity = read_intensity(*table, study.limit_states);
  if (auto table = in.table("hazard")) study.hazard = read_hazard(*table, study.intensity);
  study.performance = read_performance(in, study.limit_states);
  study.seed = static_cast<std::uint64_t>(in.integer("seed", 0, kMax, 1));
  if (in.has("draws")) study.draws = in.integer("draws", 1, kMax);
  static const std::vector<std::string> kSamplings = {"monte-carlo", "latin-hypercube", "sobol",
                                                      "saltelli"};
  if (in.has("sampling")) {
    study.sampling = static_cast<Sampling>(in.choice("sampling", kSamplings));
    if (!in.has("draws")) in.note("sampling", ": must go with draws");
    if (study.sampling == Sampling::kSaltelli && study.intensity.kind == IntensityPlan::Kind::kIda)
      in.note("sampling",
              " = \"saltelli\": must not go with intensity.ida, whose intensities "
              "differ from draw to draw; state levels");
  }
  study.replicas = in.integer("replicas", 1, kMaxReplicas, 1);
  if (study.replicas > 1 && study.sampling == Sampling::kSaltelli)
    in.note("replicas",
            ": must not go with sampling = \"saltelli\", whose rows are compared one by one");
  read_measures(in, study);
  if (auto table = in.table("keep")) study.keep = read_keep(*table);
  study.step_check = in.number("step_check", Range::within(0, 1), 0.0);
  return study;
}

}  // namespace gurney::study
