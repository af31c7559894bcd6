#include "groundmotions/processing/rotate.h"

#include <gmock/gmock.h>

#include <cmath>

#include "engine/base/units.h"
#include "tests/support/error_text.h"

namespace gurney::groundmotions {
namespace {

using testing::ElementsAre;

const Eigen::Vector4d kEast(1, -2, 3, 0.5);
const Eigen::Vector4d kNorth(4, 1, -1, 2);

/// What an instrument that points to this azimuth feels of the motion above.
Eigen::VectorXd along(double degrees) {
  const double azimuth = degrees * kRadiansPerDegree;
  return std::sin(azimuth) * kEast + std::cos(azimuth) * kNorth;
}

Record record_at(double azimuth1, double azimuth2) {
  Record record;
  record.name = "r";
  const double degrees[] = {azimuth1, azimuth2};
  for (int i = 0; i < 2; ++i) {
    Component component;
    component.name = std::to_string(std::lround(degrees[i]));
    component.file = component.name + ".at2";
    component.time_step = 0.1;
    component.acceleration = along(degrees[i]);
    component.azimuth = degrees[i] * kRadiansPerDegree;
    record.components[static_cast<std::size_t>(i)] = component;
  }
  return record;
}

/// h1 must point to this azimuth, h2 90 degrees counter-clockwise of it. Rounding: a handful of
/// operations on numbers up to 5, over the sine of 30 degrees or more.
void expect_axes(const Record& record, double azimuth) {
  const Component &h1 = *record[Direction::kH1], &h2 = *record[Direction::kH2];
  EXPECT_LT((h1.acceleration - along(azimuth)).norm(), 1e-13);
  EXPECT_LT((h2.acceleration - along(azimuth - 90)).norm(), 1e-13);
  EXPECT_NEAR(std::cos(*h1.azimuth - azimuth * kRadiansPerDegree), 1, 1e-15);
  EXPECT_NEAR(std::cos(*h2.azimuth - (azimuth - 90) * kRadiansPerDegree), 1, 1e-15);
  EXPECT_GE(*h2.azimuth, 0);
  EXPECT_LT(*h2.azimuth, 360 * kRadiansPerDegree);
}

TEST(Rotate, LeavesARightHandedPairAlone) {
  const Record record = orthogonal_horizontals(record_at(30, 300));
  expect_axes(record, 30);
  EXPECT_EQ(record[Direction::kH2]->name, "300");
  EXPECT_TRUE(record.processing.empty());
}

// North and east as h1 and h2 are a mirror image: h2 must point west.
TEST(Rotate, TurnsAMirroredPair) {
  const Record record = orthogonal_horizontals(record_at(0, 90));
  expect_axes(record, 0);
  EXPECT_EQ(record[Direction::kH2]->name, "270");
  EXPECT_EQ(Eigen::VectorXd(record[Direction::kH2]->acceleration), Eigen::VectorXd(-along(90)));
  EXPECT_THAT(
      record.processing,
      ElementsAre("h2 (90) negated: its azimuth 090 is 90 degrees clockwise of h1 (000), now "
                  "270"));
}

TEST(Rotate, ResolvesAPairThatIsNotAtRightAngles) {
  for (const double other : {75.0, 118.0, 160.0, 299.0, 301.5, -90.0})
    expect_axes(orthogonal_horizontals(record_at(30, other)), 30);
  EXPECT_THAT(orthogonal_horizontals(record_at(30, 301.5)).processing,
              ElementsAre("h2 resolved at a right angle to h1: azimuths 030 and 301.5 became 030 "
                          "and 300"));
}

TEST(Rotate, WithoutAzimuthsNothingIsTurned) {
  Record record = record_at(0, 90);
  record.components[1]->azimuth.reset();
  EXPECT_EQ(orthogonal_horizontals(record)[Direction::kH2]->acceleration, along(90));
  record.components[1].reset();
  EXPECT_FALSE(orthogonal_horizontals(record)[Direction::kH2]);
}

TEST(Rotate, GoesToAnyAzimuthFromAnyPair) {
  for (const double second : {300.0, 120.0, 80.0})
    for (const double azimuth : {0.0, 30.0, 217.5, 359.0, -45.0})
      expect_axes(rotate_to(record_at(30, second), azimuth * kRadiansPerDegree), azimuth);
  const Record record = rotate_to(record_at(0, 270), 30 * kRadiansPerDegree);
  EXPECT_EQ(record[Direction::kH1]->name, "030");
  EXPECT_EQ(record[Direction::kH2]->name, "300");
  EXPECT_THAT(record.processing,
              ElementsAre("horizontals rotated by -30 degrees counter-clockwise, h1 to azimuth "
                          "030"));
}

// Counter-clockwise by 90 degrees: the new h1 is the old h2, the new h2 the old h1 reversed.
TEST(Rotate, ByAnAngleIsCounterClockwise) {
  Record record = record_at(0, 270);
  record.components[0]->azimuth.reset();
  const Record turned = rotated_by(record, 90 * kRadiansPerDegree);
  EXPECT_LT((turned[Direction::kH1]->acceleration - along(270)).norm(), 1e-15);
  EXPECT_LT((turned[Direction::kH2]->acceleration + along(0)).norm(), 1e-15);
  EXPECT_FALSE(turned[Direction::kH1]->azimuth);
  EXPECT_EQ(turned.processing.at(0), "horizontals rotated by 90 degrees counter-clockwise");
}

TEST(Rotate, ThereAndBackIsNothingAndEnergyStays) {
  const Record record = record_at(10, 280);
  const Record turned = rotated_by(record, 1.234);
  const auto energy = [](const Record& r) {
    return r[Direction::kH1]->acceleration.squaredNorm() +
           r[Direction::kH2]->acceleration.squaredNorm();
  };
  EXPECT_NEAR(energy(turned), energy(record), 1e-13 * energy(record));
  expect_axes(rotated_by(turned, -1.234), 10);
}

TEST(Rotate, ToAFaultIsNormalAndParallel) {
  const Record record = rotate_to_fault(record_at(0, 90), 122 * kRadiansPerDegree);
  expect_axes(record, 212);
  EXPECT_EQ(record[Direction::kH1]->name, "fault-normal");
  EXPECT_EQ(record[Direction::kH2]->name, "fault-parallel");
  EXPECT_EQ(record.processing.back(),
            "horizontals rotated by -212 degrees counter-clockwise, h1 to azimuth 212: h1 normal, "
            "h2 parallel to the fault of strike 122");
}

TEST(Rotate, RefusesWhatCannotBe) {
  EXPECT_EQ(error_text([] { orthogonal_horizontals(record_at(30, 59)); }),
            "30.at2 and 59.at2: the horizontals have azimuths of 030 and 059 degrees, less than 30 "
            "degrees from parallel: the motion across them cannot be determined");
  EXPECT_NE(error_text([] { orthogonal_horizontals(record_at(30, 205)); }), "(no error)");
  Record record = record_at(0, 270);
  EXPECT_EQ(error_text([&] { rotated_by(record, std::nan("")); }),
            "the angle to rotate by must be finite");
  EXPECT_EQ(error_text([&] { rotate_to(record, std::nan("")); }),
            "the azimuth to rotate to must be finite");
  record.components[0]->azimuth.reset();
  EXPECT_EQ(error_text([&] { rotate_to(record, 0); }),
            "only a record with azimuths of h1 and h2 can be rotated to an azimuth; rotate by an "
            "angle instead");
  record.components[0].reset();
  EXPECT_EQ(error_text([&] { rotated_by(record, 0); }),
            "only a record with h1 and h2 can be rotated");
}

}  // namespace
}  // namespace gurney::groundmotions
