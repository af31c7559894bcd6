#include "studies/cli/study_size.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/base/error.h"
#include "studies/run/estimate.h"

namespace gurney::cli {

std::string duration_text(double seconds) {
  if (seconds < 90) return fmt::format("{:.2g} s", seconds);
  if (seconds < 5400) return fmt::format("{:.0f} min", seconds / 60);
  return fmt::format("{:.1f} h", seconds / 3600);
}

std::string rounded_duration(double seconds) {
  if (seconds < 1.5) return "a second";
  if (seconds < 45)
    return fmt::format("{:.0f} s", seconds < 9.5 ? seconds : 5 * std::round(seconds / 5));
  return seconds < 90 ? "a minute" : duration_text(seconds);
}

std::string size_text(double bytes) {
  if (bytes < 1e6) return fmt::format("{:.0f} kB", std::max(1.0, bytes / 1e3));
  return bytes < 1e9 ? fmt::format("{:.0f} MB", bytes / 1e6)
                     : fmt::format("{:.1f} GB", bytes / 1e9);
}

void refuse_oversized(const study::Batch& batch) {
  if (static_cast<double>(batch.plan.runs()) <= kMaxRuns) return;
  const study::Estimate needs = study::estimate(batch);
  throw Error(fmt::format(
      "{}: the study has {} runs, which would take about {} on one core and {} of disk: at most "
      "{:.0f} runs are allowed; take fewer draws, records, angles or levels, or make several "
      "studies with other seeds",
      batch.job.file(), needs.runs, duration_text(needs.seconds(1)), size_text(needs.bytes()),
      kMaxRuns));
}

}  // namespace gurney::cli
