#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <string>
#include <thread>
#include <vector>

#include "engine/run/simulate.h"
#include "studies/verification/scenes/small_scenes.h"

// The same scene gives the same bits: again, on another thread, and whether or not Bullet's
// collision passes are skipped while nothing can be near.
namespace gurney {
namespace {

struct Job {
  Scene scene = scene_of({});
  FloorMotion floor;
  SimulationSettings settings = small::settings_for(0.004, 5, 5);
};

Job shaken_job() {
  Job job;
  job.scene.items[0].model = small::trolley({10, 100, 200, 300}, Tread());
  job.floor = small::noise_record(5, 4, {4, 3, 2});
  return job;
}

/// A trolley with a skirt 40 mm above the floor, pushed over until the skirt touches and carries.
Job tipping_job() {
  Job job;
  job.scene.items[0].model = small::trolley({0, 90, 180, 270}, Tread());
  job.scene.items[0].model.shape.push_back({{0, 0, 0.125}, {1.2, 0.9, 0.2}});
  job.scene.items[0].loads = {
      PointForce{"push", {0, 0, 1.0}, {0, 1, 0}, {0, 0.3, 0.6, 0.9}, {0, 340, 340, 0}}};
  job.settings.duration = 4;
  return job;
}

/// A trolley that rolls over a kerb and on against `ahead`, shaken.
Job room_job(const decltype(RoomShape::shape)& ahead) {
  Job job;
  job.scene.items[0].model = small::trolley({0, 90, 180, 270}, Tread());
  job.scene.items[0].initial.velocity = {1.8, 0.3, 0};
  job.scene.room = {
      {"kerb", "", {0.8, 0, 0}, Quaternion::Identity(), RoomBox{{0.1, 6, 0.008}}},
      {"ahead", "", {1.1, 0.1, 1.3}, Quaternion::Identity(), ahead},  // above the wheels
  };
  job.floor = small::noise_record(7, 2, {4, 3, 2});
  job.settings.duration = 2;
  return job;
}

std::vector<Job> room_jobs() {
  return {room_job(RoomBox{{0.2, 6, 2}}), room_job(RoomColumn{0.1, 2}),
          room_job(RoomHull{{{-0.1, 0, -1},
                             {0.3, -0.2, -1},
                             {0.3, 0.2, -1},
                             {-0.1, 0, 1},
                             {0.3, -0.2, 1},
                             {0.3, 0.2, 1}}})};
}

Job with_tolerance(Job job) {
  job.settings.tolerance = 0.003;
  return job;
}

std::vector<Job> all_jobs() {
  std::vector<Job> jobs = room_jobs();
  jobs.push_back(shaken_job());
  jobs.push_back(tipping_job());
  jobs.push_back(with_tolerance(room_jobs().front()));
  return jobs;
}

Response run(const Job& job) { return simulate(job.scene, job.floor, job.settings); }

bool same(double a, double b) { return std::memcmp(&a, &b, sizeof a) == 0; }

/// Whether two runs agree in every bit of what matters: motion, forces, energy.
void expect_same_bits(const Response& a, const Response& b) {
  ASSERT_EQ(a.items[0].history.size(), b.items[0].history.size());
  EXPECT_EQ(a.outcome, b.outcome);
  for (std::size_t i = 0; i < a.items[0].history.size(); ++i) {
    const Sample &s = a.items[0].history[i], &t = b.items[0].history[i];
    bool equal = same(s.time, t.time) && same(s.yaw, t.yaw) && same(s.tilt, t.tilt);
    for (int k = 0; k < 3; ++k)
      equal &= same(s.displacement[k], t.displacement[k]) && same(s.velocity[k], t.velocity[k]) &&
               same(s.points[0].absolute_acceleration[k], t.points[0].absolute_acceleration[k]);
    for (std::size_t w = 0; w < 4; ++w)
      equal &= same(s.wheels[w].normal_force, t.wheels[w].normal_force) &&
               same(s.wheels[w].lateral_force, t.wheels[w].lateral_force) &&
               same(s.wheels[w].swivel_angle, t.wheels[w].swivel_angle);
    equal &= same(s.energy.loss(), t.energy.loss()) && same(s.energy.stored(), t.energy.stored());
    ASSERT_TRUE(equal) << "at " << s.time << " s";
  }
  EXPECT_TRUE(same(a.items[0].demands.peak_displacement, b.items[0].demands.peak_displacement));
  EXPECT_TRUE(same(a.quality.largest_residual, b.quality.largest_residual));
  EXPECT_EQ(a.quality.newton_iterations, b.quality.newton_iterations);
}

TEST(Determinism, ASecondRunGivesTheSameBits) {
  for (const Job& job : all_jobs()) expect_same_bits(run(job), run(job));
}

TEST(Determinism, ThreadsDoNotDisturbEachOther) {
  for (const Job& job : {shaken_job(), tipping_job(), with_tolerance(shaken_job())}) {
    const Response alone = run(job);
    Response a, b;
    std::thread first([&] { a = run(job); }), second([&] { b = run(job); });
    first.join();
    second.join();
    expect_same_bits(alone, a);
    expect_same_bits(alone, b);
  }
}

TEST(Determinism, SkippedCollisionPassesChangeNoBit) {
  for (Job job : all_jobs()) {
    const Response skipping = run(job);
    job.settings.skip_clear_collision_passes = false;
    const Response every = run(job);
    expect_same_bits(skipping, every);
    EXPECT_GT(every.quality.collision_passes, skipping.quality.collision_passes);
    // One pass for each time step, more only in a room, where fast wheels are searched for at least
    // every 20 mm; what contacts need between is solved with the same contacts.
    const auto steps = std::lround(job.settings.duration / job.settings.time_step);
    EXPECT_GE(every.quality.collision_passes, steps);
    if (job.scene.room.empty()) {
      EXPECT_EQ(every.quality.collision_passes, steps);
    }
    EXPECT_LE(every.quality.collision_passes, every.quality.steps);
    ASSERT_EQ(every.quality.subdivided_steps, 0);
  }
}

TEST(Determinism, TheRoomsOfTheseTestsAreMet) {
  for (const Job& job : room_jobs()) {
    const Response response = run(job);
    const auto met = [&](bool chassis, const std::string& other) {
      return std::any_of(response.impacts.begin(), response.impacts.end(),
                         [&](const Impact& impact) {
                           return (impact.body == "chassis") == chassis && impact.other == other;
                         });
    };
    EXPECT_TRUE(met(true, "ahead"));
    EXPECT_TRUE(met(false, "kerb"));
  }
}

TEST(BodyContact, ATippingChassisLandsOnItsSkirtAndDoesNotSink) {
  const Job job = tipping_job();
  const Response response = run(job);
  ASSERT_EQ(response.outcome, Outcome::kStopped) << response.cause;
  const BodyShape& skirt = job.scene.items[0].model.shape.back();
  const double bottom = skirt.center.z() - 0.5 * skirt.size.z(), edge = 0.5 * skirt.size.y();
  const double sink =
      response.items[0].history[0].wheels[0].normal_force / Tread().normal_stiffness;
  double lowest = 1, tilt = 0;
  for (const Sample& sample : response.items[0].history) {
    tilt = std::max(tilt, sample.tilt);
    // It tilts about x: height of the skirt's lower edge above the floor.
    lowest = std::min(lowest, sample.displacement.z() - sink + bottom * std::cos(sample.tilt) -
                                  edge * std::sin(sample.tilt));
  }
  // The edge, 0.25 m outside the wheels and 25 mm up, touches at atan(0.025 / 0.25) = 0.1 rad.
  EXPECT_GT(tilt, 0.12);
  // The weight on two points of 1e6 N/m sinks 0.5 mm, landing doubles it.
  EXPECT_LT(lowest, 0);
  EXPECT_GT(lowest, -1.5e-3);
  EXPECT_GT(response.items[0].energy.contact_loss, 1);
  EXPECT_EQ(response.quality.unconverged_steps, 0);
  // It falls back onto its casters and stands there.
  EXPECT_LT(response.items[0].history.back().tilt, 0.002);
}

TEST(BodyContact, TheEnergyAccountClosesWithTheTimeStep) {
  // What contacts store, and what they lose when Bullet reports them elsewhere, counts: 1.2 % of
  // the work would be missing at any step. The rest is the integrator's, O(h).
  Job job = tipping_job();
  EXPECT_LT(run(job).quality.energy_closure, 4e-3);
  job.settings.time_step = 0.001;
  EXPECT_LT(run(job).quality.energy_closure, 1e-3);
}

}  // namespace
}  // namespace gurney
