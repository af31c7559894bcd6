#pragma once

#include <optional>
#include <set>

#include "studies/plan/study.h"

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

  /// What came of it.
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

}  // namespace gurney::study
