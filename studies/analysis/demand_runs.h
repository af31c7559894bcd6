#pragma once

#include <limits>
#include <string>
#include <vector>

#include "studies/analysis/demands.h"
#include "studies/analysis/study_data.h"

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

/// The intensities at which a study's runs were made.
struct RunLevels {
  /// As the job states them: "0.3 g", "x 1.5" for a factor. One, "all", after an IDA, which finds
  /// other intensities for each record.
  std::vector<std::string> texts;
  bool traced = false;
  std::vector<std::size_t> of_run;  ///< for each run of the file: index in texts
};

RunLevels run_levels(const StudyData& data);

/// The demands of one analysis case as its record is scaled (Vamvatsikos & Cornell 2002, EESD
/// 31(3), 491-514), up to the first overturning.
struct IdaCurve {
  std::vector<double> im, demand;  ///< im increases; the first point is (0, 0)
  /// Where the item overturns: the geometric mean of the intensities around it (that above where
  /// there is none below); infinity: it does not.
  double capacity = std::numeric_limits<double>::infinity();

  /// Linear between the runs; infinity from `capacity` on; NaN: above the last run.
  double demand_at(double intensity) const;
};

std::vector<IdaCurve> ida_curves(const std::vector<DemandRun>& runs);

/// The demand that a fraction of the curves does not exceed at an intensity, of those known there:
/// linear between the ordered values, the i-th of n standing at (i - 1/2) / n (Hazen 1914).
/// Infinity where that many have overturned; NaN where fewer than half of the curves are known.
double fractile_at(const std::vector<IdaCurve>& curves, double intensity, double fraction);

}  // namespace gurney::study
