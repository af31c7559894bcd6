#pragma once

#include <optional>
#include <string>
#include <vector>

#include "studies/analysis/curve_audit.h"
#include "studies/analysis/study_data.h"
#include "studies/loss/consequences.h"
#include "studies/statistics/capacity.h"
#include "studies/statistics/fragility.h"
#include "studies/statistics/hazard.h"
#include "studies/statistics/resample.h"

namespace gurney::study {

/// An item of a study with its price.
struct PricedItem {
  std::string name;       ///< in the scene
  std::string equipment;  ///< under which the file has its price
  equipment::StatedQuantity price;
};

/// Items of the first run of a configuration that have a price.
/// @param unpriced  gets the names of the others
std::vector<PricedItem> priced_items(const StudyData& data, std::size_t configuration,
                                     const Consequences& consequences,
                                     std::vector<std::string>& unpriced);

/// What one item costs in one run. Of all states that it reaches the worst cost counts, the longest
/// time, the worst injury and the worst service, each by itself.
struct ItemLoss {
  double cost = 0;           ///< expected
  double drawn = 0;          ///< in a sample of price and ratio
  double low = 0, high = 0;  ///< with all numbers at the ends of their ranges
  double days = 0;
  Injury injury = Injury::kNone;
  Service service = Service::kKept;
};

/// @param reached  for each of the consequences' limit states
/// @param sample   number of the sample from which `drawn` is
ItemLoss item_loss(const Consequences& consequences, const PricedItem& item,
                   const std::vector<bool>& reached, std::uint64_t seed, std::uint64_t sample);

/// The ordered costs that an item can have, and an event for each: it costs that or more.
struct LossStep {
  std::string item, states;  ///< states: that cost this or more, "a or b"
  double cost = 0;           ///< what this step adds to those before it
};

/// An estimate with its 95 % interval; none: too few records.
struct LossEstimate {
  double value = 0;
  std::optional<statistics::Interval> interval;
};

/// Numbers of the runs at one of the levels at which a study was made.
struct LossAtLevel {
  std::string level;
  std::size_t runs = 0, records = 0;
  LossEstimate cost, days;   ///< means; days: sum over the items
  double low = 0, high = 0;  ///< mean cost with all numbers at the ends of their ranges
  double median = 0, p90 = 0, largest = 0;          ///< of the drawn costs of runs
  statistics::Proportion any, out_of_use, serious;  ///< P(a cost), P(an item is out), P(injury)
};

/// Mean annual rate of what has the value `share` at intensities `im`: linear in ln im between,
/// nothing below the lowest, constant above the highest. The error of its panels, 1/64 of an
/// interval, is below 1e-4 for im^-k, k <= 3, and levels a factor of 4 apart.
/// @param im  > 0, increasing, one or more
double rate_of_shares(const std::vector<double>& im, const std::vector<double>& share,
                      const statistics::HazardCurve& hazard);

/// P(event | im): the lognormal curve that fits its outcomes, or its capacities after an IDA, else,
/// where none does, the shares of the runs or analysis cases at each intensity that never fall with
/// it (isotonic_curve()): linear in ln im between, nothing below the lowest intensity, constant above
/// the highest.
class EventCurve {
 public:
  EventCurve() = default;
  explicit EventCurve(std::vector<statistics::Stripe> stripes);
  explicit EventCurve(const std::vector<statistics::Capacity>& capacities);

  bool is_fitted() const { return curve_.has_value(); }
  const std::optional<statistics::LognormalCurve>& curve() const { return curve_; }
  statistics::FragilityStatus status() const { return status_; }
  double probability(double im) const;

  /// Mean annual rate, as far as the hazard curve reaches.
  double rate(const statistics::HazardCurve& hazard) const;

 private:
  void take_shares(std::vector<statistics::Stripe> stripes);

  statistics::FragilityStatus status_ = statistics::FragilityStatus::kNoRuns;
  std::optional<statistics::LognormalCurve> curve_;
  std::vector<double> im_, share_;
};

/// A step with the curve of its event.
struct FittedStep : LossStep {
  std::size_t happened = 0;  ///< runs
  EventCurve curve;
  CurveAudit audit;
  std::optional<double> rate;  ///< a year, with a hazard
};

/// How likely, or how often a year, the cost of all items together is above a value. The costs are
/// those drawn for the runs, each event has its own EventCurve, and a higher value is cut to the
/// chance of a lower one where their curves cross.
struct LossExceedance {
  double cost = 0;      ///< >= 0
  LossEstimate chance;  ///< probability, or rate a year
  bool fitted = false;  ///< by a lognormal curve, else from the shares of the runs
};

/// Round costs at which an exceedance curve is stated: one below the smallest of the positive `costs`
/// and those from there up to below the largest: 1, 2 and 5 times the powers of ten, within a decade
/// each digit. None without a positive cost.
std::vector<double> exceedance_costs(const std::vector<double>& costs);

/// From curves: at an intensity, or a year.
struct ExpectedLoss {
  double im = 0;                                 ///< SI; of a year: 0
  LossEstimate cost, days, out_of_use, serious;  ///< the last two: probability, or rate a year
  std::vector<LossExceedance> exceedance;        ///< by increasing cost
};

/// Losses in one configuration.
struct StudyLoss {
  std::string configuration;
  RunMeasure measure;  ///< without its values
  std::vector<PricedItem> items;
  std::vector<std::string> unpriced, missing;  ///< items without a price; states not in the file
  std::vector<LossAtLevel> levels;             ///< none after an IDA or a cloud of factors
  std::vector<FittedStep> steps;
  std::vector<ExpectedLoss> at;
  std::optional<ExpectedLoss> annual;
  std::vector<std::string> cautions;
  std::size_t runs = 0, records = 0, failed = 0;
};

struct LossRequest {
  std::string measure{};     ///< empty: the study's own
  std::vector<double> at{};  ///< intensities, SI
  int threads = 1;
};

/// Losses of each configuration that has runs.
/// @throws Error for a measure that the file lacks, and where no item has a price
std::vector<StudyLoss> study_losses(const StudyData& data, const Consequences& consequences,
                                    const LossRequest& request);

}  // namespace gurney::study
