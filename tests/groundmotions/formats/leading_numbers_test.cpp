#include <gmock/gmock.h>

#include <cmath>

#include "engine/base/units.h"
#include "groundmotions/formats/plain_facts.h"
#include "tests/groundmotions/formats/text_file.h"
#include "tests/support/error_text.h"

namespace gurney::groundmotions {
namespace {

using testing::Contains;
using testing::HasSubstr;
using testing::IsEmpty;

constexpr int kCount = 30;

double sample(int i) { return std::round(1e4 * 0.3 * std::sin(0.7 * i)) / 1e4; }

std::string samples() {
  std::string text;
  for (int i = 0; i < kCount; ++i) text += std::to_string(sample(i)) + "\n";
  return text;
}

std::string table() {
  std::string text;
  for (int i = 0; i < kCount; ++i)
    text += std::to_string(0.005 * i) + " " + std::to_string(sample(i)) + "\n";
  return text;
}

void expect_the_samples(const Component& component, double step) {
  ASSERT_EQ(component.acceleration.size(), kCount);
  EXPECT_DOUBLE_EQ(component.acceleration[3], sample(3) * kStandardGravity);
  EXPECT_EQ(component.time_step, step);
}

TEST(LeadingNumbers, ScaleAndStepAreNoSamples) {
  for (const ReadOptions& options :
       {ReadOptions{.unit = "g"}, ReadOptions{.unit = "g", .time_step = 0.01}}) {
    const Component component = read_one("1\n1.0e-02\n" + samples(), options);
    expect_the_samples(component, 0.01);
    EXPECT_THAT(component.warnings,
                Contains("the first two numbers, 1 and 0.01, look like a scale factor and the time "
                         "step; they were not taken as samples"));
  }
  expect_the_samples(read_one("1 0.01\n" + samples(), {.unit = "g"}), 0.01);
  EXPECT_THAT(error_text([] { read_text("981\n0.005\n" + samples(), {.unit = "g"}); }),
              HasSubstr("f:1:1: the first two numbers, 981 and 0.005, look like a scale factor"));
  EXPECT_THAT(
      error_text([] { read_text("1\n0.01\n" + samples(), {.unit = "g", .time_step = 0.02}); }),
      HasSubstr("f:1:1: the file states a time step of 0.01 s, but time_step_s = 0.02"));
}

TEST(LeadingNumbers, TheUserMaySayThatAllAreSamples) {
  const ReadOptions options{.unit = "gal", .time_step = 0.01, .columns = "samples"};
  const Component component = read_one("2\n0.01\n" + samples(), options);
  EXPECT_EQ(component.acceleration.size(), kCount + 2);
  EXPECT_THAT(component.warnings, Contains(HasSubstr("they were taken as samples")));
  const Component doubtful = read_one("0.01\n" + samples(), {.unit = "g", .time_step = 0.01});
  EXPECT_EQ(doubtful.acceleration.size(), kCount + 1);
  EXPECT_THAT(doubtful.warnings,
              Contains("sample 1 equals the time step, 0.01 s: is it a sample?"));
  EXPECT_THAT(read_one(samples(), {.unit = "g", .time_step = 0.01}).warnings, IsEmpty());
}

TEST(LeadingNumbers, CountsStandInOneRowOrTwo) {
  for (const char* first : {"30 0.005\n", "30\n0.005\n", "0.005\n30\n", "name\n30\t0.005\n"})
    expect_the_samples(read_one(first + samples(), {.unit = "g"}), 0.005);
  const Component alone = read_one("30\n" + samples(), {.unit = "g", .time_step = 0.02});
  expect_the_samples(alone, 0.02);
  EXPECT_THAT(alone.warnings, Contains(HasSubstr("the first number, 30, is how many follow")));
}

// The motion format of DEEPSOIL.
TEST(LeadingNumbers, ACountAndAStepMayStandAboveTimesAndValues) {
  for (const ReadOptions& options :
       {ReadOptions{.unit = "g"}, ReadOptions{.unit = "g", .columns = "time,h1"}}) {
    const Component component = read_one("30 0.005\n" + table(), options);
    expect_the_samples(component, 0.005);
    EXPECT_THAT(component.warnings, IsEmpty());
  }
  EXPECT_EQ(error_text([] { read_text("31 0.005\n" + table(), {.unit = "g"}); }),
            "f:1:1: the first row states 31 samples, but the file holds 30");
  EXPECT_EQ(error_text([] { read_text("30 0.01\n" + table(), {.unit = "g"}); }),
            "f:1:1: the first row states a time step of 0.01 s, but the times have 0.005 s");
}

// A table of times beside the accelerations, or an index column.
TEST(LeadingNumbers, TimesAndIndicesAreNoSamples) {
  std::string times, indices, both;
  for (int i = 0; i < kCount; ++i) {
    times += std::to_string(0.005 * i) + "\n";
    indices += std::to_string(i) + " " + std::to_string(sample(i)) + "\n";
    both += std::to_string(i) + " " + std::to_string(0.005 * i) + " 0.1\n";
  }
  const ReadOptions options{.unit = "m/s2", .time_step = 0.005};
  EXPECT_EQ(error_text([&] { read_text(times, options); }),
            "f:1:1: the numbers rise from 0 to 0.145 by the same 0.005: they are times or indices, "
            "no accelerations");
  EXPECT_THAT(error_text([&] {
                read_text("ACCELERATION TIME SERIES IN UNITS OF G\nNPTS= 30, DT= 0.005\n" + times);
              }),
              HasSubstr("f:3:1: the numbers rise from 0 to 0.145"));
  EXPECT_THAT(error_text([&] { read_text(both, {.unit = "g"}); }),
              HasSubstr("such as columns = \"skip,time,h1\""));
  EXPECT_EQ(read_one("1\n2\n3\n4\n5\n", options).acceleration.size(), 5);
}

}  // namespace
}  // namespace gurney::groundmotions
