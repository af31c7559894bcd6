#pragma once

#include <vector>

#include "engine/scene/equipment_model.h"

/// An item on casters as rigid bodies that share nothing with ours but its data: Kane's equations with
/// the Jacobian of every body.
namespace gurney::peers {

inline constexpr int kMostRates = 22;
using Rates = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, kMostRates, 1>;
using RateMatrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, kMostRates, kMostRates>;
using RateRows = Eigen::Matrix<double, 3, Eigen::Dynamic, 0, 3, kMostRates>;

struct CartState {
  Vector3 origin = Vector3::Zero();
  Quaternion rotation = Quaternion::Identity();
  Rates joints;  ///< angles of the swivels and axles that turn, caster after caster [rad]
  Rates rates;   ///< velocity of the origin, angular velocity, and rates of the joints

  void move(double duration);
};

/// Point of a wheel on the floor: the lowest of its circle.
struct WheelPoint {
  double compression;                                                   ///< below the floor [m]
  Eigen::Matrix<double, 4, Eigen::Dynamic, 0, 4, kMostRates> jacobian;  ///< x, y, z, rolling
};

class CartBodies {
 public:
  /// Axles that brakes hold turn against a spring, or not at all.
  enum class Held { kBySprings, kRigidly };
  CartBodies(const EquipmentModel& item, Held held);

  CartState at_rest() const;

  /// Rows of the rates, and -1 where the joint does not turn.
  struct Joints {
    long swivel = -1, axle = -1;
  };
  const std::vector<Joints>& joints() const { return joints_; }

  struct Equations {
    RateMatrix mass;
    Rates force;  ///< gravity, centrifugal and gyroscopic forces
    std::vector<WheelPoint> wheels;
  };
  void evaluate(const CartState& state, const Vector3& gravity, Equations& out) const;

 private:
  struct Body;
  static Body body_at(const Body& base, const Vector3& arm);
  static void turn(Body& body, const Vector3& axis, long row, const CartState& state);
  static void add(const Body& body, const Vector3& gravity, Equations& out);
  static void add_point(const Body& wheel, const Vector3& axle, double radius, Equations& out);

  std::vector<Caster> casters_;
  std::vector<Joints> joints_;
  MassProperties chassis_;
};

}  // namespace gurney::peers
