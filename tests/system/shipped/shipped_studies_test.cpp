#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <optional>

#include "engine/base/input_file.h"
#include "studies/limit_states/limit_state.h"
#include "studies/run/run_task.h"

namespace gurney::study {
namespace {

namespace fs = std::filesystem;

/// A study of studies/jobs and its size, which docs/shipped_studies.md states.
struct Shipped {
  std::string name;
  std::size_t configurations, tasks, runs_of_task;
};

void PrintTo(const Shipped& study, std::ostream* stream) { *stream << study.name; }

const std::vector<Shipped> kShipped = {
    {"neonatal_unit", 36, 180, 3},
    {"operating_theatre", 2, 40, 6},
    {"ward_corridor", 4, 24, 3},
    {"trolley_orientation", 48, 624, 3},
    {"icu_ventilator_fragility", 2, 60, 8},
    {"icu_ventilator_ida", 2, 40, 10},
    {"crash_cart_drawers", 4, 40, 5},
};

std::string path_of(const std::string& name) {
  return GURNEY_SOURCE_DIR "/studies/jobs/" + name + ".toml";
}

class ShippedStudy : public testing::TestWithParam<Shipped> {};

INSTANTIATE_TEST_SUITE_P(Jobs, ShippedStudy, testing::ValuesIn(kShipped),
                         [](const auto& study) { return study.param.name; });

/// Every job in the folder that is a study, so that none is forgotten.
std::vector<std::string> studies_in_folder() {
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(GURNEY_SOURCE_DIR "/studies/jobs"))
    if (has_study(entry.path().string())) names.push_back(entry.path().stem().string());
  std::ranges::sort(names);
  return names;
}

class StudyInTheFolder : public testing::TestWithParam<std::string> {};

INSTANTIATE_TEST_SUITE_P(Jobs, StudyInTheFolder, testing::ValuesIn(studies_in_folder()),
                         [](const auto& name) { return name.param; });

TEST_P(ShippedStudy, HasTheSizeThatItsPageReports) {
  const StudyJob job(path_of(GetParam().name));
  const StudyMotions motions(job);
  const Plan plan(job, motions);
  EXPECT_EQ(job.configurations().size(), GetParam().configurations);
  EXPECT_EQ(plan.tasks(), GetParam().tasks);
  EXPECT_EQ(plan.runs_of_task(), GetParam().runs_of_task);
  const bool ida = job.study().intensity.kind == IntensityPlan::Kind::kIda;
  const std::string row = fmt::format(
      "| `{}` | {} | {} | {}{} |", GetParam().name, GetParam().configurations, GetParam().tasks,
      ida ? "at most " : "", GetParam().tasks * GetParam().runs_of_task);
  const std::string page = read_input_file(GURNEY_SOURCE_DIR "/docs/shipped_studies.md");
  EXPECT_NE(page.find(row), std::string::npos) << "docs/shipped_studies.md has no row " << row;
}

/// The first and the last task run as in the whole study: a task's index decides its numbers.
TEST_P(StudyInTheFolder, RunsWithoutAFault) {
  const StudyJob job(path_of(GetParam()));
  const StudyMotions motions(job);
  const Plan plan(job, motions);
  const Batch batch{job, motions, plan};
  for (const std::size_t index : {std::size_t{0}, plan.tasks() - 1}) {
    const TaskResult result = run_task(batch, index, [] { return true; });
    ASSERT_FALSE(result.runs.empty());
    const Task task = plan.task(index);
    const Job of_unit = job.job(task.configuration, plan.draw(task));
    for (const StudyRun& run : result.runs) {
      const std::string which = fmt::format("unit {} at scale {}", index, run.scale);
      ASSERT_FALSE(is_failure(run.response.outcome)) << which << ": " << run.response.cause;
      EXPECT_NE(run.response.outcome, Outcome::kStillMoving) << which;
      // Physics to 1 %: what the energy balance does not explain is a fault.
      EXPECT_LT(run.response.quality.energy_closure, 0.01) << which;
      EXPECT_EQ(run.response.quality.unconverged_steps, 0) << which;
      // Every limit state can be asked of the run, and something moved.
      const Values values = values_of(of_unit.scene, run.response);
      for (std::size_t i = 0; i < job.study().limit_states.size(); ++i)
        exceeded(job.study().limit_states, i, values);
      for (const ItemResponse& item : run.response.items)
        EXPECT_GT(item.demands.peak_displacement, 0) << which;
    }
  }
}

bool has_level(const StudyJob& job, std::size_t configuration, const std::string& factor,
               const std::string& level) {
  const Study& study = job.study();
  for (std::size_t i = 0; i < study.factors.size(); ++i)
    if (study.factors[i].name == factor)
      return job.configurations()[configuration].levels[i] == level;
  throw std::logic_error("no factor " + factor);
}

// The table of the page: under its strongest motions a braked cart's drawers open where latches alone hold them.
TEST(CrashCartDrawers, OpenOnABrakedCartUnlessTheyAreLocked) {
  const StudyJob job(path_of("crash_cart_drawers"));
  const StudyMotions motions(job);
  const Plan plan(job, motions);
  const Batch batch{job, motions, plan};
  int found = 0;
  for (std::size_t index = 0; index < plan.tasks() && found < 2; ++index) {
    const std::size_t c = plan.task(index).configuration;
    const bool locked = has_level(job, c, "drawers", "locked");
    if (!has_level(job, c, "brakes", "on") || (found == 1 && !locked)) continue;
    ++found;
    const StudyRun run = run_task(batch, index, [] { return true; }).runs.back();
    double farthest = 0;
    for (const ItemResponse& item : run.response.items)
      farthest = std::fmax(farthest, item.demands.peak_travel);
    if (locked) {
      EXPECT_LT(farthest, 1e-6);
    } else {
      EXPECT_GT(farthest, 0.3) << "some 0.4 m to the stop";
    }
  }
  EXPECT_EQ(found, 2);
}

/// A braked wheel stands still, but its fork swivels: with all forks parallel the trolley hangs on
/// four equal links and goes from one side of the wheels to the other, 2 x 34 mm of trail (R100).
/// To that add what the treads give way, M a / (4 k_t) = 96.5 kg x 1.6 m/s2 / (4 x 1e5 N/m) to
/// each side: 0.8 mm at most.
TEST(TrolleyOrientation, ABrakedTrolleySwingsByTwiceItsTrail) {
  const StudyJob job(path_of("trolley_orientation"));
  const StudyMotions motions(job);
  const Plan plan(job, motions);
  const Batch batch{job, motions, plan};
  int found = 0;
  for (std::size_t index = 0; index < plan.tasks(); ++index) {
    const Task task = plan.task(index);
    const std::size_t c = task.configuration;
    if (!has_level(job, c, "period", "2") || !has_level(job, c, "headings", "trailing") ||
        task.angle != 6)
      continue;
    ++found;
    const TaskResult result = run_task(batch, index, [] { return true; });
    for (const std::size_t run : {0, 1}) {  // 0.2 and 0.4 m/s
      const Demands& demands = result.runs[run].response.items[0].demands;
      if (has_level(job, c, "brakes", "on")) {
        EXPECT_NEAR(demands.peak_displacement, 0.068, 1e-3);
      }
      if (has_level(job, c, "brakes", "total lock")) {
        EXPECT_LT(demands.peak_displacement, 1e-3);
      }
      if (has_level(job, c, "brakes", "off")) {
        EXPECT_GT(demands.peak_displacement, 0.068);
      }
    }
  }
  EXPECT_EQ(found, 3);
}

}  // namespace
}  // namespace gurney::study
