#include <gtest/gtest.h>

#include <cmath>

#include "engine/base/units.h"
#include "engine/run/run.h"
#include "studies/verification/scenes/small_scenes.h"

// The same job by two programs that share no line of mechanics: ours in the rigid limit, and stock
// Bullet with its direct (Dantzig) contact solver, which is first order in time and lags the limit
// of the rolling resistance by a step: about h v_peak = 0.25 ms * 0.5 m/s of 0.1 to 0.3 m, 0.1 %.
namespace gurney {
namespace {

struct Job {
  Scene scene = scene_of({});
  FloorMotion floor;

  explicit Job(std::uint64_t seed) {
    Tread tread = small::bare_tread(3e8, 1e8);
    tread.normal_damping = 5e4;
    tread.tangential_damping = 1e3;
    tread.rolling_friction_length = 1e-3;
    scene.items[0].model = small::trolley({10, 105, 200, 295}, tread);
    floor = small::noise_record(seed, 7, kStandardGravity * Vector3(0.4, 0.3, 0.2));
  }
  Demands demands(Solver solver, double step) const {
    const Response response =
        gurney::run(scene, floor, {small::settings_for(step, 7, 100), solver});
    EXPECT_EQ(response.outcome, Outcome::kStopped) << response.cause;
    return response.items[0].demands;
  }
};

TEST(BulletJob, PeakDisplacementsAgreeWithTheDirectSolver) {
  for (const std::uint64_t seed : {21u, 22u, 23u}) {
    const Job job(seed);
    const Demands star = job.demands(Solver::kImplicit, 5e-4);
    const Demands direct = job.demands(Solver::kBulletDantzig, 2.5e-4);
    EXPECT_GT(star.peak_displacement, 0.02) << "seed " << seed;
    EXPECT_NEAR(star.peak_displacement, direct.peak_displacement, 0.005 * direct.peak_displacement)
        << "seed " << seed;
  }
}

}  // namespace
}  // namespace gurney
