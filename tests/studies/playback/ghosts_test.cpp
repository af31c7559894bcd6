#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "studies/playback/page.h"
#include "tests/studies/playback/base64_bytes.h"

namespace gurney::playback {
namespace {

using Json = nlohmann::json;

/// An item that swings by 0.4 m at 1 Hz and turns by 1 rad, for 60 s at the default spacing.
RecordedRun swinging() {
  RecordedRun run;
  RecordedItem item;
  item.name = "<b>";
  item.wheels.resize(4);
  for (int i = 0; i <= 3000; ++i) {
    const double time = 0.02 * i, angle = 2 * M_PI * time;
    run.time.push_back(time);
    item.position.emplace_back(0.4 * std::sin(angle), 0.1 * std::cos(3 * angle), 0);
    item.orientation.emplace_back(Eigen::AngleAxisd(std::sin(angle), Vector3::UnitZ()));
  }
  run.items.push_back(item);
  run.floor_acceleration.assign(3001, Vector3::UnitX());
  run.moments = {{1, "impact", "<b>", "hits"}, {2.5, "overturned", "<b>", "overturns"}};
  return run;
}

std::vector<double> decoded(const Json& channel, std::size_t count) {
  std::vector<double> values(count, channel.at("offset").get<double>());
  if (!channel.contains("data")) return values;
  const std::vector<std::uint8_t> bytes = bytes_of(channel.at("data").get<std::string>());
  for (std::size_t i = 0; i < count; ++i)
    values[i] += channel.at("step").get<double>() * (bytes.at(2 * i) + 256 * bytes.at(2 * i + 1));
  return values;
}

TEST(Ghosts, KeepPosesAndFalls) {
  const RecordedRun ghost = ghost_of(swinging());
  EXPECT_EQ(ghost.items.at(0).position.size(), 3001u);
  EXPECT_TRUE(ghost.items.at(0).wheels.empty());
  EXPECT_TRUE(ghost.floor_acceleration.empty());
  ASSERT_EQ(ghost.moments.size(), 1u);
  EXPECT_EQ(ghost.moments[0].time, 2.5);
}

TEST(Ghosts, AreOffByNoMoreThanThePageStates) {
  const RecordedRun run = swinging();
  const std::vector<PageRun> ghosts(100, PageRun{"run 7", run});
  const std::string text = page_data({{"run 1", run}}, ghosts);
  EXPECT_LT(text.size(), 4.7e6) << "a page has 60 kB besides";
  const Json all = Json::parse(text).at("ghosts");
  const auto every = all.at("stride").get<std::size_t>();
  ASSERT_GT(every, 1u);
  EXPECT_EQ(all.at("runs").size(), 100u);
  const Json& item = all.at("runs").at(99).at("items").at(0);
  const std::size_t kept = 3000 / every + 1 + (3000 % every != 0);
  const auto x = decoded(item.at("position").at(0), kept),
             y = decoded(item.at("position").at(1), kept);
  double worst = 0;
  for (std::size_t i = 0; i < 3000; ++i) {
    const std::size_t from = i / every * every, to = std::min<std::size_t>(from + every, 3000);
    const double fraction = static_cast<double>(i - from) / static_cast<double>(to - from);
    const auto at = [&](const std::vector<double>& v) {
      return v[i / every] + fraction * (v[i / every + 1] - v[i / every]);
    };
    worst = std::max(worst, std::hypot(at(x) - run.items[0].position[i].x(),
                                       at(y) - run.items[0].position[i].y()));
  }
  const double stated = all.at("position_error").get<double>();
  EXPECT_LE(worst, stated);
  // Two roundings, each of at most half a step of 0.8 m / 65535 along x and a quarter of it along y.
  EXPECT_GT(worst, stated - 2 * std::hypot(0.8, 0.2) / 65535 / 2);
}

TEST(Ghosts, ErrorIsThatOfChords) {
  // Between samples 2 h apart a sine of amplitude a is above its chord by a (1 - cos(w h)).
  const double half = 2 * M_PI * 0.02;
  RecordedRun run = swinging();
  for (Vector3& p : run.items[0].position) p.y() = 0;
  const ThinningError error = thinning_error({{"", run}}, 2);
  // The sample in the middle of a chord may be up to one spacing from the crest: of the second order.
  EXPECT_NEAR(error.position, 0.4 * (1 - std::cos(half)), 0.4 * std::pow(half, 4));
  EXPECT_LT(thinning_error({{"", run}}, 1).position, 0.8 / 65535);
  EXPECT_LT(thinning_error({{"", run}}, 1).angle, 1e-4);
}

}  // namespace
}  // namespace gurney::playback
