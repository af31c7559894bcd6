#include "engine/solver/island.h"

#include <algorithm>
#include <numeric>
#include <tuple>

namespace gurney {

std::vector<Island> islands_of(std::vector<BodyContact>& contacts, std::size_t items) {
  std::vector<std::size_t> first(items);  // of the item's island
  std::iota(first.begin(), first.end(), 0);
  const auto find = [&](std::size_t i) {
    while (first[i] != i) i = first[i] = first[first[i]];
    return i;
  };
  for (const BodyContact& contact : contacts) {
    if (!contact.between_items()) continue;
    const std::size_t a = find(contact.side.item), b = find(contact.other_side.item);
    first[std::max(a, b)] = std::min(a, b);
  }
  std::stable_sort(contacts.begin(), contacts.end(),
                   [&](const BodyContact& a, const BodyContact& b) {
                     const auto key = [&](const BodyContact& c) {
                       return std::tuple(find(c.side.item), c.side.item, c.other, c.side.caster,
                                         c.other_side.item, c.other_side.caster, c.side.local.x(),
                                         c.side.local.y(), c.side.local.z());
                     };
                     return key(a) < key(b);
                   });
  std::vector<Island> islands;
  std::vector<std::size_t> island_of(items);
  for (std::size_t i = 0; i < items; ++i) {
    if (find(i) == i) {
      island_of[i] = islands.size();
      islands.emplace_back();
    }
    islands[island_of[find(i)]].items.push_back(i);
  }
  std::size_t next = 0;
  for (Island& island : islands) {
    island.first_contact = next;
    while (next < contacts.size() && find(contacts[next].side.item) == island.items.front()) ++next;
    island.end_contact = next;
  }
  return islands;
}

}  // namespace gurney
