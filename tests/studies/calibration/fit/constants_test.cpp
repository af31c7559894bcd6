#include "studies/calibration/fit/constants.h"

#include <gmock/gmock.h>

#include <cmath>

#include "studies/render/render.h"
#include "studies/report/calibration_report.h"

namespace gurney::calibration {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

TrialValue friction(const char* trial, double value, bool at_least) {
  TrialValue each{ConstantKind::kStaticFriction, trial, {}, value, 0.001, at_least};
  each.setup.caster = "R100";
  each.setup.floor = "vinyl";
  return each;
}

TEST(Constants, TakeBoundsOnlyWhereThereIsNothingElse) {
  const std::vector<TrialValue> bounds = {friction("a", 0.56, true), friction("b", 0.58, true)};
  const std::vector<Constant> bound = constants_of(bounds);
  ASSERT_EQ(bound.size(), 1u);
  EXPECT_TRUE(bound[0].at_least);
  EXPECT_LT(bound[0].interval.low, 0.56);
  EXPECT_FALSE(std::isfinite(bound[0].interval.high));

  std::vector<TrialValue> both = bounds;
  both.push_back(friction("c", 0.60, false));
  both.push_back(friction("d", 0.62, false));
  const std::vector<Constant> known = constants_of(both);
  EXPECT_FALSE(known[0].at_least);
  EXPECT_THAT(known[0].trials, ElementsAre("c", "d"));
  EXPECT_NEAR(known[0].value, 0.61, 1e-3);

  both.push_back(friction("e", 0.57, true));
  both.back().setup.use = TrialUse::kValidation;
  std::vector<std::string> unpredicted;
  EXPECT_TRUE(predictions_of(both, known, unpredicted).empty());
  EXPECT_THAT(unpredicted, ElementsAre("e: only a bound of mu_s"));
}

std::string text_of(const Calibration& c) {
  return render::text(report::calibration_findings(report::calibration_facts(c)));
}

TEST(Constants, TellThatAValueIsABound) {
  Calibration c;
  c.constants = constants_of({friction("a", 0.56, true), friction("b", 0.58, true)});
  EXPECT_THAT(text_of(c), HasSubstr(" or more"));
  EXPECT_THAT(text_of(c),
              AllOf(HasSubstr("mu_s of"), HasSubstr(" is a lower bound: with all wheels locked")));
  EXPECT_THAT(render::json(report::calibration_facts(c)), HasSubstr("\"lower_bound\": true"));
  c.constants = constants_of({friction("a", 0.56, false), friction("b", 0.58, false)});
  EXPECT_THAT(text_of(c), Not(HasSubstr("lower bound")));
}

}  // namespace
}  // namespace gurney::calibration
