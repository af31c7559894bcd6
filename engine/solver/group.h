#pragma once

#include <vector>

#include "engine/contact/body_contact.h"

namespace gurney {

/// Items that may touch each other in a step: they are solved together, all others apart.
struct Group {
  std::vector<std::size_t> items;                  ///< indices in Scene::items, increasing
  std::size_t first_contact = 0, end_contact = 0;  ///< theirs, in SceneState::contacts
};

/// The groups of a scene of `items` items, by their first ones; sorts `contacts` by group.
std::vector<Group> groups_of(std::vector<BodyContact>& contacts, std::size_t items);

}  // namespace gurney
