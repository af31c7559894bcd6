#pragma once

#include <string>
#include <vector>

#include "engine/run/run.h"
#include "engine/run/simulate.h"

/// What the benchmarks run: the shipped pulling-test trolley under synthetic three-component
/// motions.
namespace gurney::benchmark {

/// The trolley of equipment/items/xu_trolley.toml with its casters at `headings_deg`.
Scene trolley(const std::vector<double>& headings_deg);

/// Treads so stiff that they act as rigid, and no scrub: the only scene all solvers share.
void make_rigid(Scene& scene, double normal_stiffness, double tangential_stiffness);

/// Synthetic motion of one seed, horizontal peak `peak_g` (the other horizontal 0.75 of it), 20 s.
FloorMotion shaking(unsigned seed, double peak_g, double vertical_ratio = 0.5);

/// A pull of 40 N for 3 s along x at the height of the centre of mass, then coasting.
PointForce pull();

/// Closed form of `pull` on aligned casters: displacement at release and at rest [m].
struct PullReference {
  double at_release, at_rest;
};
PullReference pull_reference(const Scene& scene);

/// CPU time of this thread [s].
double cpu_time();

/// Seconds of wall time of one run, the best of `repeats`, and its response.
struct Timed {
  Response response;
  double seconds;
};
Timed timed(const Scene& scene, const FloorMotion& floor, const RunOptions& settings, int repeats);

}  // namespace gurney::benchmark
