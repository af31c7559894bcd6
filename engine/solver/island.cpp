#include "engine/solver/island.h"

#include <algorithm>
#include <numeric>
#include <tuple>

namespace gurney {

std::size_t Islands::first_of(std::size_t item) {
  while (parent_[item] != item) item = parent_[item] = parent_[parent_[item]];
  return item;
}

void Islands::update(std::vector<BodyContact>& contacts, const Assembly& assembly,
                     const Riders& riders) {
  const std::vector<JointLaw>& joints = assembly.joints;
  const std::size_t items = assembly.items.size();
  parent_.resize(items);
  island_of_.resize(items);
  std::iota(parent_.begin(), parent_.end(), std::size_t{0});
  const auto join = [&](std::size_t i, std::size_t j) {
    const std::size_t a = first_of(i), b = first_of(j);
    parent_[std::max(a, b)] = std::min(a, b);
  };
  for (const JointLaw& law : joints) join(law.joint().base, law.joint().part);
  for (const BodyContact& contact : contacts)
    if (contact.between_items()) join(contact.side.item, contact.other_side.item);
  for (std::size_t i = 0; i < items; ++i)
    if (riders.rides(i)) join(i, riders.carrier(i));
  const auto key = [&](const BodyContact& c) {
    const Vector3 &at = c.side.local, &n = c.normal;
    return std::tuple(first_of(c.side.item), c.side.item, c.other, c.side.caster, c.other_side.item,
                      c.other_side.caster, at.x(), at.y(), at.z(), n.x(), n.y(), n.z());
  };
  std::ranges::sort(contacts, [&](const auto& a, const auto& b) { return key(a) < key(b); });
  count_ = 0;
  for (std::size_t i = 0; i < items; ++i) {
    if (first_of(i) == i) {
      if (count_ == islands_.size()) islands_.emplace_back();
      islands_[count_].items.clear();
      islands_[count_].joints.clear();
      island_of_[i] = count_++;
    }
    islands_[island_of_[first_of(i)]].items.push_back(i);
  }
  for (std::size_t j = 0; j < joints.size(); ++j)
    islands_[island_of_[first_of(joints[j].joint().part)]].joints.push_back(j);
  std::size_t next = 0;
  for (std::size_t k = 0; k < count_; ++k) {
    Island& island = islands_[k];
    island.first_contact = next;
    while (next < contacts.size() && first_of(contacts[next].side.item) == island.items.front())
      ++next;
    island.end_contact = next;
  }
}

void Islands::widen(const Island& island, std::size_t contacts) {
  const auto index = static_cast<std::size_t>(&island - islands_.data());
  islands_[index].end_contact += contacts;
  for (std::size_t k = index + 1; k < count_; ++k) {
    islands_[k].first_contact += contacts;
    islands_[k].end_contact += contacts;
  }
}

}  // namespace gurney
