#pragma once

#include <vector>

#include "engine/contact/body_contact.h"

namespace gurney {

/// Gives contacts that were found anew what those of the same pair of bodies remember.
class ContactMemory {
 public:
  /// Matches contacts to stored states, nearest first, one-to-one; `states` become those of
  /// `contacts`, in their order. Those of a pair stand side by side in both (Islands::update).
  void match(const std::vector<BodyContact>& contacts, std::vector<BodyContactState>& states);

 private:
  /// Matches the contacts of one pair, from `begin` to `end`. The search for its states starts at `hint`,
  /// which becomes their end.
  void match_pair(const std::vector<BodyContact>& contacts, std::size_t begin, std::size_t end,
                  std::size_t& hint, std::vector<BodyContactState>& states);

  struct Match {
    double distance;  // [m]
    std::size_t now, before;
  };
  std::vector<Match> matches_;
  std::vector<BodyContactState> before_;
  std::vector<bool> found_, taken_;
};

}  // namespace gurney
