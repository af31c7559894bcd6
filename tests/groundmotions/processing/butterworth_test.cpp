#include "groundmotions/processing/butterworth.h"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <numbers>

#include "engine/base/random/normal_draw.h"
#include "groundmotions/measures/peaks.h"
#include "tests/support/error_text.h"

namespace gurney::groundmotions {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kStep = 0.01;

Butterworth high_pass(double corner, int order) {
  return {.high_pass = corner, .low_pass = {}, .order = order, .keep_pads = true, .taper = 0.0};
}

Butterworth low_pass(double corner, int order) {
  return {.high_pass = {}, .low_pass = corner, .order = order, .keep_pads = true, .taper = 0.0};
}

/// Spectrum at one frequency of the answer to a unit impulse in the middle of a record of 200 s,
/// time counted from the impulse: the definition of the frequency response.
std::complex<double> response(const Butterworth& filter, double frequency) {
  constexpr Eigen::Index kHalf = 10000;
  Eigen::VectorXd impulse = Eigen::VectorXd::Zero(2 * kHalf + 1);
  impulse[kHalf] = 1;
  const Eigen::VectorXd answer = filtered(filter, kStep, impulse);
  const Eigen::Index middle = kHalf + pad_samples(filter, kStep);
  std::complex<double> sum = 0;
  for (Eigen::Index i = 0; i < answer.size(); ++i)
    sum += answer[i] * std::polar(1.0, -2 * kPi * frequency * kStep * double(i - middle));
  return sum;
}

double tangent(double frequency) { return std::tan(kPi * frequency * kStep); }

// The slowest pole decays with exp(-2 pi f_c sin(pi / 2n) t): at 1 Hz, order 10 and 100 s by
// exp(-98), so nothing of the answer is cut off. What is left is rounding, of 2e4 terms below 1.
TEST(Butterworth, HasTheGainOfTwoPassesAndNoPhase) {
  for (int order = 1; order <= 10; ++order)
    for (const double f : {0.5, 0.9, 1.0, 1.3, 4.0, 30.0}) {
      const double ratio = tangent(f) / tangent(1);
      const double low = 1 / (1 + std::pow(ratio, 2 * order));
      EXPECT_NEAR(response(low_pass(1, order), f).real(), low, 1e-11) << order << ' ' << f;
      EXPECT_NEAR(response(low_pass(1, order), f).imag(), 0, 1e-11) << order << ' ' << f;
      EXPECT_NEAR(response(high_pass(1, order), f).real(), 1 - low, 1e-11) << order << ' ' << f;
      EXPECT_NEAR(response(high_pass(1, order), f).imag(), 0, 1e-11) << order << ' ' << f;
    }
}

TEST(Butterworth, IsHalfAtTheCornerAndGoneAtTheForbiddenEnd) {
  EXPECT_NEAR(response(high_pass(2, 4), 2).real(), 0.5, 1e-11);
  EXPECT_NEAR(response(low_pass(2, 5), 2).real(), 0.5, 1e-11);
  EXPECT_NEAR(std::abs(response(high_pass(2, 4), 0)), 0, 1e-11);
  EXPECT_NEAR(std::abs(response(low_pass(2, 4), 50)), 0, 1e-11);
}

// The analogue filter, for f far below Nyquist: tan x = x (1 + x^2 / 3 + ...), so a ratio of two is
// off by less than x^2 / 2 at the higher one and the gain by 2 n / 4 times that.
TEST(Butterworth, IsNearTheAnalogueFilter) {
  for (const double f : {0.6, 1.0, 2.0}) {
    const double x = kPi * f * kStep;
    EXPECT_NEAR(response(high_pass(1, 4), f).real(), 1 / (1 + std::pow(1 / f, 8)), x * x) << f;
  }
}

TEST(Butterworth, BandPassIsOneAfterTheOther) {
  Butterworth band = high_pass(1, 3);
  band.low_pass = 10;
  for (const double f : {0.3, 1.0, 3.0, 10.0, 25.0})
    EXPECT_NEAR(response(band, f).real(),
                1 / (1 + std::pow(tangent(1) / tangent(f), 6)) /
                    (1 + std::pow(tangent(f) / tangent(10), 6)),
                1e-11);
}

/// 20 s of noise with an offset.
Eigen::VectorXd noise(std::uint64_t seed, double offset = 0) {
  Eigen::VectorXd a(2001);
  for (Eigen::Index i = 0; i < a.size(); ++i)
    a[i] = offset + normal_draw(seed, 0, static_cast<std::uint64_t>(i));
  return a;
}

// With n >= 2 the gain is 0 at 0 Hz to fourth order, so both integrals of the whole answer are
// zero. At the end of the pads exp(-3 pi n sin(pi / 2n)) of the tail is left, 2e-6 for n = 2;
// allowed: ten times that of the largest value. Cutting the pads off costs a thousand times more.
TEST(Butterworth, KeptPadsBringVelocityAndDisplacementBack) {
  for (const int order : {2, 4, 8}) {
    Butterworth filter = high_pass(0.2, order);
    const Eigen::VectorXd a = noise(1, 0.05);
    const IntegratedMotion kept = integrated(kStep, filtered(filter, kStep, a));
    const double duration = kStep * static_cast<double>(kept.velocity.size() - 1);
    const double v = kept.velocity.cwiseAbs().maxCoeff();
    const double d = kept.displacement.cwiseAbs().maxCoeff();
    const double v_end = std::abs(kept.velocity.tail<1>()[0]);
    const double d_end = std::abs(kept.displacement.tail<1>()[0]);
    const double tail = 10 * std::exp(-3 * kPi * order * std::sin(kPi / (2 * order)));
    EXPECT_LT(v_end, tail * v) << order;
    EXPECT_LT(d_end, tail * (d + v * duration)) << order;
    filter.keep_pads = false;
    const EndMotion cut = end_motion(kStep, filtered(filter, kStep, a));
    EXPECT_GT(std::abs(cut.displacement), 1000 * d_end) << order;
  }
}

TEST(Butterworth, PadsAreOnePointFiveTimesTheOrderOverTheCorner) {
  EXPECT_EQ(pad_samples(high_pass(0.1, 4), 0.005), 12000);  // 60 s
  EXPECT_EQ(pad_samples(low_pass(0.7, 2), 0.01), 429);      // 4.2857 s
  Butterworth band = high_pass(0.1, 4);
  band.low_pass = 20;
  EXPECT_EQ(pad_samples(band, 0.005), 12000);
  EXPECT_EQ(filtered(band, kStep, noise(1)).size(), 2001 + 2 * 6000);
  band.keep_pads = false;
  EXPECT_EQ(filtered(band, kStep, noise(1)).size(), 2001);
}

// Rounding: answers of size 1, a recursion whose errors decay within its memory.
TEST(Butterworth, IsLinearAndMovesWithTheMotion) {
  const Butterworth filter{.high_pass = 0.5, .low_pass = 20, .taper = 0.0};
  const Eigen::VectorXd a = noise(1), b = noise(2, 1);
  const Eigen::VectorXd fa = filtered(filter, kStep, a), fb = filtered(filter, kStep, b);
  const Eigen::VectorXd both = filtered(filter, kStep, 2 * a - 3 * b);
  EXPECT_LT((both - 2 * fa + 3 * fb).cwiseAbs().maxCoeff(), 1e-11);

  constexpr Eigen::Index kLater = 137;
  Eigen::VectorXd moved = Eigen::VectorXd::Zero(a.size() + kLater);
  moved.tail(a.size()) = a;
  const Eigen::VectorXd fm = filtered(filter, kStep, moved);
  // The pads cut the first tail off exp(-14) = 6e-7 earlier.
  EXPECT_LT((fm.tail(fa.size()) - fa).cwiseAbs().maxCoeff(), 1e-6);
}

// Backward in time is the same filter, up to what the ends of the pads cut off.
TEST(Butterworth, HasNoDirectionOfTime) {
  const Butterworth filter = high_pass(0.5, 4);
  const Eigen::VectorXd a = noise(3);
  const Eigen::VectorXd forth = filtered(filter, kStep, a);
  const Eigen::VectorXd back = filtered(filter, kStep, a.reverse());
  EXPECT_LT((forth - back.reverse()).cwiseAbs().maxCoeff(), 1e-6);
}

TEST(Butterworth, TapersTheRecordBeforeThePads) {
  Butterworth filter = low_pass(40, 4);
  filter.taper = 1;
  const Eigen::VectorXd ones = Eigen::VectorXd::Ones(2001);
  const Eigen::VectorXd y = filtered(filter, kStep, ones);
  EXPECT_NEAR(y[pad_samples(filter, kStep) + 50], 0.5, 1e-3);  // linear there: the filter keeps it
  filter.taper.reset();                                        // 1 % of 20 s
  EXPECT_NEAR(filtered(filter, kStep, ones)[pad_samples(filter, kStep) + 10], 0.5, 1e-3);
}

TEST(Butterworth, RefusesWhatCannotBe) {
  const Eigen::VectorXd a = noise(1);
  const auto says = [&](const Butterworth& filter) {
    return error_text([&] { filtered(filter, kStep, a); });
  };
  EXPECT_EQ(
      says(low_pass(50, 4)),
      "the low-pass corner must be more than 0 and less than the Nyquist frequency, 50 Hz for "
      "a time step of 0.01 s, got 50 Hz");
  EXPECT_EQ(says(high_pass(0, 4)),
            "the high-pass corner must be more than 0 and less than the Nyquist frequency, 50 Hz "
            "for a time step of 0.01 s, got 0 Hz");
  EXPECT_NE(says(high_pass(std::nan(""), 4)), "(no error)");
  EXPECT_EQ(says(high_pass(1, 0)), "the order of a filter must be 1 to 10, got 0");
  EXPECT_EQ(says(high_pass(1, 11)), "the order of a filter must be 1 to 10, got 11");
  EXPECT_EQ(says(Butterworth{}), "a filter needs a corner");
  Butterworth band = high_pass(5, 4);
  band.low_pass = 5;
  EXPECT_EQ(says(band), "the high-pass corner must be below the low-pass corner, got 5 and 5 Hz");
  EXPECT_EQ(says(high_pass(1e-6, 4)),
            "a corner of 1e-06 Hz needs 6e+06 s of zeros at each end, more than 1e+07 samples of "
            "0.01 s");
}

}  // namespace
}  // namespace gurney::groundmotions
