#include "groundmotions/synthetic/clough_penzien.h"

#include <fmt/format.h>

#include <cassert>
#include <cmath>
#include <numbers>

#include "engine/base/error.h"
#include "engine/base/random/normal_draw.h"
#include "engine/base/units.h"
#include "groundmotions/formats/writers.h"
#include "groundmotions/measures/peaks.h"
#include "groundmotions/measures/response_spectrum.h"
#include "groundmotions/synthetic/component.h"

namespace gurney::groundmotions {
namespace {

using std::numbers::pi;

double envelope(const SyntheticComponent& component, double time) {
  const double ratio = time / component.peak_time;
  return std::pow(ratio * std::exp(1 - ratio), component.envelope_power);
}

}  // namespace

Eigen::VectorXd clough_penzien_noise(const SyntheticMotion& motion, Direction direction) {
  const auto stream = static_cast<std::size_t>(direction);
  const SyntheticComponent& component = motion.components[stream];
  const double og = component.ground_frequency, zg = component.ground_damping;
  const double of = component.low_cut_frequency, zf = component.low_cut_damping;
  Oscillator ground(og, zg, motion.time_step), low_cut(of, zf, motion.time_step);
  Eigen::VectorXd acceleration(motion.samples);
  double noise = 0, base = 0;
  acceleration[0] = 0;
  for (int i = 1; i < motion.samples; ++i) {
    const double next_noise = envelope(component, i * motion.time_step) *
                              normal_draw(motion.seed, stream, static_cast<std::uint64_t>(i));
    ground.step(-noise, -next_noise);
    noise = next_noise;
    const double next_base = -2 * zg * og * ground.velocity() - og * og * ground.displacement();
    low_cut.step(-base, -next_base);
    base = next_base;
    acceleration[i] = -base - 2 * zf * of * low_cut.velocity() - of * of * low_cut.displacement();
  }
  return acceleration;
}

Record synthetic_record(const SyntheticMotion& motion) {
  assert(motion.time_step > 0 && motion.samples > 2);
  Record record;
  record.name = fmt::format("synthetic {}", motion.seed);
  for (const Direction direction : kDirections) {
    const auto index = static_cast<std::size_t>(direction);
    Component component;
    component.name = name_of(direction);
    component.direction = direction;
    component.time_step = motion.time_step;
    component.unit = "m/s2";
    component.acceleration = clough_penzien_noise(motion, direction);
    set_end_state(motion.time_step, component.acceleration);
    component.acceleration *=
        motion.components[index].peak_acceleration / component.acceleration.cwiseAbs().maxCoeff();
    record.components[index] = std::move(component);
  }
  return record;
}

SyntheticMotion shipped_synthetic_motion() {
  const SyntheticComponent horizontal{.peak_time = 6,
                                      .envelope_power = 3,
                                      .ground_frequency = 5 * pi,
                                      .ground_damping = 0.6,
                                      .low_cut_frequency = 0.4 * pi,
                                      .low_cut_damping = 0.6};
  SyntheticMotion motion{.seed = 1, .time_step = 0.005, .samples = 6001, .components = {}};
  motion.components = {horizontal, horizontal, horizontal};
  motion.components[0].peak_acceleration = 0.4 * kStandardGravity;
  motion.components[1].peak_acceleration = 0.3 * kStandardGravity;
  SyntheticComponent& vertical = motion.components[2];
  vertical.peak_acceleration = 0.2 * kStandardGravity;
  vertical.peak_time = 4.5;
  vertical.ground_frequency = 10 * pi;
  vertical.low_cut_frequency = 0.8 * pi;
  return motion;
}

std::string shipped_synthetic_text() {
  const SyntheticMotion motion = shipped_synthetic_motion();
  std::vector<std::string> comments = {
      "SYNTHETIC ground motion, made by Gurney. It was never recorded anywhere.",
      "Modulated white noise through Kanai-Tajimi and Clough-Penzien filters;",
      "equations and sources: docs/theory/synthetic_record.md.",
      "Made again by: cmake --build --preset release --target make_synthetic_record",
      fmt::format("seed {}, time step {} s, {} samples", motion.seed, motion.time_step,
                  motion.samples)};
  for (const Direction direction : kDirections) {
    const SyntheticComponent& c = motion.components[static_cast<std::size_t>(direction)];
    comments.push_back(fmt::format(
        "{}: peak {:.2f} g; envelope t_p {} s, p {}; omega_g {:.4f} rad/s, zeta_g {}; "
        "omega_f {:.4f} rad/s, zeta_f {}",
        name_of(direction), c.peak_acceleration / kStandardGravity, c.peak_time, c.envelope_power,
        c.ground_frequency, c.ground_damping, c.low_cut_frequency, c.low_cut_damping));
  }
  return columns_csv_text(synthetic_record(motion), comments);
}

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
