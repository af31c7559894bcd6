#include "engine/record/run_clock.h"

#include <algorithm>
#include <cmath>

namespace gurney {
namespace {

constexpr double kTimeTolerance = 1e-8;  // [s]; stops nearer than this are one
constexpr double kNoMotion = 1e-7;       // [m/s]
constexpr double kAccountStep = 0.1;     // [s]; checks of the energy balance

}  // namespace

RunClock::RunClock(const FloorMotion& floor, std::vector<double> breakpoints,
                   const SimulationSettings& settings)
    : settings_(settings),
      breakpoints_(std::move(breakpoints)),
      outcome_(settings.duration > 0 ? Outcome::kStopped : Outcome::kStillMoving) {
  if (!floor.at_rest()) breakpoints_.push_back(floor.duration());
  std::sort(breakpoints_.begin(), breakpoints_.end());
  excitation_end_ = breakpoints_.empty() ? 0.0 : breakpoints_.back();
  limit_ = settings.duration > 0 ? settings.duration : excitation_end_ + settings.settle_time;
  const auto stride = [&](double spacing) {
    return std::max(1L, std::lround(spacing / settings.time_step));
  };
  check_stride_ = stride(kAccountStep);
  stride_ = keeps_history() ? stride(settings.history_step) : check_stride_;
}

bool RunClock::next(double time) {
  if (over_ || time >= limit_ - kTimeTolerance) return false;
  if (on_grid_) ++grid_;
  const double stop = std::min(static_cast<double>(grid_) * settings_.time_step, limit_);
  while (next_break_ < breakpoints_.size() && breakpoints_[next_break_] <= time + kTimeTolerance)
    ++next_break_;
  const bool breaks = next_break_ < breakpoints_.size();
  on_grid_ = !breaks || breakpoints_[next_break_] >= stop - kTimeTolerance;
  at_breakpoint_ = breaks && breakpoints_[next_break_] <= stop + kTimeTolerance;
  target_ = on_grid_ ? stop : breakpoints_[next_break_];
  return true;
}

void RunClock::observe(double time, const std::vector<ItemMotion>& items) {
  overturned_at_.resize(items.size(), -1);
  double speed = 0;
  for (std::size_t i = 0; i < items.size(); ++i) {
    const bool lay = overturned_at_[i] >= 0;
    speed = std::max(speed, lay ? items[i].body_speed : items[i].speed);
    if (lay || !(items[i].tilt > settings_.overturn_tilt)) continue;
    overturned_at_[i] = time;
    if (items[i].on_item) continue;
    any_overturned_ = true;
    outcome_ = Outcome::kOverturned;
  }
  if (any_overturned_ && !settings_.follow_overturning) return stop(Outcome::kOverturned);
  if (settings_.duration > 0) return;
  if (speed > settings_.rest_speed || time < excitation_end_) {
    resting_since_ = std::max(time, excitation_end_);
    early_peak_ = late_peak_ = 0;
    return;
  }
  const double held = time - resting_since_;
  double& peak = held < settings_.rest_hold / 2 ? early_peak_ : late_peak_;
  peak = std::max(peak, speed);
  if (held < settings_.rest_hold - kTimeTolerance) return;
  if (late_peak_ <= early_peak_ + kNoMotion)
    return stop(any_overturned_ ? Outcome::kOverturned : Outcome::kRested);
  resting_since_ = time;  // slow but gaining speed: not at rest
  early_peak_ = late_peak_ = 0;
}

void RunClock::stop(Outcome outcome, std::string cause) {
  over_ = true;
  outcome_ = outcome;
  cause_ = std::move(cause);
}

}  // namespace gurney
