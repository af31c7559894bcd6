#include <fmt/format.h>
#include <gmock/gmock.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <optional>

#include "studies/batch/run_unit.h"
#include "studies/limit_states/response_values.h"

namespace gurney {
namespace {

namespace fs = std::filesystem;

/// A study of studies/jobs and its size, which docs/shipped_studies.md tells.
struct Shipped {
  std::string name;
  std::size_t configurations, units, runs_of_unit;
};

void PrintTo(const Shipped& study, std::ostream* stream) { *stream << study.name; }

const std::vector<Shipped> kShipped = {
    {"neonatal_unit", 36, 180, 3},
    {"operating_theatre", 2, 40, 6},
    {"ward_corridor", 4, 24, 3},
    {"trolley_orientation", 48, 624, 3},
    {"icu_ventilator_fragility", 2, 60, 8},
    {"icu_ventilator_ida", 2, 40, 10},
};

std::string path_of(const std::string& name) {
  return GURNEY_SOURCE_DIR "/studies/jobs/" + name + ".toml";
}

std::string text_of(const std::string& path) {
  std::ifstream stream(path);
  return {std::istreambuf_iterator<char>(stream), {}};
}

class ShippedStudy : public testing::TestWithParam<Shipped> {};

INSTANTIATE_TEST_SUITE_P(Jobs, ShippedStudy, testing::ValuesIn(kShipped),
                         [](const auto& study) { return study.param.name; });

TEST_P(ShippedStudy, HasTheSizeThatItsPageTells) {
  const StudyJob job(path_of(GetParam().name));
  const StudyMotions motions(job);
  const Plan plan(job, motions);
  EXPECT_EQ(job.configurations().size(), GetParam().configurations);
  EXPECT_EQ(plan.units(), GetParam().units);
  EXPECT_EQ(plan.runs_of_unit(), GetParam().runs_of_unit);
  const bool hunt = job.study().intensity.kind == IntensityPlan::Kind::kHunt;
  const std::string row = fmt::format(
      "| `{}` | {} | {} | {}{} |", GetParam().name, GetParam().configurations, GetParam().units,
      hunt ? "at most " : "", GetParam().units * GetParam().runs_of_unit);
  EXPECT_THAT(text_of(GURNEY_SOURCE_DIR "/docs/shipped_studies.md"), testing::HasSubstr(row));
}

/// The first and the last unit run as in the whole study: a unit's index decides its numbers.
TEST_P(ShippedStudy, RunsWithoutAFault) {
  const StudyJob job(path_of(GetParam().name));
  const StudyMotions motions(job);
  const Plan plan(job, motions);
  const Batch batch{job, motions, plan};
  for (const std::size_t index : {std::size_t{0}, plan.units() - 1}) {
    const UnitResult result = run_unit(batch, index, [] { return true; });
    ASSERT_FALSE(result.runs.empty());
    const Unit unit = plan.unit(index);
    const Job of_unit = job.job(unit.configuration, plan.draw(unit));
    for (const StudyRun& run : result.runs) {
      const std::string which = fmt::format("unit {} at scale {}", index, run.scale);
      ASSERT_NE(run.response.outcome, Outcome::kDiverged) << which << ": " << run.response.cause;
      EXPECT_NE(run.response.outcome, Outcome::kStillMoving) << which;
      // Physics to 1 %: what the energy account does not explain is a fault.
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

TEST(ShippedStudies, AreAllInTheList) {
  std::vector<std::string> found, listed;
  for (const auto& entry : fs::directory_iterator(GURNEY_SOURCE_DIR "/studies/jobs"))
    if (has_study(entry.path().string())) found.push_back(entry.path().stem().string());
  for (const Shipped& study : kShipped) listed.push_back(study.name);
  EXPECT_THAT(found, testing::UnorderedElementsAreArray(listed));
}

}  // namespace
}  // namespace gurney
