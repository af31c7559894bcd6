#pragma once

#include <vector>

#include "engine/contact/rolling_resistance.h"
#include "engine/solver/assembly.h"
#include "engine/solver/block_system.h"
#include "engine/solver/island.h"
#include "engine/solver/item_stage.h"

namespace gurney {

/// Solves one implicit stage of length tau for an island of items that may touch,
///
///     M (v - v_start) = tau (J' f(J v) + f_loads(v) - bias),
///
/// with every force law evaluated at the end of the stage, by Newton's method on v. The force laws
/// are piecewise smooth functions of velocity with known slopes D = -df/du (semismooth Newton, Qi &
/// Sun 1993). Each item leaves one 6 x 6 system for its chassis (ItemStage), and contacts between
/// items couple these. Their common matrix is factored once and serves, as long as its steps shrink
/// the residual well, for later iterations, stages and steps (simplified Newton, Hairer & Wanner
/// 1996, IV.8).
///
/// The geometry (M, J, bias) is that of the predicted end of the stage and is evaluated again when
/// the solution has turned a joint or a chassis further from it than `kGeometryTolerance`.
class StageSolver {
 public:
  struct Settings {
    double residual = 1e-9;
    int max_iterations = 40;
  };

  StageSolver(const Assembly& assembly, const Settings& settings);

  struct Input {
    const SceneState* start = nullptr;
    const Island* island = nullptr;
    const Riders* riders = nullptr;  ///< none: no body rides
    double tau = 0;
    FloorStage floor;
    Loads::Stage loads;           ///< `start` aside
    std::vector<Velocity> guess;  ///< of the velocity at the end; as Scene::items
  };

  struct ContactResult {
    double normal_force = 0;          ///< [N]
    double normal_speed = 0;          ///< away from the other, at the end of the stage [m/s]
    Vector3 point = Vector3::Zero();  ///< on the item, floor axes [m]
  };

  /// Results of the island's items and contacts only; the others are unchanged.
  struct Output {
    SceneState end;
    std::vector<ItemStage::Output> items;
    std::vector<Vector6> holding;  ///< wrenches on bodies that ride, about their centres [N], [N m]
    std::vector<ContactResult> contacts;
    double residual = 0;
    int iterations = 0;
  };

  /// @returns false when the residual stays above the setting; `out` then holds
  /// the last iterate, or nothing new if that is not finite.
  bool solve(const Input& input, Output& out);

 private:
  struct Side {
    ItemStage::Matrix36 chassis;
    ItemStage::Matrix32 joints;
    Vector3 point;  // relative to the chassis' centre
  };
  struct ContactWork {
    const BodyContact* contact = nullptr;
    const ImpactLaw* law = nullptr;
    ImpactLaw::Stage stage;
    Matrix3 frame;  // rows: two tangents and the normal
    Side side, other_side;
    Vector3 force;
    Matrix3 slope;          // D
    Matrix3 in_floor_axes;  // tau frame' D frame, of the last Newton step
    bool rolls = false;     // with resistance
    RollingResistance resistance;
    RollingResistance::Result rolling;

    /// Whether there is a force; without one the slope is not set.
    bool pushes() const { return force.z() != 0; }
  };
  struct JointWork {
    std::size_t index = 0;  // in Assembly::joints
    const JointLaw* law = nullptr;
    JointLaw::Stage stage;
    std::array<double, JointLaw::kRows> rates{};  // of the rows
    std::array<JointLaw::Force, JointLaw::kRows> forces{};

    std::size_t base() const { return law->joint().base; }
    std::size_t part() const { return law->joint().part; }
  };

  /// Unknowns of an item in the common system of its island: the chassis, then the joints it keeps.
  struct Layout {
    Eigen::Index size = 6;
    std::array<Eigen::Index, kMaxCasters> joints{};  ///< where they begin; 0: eliminated

    bool operator==(const Layout&) const = default;
  };
  /// The common system of an island as it was last factored.
  struct Factors {
    std::vector<std::size_t> items;  ///< of the island
    double tau = 0;
    std::vector<Layout> layouts;  ///< of the items
    BlockSystem system;           ///< the last item's block first
    double left = 1;              ///< part of the residual that the last step left
  };

