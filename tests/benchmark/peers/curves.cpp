#include "tests/benchmark/peers/curves.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <map>

#include "tests/benchmark/peers/pace.h"
#include "tests/benchmark/workload.h"

namespace gurney::benchmark {
namespace {

using peers::Path;

struct Timed {
  Path path;
  double cpu;  ///< the least of the repetitions, for each simulated second [s]
};

/// Short runs twice: the first one meets cold caches.
Timed timed_path(const Engine& engine, const peers::CrossCheck& check, double step) {
  constexpr double kShort = 0.03;  // [s]
  Timed timed{{}, 0};
  for (int i = 0; i < 2; ++i) {
    const double start = cpu_time();
    timed.path = engine.run(check, step);
    const double cpu = cpu_time() - start;
    timed.cpu = i == 0 ? cpu : std::min(timed.cpu, cpu);
    if (cpu > kShort) break;
  }
  timed.cpu /= static_cast<double>(timed.path.size() - 1) * check.sampling;
  return timed;
}

/// Peaks of each engine's finest run, by motions.
using References = std::vector<std::vector<Peaks>>;

References references_of(const Job& job, const std::vector<Engine>& engines, double step) {
  References references;
  for (const Engine& engine : engines) {
    references.emplace_back();
    for (const peers::CrossCheck& check : job.runs)
      references.back().push_back(
          peaks_of(engine.fixed_step(check, step), check, engine.euler ? step : 0));
  }
  return references;
}

/// Of the engines that share the model: the median of their finest peak displacements, which one
/// engine alone cannot move far.
std::vector<double> common_truth(const References& references, const std::vector<Engine>& engines) {
  std::vector<double> truth;
  for (std::size_t r = 0; r < references[0].size(); ++r) {
    std::vector<double> peaks;
    for (std::size_t e = 0; e < engines.size(); ++e)
      if (engines[e].shared_model) peaks.push_back(references[e][r][0]);
    truth.push_back(median(peaks));
  }
  return truth;
}

Point point_of(const Job& job, const Engine& engine, double step, const std::vector<Peaks>& finest,
               const std::vector<double>& truth) {
  Point point{job.name, engine.name, engine.setup, step, engine.chooses_steps};
  std::array<std::vector<double>, 3> errors;
  std::vector<double> from_truth, finest_from_truth;
  for (std::size_t r = 0; r < job.runs.size(); ++r) {
    const Timed run = timed_path(engine, job.runs[r], step);
    point.cpu += run.cpu / static_cast<double>(job.runs.size());
    const Peaks peaks = peaks_of(run.path, job.runs[r], engine.euler ? step : 0);
    const auto error = relative_errors(peaks, finest[r]);
    from_truth.push_back(std::abs(peaks[0] / truth[r] - 1));
    finest_from_truth.push_back(std::abs(finest[r][0] / truth[r] - 1));
    for (std::size_t i = 0; i < 3; ++i) errors[i].push_back(error[i]);
  }
  for (std::size_t i = 0; i < 3; ++i) {
    point.error[i] = median(errors[i]);
    point.largest[i] = *std::ranges::max_element(errors[i]);
  }
  point.from_truth = median(from_truth);
  point.finest_from_truth = median(finest_from_truth);
  return point;
}

std::string step_text(const Point& point) {
  return point.tolerance ? fmt::format("tol {:g}", point.step)
                         : fmt::format("{:g} ms", 1e3 * point.step);
}

double judged(const Point& point, Criterion criterion) {
  switch (criterion) {
    case Criterion::kDisplacement:
      return point.error[0];
    case Criterion::kAllPeaks:
      return *std::ranges::max_element(point.error);
    case Criterion::kFromTruth:
      return point.from_truth;
  }
  return 0;
}

}  // namespace

std::vector<Point> work_precision(const Job& job, const std::vector<Engine>& engines,
                                  double finest_step) {
  const References references = references_of(job, engines, finest_step);
  const std::vector<double> truth = common_truth(references, engines);
  fmt::print("\n{}: motion, and common truth of its peak displacement [mm]:", job.name);
  for (std::size_t r = 0; r < truth.size(); ++r)
    fmt::print(" {}, {:.1f};", job.seeds[r], 1e3 * truth[r]);
  fmt::print("\n{:>7} {:>26} {:>10} {:>9} {:>36} {:>22}\n", "engine", "set-up", "step", "x real",
             "error %: displacement, tilt, accel.", "from truth %, finest");
  std::vector<Point> points;
  double before = pace();
  for (std::size_t e = 0; e < engines.size(); ++e)
    for (const double step : engines[e].steps) {
      Point point = point_of(job, engines[e], step, references[e], truth);
      const double after = pace();
      point.pace = 0.5 * (before + after);
      before = after;
      fmt::print("{:>7} {:>26} {:>10} {:>9.0f} {:>14.3f} {:>10.3f} {:>10.3f} {:>11.2f} {:>10.2f}\n",
                 point.engine, point.setup, step_text(point), 1 / point.cpu, 100 * point.error[0],
                 100 * point.error[1], 100 * point.error[2], 100 * point.from_truth,
                 100 * point.finest_from_truth);
      std::fflush(stdout);
      points.push_back(point);
    }
  return points;
}

void correct_pace(std::vector<Point>& points) {
  const double fastest = std::ranges::min(points, {}, &Point::pace).pace;
  for (Point& point : points) point.cpu *= fastest / point.pace;
}

void print_ratios(const std::vector<Point>& points, double bound, Criterion criterion) {
  std::vector<const Point*> cheapest;
  for (const Point& point : points) {
    if (judged(point, criterion) > bound) continue;
    const auto same = std::ranges::find_if(cheapest, [&](const Point* known) {
      return known->job == point.job && known->engine == point.engine &&
             known->setup == point.setup;
    });
    if (same == cheapest.end())
      cheapest.push_back(&point);
    else if (point.cpu < (*same)->cpu)
      *same = &point;
  }
  std::map<std::string, double> ours;
  for (const Point* point : cheapest)
    if (point->engine == "Gurney") {
      const auto known = ours.try_emplace(point->job, point->cpu).first;
      known->second = std::min(known->second, point->cpu);
    }
  constexpr const char* kNames[] = {
      "Peak displacement within {:g} % of the engine's own finest step",
      "All three peaks within {:g} % of the engine's own finest step",
      "Peak displacement within {:g} % of the common truth"};
  fmt::print("\n{}\n", fmt::format(fmt::runtime(kNames[static_cast<int>(criterion)]), 100 * bound));
  for (const Point* point : cheapest)
    fmt::print("{:>22} {:>7} {:>26} {:>10} {:>8.0f} x real{}\n", point->job, point->engine,
               point->setup, step_text(*point), 1 / point->cpu,
               ours.contains(point->job) ? fmt::format(", {:>6.1f} times Gurney's CPU time",
                                                       point->cpu / ours[point->job])
                                         : "");
}

void write_points(const std::vector<Point>& points, const std::string& file) {
  std::ofstream out(file);
  out << "job,engine,setup,time_step_ms,tolerance,cpu_s_per_simulated_s,error_displacement,"
         "error_tilt,error_acceleration,largest_error_displacement,largest_error_tilt,"
         "largest_error_acceleration,from_common_truth,finest_from_common_truth\n";
  for (const Point& p : points) {
    out << fmt::format("{},{},\"{}\",{},{},{:.4g}", p.job, p.engine, p.setup,
                       p.tolerance ? "" : fmt::format("{:g}", 1e3 * p.step),
                       p.tolerance ? fmt::format("{:g}", p.step) : "", p.cpu);
    for (const double error : p.error) out << fmt::format(",{:.4g}", error);
    for (const double error : p.largest) out << fmt::format(",{:.4g}", error);
    out << fmt::format(",{:.4g},{:.4g}\n", p.from_truth, p.finest_from_truth);
  }
}

}  // namespace gurney::benchmark
