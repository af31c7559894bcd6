#include "studies/explanation/what_if.h"

#include <algorithm>
#include <mutex>

#include "engine/base/error.h"
#include "engine/base/parallel.h"
#include "engine/run/run.h"
#include "engine/scene/perturbed.h"
#include "studies/explanation/explain.h"
#include "studies/explanation/margins.h"
#include "studies/explanation/variants.h"

namespace gurney::explanation {
namespace {

/// Of one run.
struct RunOutcome {
  std::string failure;
  double peak_displacement = 0, tilt_ratio = 0, hardest_impact = 0;
  bool overturned = false, happened = false;
};

bool happened(const RunOutcome& run, Finding finding) {
  switch (finding) {
    case Finding::kOverturned:
      return run.overturned;
    case Finding::kHit:
      return run.overturned || run.hardest_impact >= kHit;
    case Finding::kRocked:
      return run.overturned || run.tilt_ratio >= kRocks;
    case Finding::kMoved:
    case Finding::kStill:
      break;
  }
  return run.overturned || run.peak_displacement > kHarmless;
}

RunOutcome outcome_of(const study::RunFacts& facts, const Scene& scene, const Explanation& of) {
  RunOutcome result;
  Response response;
  try {
    response = gurney::run(scene, facts.floor,
                           finely_stored(facts.settings, facts.floor, scene.items.size()));
    if (is_failure(response.outcome)) result.failure = "its run failed: " + response.cause;
  } catch (const Error& error) {
    result.failure = error.what();
  }
  if (!result.failure.empty()) return result;
  const ItemResponse& item = response.items.at(of.subject);
  const Impact* const hit = hardest_impact(response, of.subject);
  result.peak_displacement = item.demands.peak_displacement;
  result.tilt_ratio =
      tilt_margin(scene.items.at(of.subject).model, item.history, until_fall(item)).ratio();
  result.hardest_impact = hit == nullptr ? 0 : hit->approach_speed;
  result.overturned = item.demands.time_of_overturning >= 0;
  result.happened = happened(result, of.item().finding);
  return result;
}

/// Of an even number the mean of the middle two.
double median(std::vector<double> values) {
  if (values.empty()) return 0;
  std::ranges::sort(values);
  const std::size_t half = values.size() / 2;
  return values.size() % 2 == 1 ? values[half] : (values[half - 1] + values[half]) / 2;
}

VariantOutcome summed_up(const Variant& variant, const std::vector<RunOutcome>& runs) {
  VariantOutcome result{.name = variant.name, .clause = variant.clause, .reason = variant.reason};
  std::vector<double> displacements, ratios, impacts;
  for (const RunOutcome& run : runs) {
    if (!run.failure.empty()) {
      ++result.failed;
      continue;
    }
    ++result.runs;
    result.overturned += run.overturned;
    result.happened += run.happened;
    displacements.push_back(run.peak_displacement);
    ratios.push_back(run.tilt_ratio);
    impacts.push_back(run.hardest_impact);
  }
  result.peak_displacement = median(displacements);
  result.tilt_ratio = median(ratios);
  result.hardest_impact = median(impacts);
  if (result.reason.empty() && result.runs == 0 && !runs.empty())
    result.reason = runs.front().failure;
  return result;
}

}  // namespace

WhatIf what_if(const study::RunFacts& facts, const Explanation& of, std::size_t replicas,
               int threads, const std::function<void(std::size_t, std::size_t)>& progress) {
  std::vector<Variant> variants{{"as it was", "", facts.scene, {}}};
  for (Variant& variant : variants_of(facts, of)) variants.push_back(std::move(variant));
  std::vector<std::vector<RunOutcome>> runs(variants.size());
  std::vector<std::pair<std::size_t, std::size_t>> tasks;
  for (std::size_t i = 0; i < variants.size(); ++i) {
    if (!variants[i].reason.empty()) continue;
    runs[i].resize(replicas);
    for (std::size_t k = 0; k < replicas; ++k) tasks.emplace_back(i, k);
  }
  std::mutex reports;
  std::size_t finished = 0;
  parallel_for(tasks.size(), threads, [&](std::size_t t) {
    const auto [i, k] = tasks[t];
    runs[i][k] = outcome_of(facts, replica_of(variants[i].scene, k), of);
    if (!progress) return;
    const std::scoped_lock lock(reports);
    progress(++finished, tasks.size());
  });
  WhatIf result{.replicas = replicas, .as_it_was = summed_up(variants[0], runs[0]), .variants = {}};
  for (std::size_t i = 1; i < variants.size(); ++i)
    result.variants.push_back(summed_up(variants[i], runs[i]));
  return result;
}

}  // namespace gurney::explanation
