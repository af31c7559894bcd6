#include <algorithm>
#include <cmath>
#include <utility>

#include "studies/loss/study_loss.h"

namespace gurney::study {
namespace {

constexpr int kPanels = 64;  // of each interval between two intensities

double rate_at(const statistics::HazardCurve& hazard, double im) {
  const auto& pieces = hazard.pieces();
  return *hazard.rate(std::clamp(im, pieces.front().low, pieces.back().high));
}

}  // namespace

EventCurve::EventCurve(std::vector<statistics::Stripe> stripes) {
  std::erase_if(stripes, [](const statistics::Stripe& each) { return each.runs == 0; });
  const statistics::ProbitFit fit = statistics::fit_probit(stripes);
  status_ = fit.status;
  if (status_ == statistics::FragilityStatus::kFitted)
    curve_ = fit.curve();
  else
    take_shares(std::move(stripes));
}

EventCurve::EventCurve(const std::vector<statistics::Capacity>& capacities) {
  const statistics::CapacityFit fit = statistics::fit_capacities(capacities);
  status_ = fit.status;
  curve_ = fit.curve;
  if (!curve_) take_shares(statistics::stripes_of(capacities));
}

void EventCurve::take_shares(std::vector<statistics::Stripe> stripes) {
  if (stripes.empty()) return;
  for (const statistics::Stripe& each : stripes) im_.push_back(each.im);
  share_ = statistics::isotonic_curve(stripes);
}

double EventCurve::probability(double im) const {
  if (curve_) return curve_->probability(im);
  const auto above = std::ranges::lower_bound(im_, im);
  if (above == im_.end()) return share_.empty() ? 0 : share_.back();
  const auto i = static_cast<std::size_t>(above - im_.begin());
  if (*above == im) return share_[i];
  if (i == 0) return 0;
  const double part = std::log(im / im_[i - 1]) / std::log(im_[i] / im_[i - 1]);
  return std::lerp(share_[i - 1], share_[i], part);
}

double rate_of_shares(const std::vector<double>& im, const std::vector<double>& share,
                      const statistics::HazardCurve& hazard) {
  double sum = share.back() * rate_at(hazard, im.back());
  for (std::size_t i = 1; i < im.size(); ++i)
    for (int panel = 0; panel < kPanels; ++panel) {
      const auto at = [&](int end) {
        return im[i - 1] * std::pow(im[i] / im[i - 1], static_cast<double>(end) / kPanels);
      };
      const double middle = std::lerp(share[i - 1], share[i], (panel + 0.5) / kPanels);
      sum += middle * (rate_at(hazard, at(panel)) - rate_at(hazard, at(panel + 1)));
    }
  return sum;
}

double EventCurve::rate(const statistics::HazardCurve& hazard) const {
  if (curve_) return statistics::mean_rate(*curve_, hazard).rate;
  return im_.empty() ? 0 : rate_of_shares(im_, share_, hazard);
}

}  // namespace gurney::study
