#pragma once

#include <string>

#include "studies/explanation/facts.h"

/// Facts of a run as words. Wherever a fact is put into words, it is by these.
namespace gurney::explanation {

/// "2.34 mm", "456 mm", "1.23 m", or in the units that are stated.
std::string length(double metres, const study::UnitSystem& units);

/// "2.3 deg", "12 deg", or in the units that are stated.
std::string angle(double radians, const study::UnitSystem& units);

/// "towards +x" or "between +x and +y", by the nearest of eight directions, with the angle.
/// @param direction  from the floor's x axis [rad]
std::string towards(double direction, const study::UnitSystem& units);

/// "front left" for a direction from the front of an item, anticlockwise [rad].
std::string side_of(double direction);

/// Sentence on an item that moved against the direction of the half cycle.
std::string sentence(const HalfCycle& of, const study::UnitSystem& units);

/// How far one run shows the motion of an item; without a full stop.
std::string sentence(const Predictability& of);

/// An event of an item, without its time and the item's name.
std::string sentence(const Event& event, const study::UnitSystem& units);

/// An item that hardly moved, or a part that did so on its joint only.
std::string stayed(const ItemFacts& item, const study::UnitSystem& units);

/// The finding of the explained item in one sentence, without a line break.
std::string headline(const Explanation& of);

}  // namespace gurney::explanation
