#include "engine/baselines/stock_baseline.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "engine/base/error.h"
#include "engine/baselines/paper_model.h"
#include "engine/baselines/stock_multibody.h"
#include "engine/record/recorder.h"
#include "engine/record/run_clock.h"

namespace gurney::baselines {
namespace {

/// Fills the outcome of a step that the recorder reads.
void fill(double duration, const std::vector<double>& normal, const State& before,
          const State& after, ItemStage::Output& output) {
  output.acceleration.chassis = (after.velocity.chassis - before.velocity.chassis) / duration;
  for (std::size_t i = 0; i < normal.size(); ++i) {
    TreadLaw::Result& tread = output.treads[i];
    tread = TreadLaw::Result();
    tread.force[2] = normal[i];
    tread.compression = normal[i] > 0 ? 1e-6 : -1e-6;
    tread.end.rolling = true;
    const Matrix3 rotation = after.rotation.toRotationMatrix();
    const double yaw = std::atan2(rotation(1, 0), rotation(0, 0)) + after.casters[i].swivel_angle;
    output.heading[i] = {std::cos(yaw), std::sin(yaw)};
  }
}

/// @throws Error where a job has what these baselines do not know
void require_known(bool known, const char* limits) {
  require(known,
          fmt::format("the stock Bullet baselines know {}; use solver = \"implicit\" for this job",
                      limits));
}

bool is_free(const Fixture& fixture) {
  return std::ranges::all_of(fixture.guides,
                             [](const Guide& guide) { return guide.kind == Guide::Kind::kFree; });
}

bool of_boxes(const std::vector<RoomShape>& room) {
  return std::ranges::all_of(
      room, [](const RoomShape& shape) { return std::holds_alternative<RoomBox>(shape.shape); });
}

}  // namespace

Response simulate_on_stock_bullet(const Scene& scene, const FloorMotion& floor,
                                  const SimulationSettings& settings, StockBullet choice) {
  validate(scene);
  validate(settings);
  require_known((scene.room.empty() || (!choice.paper && of_boxes(scene.room))) &&
                    scene.tethers.empty() && scene.zones.empty() && scene.items.size() == 1 &&
                    !scene.items[0].model.casters.empty(),
                "one item on casters, no tethers and zones, and of rooms boxes only (the paper's "
                "model none)");
  const PlacedItem& item = scene.items.front();
  require_known(std::ranges::all_of(item.model.shape, &BodyShape::is_box),
                "items of boxes only, no cylinders, spheres and hulls");
  require_known(is_free(item.fixture) && loads_of<DropWeight>(item.loads).empty() &&
                    loads_of<Blocks>(item.loads).empty(),
                "no drop weights, blocks or fixtures");
  require_known(scene.joints.empty(), "no items with parts");
  require_known(!floor.rotates(), "no rotation of the floor");
  const Assembly assembly(scene);
  const Mechanism& mechanism = assembly.items[0];
  SceneState scene_state;
  scene_state.items = {mechanism.placed(item.initial)};
  State& state = scene_state.items[0];
  mechanism.set_in_motion(item.initial, state);
  Recorder recorder(scene, assembly, 0, scene_state);
  RunClock clock(floor, mechanism.loads.breakpoints(), settings);
  const std::unique_ptr<StockModel> world =
      choice.paper ? make_paper_model(scene, mechanism, choice.direct)
                   : make_stock_multibody(scene, mechanism, choice.direct);
  world->place(state);
  Response response;
  const EnergyAccount account;
  StageSolver::Output output;
  output.items.resize(1);
  const Island alone{{0}, 0, 0};
  std::vector<Loads::Row> rows;
  SceneState next = scene_state;
  recorder.sample(scene_state, account, clock.keeps_history());
  double sampled_at = state.time;
  while (clock.next(state.time)) {
    const double duration = clock.target() - state.time;
    FloorStage stage_floor;
    stage_floor.acceleration = stage_floor.translation =
        (floor.velocity_at(clock.target()) - floor.velocity_at(state.time)) / duration;
    const Loads::Stage stage{duration, state.time, clock.target(), true, &state.loads};
    mechanism.loads.evaluate(stage, state.pose(), state.velocity.chassis, rows);
    world->step(duration, mechanism.gravity - stage_floor.acceleration, rows, state, next.items[0]);
    fill(duration, world->normal_forces(), state, next.items[0], output.items[0]);
    ++response.quality.steps;
    if (!next.items[0].position.allFinite()) {
      clock.stop(Outcome::kDiverged, "the position is not finite");
      break;
    }
    recorder.observe(
        {&alone, state.time, duration, &scene_state, &next, &output, &output, stage_floor}, {});
    state = next.items[0];
    state.time = clock.target();
    if (clock.sample_due()) {
      recorder.sample(scene_state, account, clock.keeps_history());
      sampled_at = state.time;
    }
    clock.observe(state.time, {recorder.motion()});
    if (clock.overturned_at(0) == state.time) recorder.overturned();
  }
  if (sampled_at != state.time) recorder.sample(scene_state, account, clock.keeps_history());
  response.outcome = clock.outcome();
  response.cause = clock.cause();
  response.end_time = state.time;
  recorder.finish(scene_state, account, clock.overturned_at(0), response);
  response.quality.energy_closure = response.quality.numerical_loss = 0;
  return response;
}

}  // namespace gurney::baselines
