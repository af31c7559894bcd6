#pragma once

#include <string>
#include <vector>

#include "tests/benchmark/peers/engines.h"
#include "tests/benchmark/peers/jobs.h"
#include "tests/benchmark/peers/measures.h"

namespace gurney::benchmark {

/// An engine at one step on one job.
struct Point {
  std::string job, engine, setup;
  double step = 0;  ///< [s], or the tolerance
  bool tolerance = false;
  double cpu = 0;                   ///< for each simulated second, mean of the motions [s]
  double pace = 0;                  ///< of the machine meanwhile (pace.h) [s]
  std::array<double, 3> error{};    ///< of the peaks from the engine's own finest, median
  std::array<double, 3> largest{};  ///< the same, largest of the motions
  double from_truth = 0;            ///< of the peak displacement from the common truth, median
  double finest_from_truth = 0;     ///< the same of the engine's finest
};

/// Prints a line for each, with CPU times as they are measured.
std::vector<Point> work_precision(const Job& job, const std::vector<Engine>& engines,
                                  double finest_step);

/// Corrects CPU times to the machine's fastest pace.
void correct_pace(std::vector<Point>& points);

/// What must be within the bound: the error of the peak displacement, that of all three peaks, or the
/// distance of the peak displacement from the common truth.
enum class Criterion { kDisplacement, kAllPeaks, kFromTruth };

/// The cheapest point of each engine and set-up within the bound, and how many times its CPU time is
/// that of Gurney's cheapest.
void print_ratios(const std::vector<Point>& points, double bound, Criterion criterion);

void write_points(const std::vector<Point>& points, const std::string& file);

/// What can be said of a chaotic job: distributions, and times until runs part.
void print_rocking(const Job& job, const std::vector<Engine>& engines, double finest_step,
                   const std::string& file);

/// The half-locked cart by methods and set-ups that differ in their friction, and moved along x alone.
void print_sliding(bool quick, const std::string& file);

/// Error of the peak displacement over CPU time, a panel for each job.
std::string curves_figure(const std::vector<Point>& points);

}  // namespace gurney::benchmark
