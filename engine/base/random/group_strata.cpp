#include "engine/base/random/group_strata.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <mutex>
#include <numeric>
#include <vector>

#include "engine/base/error.h"
#include "engine/base/random/normal_draw.h"
#include "engine/base/random/sampling.h"

namespace gurney {
namespace {

// A stream of its own: the place in the cell must not be that of the member's own number.
constexpr std::uint64_t kPlaces = 0x67726f7570706c61;
const double kBelowOne = std::nextafter(1.0, 0.0);

std::vector<std::uint32_t> ranks_of(const GroupMember& member) {
  require(member.draws <= std::numeric_limits<std::uint32_t>::max(),
          fmt::format("{} draws are too many for members of a group", member.draws));
  std::vector<double> scores;
  for (std::uint64_t i = 0; i < member.draws; ++i)
    scores.push_back(member_score(member.correlation,
                                  latin_hypercube_draw(member.seed, member.group, i, member.draws),
                                  latin_hypercube_draw(member.seed, member.own, i, member.draws)));
  std::vector<std::uint32_t> order(scores.size()), ranks(scores.size());
  std::iota(order.begin(), order.end(), 0);
  std::ranges::stable_sort(order, {}, [&](std::uint32_t i) { return scores[i]; });
  for (std::uint32_t rank = 0; rank < order.size(); ++rank) ranks[order[rank]] = rank;
  return ranks;
}

class Ranks {
 public:
  std::uint32_t of(const GroupMember& member, std::uint64_t draw) {
    const std::lock_guard lock(mutex_);
    auto found = known_.find(member);
    if (found == known_.end()) found = known_.emplace(member, ranks_of(member)).first;
    return found->second.at(draw);
  }

 private:
  std::mutex mutex_;
  std::map<GroupMember, std::vector<std::uint32_t>> known_;
};

}  // namespace

double member_score(double correlation, double group, double own) {
  return correlation * normal_quantile(group) +
         std::sqrt(std::max(0.0, 1 - correlation * correlation)) * normal_quantile(own);
}

double stratified_member(const GroupMember& member, std::uint64_t draw) {
  static Ranks ranks;
  const double cell = ranks.of(member, draw);
  const double place = uniform_draw(member.seed, member.own ^ kPlaces, draw);
  return std::min((cell + place) / static_cast<double>(member.draws), kBelowOne);
}

}  // namespace gurney
