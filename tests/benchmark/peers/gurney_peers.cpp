#include <fmt/core.h>

#include <exception>
#include <filesystem>
#include <fstream>
#include <string>

#include "tests/benchmark/peers/curves.h"

namespace gurney::benchmark {
namespace {

/// Writes peers.csv and peers.svg.
void smooth(const std::filesystem::path& folder, bool quick) {
  const std::vector<double> tolerances = {0.1, 0.03, 0.01, 0.003, 0.001};
  const auto all = quick ? engines({0.004}, {0.01})
                         : engines({0.02, 0.01, 0.005, 0.004, 0.002, 0.001, 0.0005}, tolerances);
  std::vector<Point> points;
  for (const Job& job : smooth_jobs(quick ? 1 : 3)) {
    const std::vector<Point> of_job = work_precision(job, all, quick ? 0.002 : 0.00025);
    points.insert(points.end(), of_job.begin(), of_job.end());
  }
  correct_pace(points);
  for (const double error : {0.005, 0.01, 0.05}) {
    print_ratios(points, error, Criterion::kDisplacement);
    print_ratios(points, error, Criterion::kAllPeaks);
    print_ratios(points, error, Criterion::kFromTruth);
  }
  write_points(points, folder / "peers.csv");
  std::ofstream(folder / "peers.svg") << curves_figure(points);
}

/// Writes peers_rocking.csv.
void rocking(const std::filesystem::path& folder, bool quick) {
  print_rocking(rocking_job(quick ? 2 : 12),
                quick ? engines({0.004}, {0.003}) : engines({0.004, 0.001}, {0.003}),
                quick ? 0.002 : 0.0005, folder / "peers_rocking.csv");
}

}  // namespace
}  // namespace gurney::benchmark

/// Gurney, Bullet, MuJoCo and ODE on four jobs: gurney_peers FOLDER [--quick | --smooth | --sliding |
/// --rocking].
int main(int argc, char** argv) try {
  const std::filesystem::path folder = argc > 1 ? argv[1] : "out/peers";
  const std::string part = argc > 2 ? argv[2] : "";
  std::filesystem::create_directories(folder);
  const bool quick = part == "--quick", all = quick || part.empty();
  if (all || part == "--smooth") gurney::benchmark::smooth(folder, quick);
  if (all || part == "--sliding")
    gurney::benchmark::print_sliding(quick, (folder / "peers_sliding.csv").string());
  if (all || part == "--rocking") gurney::benchmark::rocking(folder, quick);
  return 0;
} catch (const std::exception& error) {
  fmt::print(stderr, "{}\n", error.what());
  return 1;
}
