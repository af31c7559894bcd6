#include "studies/report/failed_runs.h"

#include <fmt/format.h>

namespace gurney::report {

std::string failed_runs(std::size_t failed, std::size_t untrusted) {
  return fmt::format("{} failed", failed) +
         (untrusted > 0 ? fmt::format(" ({} untrusted)", untrusted) : "");
}

}  // namespace gurney::report
