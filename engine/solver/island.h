#pragma once

#include <vector>

#include "engine/contact/body_contact.h"

namespace gurney {

/// Items that may touch each other in a step: they are solved together, all others apart.
struct Island {
  std::vector<std::size_t> items;                  ///< indices in Scene::items, increasing
  std::size_t first_contact = 0, end_contact = 0;  ///< theirs, in SceneState::contacts
};

/// The islands of a scene of `items` items, by their first ones; sorts `contacts` by island.
std::vector<Island> islands_of(std::vector<BodyContact>& contacts, std::size_t items);

}  // namespace gurney
