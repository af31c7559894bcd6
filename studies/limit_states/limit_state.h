#pragma once

#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "engine/response/response.h"
#include "engine/scene/scene.h"

namespace gurney::study {

/// A number, or several, that a run has: of its items, their marked points, its zones or tethers.
struct Quantity {
  enum class Of { kItem, kPoint, kZone, kTether };
  Of of = Of::kItem;
  std::string column;  ///< of the results' table: "peak_displacement"
  std::string item;    ///< of kItem and kPoint; empty: see counts_of()
  std::string part;    ///< name of the point, zone or tether

  bool operator==(const Quantity&) const = default;
};

/// Whether the values of an item count: of the one that is named; else of every item of the job, and of its
/// parts and contents ("cart/drawer") what only these have. A jug that falls off a cart is no cart that moved.
bool counts_of(const Quantity& quantity, const std::string& item);

/// The values of a quantity in one run, one for each item it is asked of; NaN: there is none.
using Values = std::function<std::vector<double>(const Quantity&)>;

/// Outcome that must not happen. A simple one is exceeded when any value of its quantity, or
/// `at_least` of them, pass the limit; others combine those before them.
struct LimitState {
  enum class Kind { kAbove, kBelow, kAny, kAll };
  std::string name;
  Kind kind = Kind::kAbove;
  Quantity quantity;               ///< of kAbove and kBelow
  double limit = 0;                ///< in the SI unit of the quantity
  std::string words;               ///< its definition, with its unit: "peak_displacement > 0.3 m"
  std::string origin;              ///< of the limit, where it is a default
  std::vector<std::size_t> parts;  ///< of kAny and kAll: indices of others, each before this
  int at_least = 1;  ///< of all but kAll: how many values (items) or parts it takes, >= 1

  bool is_simple() const { return kind == Kind::kAbove || kind == Kind::kBelow; }
};

/// Whether a run exceeds a limit state.
/// @param index  of the state in `states`
bool exceeded(const std::vector<LimitState>& states, std::size_t index, const Values& values);

/// Whether two are the same requirement, whatever their names.
bool same_state(const std::vector<LimitState>& a, std::size_t i, const std::vector<LimitState>& b,
                std::size_t j);

/// The states of a study that names none: moved (residual displacement above 20 mm, the damage
/// state of Costa et al.), rolled (displacement above 0.3 m: an assumption, 0.2 to 1 m, reach of
/// tubes and cables), hit (approach speed above 0.4 m/s: an assumption, 0.2 to 0.8 m/s, the
/// handling speed of IEC 60601-1) and overturned.
std::vector<LimitState> default_limit_states();

/// Names that limit states may use: the items of a run, their marked points, its zones and tethers.
struct Places {
  std::vector<std::string> items, zones, tethers;
  std::vector<std::pair<std::string, std::string>> points;  ///< item and point
  std::vector<std::string> on_items{};                      ///< items that stand on another
};

Places places_of(const Scene& scene);

/// Complains of items, points, zones and tethers that are not there.
/// @param owner  of the places, for messages: "the job"
/// @throws Error with the nearest name
void check_names(const LimitState& state, const Places& places, const std::string& owner);

/// The values of a run that was just made.
Values values_of(const Scene& scene, const Response& response);

}  // namespace gurney::study
