#include "groundmotions/scaling/scale.h"

#include <gmock/gmock.h>

#include "tests/support/expect_error.h"

namespace gurney::groundmotions {
namespace {

using testing::ElementsAre;

Record record() {
  Record r;
  r.name = "invented";
  for (const Direction direction : {Direction::kH1, Direction::kVertical}) {
    Component c;
    c.direction = direction;
    c.time_step = 0.01;
    c.acceleration = Eigen::Vector3d(0, direction == Direction::kH1 ? 2 : 1, 0);
    r.components[static_cast<std::size_t>(direction)] = c;
  }
  return r;
}

double pga(const Record& r, Direction direction) {
  return r[direction]->acceleration.cwiseAbs().maxCoeff();
}

const ScalingMeasure kPga{"PGA of h1 [m/s2]",
                          [](const Record& r) { return pga(r, Direction::kH1); }};

TEST(Scaled, TreatsTheVerticalByItsRule) {
  using Rule = VerticalScaling::Rule;
  const Record alike = scaled(record(), 1.5);
  EXPECT_EQ(pga(alike, Direction::kH1), 3);
  EXPECT_EQ(pga(alike, Direction::kVertical), 1.5);
  EXPECT_THAT(alike.processing, ElementsAre("scaled by 1.5"));
  const Record kept = scaled(record(), 1.5, {.rule = Rule::kKept});
  EXPECT_EQ(pga(kept, Direction::kH1), 3);
  EXPECT_EQ(pga(kept, Direction::kVertical), 1);
  EXPECT_THAT(kept.processing, ElementsAre("scaled by 1.5, vertical by 1"));
  const Record own = scaled(record(), 1.5, {.rule = Rule::kOwn, .factor = 3});
  EXPECT_EQ(pga(own, Direction::kVertical), 3);
  EXPECT_ERROR(scaled(record(), 0), "invented: factors 0 and 0 (vertical): must be finite");
  EXPECT_ERROR(scaled(record(), -1, {.rule = Rule::kKept}), "must be finite numbers > 0");
  EXPECT_ERROR(scaled(record(), 1, {.rule = Rule::kOwn, .factor = 0}),
               "factors 1 and 0 (vertical): must be finite");
  EXPECT_ERROR(scaled(record(), NAN), "must be finite numbers > 0");
}

TEST(Scaled, WarnsOfFactorsAboveTwenty) {
  EXPECT_THAT(scaled(record(), 20).warnings, testing::IsEmpty());
  EXPECT_THAT(scaled(record(), 21).warnings,
              ElementsAre(testing::HasSubstr("scaled by 21, more than 20")));
}

TEST(ScaleTo, ReachesTheValue) {
  const Record result = scale_to(record(), kPga, 5);
  EXPECT_DOUBLE_EQ(pga(result, Direction::kH1), 5);
  EXPECT_THAT(result.processing, ElementsAre("scaled by 2.5: PGA of h1 [m/s2] from 2 to 5"));
  const ScalingMeasure energy{
      "energy", [](const Record& r) { return r[Direction::kH1]->acceleration.squaredNorm(); }, 2};
  EXPECT_DOUBLE_EQ(pga(scale_to(record(), energy, 16), Direction::kH1), 4);
}

TEST(ScaleTo, MayReachItsLimits) {
  EXPECT_EQ(pga(scale_to(record(), kPga, 8, {}, {.largest = 4}), Direction::kH1), 8);
  EXPECT_EQ(pga(scale_to(record(), kPga, 1, {}, {.smallest = 0.5}), Direction::kH1), 1);
}

TEST(ScaleTo, RefusesWhatItCannotReach) {
  EXPECT_ERROR(scale_to(record(), kPga, 20, {}, {.smallest = 0.5, .largest = 4}),
               "invented: PGA of h1 [m/s2] is 2; to reach 20 the record must be scaled by 10; "
               "allowed: 0.5 to 4");
  EXPECT_ERROR(scale_to(record(), kPga, 0.5, {}, {.smallest = 0.5}), "allowed: 0.5 to inf");
  const ScalingMeasure duration{"duration [s]", [](const Record&) { return 3.; }};
  EXPECT_ERROR(scale_to(record(), duration, 6),
               "duration [s] is 3 after scaling by 2, not 6: it does not grow with the power 1");
  const ScalingMeasure up{"PGA up", [](const Record& r) { return pga(r, Direction::kVertical); }};
  EXPECT_ERROR(scale_to(record(), up, 2, {.rule = VerticalScaling::Rule::kKept}),
               "PGA up is 1 after scaling by 2, not 2");
  Record still = record();
  still.components[0]->acceleration.setZero();
  EXPECT_ERROR(scale_to(still, kPga, 1), "is 0, to be scaled to 1: both must be > 0");
}

}  // namespace
}  // namespace gurney::groundmotions
