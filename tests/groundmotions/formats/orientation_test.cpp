#include "groundmotions/formats/orientation.h"

#include <gmock/gmock.h>

#include "engine/base/units.h"

namespace gurney::groundmotions {
namespace {

Component oriented(const char* name) {
  Component component;
  component.acceleration = Eigen::Vector2d(1, -2);
  orient(name, component);
  return component;
}

TEST(Orientation, KnowsAzimuths) {
  for (const char* north : {"0", "N", "ns", "N-S", "North", "HNN", "BHN10"})
    EXPECT_EQ(oriented(north).azimuth, 0) << north;
  for (const char* east : {"090", " 90.0 ", "E", "EW", "e-w", "WE", "HGE"})
    EXPECT_DOUBLE_EQ(oriented(east).azimuth.value_or(-1), 90 * kRadiansPerDegree) << east;
  EXPECT_DOUBLE_EQ(*oriented("360").azimuth, 360 * kRadiansPerDegree);
  EXPECT_FALSE(oriented("090").direction);
}

TEST(Orientation, KnowsBearingsAndTheOtherPointsOfTheCompass) {
  const std::pair<const char*, double> names[] = {
      {"N38E", 38},  {"s38w", 218}, {"S38E", 142},  {"N 38 W", 322}, {"45 DEG", 45},
      {"45DEG", 45}, {"S", 180},    {"South", 180}, {"W", 270},      {"West", 270},
      {"S-N", 0},    {"5 deg", 5},  {"W-E", 90}};
  for (const auto& [name, degrees] : names)
    EXPECT_NEAR(oriented(name).azimuth.value_or(-1), degrees * kRadiansPerDegree, 1e-12) << name;
}

// 1, 2 and 3 number the channels of a recorder; ENE lies 22.5 degrees off the east.
TEST(Orientation, TakesNoAzimuthFromChannelNumbersAndHalfPoints) {
  for (const char* name : {"1", "2", "3", "9", "ENE", "NNE"}) {
    EXPECT_FALSE(oriented(name).azimuth || oriented(name).direction) << name;
    Component component;
    EXPECT_FALSE(orient_by_label(name, component)) << name;
  }
}

TEST(Orientation, KnowsVerticals) {
  for (const char* up : {"UP", "U-D", "UD", "V", "ver", "Z", "HNZ", "Vertical"}) {
    EXPECT_EQ(oriented(up).direction, Direction::kVertical) << up;
    EXPECT_EQ(oriented(up).acceleration[0], 1) << up;
    EXPECT_FALSE(oriented(up).azimuth) << up;
  }
}

TEST(Orientation, TurnsDownToUp) {
  for (const char* down : {"DOWN", "dwn", "DN"}) {
    EXPECT_EQ(oriented(down).acceleration, Eigen::Vector2d(-1, 2)) << down;
    EXPECT_EQ(oriented(down).warnings.size(), 1u) << down;
  }
}

TEST(Orientation, LeavesOtherNamesAlone) {
  for (const char* name : {"", "L", "T", "H1", "HN2", "BH100", "-10", "361", "x_g", "DWNE"}) {
    const Component component = oriented(name);
    EXPECT_FALSE(component.azimuth || component.direction) << name;
    EXPECT_TRUE(component.warnings.empty()) << name;
  }
}

TEST(Orientation, ReadsLabels) {
  const auto azimuth = [](const char* label) {
    Component component;
    EXPECT_TRUE(orient_by_label(label, component)) << label;
    EXPECT_FALSE(component.direction) << label;
    return component.azimuth.value_or(-1) / kRadiansPerDegree;
  };
  EXPECT_NEAR(azimuth("90 DEG"), 90, 1e-12);
  EXPECT_NEAR(azimuth("360 Deg"), 0, 1e-12);
  EXPECT_NEAR(azimuth("Roof, N wall: 275 deg"), 275, 1e-12);
  EXPECT_NEAR(azimuth("S08E"), 172, 1e-12);
  EXPECT_NEAR(azimuth("E"), 90, 1e-12);
  EXPECT_NEAR(azimuth("NS"), 0, 1e-12);  // RENADIC
  EXPECT_NEAR(azimuth("E-W"), 90, 1e-12);
  EXPECT_NEAR(azimuth("HNE 00"), 90, 1e-12);
  for (const char* label : {"", "L", "T", "Roof", "THE ROOF", "ENG", "Channel", "H1", "-90 DEG",
                            "400 DEG", "N95E", "12 storeys"}) {
    Component component;
    EXPECT_FALSE(orient_by_label(label, component)) << label;
    EXPECT_FALSE(component.azimuth || component.direction) << label;
  }
  for (const char* label :
       {"UP", "Up", "V", "VERT", "Vertical - 2nd floor", "UD", "Z", "BNZ", "HNZ.--"}) {
    Component component;
    EXPECT_TRUE(orient_by_label(label, component)) << label;
    EXPECT_EQ(component.direction, Direction::kVertical) << label;
  }
}

}  // namespace
}  // namespace gurney::groundmotions
