#pragma once

#include <string>

#include "studies/study/analysis/study_data.h"

namespace gurney::study {

/// A unit that reports and figures print values in.
struct ReportUnit {
  std::string name;
  double in_si = 1;
};

/// Of an intensity: the unit in which the study states its levels where it is their measure; else
/// that of report_unit(measure.units).
ReportUnit report_unit(const StudyData& data, const RunMeasure& measure);

/// Of a demand: g for accelerations, deg for angles, else the SI unit itself.
ReportUnit report_unit(const std::string& si);

}  // namespace gurney::study
