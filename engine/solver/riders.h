#pragma once

#include <optional>
#include <vector>

#include "engine/response/energy_account.h"
#include "engine/solver/assembly.h"

namespace gurney {

/// Bodies that are held so firmly that they move with what carries them: a part whose lock or latch holds, and
/// what stands on another item and neither slides nor rocks there. While a body rides, its velocity is that of
/// its carrier,
///
///     v_r = T v_c,   T = | 1  -[s]x |,   s from the carrier's centre to its own,
///                        | 0    1   |
///
/// and no contact and no joint between the two is evaluated: they do not yield. By virtual work its
/// residual r_r and matrix K_r add T' r_r and T' K_r T to those of the carrier (StageSolver). r_r / tau is the
/// wrench that holds it. The body rides until that wrench is more than a part, kFirm, of what friction, the edges of
/// its base or its latch bear; it is then free from the start of the step in which that would happen.
class Riders {
 public:
  /// Part of what can hold a body that counts as firm: the laws of contacts and joints decide about the rest.
  static constexpr double kFirm = 0.9;
  /// A body that has stuck for this time [s] and is slower than this [m/s] rides.
  static constexpr double kHoldTime = 0.05, kStill = 5e-4;
  /// Largest yield of contacts under the weight of a body that rides; on softer ones it moves [m].
  static constexpr double kLargestYield = 2e-5;

  /// @param ride  false: none does
  Riders(const Assembly& assembly, bool ride);

  bool rides(std::size_t item) const { return seats_[item].taken; }
  /// The item with which a riding body moves; it comes before it in the scene and may ride itself.
  std::size_t carrier(std::size_t item) const { return seats_[item].carrier; }
  /// The item that carries the body over any number of others and does not ride; or itself.
  std::size_t root(std::size_t item) const;
  bool together(std::size_t a, std::size_t b) const { return root(a) == root(b); }
  /// Whether this joint holds a riding body.
  bool rests(std::size_t joint) const {
    const std::size_t part = assembly_.joints[joint].joint().part;
    return seats_[part].taken && seats_[part].joint == joint;
  }

  /// s, floor axes, for this rotation of the carrier.
  Vector3 arm(std::size_t item, const Matrix3& carrier) const {
    return carrier * seats_[item].offset;
  }
  static Vector6 velocity(const Vector6& carrier, const Vector3& arm) {
    Vector6 v = carrier;
    v.head<3>() += carrier.tail<3>().cross(arm);
    return v;
  }
  /// Moves a riding body to where its carrier has it.
  void place(std::size_t item, const State& carrier, State& state) const;

  /// Lets bodies ride from now on. Contacts that hold them end in `state`. The work on their springs, and on those of
  /// joints, from here until the body leaves is that of neighbours.
  void board(SceneState& state, std::vector<EnergyAccount>& accounts);
  /// Whether what carries a riding body bears this wrench on it firmly, about its centre, floor axes.
  bool bears(std::size_t item, const SceneState& state, const Vector6& wrench) const;
  /// Remembers the wrench at the end of a step.
  void hold(std::size_t item, const Vector6& wrench) { seats_[item].wrench = wrench; }
  /// Ends the ride, and gives the contacts that hold the body from now on: they, or the joint, bear what was held
  /// last. The body and those that ride on it yield by so much, unless that presses one of them against another.
  void leave(std::size_t item, SceneState& state, std::vector<EnergyAccount>& accounts,
             std::vector<BodyContactState>& contacts);

 private:
  /// Base of a body between the points that touch, in its own axes.
  struct Footing {
    struct Edge {
      Vector3 point, inwards;  // unit, across the edge
    };
    Vector3 normal, middle;  // towards the body; of the points
    double friction = 0;
    std::vector<Vector3> points;
    std::vector<Edge> edges;
  };
  struct Seat {
    bool taken = false;
    std::size_t carrier = 0;
    Vector3 offset;                    // of the centre from the carrier's, carrier axes
    Quaternion turn;                   // of the body in the carrier's axes
    std::optional<std::size_t> joint;  // that holds it; none: it stands there
    std::optional<Vector6> wrench;     // that held it at the end of the last step
    Footing footing;
    std::vector<BodyContactState> contacts;  // with the carrier, vectors in its axes
  };
  /// Contacts of a body now.
  struct Touch {
    std::size_t carrier = 0, points = 0;
    double stiffness = 0;  // of the points together [N/m]
    bool firm = true;
    Vector3 normal;
  };
  void observe_touches(const SceneState& state);
  bool is_on(std::size_t item, std::size_t below) const;
  bool presses(std::size_t item, const Vector6& shift, const SceneState& state) const;
  void move(std::size_t item, const Vector6& shift, SceneState& state,
            std::vector<EnergyAccount>& accounts) const;
  bool stands_still(std::size_t item, const SceneState& state) const;
  /// Whether a body may ride at once; after a time.
  bool is_locked(std::size_t item) const;
  bool is_held(std::size_t item, const SceneState& state) const;
  std::size_t carrier_of(std::size_t item) const;
  bool set_footing(std::size_t item, const SceneState& state);
  void take_contacts(std::size_t item, SceneState& state, std::vector<EnergyAccount>& accounts);
  bool bears(const Footing& footing, const Vector3& force, const Vector3& moment) const;
  /// Where a body moves from its place, and turns, for its contacts to bear the wrench; they only push.
  Vector6 yield(const Vector6& wrench, const Quaternion& rotation,
                const std::vector<BodyContactState>& contacts) const;
  double energy(const BodyContactState& memory) const;

  const Assembly& assembly_;
  std::vector<std::size_t> candidates_;  // bodies that nothing but joints and contacts holds
  std::vector<std::optional<std::size_t>> joints_;  // of parts
  std::vector<Seat> seats_;
  std::vector<Touch> touches_;
  std::vector<double> held_since_;  // [s]
};

}  // namespace gurney
