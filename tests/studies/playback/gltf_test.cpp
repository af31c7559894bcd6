#include "studies/playback/gltf.h"

#include <gtest/gtest.h>

#include <cstring>
#include <nlohmann/json.hpp>

#include "studies/results/results_file.h"
#include "tests/studies/playback/base64_bytes.h"
#include "tests/support/synthetic_run.h"
#include "tests/support/synthetic_ward.h"
#include "tests/support/temp_folder.h"

namespace gurney::playback {
namespace {

using Json = nlohmann::json;

/// Volume by the divergence theorem: positive only if the triangles look outwards.
double volume(const RecordedShape& shape) {
  const std::vector<Vector3> corners = triangles(shape);
  double sum = 0;
  for (std::size_t i = 0; i < corners.size(); i += 3)
    sum += corners[i].dot(corners[i + 1].cross(corners[i + 2])) / 6;
  return sum;
}

TEST(Solid, EnclosesItsVolume) {
  RecordedShape box{"box", "box", {}};
  for (const double z : {0.0, 2.0})
    for (const auto& [x, y] : {std::pair(1, 1), {4, 1}, {4, 6}, {1, 6}})
      box.points.emplace_back(x, y, z);
  EXPECT_NEAR(volume(box), 3 * 5 * 2, 1e-12);
  const RecordedShape hull{"ramp", "hull", {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  EXPECT_NEAR(volume(hull), 1.0 / 6, 1e-12);
  RecordedWheel wheel;
  wheel.radius = 0.05;
  wheel.width = 0.03;
  // A regular polygon of 24 sides has the area 12 R^2 sin(2 pi / 24).
  EXPECT_NEAR(volume(shape_of(wheel)), 12 * 0.0025 * std::sin(std::numbers::pi / 12) * 0.03, 1e-15);
}

class Gltf : public testing::Test {
 protected:
  Gltf() {
    const TempFolder folder;
    const Response response = synthetic_response();
    const std::string file =
        folder.write("run.h5", study::results_image(synthetic_facts(), response));
    scene_ = Json::parse(gltf(read_recorded_run(file)));
    history_ = response.items[0].history;
    const std::string uri = scene_.at("buffers").at(0).at("uri");
    bytes_ = bytes_of(uri.substr(uri.find(',') + 1));
  }

  std::vector<float> numbers(std::size_t accessor) const {
    const Json& a = scene_.at("accessors").at(accessor);
    const Json& view = scene_.at("bufferViews").at(a.at("bufferView").get<std::size_t>());
    std::vector<float> values(view.at("byteLength").get<std::size_t>() / 4);
    std::memcpy(values.data(), &bytes_.at(view.at("byteOffset").get<std::size_t>()),
                4 * values.size());
    return values;
  }

  /// Output of the animation of a node.
  std::vector<float> animation(const std::string& name, const std::string& path) const {
    const Json& run = scene_.at("animations").at(0);
    for (const Json& channel : run.at("channels")) {
      const Json& target = channel.at("target");
      const Json& node = scene_.at("nodes").at(target.at("node").get<std::size_t>());
      if (node.at("name") == name && target.at("path") == path)
        return numbers(run.at("samplers")
                           .at(channel.at("sampler").get<std::size_t>())
                           .at("output")
                           .get<std::size_t>());
    }
    ADD_FAILURE() << name << " has no " << path;
    return {};
  }

  Json scene_;
  std::vector<Sample> history_;
  std::vector<std::uint8_t> bytes_;
};

TEST_F(Gltf, HasABufferOfItsLength) {
  EXPECT_EQ(bytes_.size(), scene_.at("buffers").at(0).at("byteLength").get<std::size_t>());
  EXPECT_EQ(scene_.at("asset").at("version"), "2.0");
  for (const Json& accessor : scene_.at("accessors")) EXPECT_GT(accessor.at("count"), 0);
}

TEST_F(Gltf, MovesAsTheFile) {
  const std::string item = synthetic_facts().scene.items[0].model.name;
  const auto places = animation(item, "translation"), turns = animation(item, "rotation");
  const auto fork = animation("front right, fork", "rotation");
  ASSERT_EQ(places.size(), 3 * history_.size());
  for (std::size_t i = 0; i < history_.size(); ++i) {
    // Single precision of numbers below 1.
    for (int axis = 0; axis < 3; ++axis)
      ASSERT_NEAR(places[3 * i + static_cast<std::size_t>(axis)], history_[i].displacement[axis],
                  6e-8);
    ASSERT_NEAR(2 * std::atan2(turns[4 * i + 2], turns[4 * i + 3]), history_[i].yaw, 3e-7);
    ASSERT_NEAR(fork[4 * i + 3], std::cos(history_[i].wheels[1].swivel_angle / 2), 6e-8);
  }
}

// The file has the displacement of a part's centre of mass: its origin, which its shapes are drawn
// from, is elsewhere as it turns and where it had settled.
TEST(RecordedRun, HasTheOriginsOfParts) {
  study::RunFacts facts = synthetic_ward();
  Response response = synthetic_ward_response();
  ASSERT_GE(facts.scene.items.size(), 2U);
  Joint& joint = facts.scene.joints.emplace_back();
  joint.part = 1;
  joint.kind = Joint::Kind::kBall;
  facts.scene.items[1].initial = facts.scene.items[0].initial;
  ItemResponse& part = response.items[1];
  part.tracked = {0.3, -0.1, 0.9};
  const Vector3 settled(0.4, 0, 0.7);
  for (Sample& sample : part.history) {
    sample.orientation = Eigen::AngleAxisd(0.5 + 0.1 * sample.time, Vector3(1, 2, 2) / 3);
    sample.to_origin = settled - sample.orientation * part.tracked;
  }
  const TempFolder folder;
  const RecordedRun run =
      read_recorded_run(folder.write("run.h5", study::results_image(facts, response)));
  const Vector3 placed = facts.scene.items[1].initial.position;
  ASSERT_EQ(run.items[1].position.size(), part.history.size());
  for (std::size_t i = 0; i < part.history.size(); ++i)
    EXPECT_LT((run.items[1].position[i] - placed - part.history[i].origin_displacement()).norm(),
              1e-12);
}

}  // namespace
}  // namespace gurney::playback
