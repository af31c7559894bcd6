#pragma once

#include "studies/findings/findings.h"
#include "studies/hospital/hospital_answer.h"

namespace gurney::report {

findings::Section hospital_findings(const study::Hospital& hospital,
                                    const study::HospitalAnswer& answer);

}  // namespace gurney::report
