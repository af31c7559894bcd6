#pragma once

#include "engine/response/response.h"
#include "studies/results/run_facts.h"

namespace gurney {

/// A made-up run of ten items in a room with walls, a door, a column and a threshold, two zones and
/// three tethers. Item 3, the infusion pump, falls towards -y at 4.5 s and lies in the doorway; a
/// cord breaks; items hit each other, walls and the floor.
study::RunFacts synthetic_ward();
Response synthetic_ward_response();

}  // namespace gurney
