#include "studies/results/stored_predictability.h"

namespace gurney::study {

std::vector<std::pair<std::string, Predictability>> stored_predictability(const Hdf5Reader& file) {
  using Verdict = Predictability::Verdict;
  std::vector<std::pair<std::string, Predictability>> all;
  if (!file.has("/predictability/item")) return all;
  const auto items = file.strings("/predictability/item"),
             verdicts = file.strings("/predictability/verdict");
  const auto numbers = [&](const char* name) {
    return file.numbers(std::string("/predictability/") + name);
  };
  const auto growth = numbers("amplification"), at_peaks = numbers("amplification_at_peaks"),
             peaks = numbers("time_of_peaks"), horizons = numbers("horizon");
  for (std::size_t i = 0; i < items.size(); ++i) {
    Predictability& found = all.emplace_back(items[i], Predictability()).second;
    for (const Verdict each : {Verdict::kPredictable, Verdict::kSensitive, Verdict::kChaotic})
      if (verdicts.at(i) == name_of(each)) found.verdict = each;
    found.amplification = growth.at(i);
    found.amplification_at_peaks = at_peaks.at(i);
    found.time_of_peaks = peaks.at(i);
    found.horizon = horizons.at(i);
  }
  return all;
}

}  // namespace gurney::study
