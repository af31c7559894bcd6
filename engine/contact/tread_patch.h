#pragma once

#include "engine/contact/one_sided_spring.h"
#include "engine/contact/tread_quantities.h"

/// The equations of TreadLaw, for one tread or for four.
namespace gurney {

/// A patch whose force is this share of its friction limit slides: rounding must not make it stick.
inline constexpr double kAtLimit = 1 - 1e-12;

template <class T>
struct TreadNormal {
  T force{}, slope{}, damping_force{};
};

template <class T>
TreadNormal<T> tread_normal(const TreadConstants<T>& c, const TreadStage<T>& stage, const T& u_z) {
  const T compression = stage.compression - stage.tau * u_z;
  const T elastic = c.normal_stiffness * compression;
  const T damping = -c.normal_damping * u_z;
  const T elastic_slope = c.normal_stiffness * stage.tau;
  const Mask<T> off = compression <= T{}, leaves = damping <= -elastic, lands = damping >= elastic;
  const auto chosen = [&](const T& at_least, const T& at_most, const T& between) {
    return select(off, T{}, select(leaves, at_least, select(lands, at_most, between)));
  };
  return {chosen(T{}, elastic + elastic, elastic + damping),
          chosen(T{}, elastic_slope + elastic_slope, elastic_slope + c.normal_damping),
          chosen(-elastic, elastic, damping)};
}

/// @param size  of `force.patch`
template <class T>
void limit_patch(const Mask<T>& slides, const T& size, const T& limit, const T& limit_slope,
                 TreadForce<T>& force, TreadSlope<T>& slope) {
  const Vec3<T> direction = force.patch / size;
  const T stuck = slope.patch.x.x, share = limit / size;
  const Vec3<T> scaled = stuck * direction;
  const auto column = [&](const Vec3<T>& unlimited, const T& along) {
    return select(slides, share * (unlimited - along * scaled), unlimited);
  };
  slope.patch = {column(slope.patch.x, direction.x), column(slope.patch.y, direction.y),
                 column(slope.patch.z, direction.z)};
  slope.by_normal = select(slides, limit_slope * direction, Vec3<T>());
  force.patch = select(slides, limit * direction, force.patch);
}

template <class T>
void tread_force(const TreadConstants<T>& c, const TreadStage<T>& stage, const TreadRates<T>& u,
                 TreadForce<T>& force, TreadSlope<T>& slope) {
  const TreadNormal<T> n = tread_normal(c, stage, u.normal);
  const Vec3<T> trial = stage.memory * (stage.deflection + stage.tau * u.patch);
  force.patch = stage.damping_rate * stage.deflection - stage.stiffness * trial;
  const T stuck = stage.stiffness * stage.memory * stage.tau;
  slope.patch = diagonal(stuck);
  slope.by_normal = {};
  const T limit = stage.mu * n.force, size = norm(force.patch);
  const Mask<T> slides = size > limit;
  if (any(slides)) limit_patch<T>(slides, size, limit, stage.mu * n.slope, force, slope);

  const auto roll = c.roll.evaluate(stage.roll_deflection, u.roll,
                                    c.rolling_friction_length * n.force, stage.tau);
  force.normal = n.force;
  force.roll = roll.torque;
  slope.normal = n.slope;
  slope.roll_by_normal = roll.limit_slope * c.rolling_friction_length * n.slope;
  slope.roll = roll.rate_slope;
  const Mask<T> off = n.force <= T{};
  if (any(off)) {
    force = {select(off, Vec3<T>(), force.patch), select(off, T{}, force.normal),
             select(off, T{}, force.roll)};
    const Mat3<T>& s = slope.patch;
    slope = {
        {select(off, Vec3<T>(), s.x), select(off, Vec3<T>(), s.y), select(off, Vec3<T>(), s.z)},
        select(off, Vec3<T>(), slope.by_normal),
        select(off, T{}, slope.normal),
        select(off, T{}, slope.roll_by_normal),
        select(off, T{}, slope.roll)};
  }
}

/// Energy stored in its springs [J].
template <class T>
T tread_energy(const TreadConstants<T>& c, const T& compression, const Vec3<T>& deflection,
               const T& roll_deflection) {
  const T d = select(compression > T{}, compression, T{});
  return 0.5 * (c.normal_stiffness * d * d + c.tangential_stiffness * dot(deflection, deflection) +
                c.roll.stiffness * roll_deflection * roll_deflection);
}

/// TreadLaw::Result of four treads, and TreadLaw::spring_rates.
template <class T>
struct TreadOutcome {
  T compression{}, compression_rate{};
  T sliding_power{}, rolling_power{}, relaxation_power{}, damping_power{}, slip_speed{};
  T spring_rates{};
  Vec3<T> deflection;
  T roll_deflection{};
  Mask<T> slides{}, rolls{};
};

template <class T>
TreadOutcome<T> tread_outcome(const TreadConstants<T>& c, const TreadStage<T>& stage,
                              const TreadRates<T>& u, const TreadForce<T>& force) {
  TreadOutcome<T> result;
  result.compression = stage.compression - stage.tau * u.normal;
  result.compression_rate = -u.normal;
  const TreadNormal<T> n = tread_normal(c, stage, u.normal);
  const Mask<T> on = !(n.force <= T{});
  const auto if_on = [&](const T& value) { return select(on, value, T{}); };

  const Vec3<T>& patch = force.patch;
  const Vec3<T>& start = stage.deflection;
  const Vec3<T> end = (stage.damping_rate * start - patch) / stage.stiffness;
  const Vec3<T> rate = (end - start) / stage.tau;
  const Vec3<T> relaxation = stage.forgetting_rate * end;
  const Vec3<T> slip = u.patch - relaxation - rate;
  result.slides = on & (norm(patch) >= kAtLimit * stage.mu * n.force);
  const T lost = -dot(patch, slip);
  const T damped = -n.damping_force * u.normal;
  const T on_floor = damped + c.tangential_damping * dot(rate, rate);
  result.relaxation_power = if_on(-dot(patch, relaxation));
  result.sliding_power = select(result.slides, lost, T{});
  result.slip_speed = select(result.slides, sqrt(slip.x * slip.x + slip.y * slip.y), T{});
  // Off the floor the patch springs back at once; of one that sticks `lost` is rounding.
  result.damping_power = select(on, select(result.slides, on_floor, on_floor + lost), damped);
  result.deflection = select(on, end, Vec3<T>());

  const auto roll = c.roll.evaluate(stage.roll_deflection, u.roll,
                                    c.rolling_friction_length * n.force, stage.tau);
  result.roll_deflection = if_on(roll.deflection);
  result.rolls = on & roll.slips;
  const T elastic_rate = (roll.deflection - stage.roll_deflection) / stage.tau;
  result.rolling_power = if_on(-roll.torque * (u.roll - elastic_rate));

  const Vec3<T> patch_rate = (result.deflection - start) / stage.tau;
  const T roll_rate = (result.roll_deflection - stage.roll_deflection) / stage.tau;
  result.spring_rates =
      one_sided_rates(c.normal_stiffness, stage.compression, result.compression, stage.tau) +
      c.tangential_stiffness * dot(patch_rate, patch_rate) +
      c.roll.stiffness * roll_rate * roll_rate;
  return result;
}

}  // namespace gurney
