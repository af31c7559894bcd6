#pragma once

#include <compare>
#include <cstdint>

namespace gurney {

/// The normal score of a member of a group: r z_group + sqrt(1 - r^2) z_own.
double member_score(double correlation, double group, double own);

/// A member of a correlation group in a Latin hypercube, -1 < correlation < 1.
struct GroupMember {
  std::uint64_t seed = 0, draws = 0;
  std::uint64_t group = 0, own = 0;  ///< hashes of the streams
  double correlation = 0;

  auto operator<=>(const GroupMember&) const = default;
};

/// The probability, in (0, 1), of a member in a draw, stratified over all draws.
///
/// The score of a member is a sum of two stratified ones and so not stratified itself. Its ranks
/// among the scores of all draws are: draw i is put into the cell of its rank, at its own place
/// inside (Stein 1987, Technometrics 29(2), 143-151; ranks keep the correlation: Iman & Conover
/// 1982, Communications in Statistics B 11(3), 311-334).
///
/// A function of its arguments alone. Ranks are of all draws, so those of a member are kept for the
/// next draw, 4 bytes each. May be called from several threads.
double stratified_member(const GroupMember& member, std::uint64_t draw);

}  // namespace gurney
