#include "studies/statistics/stripes.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "engine/base/error.h"

namespace gurney::statistics {

StripeTable::StripeTable(const std::vector<Observation>& observations) {
  std::map<double, std::size_t> number_of_im;
  std::map<std::size_t, std::map<double, Stripe>> counts;
  for (const Observation& seen : observations) {
    require(seen.im > 0 && std::isfinite(seen.im), fmt::format("im = {:g} must be > 0", seen.im));
    number_of_im[seen.im] = 0;
    Stripe& stripe = counts[seen.group][seen.im];
    stripe.runs += 1;
    stripe.exceeded += seen.exceeded ? 1 : 0;
  }
  for (auto& [im, number] : number_of_im) {
    number = stripes_.size();
    stripes_.push_back({im, 0, 0});
  }
  for (const auto& [group, of_im] : counts) {
    of_group_.emplace_back();
    for (const auto& [im, stripe] : of_im)
      of_group_.back().push_back({number_of_im[im], stripe.runs, stripe.exceeded});
  }
  stripes_ = resampled(std::vector<int>(groups(), 1));
}

std::vector<Stripe> StripeTable::resampled(const std::vector<int>& times) const {
  std::vector<Stripe> stripes = stripes_;
  for (Stripe& stripe : stripes) stripe.runs = stripe.exceeded = 0;
  for (std::size_t group = 0; group < of_group_.size(); ++group) {
    if (times[group] == 0) continue;
    for (const Share& share : of_group_[group]) {
      stripes[share.stripe].runs += times[group] * share.runs;
      stripes[share.stripe].exceeded += times[group] * share.exceeded;
    }
  }
  return stripes;
}

bool StripeTable::repeats_groups() const {
  return std::ranges::any_of(of_group_, [](const std::vector<Share>& shares) {
    return std::ranges::any_of(shares, [](const Share& share) { return share.runs > 1; });
  });
}

}  // namespace gurney::statistics
