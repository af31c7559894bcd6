#include "tests/peers/cone.h"

#include <gtest/gtest.h>

#include <random>

namespace gurney::peers {
namespace {

// Of random contacts: p in the cone, (start + block p)_z = 0 under load, no slip inside the cone, and
// on it friction against the slip. Conditions hold to the rounding of a 3 x 3 inverse, 1e-10.
TEST(Cone, HoldsSlidesOrOpens) {
  std::mt19937 random(1);
  std::normal_distribution<double> normal;
  int held = 0, slid = 0, open = 0;
  for (int n = 0; n < 3000; ++n) {
    const Matrix3 root = Matrix3::NullaryExpr([&] { return normal(random); });
    // A block of small couplings: strong ones have no solution, or several (Painleve).
    const ContactBlock contact{Matrix3::Identity() + 0.05 * root * root.transpose(),
                               Vector3::NullaryExpr([&] { return normal(random); }), 0.6};
    const Vector3 p = cone_impulse(contact), u = contact.start + contact.block * p;
    if (contact.start.z() >= 0) {
      ++open;
      EXPECT_EQ(p, Vector3::Zero().eval());
      continue;
    }
    EXPECT_NEAR(u.z(), 0, 1e-10);
    const double across = p.head<2>().norm(), limit = contact.friction * p.z();
    EXPECT_GT(p.z(), 0);
    EXPECT_LE(across, limit * (1 + 1e-10));
    const bool slides = u.head<2>().norm() > 1e-9;
    ++(slides ? slid : held);
    if (!slides) continue;
    EXPECT_NEAR(across, limit, 1e-10);
    EXPECT_NEAR(p.head<2>().dot(u.head<2>()), -limit * u.head<2>().norm(), 1e-9);
  }
  EXPECT_GT(held, 100);
  EXPECT_GT(slid, 100);
  EXPECT_GT(open, 100);
}

}  // namespace
}  // namespace gurney::peers
