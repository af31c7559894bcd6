#include "studies/run/study_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <utility>

#include "engine/base/hash/sha256.h"
#include "studies/results/hdf5_reader.h"
#include "tests/studies/small_study.h"
#include "tests/support/temp_folder.h"

namespace gurney::study {
namespace {

using testing::Each;
using testing::ElementsAre;

constexpr const char* kStudy = R"raw(angles_deg = [0, 90]
draws = 2
step_check = 1
measures = ["PGA h1", "Sa(1.0)"]
[study.intensity]
measure = "PGA"
component = "h1"
unit = "g"
levels = [0.1, 0.3]
[study.keep]
histories = "all"
wheels = true
energy = true
[[study.factor]]
name = "brakes"
key = "item.brakes"
values = [false, true]
[item.yaw_deg]
value = 0
distribution = { kind = "uniform", low = 0, high = 360, assumption = "any" }
)raw";

constexpr const char* kYaw =
    "[item.yaw_deg]\nvalue = 0\ndistribution = { kind = \"uniform\", low = 0, high = 9, "
    "assumption = \"any\" }\n";

class StudyFile : public testing::Test {
 protected:
  std::string write(const SmallStudy& study) {
    results_.clear();
    for (std::size_t i = 0; i < study.plan.tasks(); ++i) results_.push_back(study.run(i));
    const std::string path = folder_.file("a.h5");
    counts_ =
        write_study_file(path, study.batch, [&](std::size_t task) { return results_.at(task); });
    return path;
  }

