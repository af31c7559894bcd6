#include <gmock/gmock.h>

#include <algorithm>
#include <set>

#include "engine/base/units.h"
#include "groundmotions/processing/pipeline.h"
#include "tests/support/error_text.h"
#include "tests/support/key_table.h"

namespace gurney::groundmotions {
namespace {

std::vector<ProcessingStep> steps_of(const std::string& list) {
  config::Document document("processing = [" + list + "]\n", "a.toml");
  config::Table root = document.root();
  auto steps = read_processing_steps(root);
  document.finish();
  return steps;
}

template <typename Step>
Step step_of(const std::string& text) {
  return std::get<Step>(steps_of("{ step = " + text + " }").at(0));
}

/// The errors of a list of steps, without the name of the file.
std::string errors(const std::string& list) {
  return error_text([&] { steps_of(list); });
}

TEST(StepReader, ReadsBaselines) {
  using Kind = Baseline::Kind;
  EXPECT_EQ(step_of<Baseline>(R"("baseline", kind = "mean")").kind, Kind::kMean);
  EXPECT_EQ(step_of<Baseline>(R"("baseline", kind = "line")").kind, Kind::kLine);
  const auto polynomial = step_of<Baseline>(R"("baseline", kind = "polynomial", degree = 8)");
  EXPECT_EQ(polynomial.kind, Kind::kPolynomial);
  EXPECT_EQ(polynomial.degree, 8);
  const auto pre = step_of<Baseline>(R"("baseline", kind = "pre_event_mean", pre_event_s = 2.5)");
  EXPECT_EQ(pre.kind, Kind::kPreEventMean);
  EXPECT_EQ(pre.pre_event, 2.5);
  EXPECT_EQ(step_of<Baseline>(R"("baseline", kind = "end_at_rest")").degree, 1);
  const auto rest = step_of<Baseline>(R"("baseline", kind = "end_at_rest", degree = 4)");
  EXPECT_EQ(rest.kind, Kind::kEndAtRest);
  EXPECT_EQ(rest.degree, 4);
}

TEST(StepReader, ReadsTapers) {
  const auto seconds = step_of<Taper>(R"("taper", start_s = 1, end_s = 2)");
  EXPECT_EQ(seconds.start, 1);
  EXPECT_EQ(seconds.end, 2);
  EXPECT_FALSE(seconds.fraction);
  const auto share = step_of<Taper>(R"("taper", end_fraction = 0.05)");
  EXPECT_EQ(share.start, 0);
  EXPECT_EQ(share.end, 0.05);
  EXPECT_TRUE(share.fraction);
}

TEST(StepReader, ReadsFilters) {
  const auto high = step_of<Butterworth>(R"("high_pass", corner_hz = 0.1)");
  EXPECT_EQ(high.high_pass, 0.1);
  EXPECT_FALSE(high.low_pass);
  EXPECT_EQ(high.order, 4);
  EXPECT_TRUE(high.keep_pads);
  EXPECT_FALSE(high.taper);
  const auto low = step_of<Butterworth>(
      R"("low_pass", corner_hz = 25, order = 2, keep_pads = false, taper_s = 0)");
  EXPECT_EQ(low.low_pass, 25);
  EXPECT_FALSE(low.high_pass);
  EXPECT_EQ(low.order, 2);
  EXPECT_FALSE(low.keep_pads);
  EXPECT_EQ(low.taper, 0);
  const auto band = step_of<Butterworth>(R"("band_pass", corners_hz = [0.1, 25])");
  EXPECT_EQ(band.high_pass, 0.1);
  EXPECT_EQ(band.low_pass, 25);
}

TEST(StepReader, ReadsTheOthers) {
  EXPECT_EQ(step_of<Resample>(R"("resample", time_step_s = 0.005)").time_step, 0.005);
  const auto trim = step_of<TrimToDuration>(
      R"("trim", from_fraction = 0.01, to_fraction = 0.9, before_s = 1, after_s = 2, taper_s = 3)");
  EXPECT_EQ(trim.from, 0.01);
  EXPECT_EQ(trim.to, 0.9);
  EXPECT_EQ(trim.before, 1);
  EXPECT_EQ(trim.after, 2);
  EXPECT_EQ(trim.taper, 3);
  EXPECT_EQ(step_of<TrimToDuration>(R"("trim")").to, 0.95);
  const auto window = step_of<TrimToWindow>(R"("window", from_s = 1, to_s = 9, taper_s = 0.5)");
  EXPECT_EQ(window.window.from, 1);
  EXPECT_EQ(window.window.to, 9);
  EXPECT_EQ(window.taper, 0.5);
  for (const auto& [key, by] :
       {std::pair("azimuth_deg", Rotate::By::kAzimuthOfH1),
        std::pair("angle_deg", Rotate::By::kAngle), std::pair("strike_deg", Rotate::By::kStrike)}) {
    const auto rotate = step_of<Rotate>("\"rotate\", " + std::string(key) + " = 90");
    EXPECT_EQ(rotate.by, by);
    EXPECT_DOUBLE_EQ(rotate.angle, 90 * kRadiansPerDegree);
  }
}

TEST(StepReader, KeepsTheOrder) {
  const auto steps = steps_of(R"({ step = "trim" }, { step = "high_pass", corner_hz = 1 })");
  ASSERT_EQ(steps.size(), 2u);
  EXPECT_TRUE(std::holds_alternative<TrimToDuration>(steps[0]));
  EXPECT_TRUE(std::holds_alternative<Butterworth>(steps[1]));
  config::Document empty("", "a.toml");
  config::Table root = empty.root();
  EXPECT_TRUE(read_processing_steps(root).empty());
}

TEST(StepReader, ReportsAllErrorsAtOnce) {
  EXPECT_EQ(errors("{ step = \"highpass\", corner_hz = 1 },\n{ step = \"resample\", dt = 1 },\n"
                   "{ step = \"low_pass\", corner_hz = -1, order = 11 }"),
            "a.toml:1:24: processing[0].step = \"highpass\": unknown step; did you mean "
            "'high_pass'?\n"
            "a.toml:2:1: processing[1].time_step_s: missing; must be a finite number > 0 and <= 1\n"
            "a.toml:2:22: processing[1].dt: unknown key; known: step, time_step_s\n"
            "a.toml:3:34: processing[2].corner_hz = -1: must be a finite number > 0\n"
            "a.toml:3:46: processing[2].order = 11: must be a whole number in 1..10");
}

TEST(StepReader, RefusesWhatDoesNotFit) {
  EXPECT_EQ(errors("{ corner_hz = 1 }"),
            "a.toml:1:15: processing[0].step: missing; must be text in quotes");
  EXPECT_EQ(errors("{ step = 3 }"), "a.toml:1:24: processing[0].step = 3: must be text in quotes");
  EXPECT_EQ(errors(R"({ step = "taper" })"),
            "a.toml:1:24: processing[0].step = \"taper\": must have start_s and end_s or one of "
            "them, or start_fraction and end_fraction or one of them");
  EXPECT_NE(errors(R"({ step = "taper", start_s = 1, end_fraction = 0.1 })"), "(no error)");
  EXPECT_EQ(errors(R"({ step = "rotate", angle_deg = 1, strike_deg = 2 })"),
            "a.toml:1:24: processing[0].step = \"rotate\": must have one of azimuth_deg, angle_deg "
            "and strike_deg");
  EXPECT_EQ(errors(R"({ step = "band_pass", corners_hz = [5, 1] })"),
            "a.toml:1:50: processing[0].corners_hz = [5, 1]: the first must be less than the "
            "second");
  EXPECT_EQ(errors(R"({ step = "trim", from_fraction = 0.96 })"),
            "a.toml:1:15: processing[0].to_fraction = 0.95: must be more than from_fraction, 0.96");
  EXPECT_EQ(errors(R"({ step = "window", from_s = 5, to_s = 5 })"),
            "a.toml:1:53: processing[0].to_s = 5: must be a finite number > 5");
  EXPECT_EQ(errors(R"({ step = "baseline", kind = "lin" })"),
            "a.toml:1:43: processing[0].kind = \"lin\": must be one of mean, line, polynomial, "
            "pre_event_mean, end_at_rest; did you mean 'line'?");
  EXPECT_EQ(errors(R"({ step = "baseline", kind = "mean", degree = 2 })"),
            "a.toml:1:51: processing[0].degree: unknown key; known: kind, step");
}

// The page has a section for each step and in it the keys that the reader asks for.
TEST(ProcessingPage, HasEveryKeyTheReaderKnowsAndNoOther) {
  const std::string page = GURNEY_SOURCE_DIR "/docs/formats/processing.md";
  const auto section_is_complete = [&](const std::string& step,
                                       const std::vector<std::string>& variants) {
    std::set<std::string> asked;
    for (const std::string& variant : variants) {
      config::Document document("processing = [{ step = \"" + step + "\"" + variant + " }]", "a");
      config::Table root = document.root();
      read_processing_steps(root);
      for (std::string key : document.asked_keys())
        if (key.rfind("processing[].", 0) == 0 && key != "processing[].step")
          asked.insert(key.substr(13));
    }
    EXPECT_EQ(asked, documented_keys(page, step));
  };
  section_is_complete("baseline", {", kind = \"polynomial\"", ", kind = \"pre_event_mean\""});
  section_is_complete("taper", {", start_s = 1", ", start_fraction = 0.1"});
  for (const char* step : {"high_pass", "low_pass", "band_pass"})
    section_is_complete(step, {", taper_s = 1"});
  for (const char* step : {"resample", "trim", "window", "rotate"}) section_is_complete(step, {""});
}

}  // namespace
}  // namespace gurney::groundmotions
