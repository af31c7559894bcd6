#pragma once

#include <optional>
#include <string>
#include <vector>

#include "studies/analysis/curve_audit.h"
#include "studies/statistics/bands.h"
#include "studies/statistics/hazard.h"

namespace gurney::study {

/// A larger part of a rate from intensities that were not analysed is cautioned against.
inline constexpr double kLargestShare = 0.1;

/// Mean annual rate of a limit state at a site, and how far the runs support it. NaN where it would
/// exceed that of motions above the lowest analysed intensity: a limit state that needs such a
/// motion cannot, and that the others matter is the form of the curve alone.
struct SiteRate : statistics::MeanRate {
  statistics::Interval interval{0, 0};  ///< of the band's lines; an end above `of_lowest`: infinite
  bool has_interval = false;
  double lowest = 0, highest = 0;           ///< im of the runs
  double share_below = 0, share_above = 0;  ///< of the rate, from motions beyond these
  std::optional<double> of_lowest;          ///< the hazard's rate at `lowest`

  /// The hazard curve is long enough, and the integral lies within the analysed intensities.
  bool is_supported() const;
};

SiteRate site_rate(const statistics::LognormalCurve& curve, const statistics::FragilityBand& band,
                   const CurveAudit& audit, const statistics::HazardCurve& hazard);

/// `0.0012 times a year (0.0007 to 0.0021), 6 % in 50 years`
std::string rate_text(const SiteRate& rate, std::size_t records);
std::string rate_interval_text(const SiteRate& rate, std::size_t records);

std::vector<std::string> cautions(const SiteRate& rate, const ReportUnit& unit);

}  // namespace gurney::study
