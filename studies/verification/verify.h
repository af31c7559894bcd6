#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "studies/verification/family.h"

namespace gurney::verification {

/// Selection of cases to run.
struct Selection {
  std::vector<std::string> names;     ///< groups, families or `family/case`; none: all
  std::optional<std::uint64_t> seed;  ///< of fresh parameters in place of the cases of the list
  int draws = 1;                      ///< of each family, with the seeds that follow
  bool stock = true;                  ///< also on stock Bullet, where it can
};

/// A case on a stock solver: only its errors are of interest.
struct StockRun {
  std::string solver;
  Findings findings;
};

struct CaseRun {
  const Family* family = nullptr;
  Case set;
  Findings findings;
  std::vector<StockRun> stock;
  double seconds = 0;

  std::string name() const { return family->statement.name + '/' + set.name; }
};

/// The cases chosen, not yet run, in the order of the list.
/// @param families  must live as long as the result
/// @throws Error for a name that nothing has, with the nearest one
std::vector<CaseRun> choose(const std::vector<Family>& families, const Selection& selection);

/// Runs a case: its findings, its time and, if `stock`, the stock solvers. What it throws is a
/// check that failed.
void run(CaseRun& chosen, bool stock);

/// Runs all of them with `threads`; calls `done` for each in their order, as soon as it can. The
/// numbers do not depend on the threads.
void run_all(std::vector<CaseRun>& chosen, bool stock, int threads,
             const std::function<void(const CaseRun&)>& done);

}  // namespace gurney::verification
