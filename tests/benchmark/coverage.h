#pragma once

namespace gurney::benchmark {

inline constexpr int kReplicas = 8, kMore = 80;

/// Whether the 95 % interval of a probability from `few` of kReplicas contains `many` of kMore.
bool covers(int few, int many);

/// The probability of covers() where `total` of both happen and any kReplicas of them are as likely to
/// be the few: few is then hypergeometric whatever the probability is, so that nothing has to be known of
/// it, and the P of the many may be as uncertain as it is.
double probability_of_cover(int total);

}  // namespace gurney::benchmark
