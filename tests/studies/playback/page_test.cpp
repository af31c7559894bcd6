#include "studies/playback/page.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <nlohmann/json.hpp>

#include "studies/results/results_file.h"
#include "tests/studies/playback/base64_bytes.h"
#include "tests/support/expect_error.h"
#include "tests/support/synthetic_run.h"
#include "tests/support/temp_folder.h"

namespace gurney::playback {
namespace {

using Json = nlohmann::json;

std::vector<double> values_of(double offset, double step, int bits, const std::string& data,
                              std::size_t count) {
  std::vector<double> values(count, offset);
  const std::vector<std::uint8_t> bytes = bytes_of(data);
  for (std::size_t i = 0; i < count && !bytes.empty(); ++i)
    values[i] += step * (bits == 8 ? bytes.at(i) : bytes.at(2 * i) + 256 * bytes.at(2 * i + 1));
  return values;
}

std::vector<double> values_of(const Json& channel, std::size_t count) {
  if (!channel.contains("data")) return values_of(channel.at("offset"), 0, 16, "", count);
  return values_of(channel.at("offset"), channel.at("step"), channel.at("bits"), channel.at("data"),
                   count);
}

double step_of(const Json& channel) { return channel.value("step", 0.0); }

TEST(Channel, DiffersByHalfAStepAtMost) {
  std::vector<double> values;
  for (int i = 0; i < 500; ++i) values.push_back(0.3 * std::sin(0.1 * i) + 0.002 * i);
  for (const int bits : {8, 16}) {
    const Channel channel = quantised(values, bits);
    const auto decoded = values_of(channel.offset, channel.step, bits, channel.data, values.size());
    // Rounding to the nearest whole number of steps; the sums are of the order of 1.
    for (std::size_t i = 0; i < values.size(); ++i)
      ASSERT_NEAR(decoded[i], values[i], channel.step / 2 + 1e-15) << i;
    EXPECT_DOUBLE_EQ(channel.step * (std::exp2(bits) - 1),
                     *std::ranges::max_element(values) - *std::ranges::min_element(values));
  }
}

TEST(Channel, NeedsNoDataForOneValue) {
  const Channel channel = quantised({2.5, 2.5, 2.5}, 16);
  EXPECT_EQ(channel.offset, 2.5);
  EXPECT_EQ(channel.data, "");
  EXPECT_EQ(quantised({NAN, NAN}, 8).offset, 0);
}

TEST(Channel, WritesBase64OfRfc4648) {
  const auto of = [](const std::string& text) {
    return base64({reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
  };
  EXPECT_EQ(of(""), "");
  EXPECT_EQ(of("f"), "Zg==");
  EXPECT_EQ(of("fo"), "Zm8=");
  EXPECT_EQ(of("foo"), "Zm9v");
  EXPECT_EQ(of("foobar"), "Zm9vYmFy");
}

class Page : public testing::Test {
 protected:
  RecordedRun recorded() const {
    return read_recorded_run(folder_.write("run.h5", study::results_image(facts, response)));
  }
  Json data() const { return Json::parse(page_data({{"", recorded()}})); }

  TempFolder folder_;
  study::RunFacts facts = synthetic_facts();
  Response response = synthetic_response();
};

TEST_F(Page, HasThePosesOfTheFile) {
  facts.scene.items[0].initial.position = {1.5, -0.25, 0};
  const Json item = data().at("runs").at(0).at("items").at(0);
  const std::vector<Sample>& history = response.items[0].history;
  const double start[] = {1.5, -0.25, 0};
  for (int axis = 0; axis < 3; ++axis) {
    const Json& channel = item.at("position").at(axis);
    const auto values = values_of(channel, history.size());
    for (std::size_t i = 0; i < history.size(); ++i)
      ASSERT_NEAR(values[i], start[axis] + history[i].displacement[axis],
                  step_of(channel) / 2 + 1e-15);
    // The position is within 1 m: its resolution is better than 1 m / 65535 / 2.
    EXPECT_LT(step_of(channel), 1.0 / 65535);
  }
  for (int k = 0; k < 4; ++k) {
    const Json& channel = item.at("orientation").at(k);
    const auto values = values_of(channel, history.size());
    for (std::size_t i = 0; i < history.size(); ++i) {
      const Quaternion& q = history[i].orientation;
      const double wxyz[] = {q.w(), q.x(), q.y(), q.z()};
      ASSERT_NEAR(values[i], wxyz[k], step_of(channel) / 2 + 1e-15);
    }
  }
}

TEST_F(Page, HasTheWheelsOfTheFile) {
  for (Sample& sample : response.items[0].history) sample.wheels[2].wheel_rate = 3;
  const Json run = data().at("runs").at(0);
  const std::size_t samples = response.items[0].history.size();
  for (std::size_t w = 0; w < 4; ++w) {
    const Json& wheel = run.at("items").at(0).at("wheels").at(w);
    const Caster& caster = facts.scene.items[0].model.casters[w];
    EXPECT_EQ(wheel.at("name"), caster.name);
    EXPECT_NEAR(wheel.at("radius"), caster.wheel_radius, 1e-12);
    EXPECT_NEAR(wheel.at("width"), caster.wheel_width, 1e-12);
    EXPECT_NEAR(wheel.at("center").at(0), -caster.trail, 1e-12);
    EXPECT_NEAR(wheel.at("center").at(2), caster.wheel_radius - caster.height, 1e-12);
    const auto modes = bytes_of(wheel.at("mode"));
    const auto swivel = values_of(wheel.at("swivel"), samples);
    const auto normal = values_of(wheel.at("normal"), samples);
    for (std::size_t i = 0; i < samples; ++i) {
      const WheelSample& sample = response.items[0].history[i].wheels[w];
      ASSERT_EQ(modes.at(i), static_cast<int>(sample.mode));
      ASSERT_NEAR(swivel[i], sample.swivel_angle, step_of(wheel.at("swivel")) / 2 + 1e-15);
      ASSERT_NEAR(normal[i], sample.normal_force, step_of(wheel.at("normal")) / 2 + 1e-12);
    }
  }
  // A constant rate for 24 s; the sum of 2400 steps of 0.03 rad.
  const Json& roll = run.at("items").at(0).at("wheels").at(2).at("roll");
  EXPECT_NEAR(values_of(roll, samples).back(), 72, step_of(roll) / 2 + 1e-10);
}

TEST_F(Page, HasTheEventsOfTheFile) {
  for (Sample& sample : response.items[0].history)
    for (WheelSample& wheel : sample.wheels) wheel.mode = WheelMode::kRolls;
  const auto lift = [&](int from, int until, std::size_t wheel) {
    for (int i = from; i < until; ++i)
      response.items[0].history[static_cast<std::size_t>(i)].wheels[wheel].mode =
          WheelMode::kLifted;
  };
  lift(300, 310, 1);  // hops less than 0.2 s apart are one event
  lift(320, 330, 2);
  lift(325, 335, 3);
  lift(500, 520, 1);
  Demands& demands = response.items[0].demands;
  demands.peak_displacement = 0;
  demands.time_of_overturning = 7.25;
  Impact impact;
  impact.time = 6.5;
  impact.body = "chassis";
  impact.other = "wall";
  impact.approach_speed = 0.5;
  response.impacts = {impact};
  facts.scene.tethers = {{.name = "cord", .anchor = {1, 2, 3}, .slack_length = 5, .stiffness = 1}};
  response.tethers = {{5.5, 5.75, 10}};
  facts.scene.zones = {{.name = "doorway"}, {.name = "way", .length = 1, .width = 1}};
  response.zones = {{.time_of_entry = 0}, {.time_of_entry = 0.5}};
  const Json run = data().at("runs").at(0);
  std::vector<std::string> kinds;
  std::vector<double> times;
  for (const Json& event : run.at("events")) {
    kinds.push_back(event.at("kind"));
    times.push_back(event.at("time"));
  }
  EXPECT_EQ(kinds, (std::vector<std::string>{"zone", "zone", "lift-off", "lift-off", "taut",
                                             "unplugged", "impact", "overturned"}));
  EXPECT_EQ(times, (std::vector<double>{0, 0.5, 0.01 * 300, 0.01 * 500, 5.5, 5.75, 6.5, 7.25}));
  EXPECT_EQ(run.at("events").at(0).at("text"), "doorway: an item is inside from the start");
  EXPECT_EQ(run.at("events").at(1).at("text"),
            "way: " + run.at("items").at(0).at("name").get<std::string>() + " enters")
      << "the zone is where the item stands";
  EXPECT_EQ(run.at("events").at(2).at("text"),
            "one or more wheels off the floor until 3.35 s, up to 2 at once: front right, rear "
            "left, rear right");
  EXPECT_EQ(run.at("events").at(3).at("text"), "a wheel off the floor until 5.20 s: front right");
  EXPECT_EQ(run.at("events").at(6).at("text"), "hits wall with 0.50 m/s");
  EXPECT_EQ(run.at("tethers").at(0).at("anchor"), Json({1.0, 2.0, 3.0}));
  EXPECT_EQ(run.at("tethers").at(0).at("time_broken"), 5.75);
}

TEST_F(Page, ShowsHostileNamesAsText) {
  facts.title = "</script><img src=x onerror=alert(1)>\"'&\xe2\x80\xa8 \xe5\xba\x8a";
  const std::string page = playback_page({{"", recorded()}});
  EXPECT_EQ(page.find("<img"), std::string::npos);
  std::size_t ends = 0;
  for (auto at = page.find("</script"); at != std::string::npos; at = page.find("</script", at + 1))
    ++ends;
  EXPECT_EQ(ends, 2u);
  EXPECT_EQ(data().at("title"), facts.title);
  EXPECT_EQ(page.find("https://"), std::string::npos);
  EXPECT_EQ(page.find("http://"), std::string::npos);
}

/// Ten items on five casters each, all in motion for 60 s.
RecordedRun large_run(double step) {
  RecordedRun run;
  const auto samples = static_cast<std::size_t>(60 / step) + 1;
  for (std::size_t i = 0; i < samples; ++i) {
    run.time.push_back(step * static_cast<double>(i));
    run.floor_acceleration.push_back(Vector3::Constant(std::sin(run.time[i])));
    run.floor_displacement.push_back(Vector3::Constant(std::cos(run.time[i])));
  }
  for (int k = 0; k < 10; ++k) {
    RecordedItem& item = run.items.emplace_back();
    for (const double t : run.time) {
      item.position.push_back(Vector3(std::sin(t), std::cos(t), 0.01 * t));
      item.orientation.emplace_back(Eigen::AngleAxisd(t, Vector3(1, 2, 3).normalized()));
    }
    item.wheels.resize(5);
    for (RecordedWheel& wheel : item.wheels) {
      wheel.swivel = wheel.roll = wheel.normal = wheel.longitudinal = wheel.lateral = run.time;
      wheel.mode.assign(samples, 1);
    }
  }
  return run;
}

TEST(PageSize, IsBelow5MbFor60Seconds) {
  for (const double step : {0.02, 0.001}) {
    const std::vector<PageRun> runs{{"", large_run(step)}};
    const Json data = Json::parse(page_data(runs));
    EXPECT_LT(playback_page(runs).size(), 5'000'000u) << step;
    EXPECT_EQ(data.at("stride"), stride(runs));
    EXPECT_EQ(stride(runs) > 1, step < 0.01) << step;
    const auto times = bytes_of(data.at("runs").at(0).at("time"));
    const std::size_t count = (runs[0].run.time.size() - 1) / stride(runs) + 1;
    EXPECT_LE(times.size() / 4, count + 1);
    float last = 0;
    std::memcpy(&last, &times.at(times.size() - 4), 4);
    EXPECT_FLOAT_EQ(last, static_cast<float>(runs[0].run.time.back()));
  }
}

TEST_F(Page, RefusesAFileWithoutHistories) {
  response.items[0].history.resize(1);
  EXPECT_ERROR(recorded(), "holds no histories");
}

TEST_F(Page, EndsBeforeWhatIsNoNumber) {
  auto& history = response.items[0].history;
  history[2000].displacement.x() = NAN;
  EXPECT_EQ(recorded().time.size(), 2000u);
}

}  // namespace
}  // namespace gurney::playback
