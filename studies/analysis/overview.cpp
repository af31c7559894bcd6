#include "studies/analysis/overview.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <set>
#include <sstream>
#include <string_view>
#include <tuple>

#include "engine/base/error.h"
#include "engine/base/printable.h"
#include "engine/base/shell_word.h"
#include "engine/response/response.h"
#include "studies/analysis/demand_runs.h"
#include "studies/results/hdf5_reader.h"

namespace gurney::study {
namespace {

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

FileOverview header_of(const Hdf5Reader& file, const std::string& path) {
  FileOverview header;
  header.path = printable(path);
  header.title = file.text_attribute("title");
  header.program_version = file.text_attribute("program_version");
  header.git_commit = file.text_attribute("git_commit");
  header.compiler = file.text_attribute("compiler");
  header.cpu_class = file.text_attribute("cpu_class");
  header.job_name = file.text_attribute("job_name");
  header.job_sha256 = file.text_attribute("job_sha256");
  header.seed = file.text_attribute("seed");
  std::set<std::tuple<std::string, std::string, std::string>> known;
  const auto texts = [&](const char* name) {
    return file.strings(std::string("/assumptions/") + name);
  };
  const auto keys = texts("key"), values = texts("value"), ranges = texts("range"),
             reasons = texts("reason"), files = texts("file");
  file.require_length(
      {"/assumptions/value", "/assumptions/range", "/assumptions/reason", "/assumptions/file"},
      keys.size());
  for (std::size_t i = 0; i < keys.size(); ++i)
    if (known.emplace(keys[i], values[i], files[i]).second)
      header.assumptions.push_back({keys[i], values[i], ranges[i], reasons[i], files[i]});
  return header;
}

std::vector<WarningKind> by_kind(const std::vector<double>& runs,
                                 const std::vector<std::string>& warnings) {
  std::vector<WarningKind> kinds;
  const auto beginning = [](const std::string& text) {
    return std::string_view(text).substr(0, text.find_first_of("0123456789"));
  };
  for (std::size_t i = 0; i < warnings.size(); ++i) {
    auto kind = std::ranges::find(kinds, beginning(warnings[i]),
                                  [&](const WarningKind& known) { return beginning(known.first); });
    if (kind == kinds.end()) kind = kinds.insert(kind, {{}, warnings[i]});
    kind->runs.insert(static_cast<std::size_t>(runs.at(i)));
  }
  return kinds;
}

/// Files of programs before 2026-11-22 do not state what was drawn.
std::optional<UndrawnRanges> undrawn_of(const StudyReader& file) {
  if (!file.has_column("assumptions/drawn")) return {};
  const auto keys = file.strings("assumptions/key"), ranges = file.strings("assumptions/range"),
             files = file.strings("assumptions/file"), drawn = file.strings("assumptions/drawn");
  UndrawnRanges undrawn;
  for (std::size_t i = 0; i < keys.size(); ++i)
    if (drawn[i] == "no" && !ranges[i].empty()) undrawn.add(files[i], keys[i]);
  return undrawn;
}

void add_motions(const StudyReader& file, FileOverview& header) {
  const auto names = file.strings("records/name"), files = file.strings("records/files"),
             warnings = file.strings("records/warnings");
  std::set<std::string> known;
  for (std::size_t i = 0; i < names.size(); ++i)
    if (!names[i].empty() && known.insert(names[i] + '\n' + files[i]).second)
      header.motions.push_back({names[i], lines_of(files[i]), lines_of(warnings[i])});
}

void add_failures(const StudyReader& file, StudyOverview& overview) {
  const std::vector<double> runs = file.numbers("failures/run");
  const std::vector<std::string> causes = file.strings("failures/cause");
  for (std::size_t i = 0; i < runs.size(); ++i) {
    const auto run = static_cast<std::size_t>(runs[i]);
    overview.failures.push_back(
        {run, causes[i], fmt::format("gurney replay {} {}", shell_word(file.path()), run)});
  }
}

void add_counts(const StudyData& data, StudyOverview& overview) {
  const RunLevels levels = run_levels(data);
  overview.levels = levels.texts;
  overview.suite_by_level = data.has_suites_by_level();
  const std::size_t states = data.limit_states().size();
  for (const std::string& configuration : data.configurations())
    for (const std::string& level : levels.texts)
      overview.counts.push_back(
          {configuration, level, 0, 0, 0, std::vector<std::size_t>(states, 0)});
  const auto counts_of = [&](std::size_t configuration, std::size_t run) -> LevelCounts& {
    return overview.counts[configuration * levels.texts.size() + levels.of_run[run]];
  };
  const std::vector<double> configuration = data.file().numbers("runs/configuration");
  const std::vector<std::string> outcome = data.file().strings("runs/outcome");
  for (std::size_t run = 0; run < outcome.size(); ++run) {
    LevelCounts& counts = counts_of(static_cast<std::size_t>(configuration[run]), run);
    const bool overturned = outcome[run] == name_of(Outcome::kOverturned);
    const bool failed = is_failure(outcome[run]);
    overview.untrusted += outcome[run] == name_of(Outcome::kUntrusted);
    ++counts.runs;
    counts.overturned += overturned;
    counts.failed += failed;
    overview.overturned += overturned;
    overview.failed += failed;
  }
  if (data.file().has("warnings")) {
    const std::vector<double> warned = data.file().numbers("warnings/run");
    overview.warned = std::set<double>(warned.begin(), warned.end()).size();
    overview.warnings = by_kind(warned, data.file().strings("warnings/warning"));
  }
  for (std::size_t i = 0; i < data.configurations().size(); ++i)
    for (std::size_t state = 0; state < states; ++state) {
      const std::vector<std::size_t>& runs = data.runs_of(i);
      const std::vector<bool> exceeds = data.exceedances(state, runs);
      for (std::size_t k = 0; k < runs.size(); ++k)
        counts_of(i, runs[k]).exceeded[state] += exceeds[k];
    }
}

void add_energy(const StudyReader& file, StudyOverview& overview) {
  const std::vector<double> closure = file.numbers("runs/energy_closure");
  const std::vector<std::string> outcome = file.strings("runs/outcome");
  double& worst = overview.file.energy_closure;
  worst = std::numeric_limits<double>::quiet_NaN();
  for (std::size_t run = 0; run < closure.size(); ++run) {
    const bool more = std::isnan(worst) || closure[run] > worst;
    if (is_failure(outcome[run]) || !more) continue;
    worst = closure[run];
    overview.energy_closure_run = run;
  }
}

std::string type_of(const Hdf5Reader& file, const std::string& path) {
  const std::string type = file.text_attribute("filetype");
  require(type == "gurney-study" || type == "gurney-results",
          path + ": is not a results file of gurney" + (type.empty() ? "" : " but '" + type + "'"));
  return type;
}

}  // namespace

bool is_study_file(const std::string& path) {
  return type_of(Hdf5Reader(path), path) == "gurney-study";
}

StudyOverview study_overview(const std::string& path, const AssessmentRequest& request,
                             const UnitSystem& units) {
  const StudyData data(path, request, {}, units);
  const Study& study = data.study();
  StudyOverview overview;
  overview.file = header_of(Hdf5Reader(path), path);
  add_motions(data.file(), overview.file);
  for (const Factor& factor : study.factors) {
    overview.factors.push_back({factor.name, {}});
    for (const FactorLevel& level : factor.levels)
      overview.factors.back().levels.push_back(level.name);
  }
  overview.configurations = data.configurations();
  overview.units = units;
  overview.angles = study.angles;
  overview.measure = data.file().text_attribute("intensity_measure");
  overview.draws = study.draws;
  overview.replicas = study.replicas;
  overview.undrawn = undrawn_of(data.file());
  overview.missing_demands = data.file().missing_demands();
  overview.states = data.limit_states();
  overview.runs = data.file().runs();
  add_counts(data, overview);
  add_failures(data.file(), overview);
  add_energy(data.file(), overview);
  overview.factors_on_records = scale_factors(data);
  overview.step_check = step_check(data);
  return overview;
}

RunOverview run_overview(const std::string& path) {
  const Hdf5Reader file(path);
  require(type_of(file, path) == "gurney-results", path + ": is the results file of a study");
  RunOverview overview;
  overview.file = header_of(file, path);
  file.require_length({"/runs/record", "/runs/outcome", "/runs/cause", "/runs/end_time",
                       "/verification/energy_closure"},
                      1);
  const std::string record = file.strings("/runs/record").at(0);
  if (!record.empty()) {
    FileOverview::Motion motion{record, {}, {}};
    const auto names = file.text_attributes("record_files"),
               hashes = file.text_attributes("record_sha256");
    require(names.size() == hashes.size(),
            path + ": attributes record_files and record_sha256 differ in length");
    for (std::size_t i = 0; i < names.size(); ++i)
      motion.files.push_back(hashes.at(i) + " " + names[i]);
    overview.file.motions.push_back(motion);
  }
  overview.file.warnings = file.text_attributes("warnings");
  overview.file.energy_closure = file.numbers("/verification/energy_closure").at(0);
  overview.outcome = file.strings("/runs/outcome").at(0);
  overview.cause = file.strings("/runs/cause").at(0);
  overview.end_time = file.numbers("/runs/end_time").at(0);
  const auto items = file.strings("/items/item"), models = file.strings("/items/model");
  const auto numbers = [&](const char* name) {
    return file.numbers(std::string("/items/") + name);
  };
  const auto peaks = numbers("peak_displacement"), residuals = numbers("residual_displacement"),
             velocities = numbers("peak_velocity"), tilts = numbers("peak_tilt"),
             times = numbers("time_of_overturning");
  file.require_length({"/items/model", "/items/peak_displacement", "/items/residual_displacement",
                       "/items/peak_velocity", "/items/peak_tilt", "/items/time_of_overturning"},
                      items.size());
  for (std::size_t i = 0; i < items.size(); ++i)
    overview.items.push_back(
        {items[i], models[i], peaks[i], residuals[i], velocities[i], tilts[i], times[i]});
  return overview;
}

}  // namespace gurney::study
