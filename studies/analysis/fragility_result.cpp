#include "studies/analysis/fragility_result.h"

#include <algorithm>
#include <cmath>

namespace gurney {
namespace {

constexpr int kGridPoints = 61;
constexpr std::size_t kMostStripes = 40;  ///< more distinct intensities are a cloud, not stripes

std::vector<double> grid(const std::vector<Stripe>& stripes) {
  if (stripes.empty()) return {};
  const double low = std::log(stripes.front().im / 1.5), high = std::log(stripes.back().im * 1.5);
  std::vector<double> im;
  for (int i = 0; i < kGridPoints; ++i)
    im.push_back(std::exp(low + (high - low) * i / (kGridPoints - 1)));
  return im;
}

/// Smaller demands are as good as none: the time step and the settling of the treads are in them.
constexpr double kFloorOfLimit = 1e-3;

void add_cloud(const StudyData& data, const FragilityRequest& request, const RunMeasure& measure,
               FragilityResult& result) {
  const LimitState& state = data.limit_states().at(request.state);
  if (state.kind != LimitState::Kind::kAbove || state.at_least > 1 || !(state.limit > 0)) return;
  result.cloud = fit_cloud(
      data.cloud(request.state, request.configuration, measure, kFloorOfLimit * state.limit));
  if (const auto fragility = cloud_fragility(*result.cloud, state.limit))
    result.cloud_curve = fragility->curve;
}

}  // namespace

std::optional<LognormalCurve> FragilityResult::curve() const {
  return capacities ? capacities->curve : fit.curve;
}

std::optional<CapacityFit> hunted_capacities(const StudyData& data, std::size_t state,
                                             const std::string& measure,
                                             const std::vector<Observation>& observations) {
  const IntensityPlan& plan = data.study().intensity;
  const bool ended_it = plan.kind == IntensityPlan::Kind::kHunt && plan.until == state;
  if (!ended_it || measure != data.file().text_attribute("intensity_measure")) return {};
  return fit_capacities(ida_capacities(observations));
}

FragilityResult fragility_of(const StudyData& data, const FragilityRequest& request) {
  const RunMeasure measure = data.measure(request.measure);
  const LimitState& state = data.limit_states().at(request.state);
  FragilityResult result;
  result.configuration = data.configurations().at(request.configuration);
  result.state = state.name;
  result.words = state.words;
  result.measure = {measure.name, measure.units, {}};
  result.failed = data.failed(request.configuration);
  const std::vector<Observation> observations =
      data.observations(request.state, request.configuration, measure);
  const StripeTable table(observations);
  result.fit = fit_fragility(table);
  result.runs = result.fit.runs;
  result.exceeded = result.fit.exceeded;
  result.records = result.fit.groups;
  result.im = grid(table.stripes());
  result.band = fragility_band(table, result.im,
                               {.confidence = request.confidence, .seed = data.study().seed});
  result.profile = profile_intervals(table, request.confidence, true);
  if (table.stripes().size() <= kMostStripes) {
    result.stripes = table.stripes();
    result.isotonic = isotonic_curve(result.stripes);
    result.check = check_fit(result.stripes, 999, data.study().seed);
  }
  const bool own = measure.name == data.file().text_attribute("intensity_measure");
  result.capacities = hunted_capacities(data, request.state, measure.name, observations);
  add_cloud(data, request, measure, result);
  if (own && data.study().hazard && result.curve())
    result.rate = mean_rate(*result.curve(), *data.study().hazard);
  return result;
}

}  // namespace gurney
