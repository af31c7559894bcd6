#include "groundmotions/processing/pipeline.h"

#include <fmt/format.h>
#include <gmock/gmock.h>

#include <cmath>

#include "engine/base/units.h"
#include "groundmotions/measures/peaks.h"
#include "groundmotions/processing/baseline.h"
#include "groundmotions/processing/resample.h"
#include "groundmotions/processing/rotate.h"
#include "groundmotions/processing/trim.h"
#include "groundmotions/synthetic/clough_penzien.h"
#include "tests/support/error_text.h"

namespace gurney::groundmotions {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::StartsWith;

/// The shipped record, its horizontals with an offset of 0.02 m/s2, azimuths and a start time.
Record with_offset() {
  Record record = synthetic_record(shipped_synthetic_motion());
  record.name = "r";
  for (auto& component : record.components) component->start_time = 1000;
  for (const int i : {0, 1}) {
    record.components[i]->acceleration.array() += 0.02;
    record.components[i]->azimuth = i == 0 ? 0 : 270 * kRadiansPerDegree;
  }
  return record;
}

const Eigen::VectorXd& h1(const Record& record) { return record[Direction::kH1]->acceleration; }

/// The line of a single step.
std::string line_of(const ProcessingStep& step) {
  return processed(with_offset(), {step}).processing.at(0);
}

TEST(Pipeline, WithoutStepsChangesNothing) {
  const Record record = processed(with_offset(), {});
  EXPECT_EQ(h1(record), h1(with_offset()));
  EXPECT_TRUE(record.processing.empty());
}

TEST(Pipeline, DoesTheStepsInTheirOrder) {
  const Record record =
      processed(with_offset(), {Taper{1, 2}, Baseline{Baseline::Kind::kLine}, Resample{0.01}});
  const Eigen::VectorXd a = h1(with_offset());
  EXPECT_EQ(h1(record), resampled(0.005, without_polynomial(tapered(0.005, a, 1, 2), 1), 0.01));
  EXPECT_EQ(record[Direction::kVertical]->time_step, 0.01);
  EXPECT_EQ(record[Direction::kVertical]->acceleration.size(), 3001);
}

// 0.02 m/s2 over 30 s: 0.6 m/s and 9 m, on the largest of the horizontals.
TEST(Pipeline, ReportsWhatIsLeftAtTheEnd) {
  EXPECT_THAT(line_of(Baseline{Baseline::Kind::kPreEventMean, 0, 0.5}),
              StartsWith("mean of the first 0.5 s removed; residual velocity 0.6 -> "));
  EXPECT_THAT(line_of(Baseline{Baseline::Kind::kEndAtRest}),
              testing::MatchesRegex("polynomial of degree 1 removed so that velocity and "
                                    "displacement end at zero; residual velocity 0.6 -> "
                                    "[0-9.]+e-1[0-9] m/s, displacement 9 -> [0-9.]+e-1[0-9] m"));
}

TEST(Pipeline, WritesALineWithEveryParameter) {
  EXPECT_THAT(line_of(Baseline{}), StartsWith("mean removed; residual"));
  EXPECT_THAT(line_of(Baseline{Baseline::Kind::kLine}),
              StartsWith("least-squares line removed; residual"));
  EXPECT_THAT(line_of(Baseline{Baseline::Kind::kPolynomial, 3}),
              StartsWith("least-squares polynomial of degree 3 removed; residual"));
  EXPECT_THAT(line_of(Taper{0.05, 0.1, true}),
              StartsWith("cosine tapers of 1.5 s at the start and 3 s at the end; residual"));
  EXPECT_THAT(line_of(Resample{0.004}),
              StartsWith("resampled from 0.005 s (6001 samples) to 0.004 s (7501 samples), "
                         "Kaiser-windowed sinc, 100 dB; residual"));
  EXPECT_THAT(
      line_of(TrimToWindow{{2, 12}, 0.5}),
      testing::MatchesRegex("trimmed to 2 to 12 s: 2 to 12 s of 30 s kept, up to [0-9.]+ m/s "
                            "at the cuts, cosine tapers of 0.5 s; residual .*"));
  EXPECT_THAT(line_of(Rotate{Rotate::By::kAngle, 30 * kRadiansPerDegree}),
              StartsWith("horizontals rotated by 30 degrees counter-clockwise, h1 to azimuth 330; "
                         "residual"));
}

TEST(Pipeline, WritesALineForEveryFilter) {
  Butterworth filter;
  filter.high_pass = 0.1;
  EXPECT_THAT(
      line_of(filter),
      StartsWith("Butterworth high-pass, 0.1 Hz (-6 dB), order 4, two passes, tapers of 0.3 "
                 "s, zero pads of 60 s at both ends kept: 30001 samples; residual"));
  filter.low_pass = 25;
  filter.keep_pads = false;
  filter.taper = 1;
  EXPECT_THAT(line_of(filter),
              StartsWith("Butterworth band-pass, 0.1 to 25 Hz (-6 dB), order 4, two passes, tapers "
                         "of 1 s, zero pads of 60 s at both ends cut off again; residual"));
  filter.high_pass.reset();
  EXPECT_THAT(line_of(filter), StartsWith("Butterworth low-pass, 25 Hz (-6 dB), order 4"));
}

TEST(Pipeline, MovesTheStartTimeWithTheFirstSample) {
  const auto start = [](const ProcessingStep& step) {
    return *processed(with_offset(), {step})[Direction::kH1]->start_time;
  };
  Butterworth filter;
  filter.high_pass = 0.1;
  EXPECT_NEAR(start(filter), 940, 1e-9);
  filter.keep_pads = false;
  EXPECT_EQ(start(filter), 1000);
  EXPECT_NEAR(start(TrimToWindow{{2, 12}}), 1002, 1e-9);
  EXPECT_EQ(start(Resample{0.01}), 1000);
}

// h1 shakes at 10 to 12 s and h2 at 14 to 16 s: both are kept. The vertical has no say.
TEST(Pipeline, TrimsToTheLargestIntervalOfTheHorizontals) {
  Record record = with_offset();
  for (const int i : {0, 1, 2}) {
    record.components[i]->acceleration.setZero();
    record.components[i]->acceleration.segment(i == 2 ? 100 : 2000 + 800 * i, 401).setOnes();
  }
  const TrimToDuration step{.from = 0.05, .to = 0.95, .before = 1, .after = 2};
  const Record trimmed = processed(record, {step});
  // 5 % of 2 s within 10 s and 16 s, up to the one step (0.005 s) of the ramps: 9.1 to 17.9 s.
  EXPECT_NEAR(*trimmed[Direction::kH1]->start_time, 1009.1, 0.01);
  EXPECT_NEAR(static_cast<double>(trimmed.samples() - 1) * 0.005, 8.8, 0.02);
  EXPECT_THAT(trimmed.processing.at(0),
              StartsWith("trimmed to 5 to 95 % of the Husid curve of the horizontals (10.1 to 15.9 "
                         "s), margins of 1 s before and 2 s after: 9.095 to 17.905 s of 30 s kept, "
                         "up to 2 m/s at the cuts; residual"));
  record.components[0].reset();
  record.components[1].reset();
  // The trapezoid gives each ramp half a step, 401 in all; 5 % are 20.05, of which 19.55 lie behind
  // sample 100: 119.55 steps. 95 % likewise: 480.45 steps.
  EXPECT_THAT(processed(record, {step}).processing.at(0),
              HasSubstr("of the vertical (0.5978 to 2.402 s)"));
}

TEST(Pipeline, RotatesTheHorizontals) {
  const Record to_30 = processed(with_offset(), {Rotate{Rotate::By::kAzimuthOfH1, 1}});
  EXPECT_EQ(h1(to_30), h1(rotate_to(with_offset(), 1)));
  const Record fault = processed(with_offset(), {Rotate{Rotate::By::kStrike, 1}});
  EXPECT_EQ(h1(fault), h1(rotate_to_fault(with_offset(), 1)));
  EXPECT_EQ(fault.processing.size(), 1u);
}

// The recipe of docs/formats/processing.md ends at rest to rounding, 6000 to 30000 terms.
TEST(Pipeline, AdvisedOrderEndsAtRest) {
  Butterworth filter;
  filter.high_pass = 0.1;
  const Record record =
      processed(with_offset(), {Baseline{}, filter, TrimToDuration{.before = 5, .after = 10},
                                Baseline{Baseline::Kind::kEndAtRest}});
  EXPECT_TRUE(record.warnings.empty());
  for (const auto& component : record.components) {
    const EndMotion end = end_motion(component->time_step, component->acceleration);
    EXPECT_LT(std::abs(end.velocity), 1e-11);
    EXPECT_LT(std::abs(end.displacement), 1e-10);
  }
}

// The table of docs/formats/processing.md: the shipped record with 0.01 m/s2 on its horizontals.
// Half a unit of the last digit there.
TEST(Pipeline, PageShowsWhatComesOut) {
  Record offset = synthetic_record(shipped_synthetic_motion());
  for (const int i : {0, 1}) offset.components[i]->acceleration.array() += 0.01;
  const auto peak = [](const Record& record) {
    return integrated(record.time_step(), h1(record)).displacement.cwiseAbs().maxCoeff();
  };
  const auto end = [](const Record& record) {
    return std::abs(end_motion(record.time_step(), h1(record)).displacement);
  };
  Butterworth filter;
  filter.high_pass = 0.1;
  const Record kept = processed(offset, {Baseline{}, filter});
  EXPECT_NEAR(peak(kept), 0.183, 0.0005);
  EXPECT_LT(end(kept), 5e-7);
  const Record trimmed = processed(
      kept, {TrimToDuration{.before = 5, .after = 10}, Baseline{Baseline::Kind::kEndAtRest}});
  EXPECT_NEAR(peak(trimmed), 0.180, 0.0005);
  filter.keep_pads = false;
  EXPECT_NEAR(peak(processed(offset, {Baseline{}, filter})), 0.262, 0.0005);
  const auto rest = [&](int degree) {
    return processed(offset, {Baseline{Baseline::Kind::kEndAtRest, degree}});
  };
  EXPECT_NEAR(peak(rest(1)), 0.234, 0.0005);
  EXPECT_NEAR(peak(rest(4)), 0.194, 0.0005);
}

TEST(Pipeline, WarnsOfStepsThatUndoTheRest) {
  const Baseline rest{Baseline::Kind::kEndAtRest};
  EXPECT_THAT(
      processed(with_offset(), {rest, Taper{1, 1}, Rotate{Rotate::By::kAngle, 1}}).warnings,
      ElementsAre("processing: step 2 (taper) comes after end_at_rest and can bring velocity "
                  "and displacement at the end back; make end_at_rest the last step"));
  EXPECT_TRUE(processed(with_offset(), {rest, Taper{1, 1}, rest}).warnings.empty());
}

// h1 has 1 m/s2 from 10 to 12 s and -1 m/s2 from 14 to 16 s: up to 2 m/s between, at rest outside.
TEST(Pipeline, WarnsOfCutsIntoTheMotion) {
  Record record = with_offset();
  for (auto& component : record.components) component->acceleration.setZero();
  record.components[0]->acceleration.segment(2000, 401).setOnes();
  record.components[0]->acceleration.segment(2800, 401).setConstant(-1);
  EXPECT_TRUE(processed(record, {TrimToWindow{{9, 17}}}).warnings.empty());
  for (const TimeInterval cut : {TimeInterval{9, 13}, TimeInterval{13, 17}})
    EXPECT_THAT(processed(record, {TrimToWindow{cut}}).warnings,
                ElementsAre(fmt::format("processing: cut at {:g} and {:g} s, where the floor moves "
                                        "at up to 2 m/s along a component; keep more before or "
                                        "after",
                                        cut.from, cut.to)));
}

TEST(Pipeline, NamesTheStepThatCannotBe) {
  Butterworth filter;
  filter.low_pass = 150;
  EXPECT_EQ(error_text([&] {
              processed(with_offset(), {Baseline{}, filter});
            }),
            "record 'r', step 2 (low_pass): the low-pass corner must be more than 0 and less than "
            "the Nyquist frequency, 100 Hz for a time step of 0.005 s, got 150 Hz");
  Record record = with_offset();
  record.components[1].reset();
  EXPECT_EQ(
      error_text([&] { processed(record, {Rotate{}}); }),
      "record 'r', step 1 (rotate): only a record with azimuths of h1 and h2 can be rotated to "
      "an azimuth; rotate by an angle instead");
  EXPECT_EQ(error_text([&] { processed(with_offset(), {TrimToDuration{.before = -1}}); }),
            "record 'r', step 1 (trim): margins must be >= 0 s, got -1 and 0 s");
  EXPECT_EQ(error_text([] { processed(Record{}, {Baseline{}}); }),
            "record '' has no samples to process");
}

}  // namespace
}  // namespace gurney::groundmotions
