#include "groundmotions/synthetic/long_period.h"

#include <cmath>
#include <numbers>

#include "engine/base/error.h"
#include "groundmotions/measures/integrate.h"
#include "groundmotions/measures/peaks.h"
#include "groundmotions/synthetic/clough_penzien.h"
#include "groundmotions/synthetic/component.h"
#include "groundmotions/synthetic/end_state.h"
#include "groundmotions/synthetic/taper.h"

namespace gurney::groundmotions {

Record long_period_motion(const LongPeriodMotion& m) {
  constexpr double kAnyPeak = 1;  // replaced by the peak velocity below
  constexpr double kLowCutDamping = 0.6, kTaperShare = 10;
  const SyntheticComponent ground{.peak_acceleration = kAnyPeak,
                                  .peak_time = m.peak_time,
                                  .envelope_power = m.envelope_power,
                                  .ground_frequency = 2 * std::numbers::pi / m.ground_period,
                                  .ground_damping = m.ground_damping,
                                  .low_cut_frequency = 2 * std::numbers::pi / m.low_cut_period,
                                  .low_cut_damping = kLowCutDamping};
  const SyntheticMotion noise{
      .seed = m.seed,
      .time_step = m.time_step,
      .samples = static_cast<int>(std::lround(m.duration / m.time_step)) + 1,
      .components = {ground, ground, ground}};
  const double end = (noise.samples - 1) * m.time_step, taper = m.duration / kTaperShare;
  const Eigen::VectorXd window = Eigen::VectorXd::NullaryExpr(noise.samples, [&](Eigen::Index i) {
    return trapezoid_taper(static_cast<double>(i) * m.time_step, end, taper);
  });
  Record record;
  for (const Direction direction : {Direction::kH1, Direction::kH2}) {
    const auto index = static_cast<std::size_t>(direction);
    if (m.peak_velocity[index] == 0) continue;
    Eigen::VectorXd a =
        acceleration_of(m.time_step, integrated(m.time_step, clough_penzien_noise(noise, direction))
                                         .displacement.cwiseProduct(window));
    a *= m.peak_velocity[index] / peaks(m.time_step, a).velocity;
    record.components[index] = synthetic_component(direction, m.time_step, std::move(a));
  }
  require(record.samples() > 0, "a long-period motion needs a peak velocity > 0");
  return record;
}

}  // namespace gurney::groundmotions
