#include "engine/solver/contact_memory.h"

#include <algorithm>
#include <tuple>

namespace gurney {
namespace {

constexpr double kSameContactDistance = 0.02;  // [m]

}  // namespace

void ContactMemory::match(const std::vector<BodyContact>& contacts,
                          std::vector<BodyContactState>& states) {
  before_.swap(states);
  matches_.clear();
  for (std::size_t i = 0; i < contacts.size(); ++i)
    for (std::size_t k = 0; k < before_.size(); ++k)
      if (before_[k].contact.same_pair(contacts[i]))
        matches_.push_back({(before_[k].contact.side.local - contacts[i].side.local).norm(), i, k});
  std::ranges::sort(matches_, [](const Match& a, const Match& b) {
    return std::tie(a.distance, a.now, a.before) < std::tie(b.distance, b.now, b.before);
  });
  states.assign(contacts.size(), BodyContactState());
  found_.assign(contacts.size(), false);
  taken_.assign(before_.size(), false);
  for (const Match& match : matches_) {
    if (found_[match.now] || taken_[match.before]) continue;
    found_[match.now] = taken_[match.before] = true;
    BodyContactState& memory = states[match.now] = before_[match.before];
    memory.kept_place = contacts[match.now].same_place(memory.contact);
    if (match.distance >= kSameContactDistance) memory.deflection.setZero();
  }
  for (std::size_t i = 0; i < contacts.size(); ++i) states[i].contact = contacts[i];
}

}  // namespace gurney
