#include "studies/study/analysis/report_unit.h"

#include "engine/base/units.h"

namespace gurney::study {

ReportUnit report_unit(const StudyData& data, const RunMeasure& measure) {
  const IntensityPlan& plan = data.study().intensity;
  if (plan.unit_in_si != 1 && measure.name == data.file().text_attribute("intensity_measure"))
    return {plan.unit, plan.unit_in_si};
  return report_unit(measure.units);
}

ReportUnit report_unit(const std::string& si) {
  if (si == "m/s2") return {"g", kStandardGravity};
  if (si == "rad") return {"deg", kRadiansPerDegree};
  if (si == "rad/s") return {"deg/s", kRadiansPerDegree};
  if (si == "rad/s2") return {"deg/s2", kRadiansPerDegree};
  return {si, 1};
}

}  // namespace gurney::study
