#include "studies/analysis/report_unit.h"

namespace gurney::study {

ReportUnit report_unit(const StudyData& data, const RunMeasure& measure) {
  const IntensityPlan& plan = data.study().intensity;
  const bool stated = plan.unit_in_si != 1 && !data.units().chosen() &&
                      measure.name == data.file().text_attribute("intensity_measure");
  if (stated) return {plan.unit, plan.unit_in_si};
  return data.units().of(measure.units);
}

}  // namespace gurney::study
