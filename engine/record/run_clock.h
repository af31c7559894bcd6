#pragma once

#include <string>
#include <vector>

#include "engine/base/floor_motion.h"
#include "engine/response/response.h"
#include "engine/scene/settings.h"

namespace gurney {

/// Where a run stops for a moment (the grid of time steps and the times at which loads change),
/// when it ends and with which outcome.
class RunClock {
 public:
  /// @param breakpoints  times at which a load starts, stops or changes slope
  RunClock(const FloorMotion& floor, std::vector<double> breakpoints,
           const SimulationSettings& settings);

  /// Moves target() to the next stop after `time`; false when the run is over.
  bool next(double time);
  double target() const { return target_; }

  /// Whether a load changes at target().
  bool at_breakpoint() const { return at_breakpoint_; }
  /// Whether a sample of the history (or, without one, of the energy balance) is due at target().
  bool sample_due() const { return on_grid_ && grid_ % stride_ == 0; }
  /// Whether a check of the energy balance is due at target().
  bool check_due() const { return on_grid_ && grid_ % check_stride_ == 0; }
  bool keeps_history() const { return settings_.history_step > 0; }

  /// Motion of one item: `speed` of its fastest part, `body_speed` without the joints of its casters, by
  /// which an item that lies on the floor rests [m/s].
  struct ItemMotion {
    double speed = 0, body_speed = 0, tilt = 0;
    bool on_item = false;  ///< it stands on another, where it topples: the run goes on
  };

  /// Ends the run when all items rest, or one has overturned and is not followed to rest.
  void observe(double time, const std::vector<ItemMotion>& items);
  void stop(Outcome outcome, std::string cause = {});

  /// When the item overturned or toppled; < 0: not [s].
  double overturned_at(std::size_t item) const {
    return item < overturned_at_.size() ? overturned_at_[item] : -1;
  }
  Outcome outcome() const { return outcome_; }
  const std::string& cause() const { return cause_; }

 private:
  SimulationSettings settings_;
  std::vector<double> breakpoints_;
  std::size_t next_break_ = 0;
  double excitation_end_, limit_;
  long grid_ = 0, stride_, check_stride_;
  std::vector<double> overturned_at_;
  bool any_overturned_ = false;
  double target_ = 0, resting_since_ = 0;
  double early_peak_ = 0, late_peak_ = 0;  // of the speed in the halves of the hold
  bool at_breakpoint_ = false, on_grid_ = true, over_ = false;
  Outcome outcome_;
  std::string cause_;
};

}  // namespace gurney
