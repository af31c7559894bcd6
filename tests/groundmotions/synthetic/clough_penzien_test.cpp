#include "groundmotions/synthetic/clough_penzien.h"

#include <gmock/gmock.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <numbers>
#include <sstream>

#include "engine/base/units.h"
#include "groundmotions/assembly/read_record.h"
#include "groundmotions/measures/peaks.h"
#include "groundmotions/record/record_motion.h"

namespace gurney::groundmotions {
namespace {

const std::filesystem::path kShipped = GURNEY_SOURCE_DIR "/groundmotions/records/synthetic_3c.csv";

TEST(Synthetic, HasItsPeaksAndEndsAtRest) {
  const SyntheticMotion motion = shipped_synthetic_motion();
  const Record record = synthetic_record(motion);
  const Residual r = residual(floor_motion(record));
  // Sums of 6000 terms of size 4 m/s2 * dt in double precision.
  EXPECT_LT(r.velocity.norm(), 1e-12);
  EXPECT_LT(r.displacement.norm(), 1e-10);
  for (const Direction direction : kDirections) {
    const auto& component = *record[direction];
    const Peaks p = peaks(motion.time_step, component.acceleration);
    const auto& wanted = motion.components[static_cast<std::size_t>(direction)];
    EXPECT_DOUBLE_EQ(p.acceleration, wanted.peak_acceleration);
    // An envelope, not stationary noise: strong around its peak time, gone at the ends. At 0.5 s
    // that of the vertical is 0.02.
    EXPECT_NEAR(p.time_of_acceleration, wanted.peak_time, 4);
    EXPECT_LT(component.acceleration.head(100).cwiseAbs().maxCoeff(), 0.02 * p.acceleration);
    EXPECT_LT(component.acceleration.tail(100).cwiseAbs().maxCoeff(), 0.01 * p.acceleration);
  }
}

// The peak of the vertical's spectrum lies an octave above that of the horizontals, so it crosses
// zero more often.
TEST(Synthetic, SwingsFasterUpAndDown) {
  const Record record = synthetic_record(shipped_synthetic_motion());
  const auto crossings = [&](Direction direction) {
    const auto& a = record[direction]->acceleration;
    int count = 0;
    for (Eigen::Index i = 401; i < 2000; ++i) count += a[i] * a[i - 1] < 0;
    return count;
  };
  EXPECT_GT(crossings(Direction::kVertical), 1.2 * crossings(Direction::kH1));
  // 8 s of strong motion with a mean frequency between 2 and 20 Hz.
  EXPECT_GT(crossings(Direction::kH1), 2 * 2 * 8);
  EXPECT_LT(crossings(Direction::kVertical), 2 * 20 * 8);
}

TEST(Synthetic, DependsOnTheSeedAndComponentsAreIndependent) {
  SyntheticMotion motion = shipped_synthetic_motion();
  const Record first = synthetic_record(motion);
  motion.seed += 1;
  const Record second = synthetic_record(motion);
  const auto correlation = [](const Eigen::VectorXd& a, const Eigen::VectorXd& b) {
    return std::abs(a.dot(b)) / (a.norm() * b.norm());
  };
  const auto& h1 = first[Direction::kH1]->acceleration;
  // About 2 * 3 Hz * 9 s = 50 independent values: the correlation scatters by 0.14; 3 of these.
  EXPECT_LT(correlation(h1, second[Direction::kH1]->acceleration), 0.42);
  EXPECT_LT(correlation(h1, first[Direction::kH2]->acceleration), 0.42);
}

// The displacement is that of the noise between the first and the last tenth, and sin^2(pi / 4) = 1/2 of it halfway
// through these, but for the peak velocity, which is 1 m/s.
TEST(LongPeriodMotion, IsNoiseWhoseFirstAndLastTenthAreTapered) {
  const LongPeriodMotion motion{
      .seed = 3, .duration = 100, .peak_velocity = {1, 0}, .peak_time = 40};
  const Eigen::VectorXd made = long_period_motion(motion)[Direction::kH1]->acceleration;
  EXPECT_NEAR(peaks(motion.time_step, made).velocity, 1, 1e-12);
  const SyntheticComponent ground{.peak_acceleration = 1,
                                  .peak_time = motion.peak_time,
                                  .envelope_power = motion.envelope_power,
                                  .ground_frequency = 2 * std::numbers::pi / motion.ground_period,
                                  .ground_damping = motion.ground_damping,
                                  .low_cut_frequency = 2 * std::numbers::pi / motion.low_cut_period,
                                  .low_cut_damping = 0.6};
  const Eigen::VectorXd noise = clough_penzien_noise({.seed = 3,
                                                      .time_step = motion.time_step,
                                                      .samples = 10001,
                                                      .components = {ground, ground, ground}},
                                                     Direction::kH1);
  const Eigen::VectorXd moved = integrated(motion.time_step, made).displacement,
                        free = integrated(motion.time_step, noise).displacement;
  const double scale = moved[5000] / free[5000], size = free.cwiseAbs().maxCoeff();
  for (const Eigen::Index i : {1000, 2500, 7000, 9000})
    EXPECT_NEAR(moved[i] / scale, free[i], 1e-9 * size) << i;
  for (const Eigen::Index i : {500, 9500})
    EXPECT_NEAR(moved[i] / scale, free[i] / 2, 1e-9 * size) << i;
}

TEST(ShippedRecord, IsWhatTheProgramMakes) {
  const Record shipped = read_record(std::vector<RecordFile>{{kShipped, {}}});
  const Record made = synthetic_record(shipped_synthetic_motion());
  EXPECT_THAT(shipped.warnings, testing::IsEmpty());
  ASSERT_EQ(shipped.samples(), made.samples());
  EXPECT_EQ(shipped.time_step(), made.time_step());
  for (const Direction direction : kDirections) {
    // Five printed digits: half a unit of the last, and 1e-9 for another libm.
    const auto difference = shipped[direction]->acceleration - made[direction]->acceleration;
    EXPECT_LE(difference.cwiseAbs().maxCoeff(), 0.5e-5 + 1e-9);
  }
}

TEST(ShippedRecord, HasTheHeaderThatTheProgramWrites) {
  std::ifstream stream(kShipped);
  std::istringstream made(shipped_synthetic_text());
  std::string line, expected;
  while (std::getline(made, expected) && expected[0] == '#') {
    std::getline(stream, line);
    EXPECT_EQ(line, expected);
  }
}

// Rounding 6000 samples to 1e-5 m/s2 leaves sqrt(6000 / 12) 1e-5 dt = 1.1e-6 m/s and, with the time
// that is left, 2e-5 m; five times these.
TEST(ShippedRecord, EndsAtRest) {
  const Residual r = residual(floor_motion(read_record(std::vector<RecordFile>{{kShipped, {}}})));
  EXPECT_LT(r.velocity.norm(), 6e-6);
  EXPECT_LT(r.displacement.norm(), 1e-4);
  EXPECT_LT(std::filesystem::file_size(kShipped), 400'000u);
}

}  // namespace
}  // namespace gurney::groundmotions
