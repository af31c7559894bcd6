#pragma once

#include "studies/analysis/study_data.h"
#include "studies/units/unit_system.h"

namespace gurney::study {

/// Unit of an intensity: the chosen one, else that in which the study states its levels where it is
/// their measure, else that of the job's units for all.
ReportUnit report_unit(const StudyData& data, const RunMeasure& measure);

}  // namespace gurney::study
