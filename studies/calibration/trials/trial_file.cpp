#include "studies/calibration/trials/trial_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <limits>

#include "engine/base/error.h"
#include "engine/base/files.h"
#include "engine/base/names.h"
#include "engine/base/number_text.h"
#include "engine/base/units.h"
#include "engine/config/nearest_name.h"
#include "engine/config/unit_limit.h"
#include "studies/calibration/trials/setup_reader.h"

namespace gurney::calibration {
namespace {

using config::Range;

constexpr const char* kTrialSchema = "gurney-trial/1";
constexpr const char* kAveragesSchema = "gurney-trial-averages/1";

struct Column {
  const char* name;
  std::vector<double> TrialSignals::*series;
  double unit;  ///< SI for one of the column's
};

const std::array<Column, 14>& columns() {
  using S = TrialSignals;
  static const std::array<Column, 14> table = {{
      {"time_s", &S::time, 1},
      {"time_ms", &S::time, 1e-3},
      {"force_n", &S::force, 1},
      {"force_kn", &S::force, 1e3},
      {"displacement_m", &S::displacement, 1},
      {"displacement_cm", &S::displacement, 1e-2},
      {"displacement_mm", &S::displacement, 1 / kMillimetersPerMeter},
      {"lateral_m", &S::lateral, 1},
      {"lateral_cm", &S::lateral, 1e-2},
      {"lateral_mm", &S::lateral, 1 / kMillimetersPerMeter},
      {"acceleration_mps2", &S::acceleration, 1},
      {"acceleration_g", &S::acceleration, kStandardGravity},
      {"yaw_deg", &S::yaw, kRadiansPerDegree},
      {"yaw_rad", &S::yaw, 1},
  }};
  return table;
}

std::vector<std::string> column_names() { return names_of(columns()); }

/// The columns of the header; nullptr for those that are unknown.
std::vector<const Column*> find_columns(const CsvText& text, CsvErrors& errors) {
  std::vector<const Column*> found;
  for (const TextCell& cell : text.header) {
    const auto column =
        std::ranges::find_if(columns(), [&](const Column& each) { return each.name == cell.text; });
    if (column == columns().end()) {
      errors.note(cell, fmt::format("{}: unknown column{}", cell.text,
                                    config::suggestion(cell.text, column_names())));
      found.push_back(nullptr);
      continue;
    }
    for (const Column* other : found)
      if (other != nullptr && other->series == column->series)
        errors.note(cell, fmt::format("{}: {} has it already", cell.text, other->name));
    found.push_back(&*column);
  }
  return found;
}

void require_columns(const Trial& trial, const CsvText& text, CsvErrors& errors) {
  const TrialSignals& s = trial.signals;
  const auto missing = [&](const char* names) {
    errors.note(text.header[0], std::string(names) + ": column missing");
  };
  if (s.time.empty()) missing("time_s or time_ms");
  if (s.force.empty() && trial.kind != TrialKind::kImpact) missing("force_n or force_kn");
  const bool acceleration = trial.kind == TrialKind::kPull && !s.acceleration.empty();
  if (s.displacement.empty() && !acceleration)
    missing(trial.kind == TrialKind::kPull ? "displacement_mm (_cm, _m) or acceleration_mps2 (_g)"
                                           : "displacement_mm (_cm, _m)");
}

void read_samples(const CsvText& text, Trial& trial, CsvErrors& errors) {
  if (text.header.size() == 1 && text.header[0].text.find(';') != std::string::npos) {
    errors.note(text.header[0],
                "cells are apart by semicolons; must be apart by commas, with decimal points");
    return;
  }
  const std::vector<const Column*> found = find_columns(text, errors);
  for (const std::vector<TextCell>& row : text.rows) {
    trial.lines.push_back(row[0].line);
    for (std::size_t i = 0; i < found.size(); ++i) {
      if (found[i] == nullptr) continue;
      const std::optional<double> value = number(row[i].text);
      if (!value && !row[i].text.empty())
        errors.note(row[i], not_a_number(found[i]->name, row[i].text));
      if (const std::string allowed =
              config::beyond_unit(found[i]->name, Range::any(), value.value_or(0));
          !allowed.empty())
        errors.note(row[i],
                    fmt::format("{} = {}: must be {}", found[i]->name, row[i].text, allowed));
      (trial.signals.*(found[i]->series))
          .push_back(value ? *value * found[i]->unit : std::numeric_limits<double>::quiet_NaN());
    }
  }
  if (text.rows.empty())
    errors.note(text.header[0], "no samples below the names of the columns");
  else
    require_columns(trial, text, errors);
}

void note_unknown(const TextCell& cell, const char* what, std::vector<std::string> known,
                  CsvErrors& errors) {
  if (std::ranges::find(known, cell.text) != known.end()) return;
  errors.note(
      cell, fmt::format("{}: unknown {}{}", cell.text, what, config::suggestion(cell.text, known)));
}

void note_unknown_facts(const CsvText& text, std::vector<std::string> known, CsvErrors& errors) {
  known.push_back("note");
  for (const CsvFact& fact : text.facts) note_unknown(fact.key, "key", known, errors);
}

TrialAverages read_average(Facts& facts, const TrialSet& before) {
  TrialAverages average;
  average.name = facts.text("trial");
  for (const TrialAverages& other : before.averages)
    if (other.name == average.name && !average.name.empty())
      facts.errors().note(facts.at("trial"),
                          fmt::format("trial = \"{}\": line {} has it already; each row must be a "
                                      "trial of its own",
                                      average.name, other.line));
  average.setup = read_setup(facts, TrialKind::kPull);
  average.pull_force = facts.number("pull_force_n", Range::positive());
  average.pull_acceleration = facts.number("a2_mps2", Range::positive());
  average.coast_deceleration = facts.number("a3_mps2", Range::positive());
  average.pull_speed = average.coast_speed = facts.number("speed_mps", Range::not_negative(), 0.0);
  return average;
}

void read_averages(const CsvText& text, TrialSet& set, CsvErrors& errors) {
  std::vector<std::string> known;
  for (const std::vector<TextCell>& row : text.rows) {
    Facts facts(errors, row[0]);
    for (const CsvFact& fact : text.facts) facts.add(fact.key.text, fact.value);
    for (std::size_t i = 0; i < row.size(); ++i) facts.add(text.header[i].text, row[i]);
    facts.text("schema");
    set.averages.push_back(read_average(facts, set));
    set.averages.back().file = text.file;
    set.averages.back().line = row[0].line;
    known = facts.asked();
  }
  if (text.rows.empty()) {
    errors.note(text.header[0], "no trials below the names of the columns");
    return;
  }
  note_unknown_facts(text, known, errors);
  for (const TextCell& cell : text.header) note_unknown(cell, "column", known, errors);
}

void read_trial(const CsvText& text, TrialSet& set, CsvErrors& errors) {
  Facts facts(errors, {"", 1, 1});
  for (const CsvFact& fact : text.facts) facts.add(fact.key.text, fact.value);
  facts.text("schema");
  Trial trial;
  trial.file = text.file;
  trial.name = std::filesystem::path(text.file).stem().string();
  trial.kind = static_cast<TrialKind>(facts.choice("kind", names_of_kinds()));
  trial.setup = read_setup(facts, trial.kind);
  note_unknown_facts(text, facts.asked(), errors);
  read_samples(text, trial, errors);
  set.trials.push_back(std::move(trial));
}

std::string key(const char* name, const std::string& value) {
  return value.empty() ? "" : fmt::format("# {} = {}\n", name, value);
}

std::string key(const char* name, double value) {
  return value == 0 ? "" : fmt::format("# {} = {:.10g}\n", name, value);
}

std::string key(const char* name, const std::vector<double>& values, double unit) {
  std::string text;
  for (const double value : values) text += fmt::format(" {:.10g}", value / unit);
  return text.empty() ? "" : fmt::format("# {} ={}\n", name, text);
}

std::string setup_text(const TrialSetup& setup) {
  const double mm = 1 / kMillimetersPerMeter;
  return key("use", names_of_uses()[static_cast<std::size_t>(setup.use)]) +
         key("origin", names_of_origins()[static_cast<std::size_t>(setup.origin)]) +
         key("caster", setup.caster) + key("floor", setup.floor) + key("tread", setup.tread) +
         key("against", setup.against) + key("wheels", setup.wheels) +
         key("wheel_diameter_mm", 2 * setup.wheel_radius / mm) + key("mass_kg", setup.mass) +
         key("payload_kg", setup.payload) +
         fmt::format("# added_mass_kg = {:.10g}\n", setup.added_mass) +
         key("drop_mass_kg", setup.drop_mass.value_or(0)) +
         key("string_tension_n", setup.string_tension) +
         key("headings_deg", setup.headings, kRadiansPerDegree) + key("item", setup.item) +
         (setup.payload_count > 0
              ? key("payload_name", setup.payload_name) + key("payload_count", setup.payload_count)
              : "") +
         key("pull_point_mm", setup.pull_point, mm) +
         (setup.locked == LockedWheels::kAll
              ? ""
              : key("locked", names_of_locked()[static_cast<std::size_t>(setup.locked)]) +
                    fmt::format("# pull_height_mm = {:.10g}\n", setup.pull_height / mm) +
                    key("wheelbase_mm", setup.wheelbase / mm) +
                    key("front_share", setup.front_share) +
                    fmt::format("# rolling_ratio = {:.10g}\n", setup.rolling_ratio) +
                    key("center_of_mass_height_mm", setup.center_height.value_or(0) / mm));
}

struct WrittenColumn {
  const char* name;
  const std::vector<double>* series;
  double unit;
  int digits;
};

}  // namespace

TrialSet read_trial_file(const std::string& file) {
  CsvErrors errors(file);
  const CsvText text = read_csv_text(file, errors);
  Facts facts(errors, {"", 1, 1});
  for (const CsvFact& fact : text.facts) facts.add(fact.key.text, fact.value);
  TrialSet set;
  const std::size_t before = errors.count();
  const std::size_t schema = facts.choice("schema", {kTrialSchema, kAveragesSchema});
  if (errors.count() == before) (schema == 0 ? read_trial : read_averages)(text, set, errors);
  errors.finish();
  return set;
}

TrialSet read_trials(const std::string& path) {
  if (!is_folder(path)) return read_trial_file(path);
  std::vector<std::string> files;
  for (const auto& entry : std::filesystem::directory_iterator(path))
    if (entry.is_regular_file() && entry.path().extension() == ".csv")
      files.push_back(entry.path().string());
  require(!files.empty(), path + ": has no .csv file of a trial");
  std::ranges::sort(files);
  TrialSet all;
  std::string errors;
  for (const std::string& file : files) {
    try {
      TrialSet set = read_trial_file(file);
      std::ranges::move(set.trials, std::back_inserter(all.trials));
      std::ranges::move(set.averages, std::back_inserter(all.averages));
    } catch (const Error& error) {
      errors += (errors.empty() ? "" : "\n") + std::string(error.what());
    }
  }
  require(errors.empty(), errors);
  return all;
}

std::string trial_file_text(const Trial& trial, const std::string& note) {
  std::string text = "# schema = gurney-trial/1\n";
  text += key("note", note);
  text += key("kind", names_of_kinds()[static_cast<std::size_t>(trial.kind)]);
  text += setup_text(trial.setup);
  const TrialSignals& s = trial.signals;
  const std::array<WrittenColumn, 6> all = {
      {{"time_s", &s.time, 1, 6},
       {"force_n", &s.force, 1, 3},
       {"displacement_mm", &s.displacement, 1 / kMillimetersPerMeter, 4},
       {"lateral_mm", &s.lateral, 1 / kMillimetersPerMeter, 4},
       {"acceleration_mps2", &s.acceleration, 1, 5},
       {"yaw_deg", &s.yaw, kRadiansPerDegree, 4}}};
  std::string header;
  for (const WrittenColumn& column : all)
    if (!column.series->empty())
      header += fmt::format("{}{}", header.empty() ? "" : ",", column.name);
  text += header + "\n";
  for (std::size_t i = 0; i < s.time.size(); ++i) {
    std::string row;
    for (const WrittenColumn& column : all) {
      if (column.series->empty()) continue;
      const double value = (*column.series)[i] / column.unit;
      row += row.empty() ? "" : ",";
      if (std::isfinite(value)) row += fmt::format("{:.{}f}", value, column.digits);
    }
    text += row + "\n";
  }
  return text;
}

}  // namespace gurney::calibration
