#include "studies/plan/plan.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>

#include "engine/scene/perturbed.h"
#include "tests/studies/small_study.h"
#include "tests/support/expect_error.h"
#include "tests/support/temp_folder.h"

namespace gurney::study {
namespace {

constexpr const char* kUncertainYaw =
    "[item.yaw_deg]\nvalue = 0\n"
    "distribution = { kind = \"uniform\", low = 0, high = 360, assumption = \"any\" }\n";

/// 2 configurations, 3 records, 2 angles, 4 draws.
std::string job_with(const std::string& sampling) {
  return small_job(R"(angles_deg = [0, 30]
synthetic_records = 3
seed = 5
draws = 4
)" + sampling + R"([[study.factor]]
key = "item.brakes"
values = [false, true]
)" + kUncertainYaw,
                   "kind = \"ac156\"");
}

TEST(Plan, CountsDrawsInAnglesInRecordsInConfigurations) {
  const SmallStudy study(job_with(""));
  ASSERT_EQ(study.plan.tasks(), 2u * 3 * 2 * 4);
  std::size_t index = 0;
  for (std::size_t configuration = 0; configuration < 2; ++configuration)
    for (std::size_t record = 0; record < 3; ++record)
      for (std::size_t angle = 0; angle < 2; ++angle)
        for (std::size_t draw = 0; draw < 4; ++draw, ++index) {
          const Task task = study.plan.task(index);
          EXPECT_EQ(task.configuration, configuration) << index;
          EXPECT_EQ(task.record, record) << index;
          EXPECT_EQ(task.angle, angle) << index;
          EXPECT_EQ(task.draw, record * 4 + draw) << index;
        }
  EXPECT_EQ(study.plan.runs_of_task(), 1u);
}

TEST(Plan, CountsReplicasInDraws) {
  const SmallStudy one(job_with("")), three(job_with("replicas = 3\n"));
  ASSERT_EQ(three.plan.tasks(), 3 * one.plan.tasks());
  EXPECT_EQ(three.plan.runs(), 3 * one.plan.runs());
  EXPECT_EQ(three.plan.draws(1), one.plan.draws(1));
  for (std::size_t i = 0; i < three.plan.tasks(); ++i) {
    const Task task = three.plan.task(i), same = one.plan.task(i / 3);
    EXPECT_EQ(task.replica, i % 3);
    EXPECT_EQ(task.draw, same.draw);
    EXPECT_EQ(task.record, same.record);
    EXPECT_EQ(task.configuration, same.configuration);
  }
}

TEST(Plan, AReplicaIsTheSameDrawWithAMassOfItsOwnThatNobodyCouldMeasure) {
  const SmallStudy study(job_with("replicas = 3\n"));
  const auto item = [&](std::size_t replica) {
    return study.job.job(0, study.plan.draw({.draw = 4}), replica).scene.items[0];
  };
  const double mass = item(0).model.chassis_mass;
  EXPECT_EQ(mass, study.job.job(0, study.plan.draw({.draw = 4})).scene.items[0].model.chassis_mass);
  EXPECT_EQ(item(2).initial.yaw, item(0).initial.yaw);
  EXPECT_NE(item(1).model.chassis_mass, item(2).model.chassis_mass);
  for (const std::size_t replica : {1u, 2u}) {
    EXPECT_NE(item(replica).model.chassis_mass, mass);
    EXPECT_NEAR(item(replica).model.chassis_mass / mass, 1, kReplicaSpread);
  }
}

TEST(Plan, ConfigurationsAndAnglesHaveTheSameDrawsAndRecordsOthers) {
  const SmallStudy study(job_with(""));
  std::set<std::uint64_t> numbers;
  for (std::size_t i = 0; i < study.plan.tasks(); ++i) {
    const Task task = study.plan.task(i);
    const Draw draw = *study.plan.draw(task);
    EXPECT_EQ(draw.seed(), 5u);
    EXPECT_EQ(draw.run(), task.draw);
    EXPECT_EQ(task.draw / 4, task.record);
    numbers.insert(draw.run());
  }
  EXPECT_EQ(numbers.size(), 12u);
  const auto yaw = [&](Task task) {
    return study.job.job(task.configuration, study.plan.draw(task)).scene.items[0].initial.yaw;
  };
  EXPECT_EQ(yaw({0, 1, 0, 6}), yaw({1, 1, 1, 6})) << "paired";
  EXPECT_NE(yaw({0, 1, 0, 6}), yaw({0, 2, 0, 10}));
  EXPECT_EQ(study.plan.draws(1), 12u);
}

TEST(Plan, AHypercubeHasOneDrawInEachCellOfEachVariable) {
  const SmallStudy study(job_with("sampling = \"latin-hypercube\"\n"));
  constexpr std::size_t kDraws = 12;
  for (const std::string variable : {"item.yaw_deg", "another"}) {
    std::set<int> cells;
    for (std::size_t i = 0; i < kDraws; ++i)
      cells.insert(static_cast<int>(kDraws * study.plan.draw({.draw = i})->probability(variable)));
    EXPECT_EQ(cells.size(), kDraws) << variable;
    EXPECT_EQ(*cells.begin(), 0);
    EXPECT_EQ(*cells.rbegin(), 11);
  }
}

TEST(Plan, SobolDrawsAreOnePointOfEachVariable) {
  // 3 records of 4 draws: of the first 8 points of a Sobol sequence one lies in each eighth.
  const SmallStudy study(job_with("sampling = \"sobol\"\n"));
  std::set<int> cells;
  for (std::size_t i = 0; i < 8; ++i)
    cells.insert(static_cast<int>(8 * study.plan.draw({.draw = i})->probability("item.yaw_deg")));
  EXPECT_EQ(cells.size(), 8);
}

TEST(Plan, ASaltelliDesignMixesRecordAndNumbersOneAtATime) {
  const SmallStudy study(job_with("sampling = \"saltelli\"\n"));
  const std::vector<std::string> inputs = study.plan.inputs();
  EXPECT_THAT(inputs, testing::Contains("record"));
  EXPECT_THAT(inputs, testing::Contains("variable item.yaw_deg"));
  EXPECT_THAT(inputs, testing::Contains("group friction"));
  const std::size_t matrices = inputs.size() + 2, of_record = 4 * matrices;
  ASSERT_EQ(study.plan.draws(0), 3 * of_record);
  ASSERT_EQ(study.plan.tasks(), 2 * 2 * 3 * of_record);
  const auto unit_of = [&](std::size_t draw, std::size_t angle) {
    return study.plan.task((draw / of_record * 2 + angle) * of_record + draw % of_record);
  };
  const auto yaw = [&](const Task& task) {
    return study.plan.draw(task)->probability("item.yaw_deg");
  };
  std::set<std::size_t> records_of_b;
  std::set<double> yaws;
  for (std::size_t point = 0; point < 12; ++point) {
    std::vector<Task> rows;
    for (std::size_t matrix = 0; matrix < matrices; ++matrix) {
      rows.push_back(unit_of(matrices * point + matrix, 1));
      EXPECT_EQ(rows[matrix].draw, matrices * point + matrix);
      EXPECT_EQ(rows[matrix].angle, 1u);
      EXPECT_EQ(rows[matrix].record, unit_of(rows[matrix].draw, 0).record) << "paired";
    }
    EXPECT_EQ(rows[0].record, point / 4);
    for (std::size_t i = 0; i < inputs.size(); ++i) {
      EXPECT_EQ(rows[2 + i].record, rows[inputs[i] == "record"].record) << inputs[i];
      EXPECT_EQ(yaw(rows[2 + i]), yaw(rows[inputs[i] == "variable item.yaw_deg"])) << inputs[i];
    }
    records_of_b.insert(rows[1].record);
    yaws.insert({yaw(rows[0]), yaw(rows[1])});
  }
  EXPECT_EQ(records_of_b.size(), 3u);
  EXPECT_EQ(yaws.size(), 24u);
}

TEST(Plan, OneRecordIsNoInputOfASaltelliDesign) {
  const SmallStudy study(small_job("draws = 2\nsampling = \"saltelli\"\n"));
  EXPECT_THAT(study.plan.inputs(), testing::Not(testing::Contains("record")));
}

TEST(Plan, ASaltelliDesignNeedsANumberThatIsDrawn) {
  const TempFolder folder;
  folder.write("cabinet.toml", R"(schema = "gurney-item/1"
name = "cabinet"
[chassis]
mass_kg = 50
center_of_mass_mm = [0, 0, 400]
inertia_box_mm = [400, 500, 800]
[[shape]]
center_mm = [0, 0, 400]
size_mm = [400, 500, 800]
[contact]
material = "steel"
friction = 0.35
restitution = 0.2
stiffness_n_per_m = 2e6
)");
  std::string job = small_job("draws = 2\nsampling = \"saltelli\"\n") + "[floor]\nslope = 0\n";
  job.replace(job.find("xu_trolley"), 10, folder.file("cabinet.toml"));
  EXPECT_ERROR(SmallStudy{job},
               "study.draws: has no effect: no parameter of the job has a distribution");
}

}  // namespace
}  // namespace gurney::study
