#include "groundmotions/formats/stated.h"

#include <gmock/gmock.h>

#include "tests/support/error_text.h"

namespace gurney::groundmotions {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

const ReadOptions kNoOptions;

struct Verdict {
  std::vector<std::string> warnings;
  std::string error;
};

/// The peak that a header states against samples of 0.02 m/s2.
Verdict peak(std::string_view stated, const AccelerationUnit& unit = {"cm/s2", 0.01}) {
  Component component;
  component.acceleration = Eigen::Vector2d(0.01, -0.02);
  const SourceFile named("f", "-");
  LayoutReader in(named, kNoOptions);
  in.check_peak({stated, 7}, unit, component);
  return {component.warnings, error_text([&] { in.errors.throw_if_any(); })};
}

// Samples have 2 cm/s2; allowed are half of the last digit and 0.1 % of the samples' peak.
TEST(Stated, ComparesPeaksToTheirLastDigit) {
  for (const char* good : {"2", "2.4", "-2.0", "2.0019", "2.000E+00", "0.2e1", "1.5"}) {
    const bool coarse = std::string_view(good) == "2.4" || std::string_view(good) == "1.5";
    EXPECT_EQ(peak(good).warnings.empty(), !coarse) << good;
    EXPECT_EQ(peak(good).error, "(no error)") << good;
  }
  EXPECT_THAT(peak("0.020", {"m/s2", 1}).warnings, IsEmpty());
  EXPECT_THAT(peak("2.003").warnings,
              ElementsAre("the file states a peak of 2.003 cm/s2, but its samples have 2 cm/s2"));
}

TEST(Stated, RefusesPeaksOffByMoreThanHalf) {
  EXPECT_EQ(peak("2.99").error, "(no error)");
  EXPECT_EQ(peak("3.01").error,
            "f:7:1: the file states a peak of 3.01 cm/s2, but its samples have 2 cm/s2");
  EXPECT_NE(peak("1.33").error, "(no error)");
  EXPECT_EQ(peak("1.34").error, "(no error)");
  EXPECT_EQ(peak("").error, "f:7:1: the peak must be a number, got ''");
  EXPECT_NE(peak("0.0").error, "(no error)");
}

TEST(Stated, AcceptsThePeakOfSamplesWithoutTheirMean) {
  Component component;
  const SourceFile named("f", "-");
  LayoutReader in(named, kNoOptions);
  component.acceleration = Eigen::Vector4d(1, 1.2, 0.8, 1);
  in.check_peak({1.2, 1e-9, 3}, component.acceleration, component);
  in.check_peak({0.2, 1e-9, 3}, component.acceleration, component);
  EXPECT_TRUE(component.warnings.empty());
  in.check_peak({1.25, 1e-9, 3}, component.acceleration, component);
  EXPECT_THAT(component.warnings,
              ElementsAre("the file states a peak of 1.25 m/s2, but its samples have 1.2 m/s2"));
  EXPECT_FALSE(in.errors.any());
  in.check_peak({2, 1e-9, 3}, component.acceleration, component);
  EXPECT_TRUE(in.errors.any());
}

TEST(Stated, ComparesLengths) {
  Component component;
  const SourceFile named("f", "-");
  LayoutReader in(named, kNoOptions);
  component.time_step = 0.1;
  component.acceleration = Eigen::VectorXd::Zero(100);
  for (const double good : {0.0, -1.0, 10.0, 9.75, 10.25}) in.check_length(good, 3, component);
  EXPECT_THAT(component.warnings, IsEmpty());
  in.check_length(12, 3, component);
  EXPECT_THAT(component.warnings,
              ElementsAre("the file states a length of 12 s, but its 100 samples at 0.1 s have "
                          "10 s"));
  EXPECT_FALSE(in.errors.any());
  in.check_length(16, 3, component);
  EXPECT_EQ(error_text([&] { in.errors.throw_if_any(); }),
            "f:3:1: the file states a length of 16 s, but its 100 samples at 0.1 s have 10 s");
}

/// What is reported of the unit and the time step that a file states, if it does.
std::string reported(std::optional<AccelerationUnit> unit, std::optional<double> time_step,
                     const ReadOptions& options, std::size_t line = 4) {
  const SourceFile named("f", "-");
  LayoutReader in(named, options);
  in.agreed_unit(unit, line);
  in.agreed_time_step(time_step, line);
  return error_text([&] { in.errors.throw_if_any(); });
}

TEST(Stated, FileAndUserMustAgree) {
  const AccelerationUnit gal{"cm/s2", 0.01};
  EXPECT_EQ(reported(gal, 0.02, {}), "(no error)");
  EXPECT_EQ(reported(gal, 0.02, {.unit = "gal", .time_step = 0.02}), "(no error)");
  EXPECT_EQ(reported({}, {}, {.unit = "g", .time_step = 0.02}), "(no error)");
  EXPECT_EQ(reported(gal, 0.02, {.unit = "g", .time_step = 0.01}),
            "f:4:1: the file states the unit cm/s2, but unit = \"g\" was given\n"
            "f:4:1: the file states a time step of 0.02 s, but time_step_s = 0.01 was given");
  EXPECT_EQ(reported(gal, 1.5, {}), "f:4:1: the time step must be in [1e-05, 1] s, got 1.5");
  EXPECT_EQ(reported({}, {}, {}),
            "f:4:1: the file does not state its unit; state it as unit = \"...\" or gurney records "
            "--unit (g, "
            "m/s2, cm/s2, "
            "gal, mm/s2, mg, %g, ft/s2 or in/s2)\n"
            "f:4:1: the file does not state its time step; state it as time_step_s or gurney "
            "records --time-step");
  EXPECT_EQ(reported({}, 0.02, {}, 0),
            "f: the file does not state its unit; state it as unit = \"...\" or gurney records "
            "--unit (g, m/s2, cm/s2, "
            "gal, mm/s2, mg, %g, ft/s2 or in/s2)");
}

}  // namespace
}  // namespace gurney::groundmotions
