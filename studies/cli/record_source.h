#pragma once

#include <functional>
#include <string>
#include <vector>

#include "groundmotions/record/record.h"
#include "groundmotions/suites/suite.h"

namespace gurney::cli {

/// Which records a `records` command works on, and what is done to them first.
struct RecordSource {
  std::vector<std::string> paths;  ///< record files, folders, lists, PEER search reports
  groundmotions::ReadOptions options;
  std::vector<std::string> steps;  ///< such as "high_pass corner_hz=0.1"
  bool tells_findings = true;      ///< record_findings() on stderr; false: the command shows them
};

void add_source_options(Options& add, RecordSource& source);

/// Collects records whose samples are too far apart for the shortest period of a command's spectra.
class ShortPeriods {
 public:
  explicit ShortPeriods(double shortest) : shortest_(shortest) {}  ///< [s]; 0: no spectra
  void take(const groundmotions::Record& record);
  std::string warning() const;  ///< one for all records; empty: their samples are close enough

 private:
  double shortest_, time_step_ = 0;
  std::size_t records_ = 0, coarse_ = 0;
};

/// Reads the records one after the other, processes them and hands each to `use`. Progress goes to
/// stderr where that is a terminal. Records that cannot be read are reported on stderr, and the
/// others go on.
/// @param refused  all that was left out, with reasons; may be null
/// @returns the exit code: 0, or 1 if a file that was named on the command line is no record or
///          nothing was read
/// @throws Error for paths that do not exist, wrong options and steps
int for_each_record(const RecordSource& source, std::vector<groundmotions::Refusal>* refused,
                    const std::function<void(const groundmotions::SuiteRecord&,
                                             const groundmotions::Record&)>& use);

}  // namespace gurney::cli
