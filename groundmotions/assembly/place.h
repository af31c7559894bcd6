#pragma once

#include <optional>
#include <vector>

#include "groundmotions/record/record.h"

namespace gurney::groundmotions {

/// A component and the direction that its user gives it, if any.
struct UnplacedComponent {
  Component component;
  std::optional<Direction> stated = {};
};

/// Puts components into the places of a record.
///
/// A stated direction is obeyed; a file that says another one is contradicted by an Error, a name
/// or azimuths that look otherwise by a warning. Of the components without a stated direction, the
/// vertical is known by the file or by its name, and two horizontals with azimuths are placed so
/// that h2 lies 90 degrees counter-clockwise from h1, seen from above: the azimuth of h2 is that of
/// h1 less 90 degrees, as with east and north. Two horizontals without azimuths are taken in the
/// order given, with a warning.
///
/// @throws Error for a component without a place, two for one place and more than two horizontals.
Record place(const std::vector<UnplacedComponent>& components);

/// "UP", "UD", "V", "HNZ", "ver" and their like, letter case apart.
bool sounds_vertical(std::string_view name);

}  // namespace gurney::groundmotions
