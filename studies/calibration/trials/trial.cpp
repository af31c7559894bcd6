#include "studies/calibration/trials/trial.h"

#include <fmt/format.h>

#include "engine/base/random/normal_draw.h"

namespace gurney::calibration {
namespace {

void add_noise(std::vector<double>& series, double deviation, std::uint64_t seed,
               std::uint64_t stream, std::uint64_t first) {
  for (std::size_t i = 0; i < series.size(); ++i)
    series[i] += deviation * normal_draw(seed, stream, first + i);
}

}  // namespace

std::string TrialFault::text() const {
  return line > 0 ? fmt::format("{}:{}: {}", file, line, reason)
                  : fmt::format("{}: {}", file, reason);
}

void refuse(const Trial& trial, std::size_t index, const std::string& reason) {
  throw UnusableTrial({trial.file, index < trial.lines.size() ? trial.lines[index] : 0, reason});
}

Trial with_noise(Trial trial, std::uint64_t seed, std::uint64_t stream) {
  TrialSignals& s = trial.signals;
  add_noise(s.displacement, kDisplacementNoise, seed, 2 * stream, 0);
  add_noise(s.force, kForceNoise, seed, 2 * stream + 1, 0);
  add_noise(s.lateral, kDisplacementNoise, seed, 2 * stream, s.time.size());
  return trial;
}

std::vector<double> rate(const std::vector<double>& time, const std::vector<double>& series) {
  constexpr std::size_t kSide = 4;
  std::vector<double> result(series.size(), std::nan(""));
  for (std::size_t i = kSide; i + kSide < series.size(); ++i)
    result[i] = (series[i + kSide] - series[i - kSide]) / (time[i + kSide] - time[i - kSide]);
  return result;
}

}  // namespace gurney::calibration
