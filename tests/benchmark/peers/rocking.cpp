#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <fstream>

#include "engine/base/units.h"
#include "tests/benchmark/peers/curves.h"
#include "tests/benchmark/workload.h"

namespace gurney::benchmark {
namespace {

/// All motions of the job on one engine at one step.
struct Runs {
  std::vector<peers::Path> paths;
  std::vector<double> displacement, tilt;
  double cpu = 0;  ///< for each simulated second [s]
  int overturned = 0;
};

Runs run_all(const Job& job, double step,
             const std::function<peers::Path(const peers::CrossCheck&, double)>& run) {
  Runs runs;
  double simulated = 0;
  const double start = cpu_time();
  for (const peers::CrossCheck& check : job.runs) runs.paths.push_back(run(check, step));
  const double cpu = cpu_time() - start;
  for (std::size_t r = 0; r < job.runs.size(); ++r) {
    const peers::Path& path = runs.paths[r];
    const Peaks peaks = peaks_of(path, job.runs[r], 0);
    simulated += static_cast<double>(path.size() - 1) * job.runs[r].sampling;
    runs.displacement.push_back(peaks[0]);
    runs.tilt.push_back(peaks[1]);
    runs.overturned += path.back().tilt >= peers::kOverturned;
  }
  runs.cpu = cpu / simulated;
  return runs;
}

double median_agreement(const Runs& a, const Runs& b) {
  std::vector<double> times;
  for (std::size_t r = 0; r < a.paths.size(); ++r)
    times.push_back(agreement(a.paths[r], b.paths[r], kSampling));
  return median(times);
}

}  // namespace

void print_rocking(const Job& job, const std::vector<Engine>& engines, double finest_step,
                   const std::string& file) {
  const std::size_t n = job.runs.size();
  fmt::print("\n{}: {} motions; medians\n{:>7} {:>26} {:>10} {:>9} {:>10} {:>14} {:>10} {:>22}\n",
             job.name, n, "engine", "set-up", "step", "x real", "overturned", "displacement mm",
             "tilt deg", "agrees: finest, Gurney s");
  std::ofstream out(file);
  out << "engine,setup,time_step_ms,tolerance,cpu_s_per_simulated_s,motions,overturned,"
         "median_peak_displacement_mm,median_peak_tilt_deg,agrees_with_own_finest_until_s,"
         "own_finest_agrees_with_gurney_until_s\n";
  const auto ours = std::ranges::find_if(
      engines, [](const Engine& e) { return e.name == "Gurney" && e.shared_model; });
  const Runs truth = run_all(job, finest_step, ours->fixed_step);
  for (const Engine& engine : engines) {
    const Runs finest = run_all(job, finest_step, engine.fixed_step);
    const double apart = median_agreement(finest, truth);
    const auto row = [&](const std::string& step, const std::string& columns, const Runs& runs) {
      const double here = median_agreement(runs, finest);
      const double mm = 1e3 * median(runs.displacement);
      const double degrees = median(runs.tilt) / kRadiansPerDegree;
      fmt::print("{:>7} {:>26} {:>10} {:>9.0f} {:>7}/{} {:>14.1f} {:>10.2f} {:>10.2f} {:>10.2f}\n",
                 engine.name, engine.setup, step, 1 / runs.cpu, runs.overturned, n, mm, degrees,
                 here, apart);
      std::fflush(stdout);
      out << fmt::format("{},\"{}\",{},{:.4g},{},{},{:.4g},{:.4g},{:.4g},{:.4g}\n", engine.name,
                         engine.setup, columns, runs.cpu, n, runs.overturned, mm, degrees, here,
                         apart);
    };
    for (const double step : engine.steps) {
      const Runs runs = run_all(job, step, engine.run);
      if (engine.chooses_steps)
        row(fmt::format("tol {:g}", step), fmt::format(",{:g}", step), runs);
      else
        row(fmt::format("{:g} ms", 1e3 * step), fmt::format("{:g},", 1e3 * step), runs);
    }
    if (!engine.chooses_steps)
      row(fmt::format("{:g} ms", 1e3 * finest_step), fmt::format("{:g},", 1e3 * finest_step),
          finest);
  }
}

}  // namespace gurney::benchmark
