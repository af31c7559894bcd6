#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cstdlib>

#include "engine/base/error.h"
#include "engine/record/energy_balance.h"
#include "tests/engine/run/drawn_items.h"
#include "tests/studies/small_study.h"
#include "tests/system/properties/motions.h"

/// Whatever stands in whatever room: a result or a reason.
namespace gurney::properties {
namespace {

/// The same draws each time, unless RC_PARAMS asks for others: "max_success=10000".
const bool kSeeded = setenv("RC_PARAMS", "seed=1 max_success=60", 0) == 0;

/// Steps of a run as drawn, and how much shorter events may make them: a caster that bounces
/// between a floor and a wall took 1e5 of them in 4 s.
constexpr long kMostSteps = 1'000'000;

RC_GTEST_PROP(AnyRun, EndsOrIsRefused, ()) {
  drawn::Run run = drawn::run(*rc::gen::arbitrary<unsigned>());
  run.settings.time_step = *rc::gen::element(0.001, 0.004, 0.01);
  run.scene.slope = *between(0, 0.1);
  Response response;
  try {
    response = simulate(run.scene, run.floor, run.settings);
  } catch (const Error& error) {
    RC_ASSERT(!std::string(error.what()).empty());
    RC_SUCCEED("refused");
  }
  RC_CLASSIFY(true, std::string(name_of(response.outcome)));
  RC_ASSERT(response.quality.steps < kMostSteps);
  RC_ASSERT(response.end_time <= run.floor.duration() + run.settings.settle_time + 1);
  RC_ASSERT(is_failure(response.outcome) != response.cause.empty());
  for (const Sample& sample : response.items[0].history) {
    if (response.outcome != Outcome::kDiverged)
      RC_ASSERT(sample.displacement.allFinite() && sample.velocity.allFinite());
  }
}

// With no work from outside, what is stored can only be lost. The verdict on a run allows an error
// of kTrusted, and says so where there is more.
RC_GTEST_PROP(AnyRun, MakesNoEnergyOnAFloorAtRest, ()) {
  Scene scene = scene_of(low_cart());
  scene.items[0].initial.velocity = {*between(0, 2), *between(0, 2), 0};
  scene.items[0].initial.yaw_rate = *between(0, 3);
  SimulationSettings settings;
  settings.duration = 1.5;
  const Response response = simulate(scene, {}, settings);
  RC_PRE(!is_failure(response.outcome));
  const double allowed = EnergyBalance::kTrusted * response.items[0].stored_energy_at_start;
  double least = response.items[0].stored_energy_at_start;
  for (const Sample& sample : response.items[0].history) {
    RC_ASSERT(sample.energy.stored() <= least + allowed);
    least = std::min(least, sample.energy.stored());
  }
}

constexpr const char* kStudy = R"(angles_deg = [0, 40, 90]
draws = 4
[study.intensity]
scales = [1, 2]
[[study.factor]]
name = "brakes"
key = "item.brakes"
values = [false, true]
[item.yaw_deg]
value = 0
distribution = { kind = "uniform", low = 0, high = 360, assumption = "any" }
)";

std::string bytes_of(const study::SmallStudy& study, std::size_t task) {
  study::TaskResult result = study.run(task);
  return to_bytes(result);
}

RC_GTEST_PROP(AnyRun, DoesNotDependOnItsNeighboursInTheBatch, ()) {
  const study::SmallStudy batch(study::small_job(kStudy));
  const auto tasks = *rc::gen::container<std::vector<std::size_t>>(
      3, rc::gen::inRange(std::size_t{0}, batch.plan.tasks()));
  for (const std::size_t task : tasks) {
    const study::SmallStudy alone(study::small_job(kStudy));
    RC_ASSERT(bytes_of(batch, task) == bytes_of(alone, task));
  }
}

}  // namespace
}  // namespace gurney::properties
