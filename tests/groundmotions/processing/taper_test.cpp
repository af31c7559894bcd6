#include <gtest/gtest.h>

#include <cmath>

#include "groundmotions/processing/trim.h"
#include "tests/support/error_text.h"

namespace gurney::groundmotions {
namespace {

TEST(Taper, IsACosineAtBothEnds) {
  const Eigen::VectorXd w = tapered(0.1, Eigen::VectorXd::Ones(21), 0.4, 0.6);
  EXPECT_EQ(w[0], 0);
  EXPECT_NEAR(w[1], (1 - std::sqrt(0.5)) / 2, 1e-15);
  EXPECT_NEAR(w[2], 0.5, 1e-15);
  EXPECT_EQ(w.segment(4, 11), Eigen::VectorXd::Ones(11));
  EXPECT_NEAR(w[17], 0.5, 1e-15);
  EXPECT_NEAR(w[19], (1 - std::sqrt(0.75)) / 2, 1e-15);
  EXPECT_EQ(w[20], 0);
}

TEST(Taper, OfNoLengthChangesNothing) {
  const Eigen::VectorXd a = Eigen::VectorXd::LinSpaced(5, 1, 2);
  EXPECT_EQ(tapered(0.1, a, 0, 0), a);
  EXPECT_EQ(tapered(0.1, a, 0, 0.2).head(3), a.head(3));
}

TEST(Taper, RefusesWhatIsLongerThanTheRecord) {
  const Eigen::VectorXd a = Eigen::VectorXd::Ones(11);
  EXPECT_EQ(error_text([&] { tapered(0.1, a, 0.5, 0.5); }), "(no error)");
  EXPECT_EQ(error_text([&] { tapered(0.1, a, 0.5, 0.6); }),
            "tapers must be >= 0 s and together at most the record, 1 s, got 0.5 and 0.6 s");
  for (const double wrong : {-0.1, std::nan("")})
    EXPECT_NE(error_text([&] { tapered(0.1, a, wrong, 0); }), "(no error)");
}

}  // namespace
}  // namespace gurney::groundmotions
