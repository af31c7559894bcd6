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
  states.assign(contacts.size(), BodyContactState());
  std::size_t hint = 0;
  for (std::size_t begin = 0, end = 0; begin < contacts.size(); begin = end) {
    while (end < contacts.size() && contacts[end].same_pair(contacts[begin])) ++end;
    match_pair(contacts, begin, end, hint, states);
  }
  for (std::size_t i = 0; i < contacts.size(); ++i) states[i].contact = contacts[i];
}

void ContactMemory::match_pair(const std::vector<BodyContact>& contacts, std::size_t begin,
                               std::size_t end, std::size_t& hint,
                               std::vector<BodyContactState>& states) {
  const auto is_of_pair = [&](std::size_t k) {
    return before_[k].contact.same_pair(contacts[begin]);
  };
  std::size_t first = hint, passed = 0;
  for (; passed < before_.size() && !is_of_pair(first % before_.size()); ++passed) ++first;
  if (passed == before_.size()) return;  // a new pair
  first %= before_.size();
  // The search began inside those of the pair, or before them.
  while (first > 0 && is_of_pair(first - 1)) --first;
  matches_.clear();
  std::size_t last = first;
  for (; last < before_.size() && is_of_pair(last); ++last)
    for (std::size_t i = begin; i < end; ++i)
      matches_.push_back(
          {(before_[last].contact.side.local - contacts[i].side.local).norm(), i, last});
  hint = last;
  std::ranges::sort(matches_, [](const Match& a, const Match& b) {
    return std::tie(a.distance, a.now, a.before) < std::tie(b.distance, b.now, b.before);
  });
  found_.assign(end - begin, false);
  taken_.assign(last - first, false);
  for (const Match& match : matches_) {
    if (found_[match.now - begin] || taken_[match.before - first]) continue;
    found_[match.now - begin] = taken_[match.before - first] = true;
    BodyContactState& memory = states[match.now] = before_[match.before];
    memory.kept_place = contacts[match.now].same_place(memory.contact);
    if (match.distance < kSameContactDistance) continue;
    memory.deflection.setZero();
    memory.lead.setZero();
  }
}

}  // namespace gurney
