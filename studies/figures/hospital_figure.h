#pragma once

#include <string>

#include "studies/hospital/hospital_answer.h"

namespace gurney::figures {

/// How each service works at each level, and what to secure first, as SVG.
std::string hospital_figure(const study::Hospital& hospital, const study::HospitalAnswer& answer);

}  // namespace gurney::figures
