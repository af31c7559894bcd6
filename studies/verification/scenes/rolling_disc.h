#pragma once

#include <array>
#include <functional>

#include "engine/response/response.h"
#include "engine/scene/scene.h"
#include "engine/scene/settings.h"

/// A disc that rolls on its edge without slip, in 3D.
namespace gurney {

/// Mass m, radius r, inertia C about its axle and A about a diameter.
struct Disc {
  double mass, radius;
  double axial;         ///< C / (m r^2): 1/2 a disc, 1 a hoop
  double crumb = 1e-5;  ///< mass of the chassis over m, and of the fork

  double m() const { return mass * (1 + 2 * crumb); }
  double C() const { return axial * mass * radius * radius; }
  double A() const;
  /// Speed above which straight rolling is stable: sqrt(g r / 3) of a disc, sqrt(g r / 4) of a
  /// hoop.
  double critical_speed() const;
  /// x'' = -stiffness x for a small lean x of straight rolling at v.
  double stiffness(double v) const;
};

/// With the axle a, the unit vector u from the contact to the centre, and the angular velocity w,
/// the centre moves with v = r w x u, and
///
///     d/dt [A w + (C - A) (w . a) a] = -r u x [m (dv/dt + g z) - F]
///
/// (Routh, Advanced Rigid Dynamics; O'Reilly 1996), F a push at the centre along the level
/// direction of the axle. Runge-Kutta steps of fourth order.
class DiscReference {
 public:
  DiscReference(const Disc& disc, const Vector3& axle, const Vector3& angular_velocity)
      : disc_(disc), state_{axle, angular_velocity, Vector3::Zero()} {}

  void advance(double duration);

  /// Goes on for `duration` while a push makes the axle's height a_z follow a_z'' = `height_rate2`.
  void advance_led(double duration, const std::function<double(double time)>& height_rate2);

  /// The push that gives a_z'' = height_rate2 now [N].
  double push_for(double height_rate2) const { return push_for(state_, height_rate2); }

  double time() const { return time_; }
  const Vector3& axle() const { return state_[0]; }
  const Vector3& angular_velocity() const { return state_[1]; }
  const Vector3& moved() const { return state_[2]; }  ///< of the centre [m]

 private:
  using State = std::array<Vector3, 3>;  // axle, angular velocity, displacement of the centre
  static State sum(const State& y, double h, const State& k);
  State rates(const State& y, double push) const;
  double push_for(const State& y, double height_rate2) const;
  template <class Push>
  void integrate(double duration, Push push);

  Disc disc_;
  State state_;
  double time_ = 0;
};

inline constexpr double kDiscTread = 1e7;  // normal and tangential stiffness [N/m]

/// The disc as the wheel of one rigid caster without trail, upright at the origin, rolling along x
/// at `speed` and turning at `yaw_rate`. Its chassis has the mass of a crumb at the wheel's centre
/// and an inertia equal in all directions: it takes part in m and A and not in C, and without
/// friction on the axle never turns about it. Marked point: the centre.
/// @param tread  its normal and tangential stiffness [N/m]
Scene rolling_disc(const Disc& disc, double speed, double yaw_rate, double tread = kDiscTread);

/// An error proportional to the square of the step is a third of what halving the step changed, and
/// one proportional to the compliance of the tread what doubling that changes. Both are taken with
/// half as much again or more.
inline constexpr const char* kDiscTolerance =
    "half of what halving the step changed, of which a method of second order leaves a third; "
    "twice what a tread half as stiff changes, as much as the tread itself";

/// Runs it for exactly `duration`; keeps every `stride`-th step. The chassis, which does not turn
/// about the axle, pitches as the disc turns on a circle: what the engine gives for its tilt and of
/// overturning means nothing here.
SimulationSettings disc_settings(double step, double duration, int stride);

/// The axle's direction; it starts along y.
inline Vector3 disc_axle(const Sample& sample) { return sample.orientation * Vector3::UnitY(); }

}  // namespace gurney
