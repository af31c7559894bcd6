#pragma once

#include <string>
#include <vector>

#include "studies/limit_states/limit_state.h"
#include "studies/run/run_task.h"

namespace gurney::study {

/// Setting that a convergence study varies.
enum class Varied { kTimeStep, kSolverTolerance, kTreadStiffness };

/// A factor on what the job states.
struct Variant {
  Varied varied = Varied::kTimeStep;
  double factor = 1;
};

/// The job itself, first; then twice, a half, a quarter and an eighth of its time step (twice only
/// within the engine's range); 1000 times and a hundredth of its solver tolerance; a quarter, a
/// half, twice and four times its tread stiffness.
std::vector<Variant> variants_for(const SimulationSettings& settings);

/// The stiffness is that of treads, normal and tangential; their damping is proportional to its
/// square root, so that the share of critical damping stays.
RunCase varied(RunCase run, const Variant& variant);

/// The runs of a job that stand for it: its only one, or a sample of a study's.
struct ConvergenceCases {
  std::vector<RunCase> runs;             ///< without histories
  std::vector<std::string> names;        ///< of the runs: what each is
  std::size_t of_runs = 1;               ///< that the job has; of an IDA: the most there can be
  std::vector<LimitState> limit_states;  ///< of a study; else empty
};

/// A study's runs are taken at equal distances through its plan, each at the next of its levels, so
/// that all configurations, records and levels have their share. Of an IDA they are its first
/// steps.
/// @param most  runs that are taken, >= 1
/// @throws Error with every error of the job, and for a study of which no draw makes a job
ConvergenceCases convergence_cases(const std::string& job, std::size_t most, int threads);

/// How a number changes as the time step is halved.
enum class StepVerdict {
  kConverged,   ///< its change down to the smallest step is within the tolerance
  kConverging,  ///< it is not, but the changes shrink: a smaller step helps
  kScattered,   ///< of a sample: the change is small beside what other runs would give
  kSensitive,   ///< the changes do not shrink: the number of one run means little
};
std::string name_of(StepVerdict verdict);

/// A demand of an item (of several runs: its median) or the share of runs that exceed a limit
/// state.
struct ConvergedNumber {
  std::string item;  ///< empty: a limit state
  std::string name, units;
  std::size_t runs = 0;        ///< that have it in every variant
  std::vector<double> values;  ///< one for each variant
  double scatter = 0;          ///< of a sample: half the 95 % interval of the number; else 0
  double change = 0;           ///< |job's - smallest step's| over the larger
  double order = 0;            ///< observed order of the step; NaN: not to be determined
  StepVerdict step = StepVerdict::kConverged;
  double step_needed = 0;       ///< of kConverging: the time step that should do [s]
  double solver_change = 0;     ///< relative change with a hundredth of the solver tolerance
  double stiffness_change = 0;  ///< largest with half and twice the tread stiffness
};

struct Convergence {
  SimulationSettings settings;  ///< of the job
  double tolerance = 0;
  std::vector<Variant> variants;
  std::vector<ConvergedNumber> numbers;
  std::vector<std::string> failed;  ///< runs that failed in a variant, with the cause
  std::size_t runs = 0, of_runs = 0;
};

/// Runs every case in every variant and judges each demand.
///
/// Order of the step from three steps, log2(|v(h) - v(h/2)| / |v(h/2) - v(h/4)|) (Roache 1994,
/// J. Fluids Engineering 116(3), 405-413), and with it the step that should do,
/// h (tolerance / change)^(1/p) with p between 0.5 and 2. Changes below what could be measured
/// (0.1 mm, 1 mm/s, 1e-4 rad, 0.1 N, 0.1 N s, a time step) count as none.
/// @param tolerance  relative, > 0
/// @param threads    >= 1; the numbers do not depend on it
Convergence converge(const ConvergenceCases& cases, double tolerance, int threads);

/// |a - b| over the larger of both; 0 where they differ by `smallest` or less.
double relative_change(double a, double b, double smallest);

/// Fills change, order, verdicts of a number from its values.
/// @param smallest  change that counts as none, in the number's unit, >= 0
void judge(ConvergedNumber& number, const std::vector<Variant>& variants,
           const SimulationSettings& settings, double tolerance, double smallest);

}  // namespace gurney::study
