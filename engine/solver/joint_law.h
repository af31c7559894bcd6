#pragma once

#include <array>
#include <cmath>
#include <optional>

#include "engine/contact/dry_friction.h"
#include "engine/contact/impact_law.h"
#include "engine/response/energy_account.h"
#include "engine/scene/joint.h"
#include "engine/solver/mechanism.h"
#include "engine/solver/state.h"

namespace gurney {

/// The law of a joint: rows, each a force along one generalised direction of the part relative to its
/// base (docs/theory/parts.md).
///
/// With the row's directions d_p and d_b, a value e and its rate u = d_p . V_p - d_b . V_b, the part
/// feels -T d_p and the base T d_b. Directions are those of the base, and forces on it act at the
/// part's point, so that momentum and its moment are kept whatever the joint yields. In directions
/// that a joint holds
///
///     T = k (e + T_c u),   k = m omega_c^2,
///
/// m being the mass that the joint carries: the constraint e = 0 returns with the time T_c, and
/// yields by g / omega_c^2, 0.1 um, under the part's weight. In those it leaves free T is that
/// of its spring and damper; along q also of friction, stops and latch.
///
/// A tether between two items is one too: a row along the line between its ends, towards the base, and one of
/// its slack pull (cord_law.h). It holds nothing; its latch is its strength, and it is latched until it breaks.
class JointLaw {
 public:
  static constexpr double kHoldFrequency = 1e4;  ///< omega_c [rad/s]
  static constexpr double kHoldTime = 0.01;      ///< T_c [s]
  /// Stuck friction and a latch yield by this until they let go [m], [rad].
  static constexpr double kYield = 1e-4;
  /// A latch nearer than this to its release lets go [m], [rad].
  static constexpr double kReleaseDistance = 1e-9;
  /// A latch that catches its part again does so when that is so near and slow [m, rad], [m/s, rad/s].
  static constexpr double kCatchRange = 1e-3, kCatchSpeed = 0.05;

  /// @param carried  mass of the part and of all that hangs on it [kg]
  JointLaw(const Joint& joint, const Mechanism& base, const Mechanism& part, double carried);
  /// @param index  of the tether, in Scene::tethers
  JointLaw(const Tether& tether, std::size_t index, const Mechanism& anchor_item,
           const Mechanism& item);

  const Joint& joint() const { return joint_; }
  /// Index in Scene::tethers; none: it is a joint.
  std::optional<std::size_t> tether() const {
    return cord_ ? std::optional(tether_index_) : std::nullopt;
  }

  struct Row {
    Vector6 part, base;  ///< d_p, d_b
    double value = 0;    ///< e [m], [rad]
    double stiffness = 0, damping = 0;
    bool holds = false;

    double rate(const Vector6& of_part, const Vector6& of_base) const {
      return part.dot(of_part) - base.dot(of_base);
    }
  };
  static constexpr std::size_t kRows = 6;
  struct Rows {
    std::array<Row, kRows> rows;
    std::size_t count = 0;
    std::optional<std::size_t> along;  ///< the row of q
  };
  /// @param turn  q before, from which an angle is not further than half a turn
  Rows rows(const Pose& base, const Pose& part, double turn) const;

  JointState initial_state() const;

  /// One implicit stage of length tau. Values are those at zero rate: e = value + tau u.
  struct Stage {
    double tau = 0;
    Rows rows;
    JointState start;
    double ahead = 0;  ///< as ImpactLaw::Stage
  };
  struct Force {
    double force = 0;  ///< T
    double slope = 0;  ///< dT/du >= 0
  };
  Force force(const Stage& stage, std::size_t row, double rate) const;

  /// Adds the powers of losses, and returns the sum of k e'^2 of springs
  /// (EnergyAccount::numerical_loss). What a held direction takes while the integration's error of its
  /// constraint decays is numerical.
  /// @param rates  of the rows
  double finish(const Stage& stage, const std::array<double, kRows>& rates, EnergyAccount& power,
                JointState& end) const;

  /// Yield of a latch beyond that at which it lets go; -1 without one that may [m], [rad].
  double past_release(const JointState& state) const;
  /// Opens a latch that is loaded with what it holds, and closes one that catches its part again;
  /// returns the energy lost [J].
  /// @param rate  of q
  double work_latch(double rate, JointState& state) const;

  /// Energy of springs; held directions store nothing [J].
  double stored_energy(const Rows& rows, const JointState& state) const;

  /// Overlap of q with a stop and its speed towards it; of the lower stop, then the upper one.
  struct Approach {
    double compression, speed;
  };
  std::array<Approach, 2> approaches(const JointState& state, double rate) const;
  /// Travel of the part's centre of mass by q: 1, or its distance from a hinge [m/rad].
  double arm() const { return slides() ? 1 : on_part_.cross(joint_.axis).norm(); }
  bool locked() const { return std::isinf(joint_.latch); }
  /// Load of the joint along q where this wrench about its centre holds the part [N], [N m].
  double along(const Pose& base, const Pose& part, const Vector6& wrench) const;
  /// How a part moves at its centre, and turns, where q grows by this little.
  Vector6 shift(const Pose& base, const Pose& part, double by) const;
  /// q at which latch, friction and stops bear this along q, what sticks from where it is; and the friction's
  /// deflection there.
  JointState yielded(const JointState& state, double along) const;
  /// Whether it has a latch that lets go, or is a tether that may break.
  bool releases() const { return joint_.latch > 0 && !locked(); }
  bool has_stops() const { return std::isfinite(joint_.lower) || std::isfinite(joint_.upper); }
  double stop_stiffness() const { return stop_.impact_stiffness(); }

 private:
  Rows cord_rows(const Pose& base, const Pose& part) const;
  double finish_cord(const Stage& stage, const std::array<double, kRows>& rates,
                     EnergyAccount& power, JointState& end) const;
  Force along(const Stage& stage, double rate) const;
  ImpactLaw::Stage at_stop(const Stage& stage, int side) const;
  bool slides() const { return joint_.kind == Joint::Kind::kSlider; }
  double latch_stiffness() const {
    return locked() ? (slides() ? hold_ : hold_turn_) : joint_.latch / kYield;
  }

  Joint joint_;
  Matrix3 frame_;              // columns: two directions across the axis, and the axis; item axes
  Vector3 on_base_, on_part_;  // the point from the centres, item axes
  double hold_ = 0, hold_turn_ = 0;  // k of displacements and of rotations
  DryFriction friction_;
  ImpactLaw stop_;
  std::optional<Tether> cord_ = {};
  std::size_t tether_index_ = 0;
};

}  // namespace gurney