  void set_input(const Input& input, std::size_t item);
  void set_riders(const Input& input);
  /// Gives bodies that ride the velocities of their carriers.
  void follow(std::vector<Velocity>& v) const;
  /// Where a point of an item is from the centre of what its velocity is that of.
  Vector3 from_root(std::size_t item, const Vector3& point) const {
    return point + arms_from_root_[item];
  }
  Vector6 of_root(std::size_t item, const Vector6& direction) const;
  ItemStage::Matrix36 of_root(std::size_t item, const ItemStage::Matrix36& rates) const;
  void update_geometry(const Input& input, std::vector<Velocity>& v, bool first);
  double evaluate_forces(const Input& input, const std::vector<Velocity>& v);
  /// Adds a step of Newton's method to v, with the matrix of this velocity or the last one.
  void newton_step(const Input& input, bool anew, std::vector<Velocity>& v);
  void set_matrices(const Input& input);
  bool has_factors(const Input& input) const;
  void factor(const Input& input);
  void couple(const ContactWork& work, Factors& factors);
  /// -tau sum of dT/du d_p d_b' of a joint, d for the velocities of the roots.
  Matrix6 coupling(const JointWork& work, double tau) const;
  void couple(const JointWork& work, Factors& factors);
  /// Whether a joint, a cord, is between bodies that move together.
  bool within_one(const JointWork& work) const {
    return roots_[work.part()] == roots_[work.base()];
  }
  Layout layout_of(std::size_t item) const;
  /// Calls visit(caster, first unknown) for each caster that keeps its joints.
  static void for_kept(const Layout& layout, const auto& visit) {
    for (std::size_t j = 0; j < kMaxCasters; ++j)
      if (layout.joints[j] > 0) visit(static_cast<int>(j), layout.joints[j]);
  }
  /// Makes v this part of the step from before_ to full_.
  void take(double part);
  double geometry_error(const Island& island, const std::vector<Velocity>& v) const;
  void finish(const Input& input, const std::vector<Velocity>& v, Output& out);

  Vector3 rates(const BodyContact::Side& at, const Side& side,
                const std::vector<Velocity>& v) const;
  Vector3 contact_rates(const ContactWork& work, const std::vector<Velocity>& v) const;
  Vector3 turning(const ContactWork& work, const std::vector<Velocity>& v) const;
  void set_rolling(ContactWork& work) const;
  void add_rolling(const Input& input, std::size_t c, const std::vector<Velocity>& v);
  bool stays_apart(const ContactWork& work, const std::vector<Velocity>& v) const;
  void place(const Input& input, const std::vector<Velocity>& v, const Matrix3& frame,
             const BodyContact::Side& at, Side& side) const;
  void update_contacts(const Input& input, const std::vector<Velocity>& v);
  void finish_contacts(const Input& input, const std::vector<Velocity>& v, Output& out) const;

  void update_joints(const Input& input, const std::vector<Velocity>& v);
  void add_joint_forces(const std::vector<Velocity>& v);
  void add_joint_slopes();
  void finish_joints(const Input& input, Output& out) const;

  const Assembly& assembly_;
  Settings settings_;
  std::vector<ItemStage> items_;
  std::vector<ItemStage::Input> inputs_;  // of the island's items, in the stage that is solved
  std::vector<std::size_t> free_,
      riders_;  // items of the island: with a velocity of their own, without
  std::vector<std::size_t> carriers_, roots_;   // of all items; of free ones themselves
  std::vector<Vector3> arms_, arms_from_root_;  // floor axes, zero of free items
  std::vector<ContactWork> contacts_;           // of the island
  std::vector<JointWork> joints_;               // of the island
  std::vector<Velocity> v_, before_, full_;
  std::vector<Factors> factors_;       // of islands, by their first items
  std::vector<std::size_t> block_of_;  // of free items, in the system of their island
};

}  // namespace gurney
