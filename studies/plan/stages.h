#pragma once

#include <optional>
#include <set>
#include <vector>

#include "studies/plan/study.h"
#include "studies/statistics/fragility.h"

namespace gurney::study {

/// The intensities of one record, one after the other.
///
/// Levels are taken in their order. An IDA (incremental dynamic analysis; Vamvatsikos & Cornell
/// 2002, EESD 31(3), 491-514) goes up with steps that grow by the increment each, until the limit
/// state is exceeded; then it halves the bracket between the highest intensity that is safe below
/// the lowest that is not and the latter, until the bracket is narrower than `resolution` of its
/// lower end. Then it fills: `fill` more, each in the middle of the widest gap below the capacity.
/// It ends early where the runs are used up.
class Intensities {
 public:
  explicit Intensities(const IntensityPlan& plan) : plan_(&plan) {}

  /// The next value of the measure [SI], or factor of kScales; empty: there is no more.
  std::optional<double> next() const;

  /// Takes the outcome at that value.
  void report(double value, bool exceeded);

  void stop() { stopped_ = true; }  ///< a run failed: nothing is known of what lies above

 private:
  std::optional<double> traced() const;
  double middle_of_widest_gap() const;
  double highest_below(double value) const;

  const IntensityPlan* plan_;
  std::size_t done_ = 0;
  std::set<double> tried_;
  int filled_ = 0;
  double safe_ = 0;                 ///< highest below the lowest that is not
  std::optional<double> exceeded_;  ///< lowest
  bool narrow_ = false;             ///< the bracket is: what comes now fills
  bool stopped_ = false;
};

inline constexpr int kLevelsOfAStage = 2;

/// The levels at which a next stage of stripes determines theta and beta best, increasing: with a
/// lognormal curve fitted to the stripes so far those where it is 12.8 and 87.2 %, the D-optimal
/// design of a probit line (Abdelbasit & Plackett 1983, J. American Statistical Association 78,
/// 90-98), but within twice the
/// highest and half the lowest stripe. Where there is no curve:
/// - all or none exceed: 1.5 and 2 times below the lowest, or above the highest;
/// - separated: the thirds of the interval between, on a logarithmic scale;
/// - one stripe only with both outcomes: half of the way to its neighbours;
/// - no rise with intensity: 1.5 times beyond either end.
///
/// Levels have three digits in their unit. One within 1 % of a stripe that was made would be the
/// same runs again, and goes outward in steps of 5 %.
/// @param stripes  im increases, in SI; at least one
/// @param unit     of the levels in SI
std::vector<double> next_levels(const std::vector<statistics::Stripe>& stripes, double unit);

}  // namespace gurney::study
