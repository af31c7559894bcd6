#include <fmt/core.h>

#include <algorithm>
#include <optional>
#include <set>
#include <tuple>

#include "engine/run/run.h"
#include "studies/run/run_task.h"
#include "tests/benchmark/sections.h"
#include "tests/benchmark/workload.h"

namespace gurney::benchmark {
namespace {

/// The free trolley, each run under a stochastic motion of its own of some 20 s.
constexpr const char* kFreeTrolley = R"(schema = "gurney-job/1"
item.equipment = "xu_trolley"
item.yaw_deg = { value = 0, distribution = { kind = "uniform", low = 0, high = 360, assumption = "any" } }
excitation.record.synthetic = { kind = "stochastic", significant_duration_s = 6, middle_s = 5, corner_frequency_hz = 0.2 }
settings.duration_s = 20
settings.settle_time_s = 0
settings.time_step_s = 0.01
study.synthetic_records = 200
study.draws = 1
study.intensity = { measure = "PGV", component = "larger", unit = "m/s", levels = [0.4] }
)";

/// CPU time of a whole study on one thread, by what takes it [s].
struct Shares {
  double motions = 0;    ///< reading or making, processing, intensity measures
  double buildings = 0;  ///< motions of floors
  double jobs = 0;       ///< items with their drawn numbers
  double engine = 0;
  double rest = 0;  ///< floor axes, peaks of the floor, bookkeeping
  double runs = 0;

  double sum() const { return motions + buildings + jobs + engine + rest; }
};

template <class Work>
double cpu_of(const Work& work) {
  const double start = cpu_time();
  work();
  return cpu_time() - start;
}

/// From `cases` tasks spread evenly over the study: means over distinct motions and over runs, times the
/// numbers of these in the study.
Shares shares_of(const study::StudyJob& job, std::size_t cases) {
  const study::StudyMotions motions(job);
  const study::Plan plan(job, motions);
  const study::Batch batch{job, motions, plan};
  std::size_t all_motions = 0;
  for (std::size_t set = 0; set < motions.sets(); ++set) all_motions += motions.set(set).size();
  const double all_tasks = double(plan.tasks_of_stage());

  std::set<std::tuple<std::size_t, std::size_t>> made;
  double tasks = 0, floors = 0;
  Shares seen;
  const std::size_t stride = std::max<std::size_t>(1, plan.tasks_of_stage() / cases);
  for (std::size_t index = 0; index < plan.tasks_of_stage(); index += stride, ++tasks) {
    const study::Task task = plan.task(index);
    const study::MotionSet& set = motions.set_of(task.configuration);
    const bool is_new = made.emplace(motions.index_of(task.configuration), task.record).second;
    seen.motions += cpu_of([&] { set.ground(task.record); });
    if (is_new && set.has_building())
      for (const double value : job.study().intensity.levels) {
        const bool is_scale = job.study().intensity.kind == study::IntensityPlan::Kind::kScales;
        const double scale = is_scale ? value : set.scale_for(task.record, value);
        seen.buildings += cpu_of([&] { set.floor_record(task.record, scale); });
        ++floors;
      }
    study::TaskResult result;
    const double whole =
        cpu_of([&] { result = study::run_task(batch, index, [] { return true; }); });
    std::optional<study::Job> drawn;
    const double draw = cpu_of([&] { drawn = job.job(task.configuration, plan.draw(task)); });
    double engine = 0;
    for (const study::StudyRun& done : result.runs) {
      study::RunCase each = study::case_of(batch, task, *drawn, done.scale);
      each.settings.history_step = 0;
      engine += cpu_of([&] { run(each.scene, each.floor, each.settings); });
    }
    seen.jobs += draw, seen.engine += engine, seen.rest += std::max(0.0, whole - draw - engine);
    seen.runs += double(result.runs.size());
  }
  const double per_motion = double(all_motions) / double(made.size()), per_task = all_tasks / tasks;
  const double of_floors = double(job.study().intensity.levels.size()) * double(all_motions);
  return {seen.motions * per_motion, floors > 0 ? seen.buildings * of_floors / floors : 0,
          seen.jobs * per_task,      seen.engine * per_task,
          seen.rest * per_task,      seen.runs * per_task};
}

void print_row(const std::string& name, const Shares& s) {
  const double percent = 100 / s.sum();
  fmt::print("| {} | {:.0f} | {:.2f} | {:.0f} | {:.0f} | {:.0f} | {:.0f} | {:.0f} |\n", name,
             s.runs, 1e3 * s.sum() / s.runs, s.motions * percent, s.buildings * percent,
             s.jobs * percent, s.engine * percent, s.rest * percent);
}

}  // namespace

void print_studies(const std::vector<std::string>& jobs, int cases) {
  fmt::print(
      "\nCPU time of whole studies, from {} cases each: ms a run, and shares [%]\n"
      "| study | runs | ms a run | motions | buildings | draws | engine | rest |\n"
      "| --- | ---: | ---: | ---: | ---: | ---: | ---: | ---: |\n",
      cases);
  print_row("a motion a run", shares_of(study::StudyJob(kFreeTrolley, "free_trolley.toml"),
                                        static_cast<std::size_t>(10 * cases)));
  for (const std::string& path : jobs)
    print_row(path.substr(path.rfind('/') + 1),
              shares_of(study::StudyJob(path), static_cast<std::size_t>(cases)));
}

}  // namespace gurney::benchmark
