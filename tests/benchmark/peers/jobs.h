#pragma once

#include <string>
#include <vector>

#include "tests/peers/cross_check.h"

/// Work-precision curves of Gurney and of other engines: docs/performance.md.
namespace gurney::benchmark {

inline constexpr double kDuration = 12;    // [s]
inline constexpr double kSampling = 0.02;  // [s]; every step is a whole fraction of it
inline constexpr double kRigid = 3e7, kRigidTangential = 1e7;  // treads that act as rigid [N/m]

/// One scene under several motions. Treads are the item's own, but without scrub and with
/// mu_s = mu_k, and bearings have no friction: what the other engines can have.
struct Job {
  std::string name;
  std::vector<unsigned> seeds;
  std::vector<peers::CrossCheck> runs;  ///< one for each seed
};

/// The four-swivel trolley free, between walls, and with two casters locked; the first motions of
/// which Gurney calls these predictable.
std::vector<Job> smooth_jobs(int motions);
Job free_trolley_job(int motions);
Job half_locked_job(int motions);

/// The ventilator with all brakes on, under strong motions: chaotic.
Job rocking_job(int motions);

/// The same scene on treads that act as rigid.
Scene with_rigid_treads(const Scene& scene);

}  // namespace gurney::benchmark
