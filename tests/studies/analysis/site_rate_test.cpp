#include <gmock/gmock.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "engine/base/units.h"
#include "studies/analysis/fragility_result.h"
#include "studies/render/render.h"
#include "studies/report/fragility_report.h"
#include "tests/studies/analysis/small_study.h"
#include "tests/studies/statistics/synthetic.h"
#include "tests/support/temp_folder.h"

namespace gurney::study {
namespace {

using statistics::HazardCurve;
using statistics::LognormalCurve;
using testing::AllOf;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

const std::vector<double> kLevels{0.1, 0.158, 0.251, 0.398, 0.631, 1.0};

/// Of a curve that 40 records determine.
SiteRate rate_of(const LognormalCurve& curve, const HazardCurve& hazard) {
  const auto outcomes = statistics::SyntheticStudy{.curve = curve, .levels = kLevels}.outcomes(1);
  const auto fit = statistics::fit_fragility(outcomes);
  return site_rate(*fit.curve, statistics::fragility_band(statistics::StripeTable(outcomes), {}),
                   outcome_audit(fit, outcomes, {}), hazard);
}

TEST(SiteRate, IsSupportedWhereTheRunsAre) {
  const HazardCurve hazard = HazardCurve::power_law(1e-4, 2.5);
  const SiteRate rate = rate_of({0.4, 0.3}, hazard);
  EXPECT_TRUE(rate.is_supported());
  EXPECT_THAT(cautions(rate, {"g", kStandardGravity}), IsEmpty());
  EXPECT_TRUE(rate.interval.contains(rate.rate));
  // k0 im^-k at the lowest level
  EXPECT_NEAR(*rate.of_lowest, 1e-4 * std::pow(10, 2.5), 1e-15);
  EXPECT_LT(rate.interval.high, *rate.of_lowest);
  EXPECT_THAT(rate_text(rate, {}), HasSubstr(" times a year (95 %: "));
}

// beta 0.7, k 3: the integrand is lognormal about theta exp(-k beta^2): Phi(ln(0.1 / 0.4) /
// 0.7 + 3 0.7) = 55 % of it is below 0.1.
TEST(SiteRate, SaysWhichPartWasNotAnalysed) {
  const SiteRate rate = rate_of({0.4, 0.7}, HazardCurve::power_law(1e-4, 3));
  EXPECT_GT(rate.share_below, 0.1);
  EXPECT_TRUE(std::isfinite(rate.rate));
  EXPECT_FALSE(rate.is_supported());
  EXPECT_THAT(cautions(rate, {"g", 1}),
              testing::ElementsAre(HasSubstr("% of the rate is from motions below the lowest "
                                             "analysed intensity, 0.1 g")));
}

// k0 theta^-k exp(k^2 beta^2 / 2) with beta = 1.7 and k = 3 is 4.5e5 k0, motions above 0.1 have
// 1000 k0: 40 times a year for k0 = 1e-4.
TEST(SiteRate, IsNotStatedAboveTheHazardOfTheLowestLevel) {
  const SiteRate rate = rate_of({1, 1.7}, HazardCurve::power_law(1e-4, 3));
  EXPECT_TRUE(std::isnan(rate.rate));
  EXPECT_FALSE(rate.is_supported());
  EXPECT_TRUE(std::isinf(rate.interval.high));
  EXPECT_EQ(rate_text(rate, {}), "no annual rate");
  EXPECT_THAT(cautions(rate, {"g", 1}),
              testing::ElementsAre(HasSubstr("motions above the lowest analysed intensity, 0.1 a "
                                             "year at 0.1 g: the runs do not support a rate")));
  // A table has a lowest intensity, and no more than its rate.
  const SiteRate of_table = rate_of({1, 1.7}, HazardCurve::table({0.1, 1, 10}, {0.1, 1e-4, 1e-7}));
  EXPECT_LE(of_table.rate, 0.1);
}

// 3 of 240 runs exceed, one at each of three levels: theta would be 1.55e6 g, by the cloud
// 1e45 g, beta 6.8, and the closed form of the rate 1e70 a year and more.
TEST(SiteRate, OfFewOutcomesIsNoAstronomicalNumber) {
  std::vector<SmallRun> runs;
  for (std::size_t record = 0; record < 40; ++record)
    for (std::size_t level = 0; level < kLevels.size(); ++level) {
      const bool exceeds = record == level && (level == 1 || level == 3 || level == 5);
      runs.push_back({record, kLevels[level] * kStandardGravity, exceeds ? 0.2 : 0.05});
    }
  TempFolder folder;
  write_small_study(folder.file("s.h5"), runs);
  const StudyData data(folder.file("s.h5"));
  const FragilityResult result = fragility_of(data, {});
  const std::string text = render::text(report::fragility_findings(data, {result}));
  EXPECT_THAT(text, Not(testing::ContainsRegex("e\\+[0-9]"))) << text;
  const auto json = nlohmann::json::parse(
      render::json(report::fragility_findings(data, {result})))["fragilities"][0];
  EXPECT_THAT(text, HasSubstr("hardly or not"));
  EXPECT_FALSE(json.contains("rate"));
  EXPECT_TRUE(json["curve"].is_null());
}

TEST(SiteRate, ThatIsNotStatedIsNull) {
  std::vector<SmallRun> runs;  // as many exceed at 0.1 g as not at 1 g
  for (std::size_t record = 0; record < 40; ++record)
    for (std::size_t level = 0; level < kLevels.size(); ++level)
      runs.push_back(
          {record, kLevels[level] * kStandardGravity, record < 10 + 4 * level ? 0.2 : 0.05});
  TempFolder folder;
  write_small_study(folder.file("s.h5"), runs);
  const StudyData data(folder.file("s.h5"));
  const FragilityResult result = fragility_of(data, {});
  EXPECT_THAT(render::text(report::fragility_findings(data, {result})),
              AllOf(HasSubstr("no annual rate"), HasSubstr("do not support a rate")));
  const auto rate = nlohmann::json::parse(
      render::json(report::fragility_findings(data, {result})))["fragilities"][0]["rate"];
  EXPECT_TRUE(rate["per_year"].is_null());
  EXPECT_TRUE(rate["in_50_years"].is_null());
  EXPECT_EQ(rate["complete"], false);
  EXPECT_EQ(rate["cautions"].size(), 1);
}

}  // namespace
}  // namespace gurney::study
