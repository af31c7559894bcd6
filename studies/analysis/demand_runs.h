#pragma once

#include <string>
#include <vector>

#include "studies/analysis/demands.h"
#include "studies/analysis/report_unit.h"

namespace gurney::study {

/// A demand of a run at its intensity, both SI.
struct DemandRun {
  double im = 0;
  double demand = 0;
  bool overturned = false;  ///< the item did: the demand has no upper bound
  std::size_t record = 0;
  std::size_t analysis_case = 0;  ///< runs that differ in their intensity alone share it
  std::string level = {};         ///< as the job states it: "0.3 g"
  std::size_t run = 0;            ///< its number in the file
};

/// One demand in several configurations.
struct DemandRuns {
  std::string item, column;  ///< column: "peak_displacement"
  ReportUnit unit;
  std::string measure;
  ReportUnit measure_unit;
  struct Configuration {
    std::string name;
    std::vector<DemandRun> runs;  ///< with a demand and an intensity > 0
  };
  std::vector<Configuration> configurations = {};
};

/// For each item, or point, whose demand has this name, in the order of the items.
/// @throws Error with the nearest name, or where no run has this demand
std::vector<DemandRuns> demand_runs(const StudyData& data,
                                    const std::vector<std::size_t>& configurations,
                                    const std::string& demand, const RunMeasure& measure);

}  // namespace gurney::study