  TempFolder folder_;
  std::vector<TaskResult> results_;
  RunCounts counts_;
};

TEST_F(StudyFile, NamesTheInputsOfASaltelliDesign) {
  const SmallStudy study(small_job(
      "draws = 1\nsampling = \"saltelli\"\n"
      "[item.yaw_deg]\nvalue = 0\ndistribution = { kind = \"uniform\", low = 0, high = 9, "
      "assumption = \"any\" }\n"));
  const Hdf5Reader file(write(study));
  EXPECT_EQ(file.strings("/design/input"), study.plan.inputs());
  const std::vector<double> draws = file.numbers("/runs/draw");
  ASSERT_EQ(draws.size(), study.plan.inputs().size() + 2);
  for (std::size_t i = 0; i < draws.size(); ++i) EXPECT_EQ(draws[i], double(i));
}

TEST_F(StudyFile, ReplicasAreRowsOfTheirDraw) {
  const std::string study = "draws = 2\n[study.keep]\nwheels = true\n" + std::string(kYaw);
  std::vector<double> of_alone, drawn_alone;
  {
    const Hdf5Reader alone(write(SmallStudy(small_job(study))));
    of_alone = alone.numbers("/items/peak_displacement");
    drawn_alone = alone.numbers("/drawn/draw");
    EXPECT_THAT(alone.numbers("/runs/replica"), testing::ElementsAre(0, 0));
  }
  const Hdf5Reader file(write(SmallStudy(small_job("replicas = 3\n" + study))));
  EXPECT_THAT(file.numbers("/runs/replica"), testing::ElementsAre(0, 1, 2, 0, 1, 2));
  EXPECT_THAT(file.numbers("/runs/draw"), testing::ElementsAre(0, 0, 0, 1, 1, 1));
  EXPECT_EQ(file.numbers("/drawn/draw"), drawn_alone) << "each draw once";
  const std::vector<double> peaks = file.numbers("/items/peak_displacement");
  ASSERT_EQ(peaks.size(), 6u);
  for (std::size_t draw = 0; draw < 2; ++draw) {
    EXPECT_EQ(peaks[3 * draw], of_alone[draw]) << "the first is the draw itself";
    EXPECT_NE(peaks[3 * draw + 1], peaks[3 * draw]);
    EXPECT_NEAR(peaks[3 * draw + 1], peaks[3 * draw], 1e-5 * peaks[3 * draw]) << "it rolls";
  }
}

TEST_F(StudyFile, HasARowForEachRun) {
  const SmallStudy study(small_job(kStudy));
  const Hdf5Reader file(write(study));
  ASSERT_EQ(study.plan.tasks(), 2u * 1 * 2 * 2);
  EXPECT_EQ(counts_.runs, 16u);
  EXPECT_EQ(counts_.failed, 0u);
  const auto column = [&](const std::string& name) { return file.numbers("/" + name); };
  ASSERT_EQ(column("runs/run").size(), 16u);
  for (std::size_t run = 0; run < 16; ++run) {
    const Task task = study.plan.task(run / 2);
    const StudyRun& made = results_[run / 2].runs[run % 2];
    EXPECT_EQ(column("runs/run")[run], double(run));
    EXPECT_EQ(column("runs/analysis_case")[run], double(run / 2));
    EXPECT_EQ(column("runs/configuration")[run], double(task.configuration));
    EXPECT_EQ(column("runs/record")[run], double(task.record));
    EXPECT_EQ(column("runs/motion")[run], double(run % 2));
    EXPECT_EQ(column("runs/angle")[run], study.job.study().angles[task.angle]);
    EXPECT_EQ(column("runs/draw")[run], double(task.draw));
    EXPECT_EQ(column("runs/scale")[run], made.scale);
    EXPECT_EQ(column("runs/intensity")[run], made.intensity);
    EXPECT_EQ(column("runs/pfa")[run], made.pfa);
    EXPECT_EQ(column("runs/pfv")[run], made.pfv);
    EXPECT_EQ(file.strings("/runs/outcome")[run], name_of(made.response.outcome));
    EXPECT_EQ(column("runs/end_time")[run], made.response.end_time);
    EXPECT_EQ(column("items/run")[run], double(run));
    EXPECT_EQ(column("items/peak_displacement")[run],
              made.response.items[0].demands.peak_displacement);
    EXPECT_EQ(column("half_step/peak_displacement")[run], made.at_half_step[0].peak_displacement);
    EXPECT_EQ(column("energy/work_of_floor")[run], made.response.items[0].energy.work_of_floor);
    EXPECT_EQ(column("wheels/peak_normal_force")[4 * run + 2],
              made.response.items[0].demands.wheels[2].peak_normal_force);
  }
}

TEST_F(StudyFile, TheLevelIsTheIntensityOfTheScaledMotion) {
  const SmallStudy study(small_job(kStudy));
  const Hdf5Reader file(write(study));
  EXPECT_THAT(file.numbers("/motions/scale").size(), 2u) << "a row for each scaled record";
  EXPECT_NEAR(file.numbers("/motions/PGA h1")[0], 0.98066, 1e-4);
  EXPECT_DOUBLE_EQ(file.numbers("/runs/intensity")[1], 0.3 * 9.80665);
  // The Ricker wavelet acts in one direction alone: the floor has its PGA whatever the angle.
  for (std::size_t run = 0; run < 16; ++run)
    EXPECT_NEAR(file.numbers("/runs/pfa")[run], file.numbers("/runs/intensity")[run], 1e-9) << run;
}

TEST_F(StudyFile, NamesConfigurationsRecordsDrawsAndItself) {
  const SmallStudy study(small_job(kStudy));
  const Hdf5Reader file(write(study));
  EXPECT_EQ(file.text_attribute("filetype"), "gurney-study");
  EXPECT_EQ(file.text_attribute("job_text"), study.job.text());
  EXPECT_EQ(file.text_attribute("job_sha256"), sha256(study.job.text()));
  EXPECT_EQ(file.text_attribute("intensity_measure"), "PGA h1");
  EXPECT_EQ(file.text_attribute("intensity_units"), "m/s2");
  EXPECT_THAT(file.strings("/configurations/brakes"), ElementsAre("false", "true"));
  EXPECT_THAT(file.strings("/records/name"), ElementsAre("synthetic ricker"));
  // The brakes of the second configuration are on: their torques are drawn as well.
  const std::size_t variables = results_[0].drawn.size(), braked = variables + 4;
  const std::vector<double> configuration = file.numbers("/drawn/configuration"),
                            draw = file.numbers("/drawn/draw"),
                            value = file.numbers("/drawn/value");
  const std::vector<std::string> variable = file.strings("/drawn/variable");
  ASSERT_EQ(value.size(), 2 * (variables + braked)) << "one angle stands for all";
  std::map<std::pair<double, std::string>, double> unbraked;
  for (std::size_t i = 0; i < 2 * variables; ++i) {
    EXPECT_EQ(configuration[i], 0);
    EXPECT_EQ(draw[i], double(i / variables));
    unbraked[{draw[i], variable[i]}] = value[i];
  }
  std::size_t torques = 0;
  for (std::size_t i = 2 * variables; i < value.size(); ++i) {
    EXPECT_EQ(configuration[i], 1);
    EXPECT_EQ(draw[i], double((i - 2 * variables) / braked));
    const auto pair = unbraked.find({draw[i], variable[i]});
    if (pair == unbraked.end())
      torques += variable[i].ends_with("/brake_torque_n_m");
    else
      EXPECT_EQ(value[i], pair->second) << "paired: " << variable[i];
  }
  EXPECT_EQ(torques, 2 * 4u);
  EXPECT_EQ(variable[variables], variable[0]);
  EXPECT_EQ(value[0], results_[0].drawn[0]);
  EXPECT_NE(value[0], value[variables]);
}

TEST_F(StudyFile, HasTheHistoriesThatAreKept) {
  const SmallStudy study(small_job(kStudy));
  const Hdf5Reader file(write(study));
  const std::vector<Sample>& first = results_[0].runs[0].response.items[0].history;
  ASSERT_GT(first.size(), 2u);
  EXPECT_EQ(file.numbers("/histories/displacement_x")[2], first[2].displacement.x());
  EXPECT_EQ(file.numbers("/histories/run")[first.size()], 1);
  const SmallStudy without(small_job(""));
  EXPECT_TRUE(without.run(0).runs[0].response.items[0].history.empty());
}

TEST_F(StudyFile, ARunThatFailedIsARowWithItsCause) {
  std::string job = small_job(kStudy);
  job.insert(job.find("duration_s"),
             "residual = 1e-300\nmax_newton_iterations = 4\nmax_subdivisions = 0\n");
  const SmallStudy study(job);
  const Hdf5Reader file(write(study));
  ASSERT_GT(counts_.failed, 0u);
  std::vector<std::string> causes;
  for (const TaskResult& task : results_)
    for (const StudyRun& run : task.runs)
      if (is_failure(run.response.outcome)) causes.push_back(run.response.cause);
  EXPECT_EQ(causes.size(), counts_.failed);
  EXPECT_EQ(file.strings("/failures/cause"), causes);
  EXPECT_THAT(causes, Each(testing::Ne("")));
  EXPECT_EQ(std::ranges::count(file.strings("/runs/outcome"), "diverged"), causes.size());
  EXPECT_EQ(file.numbers("/items/run").size(), counts_.runs - counts_.failed);
}

TEST_F(StudyFile, KeepsWhatTheBuildingWarnsOf) {
  // Isolators with room for 1 mm under 0.4 mg, which moves them by less, and under 0.4 g.
  std::string job = small_job("[study.intensity]\nscales = [0.001, 1]\n");
  job.insert(job.find("[settings]"),
             "[excitation.building]\nkind = \"generic\"\nname = \"b\"\nstoreys = 4\n"
             "height_m = 16\nframe = \"concrete_moment_frame\"\ndamping_ratio = 0.03\n"
             "shear_flexure_ratio = 8\nfloor = 0\n"
             "[excitation.building.isolation]\nkind = \"lead_rubber\"\nperiod_s = 3\n"
             "strength_ratio = 0.06\nyield_displacement_mm = 10\ndamping_ratio = 0.03\n"
             "base_mass_ratio = 0.2\ndisplacement_capacity_mm = 1\n");
  job.replace(job.find("period_s = 0.1"), 14, "period_s = 0.5");
  const Hdf5Reader file(write(SmallStudy(job)));
  EXPECT_THAT(file.numbers("/warnings/run"), testing::ElementsAre(1));
  EXPECT_THAT(file.strings("/warnings/warning"),
              testing::ElementsAre(testing::HasSubstr("exceeds the capacity of 0.001 m")));
}

TEST_F(StudyFile, DrawsThatMakeNoJobAreFailuresAndNoMore) {
  // Two trolleys 2 m apart, one of which may stand in the other in the first draw.
  const SmallStudy study(R"(schema = "gurney-job/1"
[[item]]
name = "a"
equipment = "xu_trolley"
[[item]]
name = "b"
equipment = "xu_trolley"
[item.position_m]
value = [2, 0]
source = "plan"
distribution = { x = { kind = "uniform", low = 0, high = 2, source = "plan" } }
[settings]
duration_s = 0.02
settle_time_s = 0
[study]
draws = 20
)");
  const Hdf5Reader file(write(study));
  EXPECT_EQ(counts_.runs, 20u);
  EXPECT_GT(counts_.failed, 0u);
  EXPECT_LT(counts_.failed, 20u);
  EXPECT_NE(file.strings("/failures/cause")[0].find("deep in 'a'"), std::string::npos)
      << file.strings("/failures/cause")[0];
  std::size_t drawn = 0;
  for (const TaskResult& task : results_) drawn += task.drawn.size();
  EXPECT_GT(drawn, 0u);
  EXPECT_EQ(file.numbers("/drawn/value").size(), drawn);
}

TEST_F(StudyFile, EventsHaveTheWholeNameOfWhatWasHit) {
  const std::string wall = "the wall between bay 3 and the corridor of the neonatal unit";
  const SmallStudy study(R"(schema = "gurney-job/1"
[item]
equipment = "xu_trolley"
[initial]
velocity_m_per_s = [0.8, 0, 0]
[[room.wall]]
name = ")" + wall + R"("
from_m = [0.7, -2]
to_m = [0.7, 2]
thickness_m = 0.15
height_m = 2.8
[settings]
duration_s = 0.4
[study]
)");
  const Hdf5Reader file(write(study));
  ASSERT_FALSE(file.strings("/events/other").empty());
  EXPECT_EQ(file.strings("/events/other")[0], wall);
}

}  // namespace
}  // namespace gurney::study
