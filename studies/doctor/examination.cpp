#include "studies/doctor/examination.h"

#include "studies/doctor/determinism.h"
#include "studies/doctor/installation.h"
#include "studies/doctor/machine.h"

namespace gurney::doctor {

std::vector<Finding> examination() {
  return {program(), libraries(), cpu(),     arithmetic(), data(),
          threads(), memory(),    disk("."), figures(),    determinism()};
}

}  // namespace gurney::doctor
