#pragma once

#include <optional>
#include <string>
#include <vector>

#include "equipment/catalogue/uncertainty.h"
#include "studies/hospital/fault_tree.h"
#include "studies/loss/consequences.h"
#include "studies/plan/assessment_files.h"

namespace gurney::study {

/// Brakes of a piece; `locked`: and its swivels.
enum class Brakes { kOff, kOn, kLocked };
const std::vector<std::string>& brakes_names();

/// How the pieces of a group are secured.
struct Securing {
  Brakes brakes = Brakes::kOff;
  double share = 1;         ///< P(a piece has them so), the others have them off
  double tether_holds = 0;  ///< P(its tether holds): then it reaches no state; 0: it has none
};

/// A group of equal pieces in a room.
struct HospitalItem {
  std::string name, equipment, place;  ///< place: "open" or "bay"
  int count = 1;
  Securing securing;
  std::string where;  ///< `file:line:column`
};

struct Storey {
  std::string name;
  std::string floor;  ///< of the curves: "flexible building"
  /// Where the curves are over the velocity of the floor: median of PFV / PGV, and the standard
  /// deviation of its logarithm. None: they are over the PGV of the ground.
  std::optional<double> amplification;
  double scatter = 0;
  std::string building;  ///< TOML of excitation.building; empty: the ground
  std::string where;
};

/// `count` equal rooms.
struct Room {
  std::string name;
  int count = 1, beds = 0;
  std::size_t storey = 0;
  std::vector<HospitalItem> items;
  std::optional<Requirement> works;
  config::Spot spot;  ///< of `works`, else of the room
};

struct HospitalService {
  std::string name;
  Requirement works;
  config::Spot spot;
};

/// What may be done, for a group of pieces.
struct HospitalAction {
  std::string name;
  std::vector<std::pair<std::size_t, std::size_t>> items;  ///< room and item
  std::optional<Brakes> brakes;
  std::optional<double> tether_holds;
  equipment::StatedQuantity cost;  ///< of each piece, >= 0
};

/// Keys of the study that a hospital becomes.
struct HospitalStudy {
  std::string record;    ///< TOML of excitation.record
  std::string covering;  ///< of the floor
  int synthetic_records = 0, draws = 1;
  std::uint64_t seed = 1;
};

/// An inventory with its services (docs/hospital.md).
struct Hospital {
  std::string path, title, currency;
  std::vector<double> levels;  ///< PGV of the ground, larger component [m/s], increasing
  std::optional<SiteHazard> hazard;
  double correlation = 0.5;         ///< of the capacities of curves, given the intensity; in [0, 1]
  std::vector<std::string> curves;  ///< paths of tables; empty: those of the catalogue
  std::string consequences;         ///< path
  std::vector<Storey> storeys;
  std::vector<Room> rooms;
  std::vector<HospitalService> services;
  std::vector<HospitalAction> actions;
  std::optional<HospitalStudy> study;

  int beds() const;
};

/// @throws Error with all errors, each with file:line:column
Hospital read_hospital(const std::string& path);

/// One piece of equipment.
struct Piece {
  std::size_t room, item;
};

/// Pieces, and the tree of what needs which.
struct HospitalTree {
  std::vector<Piece> pieces;
  FaultTree tree;
  std::vector<std::vector<FaultTree::Node>> rooms;  ///< of each room, of each copy
  std::vector<FaultTree::Node> services;

  /// @param states  names of the bits of Reached
  /// @param lost    of each room and item: the states in which a piece is out of use
  /// @throws Error with all errors, each with file:line:column: unknown names, circles, more parts
  ///         asked for than there are
  HospitalTree(const Hospital& hospital, const std::vector<std::string>& states,
               const std::vector<std::vector<Reached>>& lost);
};

}  // namespace gurney::study
