#include <fmt/format.h>

#include "engine/base/append_all.h"
#include "engine/base/error.h"
#include "engine/base/parallel.h"
#include "engine/base/printable.h"
#include "engine/base/units.h"
#include "engine/run/rest.h"
#include "equipment/catalogue/check_file.h"
#include "studies/cli/commands.h"
#include "studies/cli/equipment_command.h"
#include "studies/cli/output.h"
#include "studies/cli/shared_options.h"
#include "studies/cli/study_output.h"
#include "studies/plan/stages.h"
#include "studies/prepare/run_job.h"
#include "studies/report/overview_report.h"
#include "studies/report/study_report.h"
#include "studies/run/declared_ranges.h"
#include "studies/run/estimate.h"

namespace gurney::cli {
namespace {

struct CheckOptions {
  std::string job;
  bool json = false;
  int threads = 0;
};

/// Facts of a job: a value for programs, and words for people beside the key without its
/// unit.
class Answer {
 public:
  void add(const std::string& key, const findings::Value& value, const std::string& words) {
    known.json(key, value).text(key.substr(0, key.find('_')), printable(words));
  }

  findings::Section known;
};

void add_warnings(Answer& answer, const std::vector<std::string>& warnings) {
  answer.known.list("warnings", "", warnings);
  for (const std::string& warning : warnings) answer.known.say("warning: " + printable(warning));
}

void add_intensity(Answer& answer, const study::IntensityPlan& plan) {
  std::vector<double> levels = plan.levels;
  for (double& level : levels) level /= plan.unit_in_si;
  if (plan.kind == study::IntensityPlan::Kind::kScales) {
    answer.add("scales", levels, fmt::format("{}: {:g}", levels.size(), fmt::join(levels, ", ")));
    return;
  }
  const std::string measure = name_of(plan.measure) + " " + name_of(plan.combination);
  answer.known.json("measure", measure).json("unit", plan.unit);
  if (plan.kind == study::IntensityPlan::Kind::kStripes)
    answer.add("levels", levels,
               fmt::format("{}: {:g} {} of {}", levels.size(), fmt::join(levels, ", "), plan.unit,
                           measure));
  else
    answer.add("ida", plan.most_runs,
               fmt::format("at most {} runs per analysis case, from {:g} {} of {}", plan.most_runs,
                           plan.first / plan.unit_in_si, plan.unit, measure));
  if (plan.more_stages > 0)
    answer.add("stages", 1 + plan.more_stages,
               fmt::format("{}: these levels, then {} further for each configuration, planned from "
                           "the preceding runs",
                           1 + plan.more_stages, study::kLevelsOfAStage));
}

/// Scale factors of the stated levels: of an IDA the first, for the others are not known before it runs.
void add_scale_factors(Answer& answer, const study::Batch& batch) {
  const study::IntensityPlan& plan = batch.job.study().intensity;
  const bool ida = plan.kind == study::IntensityPlan::Kind::kIda;
  const bool stated = plan.kind == study::IntensityPlan::Kind::kScales;
  study::ScaleFactors factors;
  std::size_t number = 0;
  for (std::size_t set = 0; set < batch.motions.sets(); ++set) {
    const study::MotionSet& motions = batch.motions.set(set);
    for (std::size_t i = 0; i < motions.size(); ++i, ++number)
      for (const double level : motions.levels(i))
        if (!motions.name(i).empty() && (!ida || level == plan.first))
          factors.add(number,
                      motions.stated_scale(i) * (stated ? level : motions.scale_for(i, level)));
  }
  if (!factors.any()) return;
  answer.known.add(report::scale_factor_findings(factors, ida ? " (first level of the IDA)" : ""));
}

void add_plan(Answer& answer, const study::Batch& batch,
              const std::vector<std::string>& of_buildings) {
  const study::Study& study = batch.job.study();
  std::vector<std::string> names;
  for (const study::Configuration& each : batch.job.configurations())
    names.push_back(each.levels.empty() ? "the job"
                                        : fmt::format("{}", fmt::join(each.levels, ", ")));
  answer.add("configurations", names, list_of(names));
  std::vector<std::string> records;
  std::vector<std::string> warnings = job_warnings(batch.job);
  for (std::size_t set = 0; set < batch.motions.sets(); ++set)
    for (std::size_t i = 0; i < batch.motions.set(set).size(); ++i) {
      const std::string& name = batch.motions.set(set).name(i);
      records.push_back(name.empty() ? "the floor rests" : name);
      for (const std::string& warning : batch.motions.set(set).ground(i).warnings)
        warnings.push_back(name + ": " + warning);
    }
  for (std::string& warning : scale_warnings(batch)) warnings.push_back(std::move(warning));
  answer.add(
      "records", records,
      list_of(records) +
          (batch.motions.sets() > 1 ? fmt::format(" (in {} sets)", batch.motions.sets()) : ""));
  std::vector<double> angles = study.angles;
  for (double& angle : angles) angle /= kRadiansPerDegree;
  answer.add("angles_deg", angles,
             fmt::format("{}: {:g} deg", angles.size(), fmt::join(angles, ", ")));
  add_intensity(answer, study.intensity);
  add_scale_factors(answer, batch);
  const std::vector<std::string> inputs = batch.plan.inputs();
  answer.add("draws", study.draws,
             study.draws == 0 ? "none: every parameter has its value"
             : inputs.empty()
                 ? fmt::format("{} for each record", study.draws)
                 : fmt::format("{} points for each record, each with {} rows of a Saltelli design",
                               study.draws, inputs.size() + kSaltelliMatrices));
  if (study.replicas > 1)
    answer.add(
        "replicas", study.replicas,
        fmt::format("{} of each draw, masses times a factor within 1 +- 1e-6", study.replicas));
  if (!inputs.empty()) answer.add("inputs", inputs, list_of(inputs));
  const study::UndrawnRanges undrawn = study::undrawn_ranges(batch);
  append_all(warnings, of_buildings);
  answer.known.add(report::undrawn_findings(undrawn));
  add_warnings(answer, warnings);
}

Answer check_study(const study::StudyJob& job, int threads) {
  const study::StudyMotions motions(job);
  const study::Plan plan(job, motions);
  const study::Batch batch{job, motions, plan};
  refuse_oversized(batch);
  motions.read_all(threads);
  Answer answer;
  answer.add("job", job.file(), job.file() + ": a valid study");
  const study::Estimate needs = study::estimate(batch);
  add_plan(answer, batch, needs.warnings);
  const bool ida = job.study().intensity.kind == study::IntensityPlan::Kind::kIda;
  const char* const most = ida ? "at most " : "";
  answer.add("cases", plan.tasks(), fmt::format("{}", plan.tasks()));
  answer.add("runs", needs.runs, fmt::format("{}{}", most, needs.runs));
  answer.add("time_s", needs.seconds(threads),
             fmt::format("about {} with {} threads on as many idle cores ({} runs were timed: "
                         "{:.2g} s each)",
                         rounded_duration(needs.seconds(threads)), threads, needs.timed,
                         needs.seconds_per_run));
  answer.add("memory_bytes", needs.memory_bytes,
             "about " + size_text(static_cast<double>(needs.memory_bytes)));
  answer.add("disk_bytes", needs.bytes(),
             fmt::format("{}about {} while it runs ({:.0f} bytes a run), and as much or less for "
                         "the results",
                         most, size_text(needs.bytes()), needs.bytes_per_run));
  return answer;
}

Answer check_run(const std::string& job) {
  const study::PreparedRun run = study::prepare_run(job);
  try {
    at_rest(run.facts.scene);
  } catch (const Error& error) {
    throw Error(job + ": " + error.what());
  }
  std::vector<std::string> items;
  for (const PlacedItem& item : run.facts.scene.items)
    items.push_back(item.name.empty() ? item.model.name : item.name);
  Answer answer;
  answer.add("job", job, job + ": a valid single run");
  answer.add("items", items, list_of(items));
  answer.add("record", run.facts.record ? run.facts.record->name : "",
             run.facts.record ? run.facts.record->name : "the floor rests");
  answer.add("runs", 1, "1");
  add_warnings(answer, run.facts.warnings);
  return answer;
}

int check_command(const CheckOptions& options) {
  require_job(options.job, "check");
  if (equipment::holds_equipment(options.job)) return check_equipment({options.job}, options.json);
  const int threads = threads_or_all(options.threads);
  const Answer answer = study::has_study(options.job)
                            ? check_study(study::StudyJob(options.job), threads)
                            : check_run(options.job);
  print_findings(answer.known, options.json);
  return 0;
}

}  // namespace

void add_check(Commands& commands) {
  commands.add<CheckOptions>({"check", "Validate a job and estimate its cost (dry run)",
                              "gurney check studies/jobs/icu_ventilator_fragility.toml\n"
                              "gurney check job.toml --json"},
                             check_command, [](Options& add, CheckOptions& options) {
                               add.required("JOB", options.job,
                                            "The job file; or a file of an item, caster, room ...");
                               add("--json", options.json, "Print the answer as JSON");
                               add.threads(options.threads, "Threads of the study");
                             });
}

}  // namespace gurney::cli
