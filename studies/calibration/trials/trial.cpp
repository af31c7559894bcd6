#include "studies/calibration/trials/trial.h"

#include <fmt/format.h>

namespace gurney::calibration {

std::string TrialFault::text() const {
  return line > 0 ? fmt::format("{}:{}: {}", file, line, reason)
                  : fmt::format("{}: {}", file, reason);
}

int line_of(const Trial& trial, std::size_t index) {
  return index < trial.lines.size() ? trial.lines[index] : 0;
}

}  // namespace gurney::calibration
