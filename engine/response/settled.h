#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

#include "engine/response/response.h"

namespace gurney {

/// One number of an item's demands, of one of its wheels or of its marked points.
struct DemandNumber {
  enum class Of { kItem, kWheel, kPoint };

  Of of = Of::kItem;
  std::size_t part = 0;  ///< which wheel or point
  const char* name = "";
  const char* units = "";
  double value = 0;  ///< [SI]; NaN: there is none

  /// Whether each event adds one: of many some are marginal, and come and go with the step.
  bool counts_events() const;
  /// Whether it is known as soon as the item overturns: what comes after does not touch it.
  bool is_of_overturning() const;
};

/// All demands of an item, always in the same order.
std::vector<DemandNumber> numbers_of(const Demands& demands);

/// Smallest size of a number that anybody asks for, in its unit.
/// @throws Error for a unit without one
double size_of_interest(std::string_view units);

/// Change of a demand over the larger of its two values, or over size_of_interest() where both are
/// less; of directions [rad]; infinite where only one is a number, 0 where none is.
double relative_change(const char* name, const char* units, double from, double to);

inline double change_between(const DemandNumber& from, const DemandNumber& to) {
  return relative_change(from.name, from.units, from.value, to.value);
}

/// Result of the repetitions of a run for one of its numbers (docs/theory/predictability.md).
struct SettledDemand {
  /// The fractions within which a number is said to be settled.
  static constexpr double kFractions[] = {0.01, 0.02, 0.05, 0.1};
  /// Error of a number over its change with half the time step, at most: where the method is of
  /// first order it is 2, and a change may be small by chance.
  static constexpr double kMargin = 4;
  /// Change that a number is taken to have at least, over that which a quarter of the numbers of
  /// its item exceed, or of one that it may meet: among large changes small ones are chance.
  static constexpr double kShareOfOthers = 0.25;

  DemandNumber number;
  double at_half_step = 0, of_twin = 0;  ///< [SI]; NaN: there is none
  double step_change = 0;                ///< relative_change() with half the time step
  double twin_change = 0;                ///< and of the twin
  /// Least size that |step_change| counts as: 0 of overturning, infinite of numbers of events that there are,
  /// else by kShareOfOthers; of what is zero or none by that of the items that it may meet.
  double least_change = 0;

  /// The least of kFractions that the change with half the time step, or least_change, times
  /// kMargin is within; infinite: none, or the number is not predictable().
  double within() const;
  bool settled() const { return within() <= kFractions[3]; }

  /// Whether the change of the twin is grown by less than Predictability::kSensitive.
  bool predictable() const;
};

/// Change with half the time step that a quarter of an item's demands exceed; 0 where a repetition is missing.
double change_of_a_quarter(const Demands& run, const Predictability& found);

/// All demands of an item, as numbers_of(); empty where a repetition is missing.
std::vector<SettledDemand> settled_demands(const ItemResponse& item);

}  // namespace gurney
