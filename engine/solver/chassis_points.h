#pragma once

#include <vector>

#include "engine/contact/body_form.h"
#include "engine/solver/riders.h"
#include "engine/solver/travel.h"

namespace gurney {

/// Where the shapes of the chassis may touch the shapes of the room and each other: analytic, like
/// the corners on the floor, and known before they touch.
///
/// Bullet reports one edge point of two boxes until they overlap by 0.1 mm, so a face that lands
/// flat would touch with one point and turn.
///
/// Pairs of shapes are left out while a gap along one of the axes of the search, less what they
/// have moved since it was measured, is larger than the margin: nothing would be found.
class ChassisPoints {
 public:
  ChassisPoints(const Scene& scene, const Assembly& assembly);

  /// Appends the contacts with a gap of at most `margin` [m].
  /// @param travels  up to `state`
  /// @param step     until this is asked again [s]
  /// @param riders   bodies that move together touch each other nowhere; none: none does
  void collect(const SceneState& state, const Travels& travels, double step, double margin,
               std::vector<BodyContact>& contacts, const Riders* riders = nullptr);

 private:
  struct Obstacle {
    int other;      // BodyContact::other
    BodyForm form;  // floor axes
    Vector3 center;
    double reach;  // of any of its points from there [m]
  };
  /// A shape of a chassis, in chassis axes.
  struct Body {
    BodyForm form;
    Vector3 center;
    double reach;
    bool is_box, is_round;
  };
  struct PlacedBody {
    BodyForm form;  // floor axes
    Vector3 center = Vector3::Zero(), velocity = Vector3::Zero();
    double reach = 0;
    bool is_now = false;  // of the state that is searched
  };
  struct PairClearance {
    Clearance clearance;
    double arm = 0;  // of the turns of both [m]
  };
  /// Objects and purpose of a search.
  struct Search {
    const SceneState& state;
    const Travels& travels;
    double step, margin;
    std::vector<BodyContact>& contacts;
  };
  static double gap_of(const PlacedBody& body, const Obstacle& obstacle);
  static double gap_of(const PlacedBody& a, const PlacedBody& b);
  const PlacedBody& placed(std::size_t item, std::size_t shape, const State& state);
  BodyContact::Side side(std::size_t item, std::size_t shape, const State& state,
                         const Vector3& point, bool rolls, const Vector3& outwards) const;
  void against_room(std::size_t item, const Search& search);
  void between(std::size_t a, std::size_t b, const Search& search);

  const Assembly& assembly_;
  std::vector<std::vector<Body>> bodies_;  // of each item
  std::vector<double> reach_;              // of each chassis
  std::vector<Obstacle> obstacles_;
  std::vector<std::vector<PlacedBody>> placed_;    // as bodies_
  std::vector<std::vector<Clearance>> from_room_;  // of each item: bodies x obstacles
  std::vector<std::vector<PairClearance>> pairs_;  // of each pair of items: bodies x bodies
};

}  // namespace gurney
