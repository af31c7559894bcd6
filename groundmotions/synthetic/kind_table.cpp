#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/base/append_all.h"
#include "engine/base/units.h"
#include "groundmotions/synthetic/ac156.h"
#include "groundmotions/synthetic/clough_penzien.h"
#include "groundmotions/synthetic/harmonic.h"
#include "groundmotions/synthetic/kinds.h"
#include "groundmotions/synthetic/noise.h"
#include "groundmotions/synthetic/pulses.h"
#include "groundmotions/synthetic/rezaeian.h"

namespace gurney::groundmotions {

namespace {

using config::Range;
using std::numbers::pi;
using Values = SyntheticValues;

constexpr double kG = kStandardGravity;
const char* const kElementary = "closed form; docs/theory/synthetic_motions.md";

const SyntheticParameter kSeed{"seed", "of the random numbers", 1, Range::not_negative()};
const SyntheticParameter kTimeStep{"time_step_s", "of the samples", 0.005,
                                   Range::within(0.0005, 0.05)};
const SyntheticParameter kPga{"pga_g", "peak acceleration", 0.4, Range::positive()};
const SyntheticParameter kPeriod{"period_s", "of the sine", 1, Range::positive()};
const SyntheticParameter kDuration{"duration_s", "of the motion with its tapers", 30,
                                   Range::within(0, 3600).open_below()};
const SyntheticParameter kTaper{"taper_s", "of each end", 3, Range::positive()};

std::uint64_t seed_of(const Values& v) { return static_cast<std::uint64_t>(v.at("seed")); }

Record make_harmonic(const Values& v) {
  return harmonic(v.at("time_step_s"), {.peak_acceleration = v.at("pga_g") * kG,
                                        .frequency = v.at("frequency_hz"),
                                        .duration = v.at("duration_s"),
                                        .taper = v.at("taper_s")});
}

Record make_sweep(const Values& v, bool logarithmic) {
  return sweep(v.at("time_step_s"), {.peak_acceleration = v.at("pga_g") * kG,
                                     .first_frequency = v.at("first_frequency_hz"),
                                     .last_frequency = v.at("last_frequency_hz"),
                                     .duration = v.at("duration_s"),
                                     .taper = v.at("taper_s"),
                                     .logarithmic = logarithmic});
}

Record make_noise(const Values& v) {
  return white_noise(v.at("time_step_s"),
                     {.seed = seed_of(v),
                      .lowest_frequency = v.at("lowest_frequency_hz"),
                      .highest_frequency = v.at("highest_frequency_hz"),
                      .duration = v.at("duration_s"),
                      .taper = v.at("taper_s"),
                      .peak_acceleration = {v.at("pga_h1_g") * kG, v.at("pga_h2_g") * kG,
                                            v.at("pga_vertical_g") * kG}});
}

Record make_clough_penzien(const Values& v) {
  SyntheticComponent ground{.peak_acceleration = v.at("pga_h1_g") * kG,
                            .peak_time = v.at("peak_time_s"),
                            .envelope_power = v.at("envelope_power"),
                            .ground_frequency = 2 * pi * v.at("ground_frequency_hz"),
                            .ground_damping = v.at("ground_damping"),
                            .low_cut_frequency = 2 * pi * v.at("low_cut_frequency_hz"),
                            .low_cut_damping = v.at("low_cut_damping")};
  const double step = v.at("time_step_s");
  SyntheticMotion motion{
      .seed = seed_of(v),
      .time_step = step,
      .samples = 1 + static_cast<int>(std::lround(std::max(4., v.at("duration_s") / step))),
      .components = {ground, ground, ground}};
  motion.components[1].peak_acceleration = v.at("pga_h2_g") * kG;
  SyntheticComponent& up = motion.components[2];
  up.peak_acceleration = v.at("pga_vertical_g") * kG;
  up.peak_time = v.at("vertical_peak_time_s");
  up.ground_frequency *= v.at("vertical_frequency_ratio");
  up.low_cut_frequency *= v.at("vertical_frequency_ratio");
  Record record = synthetic_record(motion);
  constexpr double kGone = 0.01;
  const double ratio = v.at("duration_s") / std::max(ground.peak_time, up.peak_time);
  const double left = std::pow(ratio * std::exp(1 - ratio), ground.envelope_power);
  if (ratio < 1 || left > kGone)
    record.components[0]->warnings.push_back(
        fmt::format("the envelope is still at {:.2g} of its peak at the end of {:g} s: what makes "
                    "the motion end at rest is a long drift; take a longer duration",
                    left, v.at("duration_s")));
  return record;
}

Record make_long_period(const Values& v) {
  return long_period_motion({.seed = seed_of(v),
                             .time_step = v.at("time_step_s"),
                             .duration = v.at("duration_s"),
                             .peak_velocity = {v.at("pgv_h1_m_per_s"), v.at("pgv_h2_m_per_s")},
                             .ground_period = v.at("ground_period_s"),
                             .ground_damping = v.at("ground_damping"),
                             .low_cut_period = v.at("low_cut_period_s"),
                             .peak_time = v.at("peak_time_s"),
                             .envelope_power = v.at("envelope_power")});
}

std::vector<SyntheticParameter> pulse_parameters() {
  return {{"amplitude_m_per_s", "A, the peak velocity for phase 0", 0.8, Range::positive()},
          {"period_s", "1 / f_p", 2, Range::positive()},
          {"gamma", "length of the envelope in periods", 1.5, Range::within(1, 20).open_below()},
          {"phase_deg", "nu; 90 comes back to its place", 90, Range::within(-360, 360)}};
}

std::vector<SyntheticParameter> stochastic_parameters() {
  return {
      kSeed,
      {"time_step_s", "of the samples", 0.01, Range::within(0.0005, 0.02)},
      {"arias_m_per_s", "expected Arias intensity of h1", 1, Range::positive()},
      {"arias_ratio_h2", "Arias intensity of h2 to h1; 0: none", 0.8, Range::not_negative()},
      {"arias_ratio_vertical", "Arias intensity up to h1; 0: none", 0.3, Range::not_negative()},
      {"significant_duration_s", "D5-95", 12, Range::positive()},
      {"middle_s", "time at which 45 % of the energy has come", 8, Range::positive()},
      {"frequency_hz", "of the filter at middle_s", 5, Range::positive()},
      {"frequency_slope_hz_per_s", "of the filter", -0.1, Range::any()},
      {"filter_damping", "of the filter", 0.3, Range::within(0, 1).open_below().open_above()},
      {"corner_frequency_hz", "of the high-pass", 0.1, Range::positive()},
      {"vertical_frequency_ratio", "of the filter, vertical to horizontal", 2, Range::positive()}};
}

std::vector<SyntheticParameter> joined(std::vector<SyntheticParameter> first,
                                       const std::vector<SyntheticParameter>& second) {
  append_all(first, second);
  return first;
}

Record make_stochastic(const Values& v) {
  const StochasticComponent h1{.arias_intensity = v.at("arias_m_per_s"),
                               .duration = v.at("significant_duration_s"),
                               .middle = v.at("middle_s"),
                               .frequency = v.at("frequency_hz"),
                               .frequency_slope = v.at("frequency_slope_hz_per_s"),
                               .damping = v.at("filter_damping")};
  StochasticMotion motion{.seed = seed_of(v),
                          .time_step = v.at("time_step_s"),
                          .corner_frequency = v.at("corner_frequency_hz"),
                          .components = {h1, h1, h1}};
  motion.components[1].arias_intensity *= v.at("arias_ratio_h2");
  motion.components[2].arias_intensity *= v.at("arias_ratio_vertical");
  motion.components[2].frequency *= v.at("vertical_frequency_ratio");
  motion.components[2].frequency_slope *= v.at("vertical_frequency_ratio");
  return stochastic_motion(motion);
}

NearFaultPulse pulse_of(const Values& v) {
  return {.amplitude = v.at("amplitude_m_per_s"),
          .period = v.at("period_s"),
          .gamma = v.at("gamma"),
          .phase = v.at("phase_deg") * kRadiansPerDegree};
}

/// The middle of the pulse at that of the noise, but not before its first sample.
Record make_near_fault(const Values& v) {
  const NearFaultPulse pulse = pulse_of(v);
  const double start = std::max(0., v.at("middle_s") - pulse.gamma * pulse.period / 2);
  return with_pulse(make_stochastic(v), pulse, start);
}

Record make_ac156(const Values& v) {
  return ac156_motion({.seed = seed_of(v),
                       .time_step = v.at("time_step_s"),
                       .short_period_acceleration = v.at("sds_g") * kG,
                       .height_ratio = v.at("height_ratio"),
                       .low_cut = v.at("low_cut_hz")});
}

std::vector<SyntheticParameter> sweep_parameters() {
  return {kTimeStep,
          kPga,
          {"first_frequency_hz", "at the start", 0.5, Range::positive()},
          {"last_frequency_hz", "at the end", 10, Range::positive()},
          kDuration,
          kTaper};
}

std::vector<SyntheticKind> table() {
  return {
      {"half_sine",
       "half a sine of acceleration; leaves a velocity",
       kElementary,
       {kTimeStep, kPga, kPeriod},
       [](const Values& v) {
         return half_sine(v.at("time_step_s"), v.at("pga_g") * kG, v.at("period_s"));
       }},
      {"full_sine",
       "one sine of acceleration: a step of the ground (fling)",
       kElementary,
       {kTimeStep, kPga, kPeriod},
       [](const Values& v) {
         return full_sine(v.at("time_step_s"), v.at("pga_g") * kG, v.at("period_s"));
       }},
      {"step",
       "constant acceleration with short ramps; leaves a velocity",
       kElementary,
       {kTimeStep,
        kPga,
        {"rise_s", "of each ramp", 0.05, Range::positive()},
        {"hold_s", "at the peak", 0.5, Range::not_negative()}},
       [](const Values& v) {
         return acceleration_step(v.at("time_step_s"), v.at("pga_g") * kG, v.at("rise_s"),
                                  v.at("hold_s"));
       }},
      {"double_impulse",
       "two opposite impulses; leaves a displacement",
       "after Kojima & Takewaki (2015), with impulses of finite width",
       {kTimeStep,
        {"pgv_m_per_s", "change of velocity of each impulse", 0.5, Range::positive()},
        {"width_s", "of each impulse", 0.1, Range::positive()},
        {"interval_s", "between their middles", 0.5, Range::positive()}},
       [](const Values& v) {
         return double_impulse(v.at("time_step_s"), v.at("pgv_m_per_s"), v.at("width_s"),
                               v.at("interval_s"));
       }},
      {"ricker",
       "Ricker wavelet of acceleration",
       "Ricker (1943)",
       {kTimeStep, kPga, kPeriod},
       [](const Values& v) {
         return ricker_wavelet(v.at("time_step_s"), v.at("pga_g") * kG, v.at("period_s"));
       }},
      {"near_fault_pulse", "near-fault velocity pulse", "Mavroeidis & Papageorgiou (2003)",
       joined({kTimeStep}, pulse_parameters()),
       [](const Values& v) { return near_fault_pulse(v.at("time_step_s"), pulse_of(v)); }},
      {"harmonic",
       "sine of constant frequency with tapered ends",
       kElementary,
       {kTimeStep, kPga, {"frequency_hz", "of the sine", 1, Range::positive()}, kDuration, kTaper},
       make_harmonic},
      {"sweep_linear", "sine, the frequency changes evenly in time", kElementary,
       sweep_parameters(), [](const Values& v) { return make_sweep(v, false); }},
      {"sweep_logarithmic", "sine, as many octaves in every second", kElementary,
       sweep_parameters(), [](const Values& v) { return make_sweep(v, true); }},
      {"white_noise",
       "noise of constant density between two frequencies",
       kElementary,
       {kSeed,
        kTimeStep,
        {"pga_h1_g", "peak acceleration of h1; 0: none", 0.3, Range::not_negative()},
        {"pga_h2_g", "peak acceleration of h2; 0: none", 0, Range::not_negative()},
        {"pga_vertical_g", "peak acceleration up; 0: none", 0, Range::not_negative()},
        {"lowest_frequency_hz", "of the band", 0.5, Range::positive()},
        {"highest_frequency_hz", "of the band", 30, Range::positive()},
        kDuration,
        kTaper},
       make_noise},
      {"clough_penzien",
       "noise through the Kanai-Tajimi and Clough-Penzien filters",
       "Clough & Penzien (1975); docs/theory/synthetic_record.md",
       {kSeed,
        kTimeStep,
        {"pga_h1_g", "peak acceleration of h1", 0.4, Range::positive()},
        {"pga_h2_g", "peak acceleration of h2", 0.3, Range::positive()},
        {"pga_vertical_g", "peak acceleration up", 0.2, Range::positive()},
        {"duration_s", "of the motion", 30, Range::within(1, 3600)},
        {"peak_time_s", "of the envelope, h1 and h2", 6, Range::positive()},
        {"vertical_peak_time_s", "of the envelope, vertical", 4.5, Range::positive()},
        {"envelope_power", "of the envelope", 3, Range::positive()},
        {"ground_frequency_hz", "of the ground", 2.5, Range::positive()},
        {"ground_damping", "of the ground", 0.6, Range::within(0, 1).open_below().open_above()},
        {"low_cut_frequency_hz", "of the low-cut filter", 0.2, Range::positive()},
        {"low_cut_damping", "of the low-cut filter", 0.6,
         Range::within(0, 1).open_below().open_above()},
        {"vertical_frequency_ratio", "of both filters, vertical to horizontal", 2,
         Range::positive()}},
       make_clough_penzien},
      {"long_period",
       "minutes of long-period motion, as in deep basins",
       "Clough & Penzien (1975) with the ground of a basin; docs/theory/synthetic_motions.md",
       {kSeed,
        {"time_step_s", "of the samples", 0.01, Range::within(0.0005, 0.05)},
        {"pgv_h1_m_per_s", "peak velocity of h1; 0: none", 0.8, Range::not_negative()},
        {"pgv_h2_m_per_s", "peak velocity of h2; 0: none", 0.6, Range::not_negative()},
        {"duration_s", "of the motion", 300, Range::within(10, 3600)},
        {"ground_period_s", "of the basin", 4, Range::positive()},
        {"ground_damping", "of the basin", 0.15, Range::within(0, 1).open_below().open_above()},
        {"low_cut_period_s", "of the low-cut filter", 12, Range::positive()},
        {"peak_time_s", "of the envelope", 80, Range::positive()},
        {"envelope_power", "of the envelope", 1.5, Range::positive()}},
       make_long_period},
      {"stochastic", "noise whose strength and frequency change with time",
       "Rezaeian & Der Kiureghian (2010)", stochastic_parameters(), make_stochastic},
      {"near_fault", "velocity pulse on h1 in stochastic motion of three components",
       "Mavroeidis & Papageorgiou (2003); Rezaeian & Der Kiureghian (2010)",
       joined(stochastic_parameters(), pulse_parameters()), make_near_fault},
      {"ac156",
       "three-component floor motion for the required spectrum of AC156",
       "ICC-ES AC156 (2010), matched as by Gasparini & Vanmarcke (1976)",
       {kSeed,
        {"time_step_s", "of the samples", 0.002, Range::within(0.0005, 0.005)},
        {"sds_g", "S_DS, design spectral acceleration at short periods", 1, Range::positive()},
        {"height_ratio", "z/h, height of the floor to that of the roof", 1, Range::within(0, 1)},
        {"low_cut_hz", "no energy below", 0.9, Range::within(0.3, 1.1)}},
       make_ac156}};
}

}  // namespace

const std::vector<SyntheticKind>& synthetic_kinds() {
  static const std::vector<SyntheticKind> kinds = table();
  return kinds;
}

}  // namespace gurney::groundmotions
