#pragma once

#include <array>
#include <vector>

#include "engine/contact/body_contact.h"
#include "engine/solver/mechanism.h"

namespace gurney {

/// Solves one implicit stage of length tau of the whole mechanism,
///
///     M (v - v_start) = tau (J' f(J v) + f_loads(v) - bias),
///
/// with every force law evaluated at the end of the stage, by Newton's method on v. The force laws
/// are piecewise smooth functions of velocity with known slopes D = -df/du (semismooth Newton, Qi &
/// Sun 1993). The mechanism is a star: each caster touches only the chassis, so its two joints are
/// eliminated from K = M + tau J' D J and one 6 x 6 system for the chassis is left.
///
/// The geometry (M, J, bias) is that of the predicted end of the stage and is evaluated again when
/// the solution has turned a joint or the chassis further from it than `kGeometryTolerance`.
class StageSolver {
 public:
  struct Settings {
    double residual = 1e-9;
    int max_iterations = 40;
  };

  StageSolver(const Mechanism& mechanism, const Settings& settings);

  struct Input {
    const State* start = nullptr;  ///< pose, velocity and memory the stage starts from
    double tau = 0;
    Vector3 floor_acceleration = Vector3::Zero();
    Loads::Stage loads;
    Velocity guess;  ///< of the velocity at the end
    const std::vector<BodyContact>* contacts = nullptr;
  };

  struct ContactResult {
    double normal_force = 0;          ///< [N]
    double normal_speed = 0;          ///< away from the other, at the end of the stage [m/s]
    Vector3 point = Vector3::Zero();  ///< on the item, floor axes [m]
  };

  /// What the stage dissipated and how it ended, besides the new state.
  struct Output {
    State end;
    Velocity acceleration;    ///< (v - v_start) / tau
    EnergyAccount power;      ///< work and loss entries in W
    double spring_rates = 0;  ///< a' M a + sum of k x'^2 [W/s]: for the numerical loss
    std::array<TreadLaw::Result, kMaxLegs> treads;
    std::vector<ContactResult> contacts;
    std::array<bool, kMaxLegs> axle_slips{};
    std::array<Vector2, kMaxLegs> heading;
    double residual = 0;
    int iterations = 0;
  };

  /// @returns false when the residual stays above the setting; `out` then holds
  /// the last iterate, or nothing new if that is not finite.
  bool solve(const Input& input, Output& out);

 private:
  struct LegWork {
    Leg::Geometry g;
    TreadLaw::Stage tread;
    Vector5 rates;
    Vector5 force;
    Matrix5 slope;
    DryFriction::Result swivel, axle;
    Eigen::Vector2d joint_residual;
    Matrix2 k_inverse;
    Eigen::Matrix<double, 6, 2> k_chassis_joints;
    Eigen::Matrix<double, 2, 6> k_joints_chassis;
  };
  struct ContactWork {
    Eigen::Matrix<double, 3, 6> jacobian_chassis;
    Eigen::Matrix<double, 3, 2> jacobian_joints;
    const ImpactLaw* law = nullptr;
    ImpactLaw::Stage stage;
    Matrix3 frame;  // rows: two tangents and the normal
    Vector3 point;
    Vector3 force;
    Matrix3 slope;
  };

  Vector3 contact_rates(const ContactWork& work, const BodyContact& contact,
                        const Velocity& v) const;
  void update_contacts(const Input& input, const Velocity& v);
  void update_geometry(const Input& input, const Velocity& v, bool first);
  double evaluate_forces(const Input& input, const Velocity& v);
  void newton_step(const Input& input, Velocity& v);
  void finish(const Input& input, const Velocity& v, Output& out);
  double finish_contacts(const Input& input, const Velocity& v, Output& out) const;
  double geometry_error(const Input& input, const Velocity& v) const;

  const Mechanism& mechanism_;
  Settings settings_;
  std::array<LegWork, kMaxLegs> legs_;
  std::vector<ContactWork> contacts_;
  std::vector<Loads::Row> load_rows_;
  Pose pose_;           // predicted end of the stage
  Velocity predicted_;  // the velocity that leads there
  Matrix6 mass_;
  Vector6 bias_, chassis_residual_;
  std::array<double, 6> reaction_{};  // of guides, impulse
};

}  // namespace gurney
