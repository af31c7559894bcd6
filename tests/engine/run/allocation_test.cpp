#include <gtest/gtest.h>

#include <cstdlib>

#include "engine/bullet/contact_search.h"
#include "engine/record/impact_log.h"
#include "engine/record/recorder.h"
#include "engine/record/tether_log.h"
#include "engine/solver/stepper.h"
#include "studies/verification/scenes/blocks.h"
#include "studies/verification/scenes/small_scenes.h"

// A step allocates nothing: neither the solver nor what observes it. Everything that this program
// allocates goes through malloc, operator new and Eigen alike, which is counted here.
#if defined(__GLIBC__) && !defined(GURNEY_SANITIZED) && !defined(__SANITIZE_THREAD__)
#define GURNEY_COUNTS_ALLOCATIONS
#endif

namespace {
thread_local long allocations = 0;
}

#ifdef GURNEY_COUNTS_ALLOCATIONS
extern "C" {
void* __libc_malloc(std::size_t size);  // NOLINT: the name is glibc's
void* malloc(std::size_t size) noexcept {
  ++allocations;
  return __libc_malloc(size);
}
}
#endif

namespace gurney {
namespace {

constexpr double kStep = 0.004, kWarmUp = 2;  // [s]

class Stepping {
 public:
  Stepping(Scene scene, FloorMotion floor) : scene_(std::move(scene)), floor_(std::move(floor)) {
    for (std::size_t i = 0; i < scene_.items.size(); ++i)
      state_.items.push_back(assembly_.items[i].placed(scene_.items[i].initial));
    for (std::size_t i = 0; i < scene_.items.size(); ++i)
      recorders_.emplace_back(scene_, assembly_, i, state_);
  }

  /// Allocations in steps up to `until`; those of the search for contacts apart.
  struct Count {
    long steps = 0, search = 0;
  };
  Count advance(double until) {
    const Stepper::Observer observer = [&](const Stepper::Step& step) {
      impacts_.observe(step);
      tethers_.observe(step);
      for (std::size_t i : step.island->items) recorders_[i].observe(step, impacts_.impacts_of(i));
    };
    Count count;
    while (time_ < until) {
      const double stop = search_.next(state_, time_, time_ + kStep);
      const long before = allocations;
      const std::vector<BodyContact>& contacts = search_.find(state_, stop - time_);
      const long found = allocations;
      stepper_.set_contacts(contacts, state_);
      EXPECT_FALSE(stepper_.advance(state_, stop, observer).has_value());
      count.search += found - before;
      count.steps += allocations - found;
      time_ = stop;
    }
    return count;
  }
  const SceneState& state() const { return state_; }

 private:
  Scene scene_;
  FloorMotion floor_;
  Assembly assembly_{scene_};
  SceneState state_;
  Stepper stepper_{assembly_, floor_, {.time_step = kStep}};
  ContactSearch search_{scene_, assembly_, true};
  ImpactLog impacts_{scene_, assembly_};
  TetherLog tethers_{assembly_, scene_.tethers.size()};
  std::vector<Recorder> recorders_;
  double time_ = 0;
};

#ifdef GURNEY_COUNTS_ALLOCATIONS
TEST(Allocation, IsCounted) {
  const long before = allocations;
  const Eigen::VectorXd of_eigen(7);
  const auto of_new = std::make_unique<int>(7);
  EXPECT_GE(allocations - before, 2);
}

// A trolley that rolls and sticks under a shaken floor, with all that pulls on it.
TEST(Allocation, AStepOfATrolleyMakesNone) {
  Scene scene = scene_of(small::trolley({0, 40, 80, 120}, small::bare_tread(3e5, 1e5)));
  scene.items[0].loads = {
      PointForce{.name = "push",
                 .point = {0, 0, 0.4},
                 .direction = {1, 0, 0},
                 .time = {0, 10},
                 .force = {20, 20}},
      DropWeight{.point = {0, 0, 0.4}, .direction = {1, 0, 0}, .mass = 1, .drop_height = 100}};
  scene.tethers = {{.name = "cord",
                    .item = 0,
                    .point = {0, 0, 0.6},
                    .anchor = {-0.5, 0.1, 0.6},
                    .slack_length = 0.5,
                    .stiffness = 2e3,
                    .damping = 50}};
  Stepping steps(scene, small::noise_record(7, 4, {3, 2, 1}));
  steps.advance(kWarmUp);
  const Stepping::Count count = steps.advance(2 * kWarmUp);
  EXPECT_EQ(count.steps, 0);
  EXPECT_EQ(count.search, 0);
}

// Two blocks on a sloping floor that press each other against a wall.
TEST(Allocation, AStepOfItemsThatPressEachOtherMakesNone) {
  Scene scene = blocks::block(10, {0.5, 0.4, 0.6}, {.friction = 0.1});
  blocks::add_wall(scene, 1, {.friction = 0.1});
  scene.pairs.push_back({"steel", "steel", {.friction = 0.1}});
  scene.slope = -0.5;
  scene.items.push_back(scene.items[0]);
  scene.items[0].name = "first";
  scene.items[1].name = "second";
  scene.items[0].initial.position = {0.74, 0, 0};
  scene.items[1].initial.position = {0.22, 0.05, 0};
  Stepping steps(scene, {});
  steps.advance(kWarmUp);
  ASSERT_GT(steps.state().contacts.size(), 8u) << "of the floor, the wall and each other";
  EXPECT_EQ(steps.advance(2 * kWarmUp).steps, 0);
}
#endif

}  // namespace
}  // namespace gurney
