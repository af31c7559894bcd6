#include <gmock/gmock.h>

#include <limits>

#include "engine/base/units.h"
#include "groundmotions/formats/readers.h"
#include "tests/groundmotions/formats/sac_sample.h"
#include "tests/groundmotions/formats/text_file.h"
#include "tests/support/error_text.h"

namespace gurney::groundmotions {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

Component read(const SacSample& sample, const ReadOptions& options = {.unit = "m/s2"}) {
  return read_text(sac_file(sample), options)[0];
}

std::string error(const SacSample& sample, const ReadOptions& options = {.unit = "m/s2"}) {
  return error_text([&] { read_text(sac_file(sample), options); });
}

TEST(Sac, ReadsBothByteOrdersAndVersions) {
  for (const bool is_swapped : {false, true})
    for (const int version : {6, 7}) {
      if (is_swapped && version == 7) continue;  // the sample's footer is not swapped
      const Component component = read({.version = version, .is_swapped = is_swapped});
      EXPECT_TRUE(component.acceleration.isApprox(Eigen::Vector4d(0.5, -1.25, 0.75, 0.25), 1e-15));
      EXPECT_EQ(component.format, "SAC");
      EXPECT_EQ(component.time_step, 0.02);  // not 0.0199999996, the single precision of it
      EXPECT_EQ(component.name, "HNE");
      EXPECT_DOUBLE_EQ(component.azimuth.value(), 90 * kRadiansPerDegree);
      // date -u -d '2001-06-01 15:05:37.5' +%s.%N is 991407937.5; B is 0.25 s.
      EXPECT_EQ(component.start_time, 991407937.75);
      EXPECT_EQ(fact(component, "station"), "XX01");
      EXPECT_THAT(component.warnings, IsEmpty());
    }
}

TEST(Sac, CountsTheDaysOfAYear) {
  // date -u -d '2001-01-01 15:05:37.5' +%s is 978361537.
  const auto start = [](int day) { return read({.integers = {{71, day}}}).start_time; };
  EXPECT_EQ(start(1), 978361537.75);
  EXPECT_EQ(start(366), 978361537.75 + 365 * 86400.0);
  EXPECT_FALSE(start(0));
  EXPECT_FALSE(start(367));
}

TEST(Sac, NeedsTheUnit) {
  EXPECT_THAT(error({}, {}), HasSubstr("f: a SAC file does not state its unit; state it as unit"));
  EXPECT_NEAR(read({}, {.unit = "g"}).acceleration[1], -1.25 * kStandardGravity, 1e-14);
  const Component counts = read({}, {.si_per_count = 1e-9});
  EXPECT_NEAR(counts.acceleration[1], -1.25e-9, 1e-24);
  EXPECT_EQ(counts.unit, "counts");
  EXPECT_THAT(error({}, {.unit = "g", .si_per_count = 1}),
              HasSubstr("unit and count_m_per_s2 were both given"));
}

TEST(Sac, KnowsTheVertical) {
  EXPECT_EQ(read({.name = "HNZ", .reals = {{57, 0}, {58, 0}}}).direction, Direction::kVertical);
  EXPECT_THAT(read({.name = "HNZ", .reals = {{57, 0}, {58, 0}}}).warnings, IsEmpty());
  const Component down = read({.name = "HNZ", .reals = {{58, 180}}});
  EXPECT_EQ(down.acceleration[1], 1.25);
  EXPECT_THAT(down.warnings, ElementsAre(HasSubstr("points down (CMPINC 180)")));
  EXPECT_THAT(
      read({.name = "HNZ", .reals = {{58, -12345}}}).warnings,
      ElementsAre("the component is called 'HNZ', but its inclination from up is not stated "
                  "(CMPINC)"));
  EXPECT_EQ(read({.name = "HNN", .reals = {{57, -12345}, {58, -12345}}}).azimuth, 0);
  EXPECT_EQ(read({.name = "HNE", .reals = {{57, -12345}, {58, -12345}}}).azimuth,
            90 * kRadiansPerDegree);
  EXPECT_FALSE(read({.name = "HN1", .reals = {{57, -12345}, {58, -12345}}}).azimuth);
}

TEST(Sac, RefusesWhatIsNoAcceleration) {
  EXPECT_THAT(error({.integers = {{86, 7}}}),
              HasSubstr("a record must be acceleration, but this file holds velocity (IDEP 7)"));
  EXPECT_THAT(error({.integers = {{86, 6}}}), HasSubstr("holds displacement (IDEP 6)"));
  EXPECT_THAT(error({.integers = {{85, 2}}}), HasSubstr("not a time series (IFTYPE 1)"));
  EXPECT_THAT(error({.integers = {{105, 0}}}), HasSubstr("unevenly spaced samples"));
  EXPECT_THAT(read({.integers = {{86, 5}}}).warnings,
              ElementsAre(HasSubstr("does not say that the samples are acceleration")));
}

TEST(Sac, ChecksLengthSamplesAndStep) {
  EXPECT_THAT(error({.integers = {{79, 5}}}),
              HasSubstr("5 samples make 652 bytes, but the file has 648: it was cut or changed"));
  EXPECT_THAT(error({.integers = {{79, -5}}}),
              HasSubstr("a record needs at least 2 samples, got -5"));
  EXPECT_THAT(error({.reals = {{0, 0}}}),
              HasSubstr("the time step must be in [1e-05, 1] s, got 0"));
  EXPECT_THAT(error({.values = {1, std::numeric_limits<float>::quiet_NaN()}}),
              HasSubstr("not all samples are finite numbers"));
  EXPECT_THAT(read({.reals = {{2, 3}}}).warnings,
              ElementsAre("the header states samples of -1.25 to 3, but they are -1.25 to 0.75"));
  EXPECT_THAT(error({}, {.unit = "g", .time_step = 0.01}),
              HasSubstr("the file states a time step of 0.02 s, but time_step_s = 0.01"));
}

TEST(Sac, ReportsTheMeanAndWhatWasNotApplied) {
  EXPECT_EQ(fact(read({}), "mean of the samples [m/s2]"), "0.0625");
  EXPECT_THAT(read({.reals = {{3, 2}}}).warnings, ElementsAre(HasSubstr("SCALE = 2")));
}

}  // namespace
}  // namespace gurney::groundmotions
