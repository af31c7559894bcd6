#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>
#include <numbers>

#include "engine/base/error.h"
#include "engine/run/simulate.h"
#include "engine/solver/joint_law.h"
#include "studies/verification/scenes/blocks.h"
#include "studies/verification/scenes/small_scenes.h"

// Items with parts on joints, against closed forms and an independent integration.
namespace gurney {
namespace {

constexpr double kGravity = 9.80665;
using Kind = Joint::Kind;

/// A body of `mass` whose centre is at `center`, a box of edge `edge` there.
PlacedItem body(const std::string& name, double mass, const Vector3& center, double edge) {
  PlacedItem item = blocks::block(mass, Vector3::Constant(edge), {}).items[0];
  item.name = name;
  item.model.chassis_center_of_mass = center;
  item.model.shape[0].center = center;
  item.model.marked_points.clear();
  return item;
}

/// A block of 100 kg and 1 m that its fixture holds on the floor.
Scene held_block() {
  Scene scene = blocks::block(100, {1, 1, 1}, {});
  scene.items[0].name = "base";
  scene.pairs.push_back({"steel", "steel", {}});
  for (Guide& guide : scene.items[0].fixture.guides) guide.kind = Guide::Kind::kHeld;
  return scene;
}

Joint joint(Kind kind, std::size_t base, std::size_t part, const Vector3& point,
            const Vector3& axis) {
  Joint joint;
  joint.kind = kind;
  joint.name = "joint";
  joint.base = base;
  joint.part = part;
  joint.point = point;
  joint.axis = axis;
  return joint;
}

/// A floor that accelerates along x as `size` sin(2 pi f t), every millisecond a sample.
FloorMotion sine_floor(double size, double frequency, double duration) {
  const auto count = static_cast<Eigen::Index>(std::lround(duration / 0.001)) + 1;
  Eigen::Matrix3Xd a = Eigen::Matrix3Xd::Zero(3, count);
  for (Eigen::Index i = 0; i < count; ++i)
    a(0, i) = size * std::sin(2 * std::numbers::pi * frequency * 0.001 * static_cast<double>(i));
  return {0.001, a};
}

double angle_about_y(const Quaternion& q) { return 2 * std::atan2(q.y(), q.w()); }

template <std::size_t N>
std::array<double, N> rk4(
    std::array<double, N> y, double t, double h,
    const std::function<std::array<double, N>(double, const std::array<double, N>&)>& f) {
  const auto add = [](std::array<double, N> a, double s, const std::array<double, N>& b) {
    for (std::size_t i = 0; i < N; ++i) a[i] += s * b[i];
    return a;
  };
  const auto k1 = f(t, y), k2 = f(t + h / 2, add(y, h / 2, k1)),
             k3 = f(t + h / 2, add(y, h / 2, k2)), k4 = f(t + h, add(y, h, k3));
  return add(add(add(add(y, h / 6, k1), h / 3, k2), h / 3, k3), h / 6, k4);
}

// Two uniform cubes hang on each other under a floor that shakes: Lagrange's equations of the double
// pendulum with the angles a, b from the vertical and the floor's acceleration x'',
//   (I1 + (m1) d1^2 + m2 l^2) a'' + m2 l d2 cos(a - b) b'' = -m2 l d2 sin(a - b) b'^2 - (m1 d1 + m2 l)(g sin a + x'' cos a)
//   (I2 + m2 d2^2) b'' + m2 l d2 cos(a - b) a'' = m2 l d2 sin(a - b) a'^2 - m2 d2 (g sin b + x'' cos b).
TEST(Parts, DoublePendulumOnAShakingFloor) {
  Scene scene = held_block();
  const double m1 = 3, m2 = 2, d1 = 0.4, l = 0.7, d2 = 0.3, edge = 0.1;
  scene.items.push_back(body("upper", m1, {1, 0, 2 - d1}, edge));
  scene.items.push_back(body("lower", m2, {1, 0, 2 - l - d2}, edge));
  scene.joints = {joint(Kind::kHinge, 0, 1, {1, 0, 2}, Vector3::UnitY()),
                  joint(Kind::kHinge, 1, 2, {1, 0, 2 - l}, Vector3::UnitY())};
  const double I1 = m1 * edge * edge / 6, I2 = m2 * edge * edge / 6;
  const auto floor = [](double t) { return 3.0 * std::sin(2 * std::numbers::pi * 0.8 * t); };
  using Y = std::array<double, 4>;
  const std::function<Y(double, const Y&)> rates = [&](double t, const Y& y) -> Y {
    const double a = y[0], b = y[1], c = std::cos(a - b), s = std::sin(a - b), x = floor(t);
    const double A = I1 + m1 * d1 * d1 + m2 * l * l, B = m2 * l * d2 * c, C = I2 + m2 * d2 * d2;
    const double p = -m2 * l * d2 * s * y[3] * y[3] -
                     (m1 * d1 + m2 * l) * (kGravity * std::sin(a) + x * std::cos(a));
    const double q =
        m2 * l * d2 * s * y[2] * y[2] - m2 * d2 * (kGravity * std::sin(b) + x * std::cos(b));
    const double det = A * C - B * B;
    return {y[2], y[3], (p * C - q * B) / det, (A * q - B * p) / det};
  };
  const double duration = 3;
  Y y{};
  const int steps = 30000;
  for (int i = 0; i < steps; ++i) y = rk4<4>(y, duration / steps * i, duration / steps, rates);
  // Second order: the error of half a step is a quarter, less terms of third order, and what is left after their
  // extrapolation to a step of zero is far less than the error of the finer.
  std::array<double, 3> a{}, b{};
  const std::array h = {0.002, 0.001, 0.0005};
  for (std::size_t k = 0; k < h.size(); ++k) {
    const Response r =
        simulate(scene, sine_floor(3, 0.8, duration), blocks::run_for(duration, h[k], 0.1));
    ASSERT_EQ(r.outcome, Outcome::kStopped) << r.cause;
    // The rotation about +y swings the body to -x.
    a[k] = -angle_about_y(r.items[1].history.back().orientation) - y[0];
    b[k] = -angle_about_y(r.items[2].history.back().orientation) - y[1];
    EXPECT_NEAR(r.items[1].demands.residual_swing, -y[0], 2 * std::abs(a[k]) + 1e-9);
    // The energy of a swing is as its amplitude squared: it may miss twice the share that the angles do.
    EXPECT_LT(r.quality.energy_closure, 2 * std::hypot(a[k], b[k]) / r.items[1].demands.peak_swing);
  }
  const double finer = std::hypot(a[2], b[2]);
  EXPECT_NEAR(std::hypot(a[1], b[1]) / finer, 4, 1);
  EXPECT_LT(std::hypot((4 * a[2] - a[1]) / 3, (4 * b[2] - b[1]) / 3), 0.2 * finer);
}

// A bag hangs from a cart that springs of its fixture lead along x:
//   (M + m) x'' + m d (a'' cos a - a'^2 sin a) = -(M + m) X'' - K x,   (I + m d^2) a'' + m d x'' cos a = -m d (g sin a + X'' cos a)
TEST(Parts, BagOnACartThatMoves) {
  Scene scene = held_block();
  const double K = 4000;
  scene.items[0].fixture.guides[0] = {Guide::Kind::kSpring, 0, K, 0};
  scene.pairs[0].constants.friction = 0;
  const double M = 100, m = 30, d = 0.5, edge = 0.2, I = m * edge * edge / 6;
  scene.items.push_back(body("bag", m, {1, 0, 2 - d}, edge));
  scene.joints = {joint(Kind::kBall, 0, 1, {1, 0, 2}, Vector3::UnitZ())};
  const auto floor = [](double t) { return 2.0 * std::sin(2 * std::numbers::pi * 0.9 * t); };
  using Y = std::array<double, 4>;
  const std::function<Y(double, const Y&)> rates = [&](double t, const Y& y) -> Y {
    const double c = std::cos(y[1]), s = std::sin(y[1]), X = floor(t);
    const double A = M + m, B = m * d * c, C = I + m * d * d;
    const double p = m * d * y[3] * y[3] * s - A * X - K * y[0],
                 q = -m * d * (kGravity * s + X * c);
    const double det = A * C - B * B;
    return {y[2], y[3], (p * C - q * B) / det, (A * q - B * p) / det};
  };
  const double duration = 3;
  Y y{};
  const int steps = 30000;
  for (int i = 0; i < steps; ++i) y = rk4<4>(y, duration / steps * i, duration / steps, rates);
  std::array<double, 2> x{}, a{};
  const std::array h = {0.004, 0.002};
  for (std::size_t k = 0; k < h.size(); ++k) {
    const Response r =
        simulate(scene, sine_floor(2, 0.9, duration), blocks::run_for(duration, h[k], 0.1));
    ASSERT_EQ(r.outcome, Outcome::kStopped) << r.cause;
    x[k] = r.items[0].history.back().displacement.x() - y[0];
    a[k] = -angle_about_y(r.items[1].history.back().orientation) - y[1];
    EXPECT_GT(r.items[1].demands.peak_swing, 0.3);
  }
  EXPECT_LT(std::abs(4 * x[1] - x[0]) / 3, 0.2 * std::abs(x[1]) + 1e-5);
  EXPECT_LT(std::abs(4 * a[1] - a[0]) / 3, 0.2 * std::abs(a[1]) + 1e-5);
  EXPECT_LT(std::abs(x[0]), 2e-3);
}

/// A drawer of 4 kg that slides along x out of a held block.
Scene drawer() {
  Scene scene = held_block();
  scene.items.push_back(body("drawer", 4, {0, 0, 0.5}, 0.2));
  scene.joints = {joint(Kind::kSlider, 0, 1, {0, 0, 0.5}, Vector3::UnitX())};
  return scene;
}

/// A floor whose acceleration along x is linear between these.
FloorMotion floor_of(std::vector<double> x, double step) {
  Eigen::Matrix3Xd a = Eigen::Matrix3Xd::Zero(3, static_cast<Eigen::Index>(x.size()));
  for (std::size_t i = 0; i < x.size(); ++i) a(0, static_cast<Eigen::Index>(i)) = x[i];
  return {step, a};
}

// Under a ramp the drawer loads its latch by m r t, and its spring and damper k (e + T_c e') lag behind by T_c: it lets
// go at F / (m r) + T_c, when k e = F. The transient of the start, exp(-t / T) with T below 0.1 s, is gone by then.
TEST(Parts, LatchLetsGoAtItsForce) {
  Scene scene = drawer();
  scene.joints[0].latch = 10;
  scene.joints[0].lower = 0;
  const double rate = -2;  // [m/s3]
  const double due = 10 / (4 * 2.0) + JointLaw::kHoldTime;
  for (const double h : {0.008, 0.002}) {
    const Response r = simulate(scene, floor_of({0, 2 * rate}, 2), blocks::run_for(1.5, h, 0.1));
    EXPECT_NEAR(r.items[1].demands.time_of_release, due, 1e-3);
    EXPECT_GT(r.items[1].demands.peak_travel, 0.01);
  }
  scene.joints[0].latch = 20.1;  // m r t is 16 N in the end
  const Response held =
      simulate(scene, floor_of({0, 2 * rate}, 2), blocks::run_for(1.9, 0.004, 0.1));
  EXPECT_EQ(held.items[1].demands.time_of_release, -1);
  EXPECT_LT(held.items[1].demands.peak_travel, JointLaw::kYield);
  EXPECT_TRUE(std::isnan(held.items[0].demands.peak_travel)) << "the base is no part";
}

// Spring and damper of a latch that is shaken by a sin w t stretch to a m / (k |H|), with r = w / w0 and
// |H|^2 = (1 - r^2)^2 + (w T_c)^2: it opens at a = F |H| / m. The transient, exp(-w0^2 T_c t / 2), is below 1 % at the
// first peak of 8 Hz, and steps of 2 ms err by less than (w h)^2 = 1 %: 3 % hold both.
TEST(Parts, LatchHoldsAgainstShakingUpToItsForce) {
  Scene scene = drawer();
  scene.joints[0].latch = 12;
  const double at_rest = 12.0 / 4, own_squared = at_rest / JointLaw::kYield;
  for (const double frequency : {1.0, 4.0, 8.0}) {
    const double w = 2 * std::numbers::pi * frequency;
    const double opens = at_rest * std::hypot(1 - w * w / own_squared, w * JointLaw::kHoldTime);
    EXPECT_NEAR(opens, at_rest, 0.06 * at_rest)
        << "a latch of stated force, at " << frequency << " Hz";
    const auto released = [&](double share) {
      const FloorMotion floor = sine_floor(share * opens, frequency, 1);
      return simulate(scene, floor, blocks::run_for(1, 0.002, 0.1))
          .items[1]
          .demands.time_of_release;
    };
    EXPECT_EQ(released(0.97), -1) << frequency;
    EXPECT_GT(released(1.03), 0) << frequency;
  }
}

// 4 kg on a slope of 0.3 load the latch by 11 N: held by 12 N the drawer stays, by 10 N it rests open from the start.
TEST(Parts, ALatchThatBearsMoreThanItHoldsIsOpenAtRest) {
  Scene scene = drawer();
  scene.slope = 0.3;
  scene.joints[0].lower = -0.2;
  scene.joints[0].upper = 0.2;
  scene.joints[0].latch = 12;
  const SimulationSettings settings = blocks::run_for(1, 0.004, 0.1);
  const Demands held = simulate(scene, {}, settings).items[1].demands;
  EXPECT_EQ(held.time_of_release, -1);
  EXPECT_LT(held.peak_travel, JointLaw::kYield);
  scene.joints[0].latch = 10;
  const Response open = simulate(scene, {}, settings);
  EXPECT_EQ(open.outcome, Outcome::kStopped) << open.cause;
  EXPECT_LT(open.quality.energy_closure, 1e-3);
  const Demands& d = open.items[1].demands;
  EXPECT_EQ(d.time_of_release, 0);
  // Against its stop, which yields by the force over its stiffness of 1e5 N/m, and moves no more.
  EXPECT_NEAR(d.residual_travel, -0.2, 2e-4);
  EXPECT_LT(d.largest_stop_speed, 1e-4);
}

// A mast of k < m g h stands upright and falls once it is touched; k > m g h holds it. A door on a hinge along the
// vertical stays where it is left.
TEST(Parts, RefusesWhatStandsOnlyUntilItIsTouched) {
  const auto refused = [](Kind kind, const Vector3& axis, double stiffness) -> std::string {
    Scene scene = held_block();
    scene.items.push_back(body("mast", 2, {0, 0, 1.5}, 0.1));
    scene.joints = {joint(kind, 0, 1, {0, 0, 1}, axis)};
    scene.joints[0].stiffness = stiffness;
    try {
      simulate(scene, {}, blocks::run_for(0.1, 0.004, 0.1));
    } catch (const Error& error) {
      return error.what();
    }
    return "";
  };
  using testing::HasSubstr;
  const double weight = 2 * kGravity * 0.5;  // m g h [N m/rad]
  for (const Kind kind : {Kind::kFlexible, Kind::kBall}) {
    EXPECT_THAT(refused(kind, Vector3::UnitZ(), 0.7 * weight),
                HasSubstr("item 'base' does not come to rest: its part 'mast' stands upright"));
    EXPECT_EQ(refused(kind, Vector3::UnitZ(), 1.3 * weight), "");
    // (m h^2 + I) a'' = (m g h - k) a: what falls as exp(t) or slower counts as resting.
    const double inertia = 2 * (0.5 * 0.5 + 0.1 * 0.1 / 6);
    EXPECT_EQ(refused(kind, Vector3::UnitZ(), weight - 0.95 * inertia), "");
    EXPECT_THAT(refused(kind, Vector3::UnitZ(), weight - 1.05 * inertia),
                HasSubstr("stands upright"));
  }
  EXPECT_THAT(refused(Kind::kHinge, Vector3::UnitX(), 0), HasSubstr("stands upright"));
  EXPECT_EQ(refused(Kind::kHinge, Vector3::UnitZ(), 0), "");
}

// A short link that carries 40 kg swings fast: its rest is that of any chain. Turned over it falls, as does a chain of
// which one spring alone would hold its own part, but not what that carries.
TEST(Parts, AChainHangsAndDoesNotStand) {
  const auto rests = [](double down, double upper_spring, double lower_spring) {
    Scene scene = held_block();
    const double link = down * 0.02, below = down * 0.3;
    scene.items.push_back(body("link", 1, {0, 0, 1.5 - link / 2}, 0.02));
    scene.items.push_back(body("weight", 40, {0, 0, 1.5 - link - below}, 0.2));
    scene.joints = {joint(Kind::kHinge, 0, 1, {0, 0, 1.5}, Vector3::UnitY()),
                    joint(Kind::kHinge, 1, 2, {0, 0, 1.5 - link}, Vector3::UnitY())};
    scene.joints[0].stiffness = upper_spring;
    scene.joints[1].stiffness = lower_spring;
    try {
      simulate(scene, {}, blocks::run_for(0.02, 0.004, 0.02));
    } catch (const Error&) {
      return false;
    }
    return true;
  };
  EXPECT_TRUE(rests(1, 0, 0));
  EXPECT_FALSE(rests(-1, 0, 0));
  const double weight = 40 * kGravity * 0.3;
  EXPECT_FALSE(rests(-1, 0, 2 * weight)) << "the link falls with what it carries";
  EXPECT_FALSE(rests(-1, 0.5 * weight, 2 * weight));
  EXPECT_TRUE(rests(-1, 4 * weight, 4 * weight));
}

// Histories of a part have the displacement of its centre of mass: its origin follows from its orientation. A bag
// that hangs obliquely where it is placed settles by 45 degrees; then it swings. The joint yields by less than 10 um.
TEST(Parts, OriginsStayAtTheirJoints) {
  Scene scene = held_block();
  const Vector3 point(1, 0, 2), center(1.3, 0, 1.7);
  scene.items.push_back(body("bag", 3, center, 0.1));
  scene.joints = {joint(Kind::kBall, 0, 1, point, Vector3::UnitZ())};
  const Response r = simulate(scene, sine_floor(3, 0.8, 1), blocks::run_for(1, 0.002, 0.02));
  ASSERT_EQ(r.outcome, Outcome::kStopped) << r.cause;
  const ItemResponse& bag = r.items[1];
  EXPECT_EQ(bag.tracked, center);
  EXPECT_GT(bag.demands.peak_displacement, 0.05);
  for (const Sample& s : bag.history)
    EXPECT_LT((s.origin_displacement() + s.orientation * point - point).norm(), 1e-5) << s.time;
  for (const Sample& s : r.items[0].history) EXPECT_EQ(s.to_origin, Vector3::Zero());
}

// Nothing moves, and the springs below the box are the desk's: its energies are rounding, and no error.
TEST(Parts, ContentsAtRestAreNoErrorOfTheEnergy) {
  Scene scene = blocks::block(50, {0.6, 0.5, 0.8}, {});
  scene.items[0].name = "desk";
  scene.pairs.clear();
  scene.items.push_back(body("drawer", 5, {0, 0, 0.7}, 0.1));
  scene.items.push_back(body("box", 5, {0, 0, 0.125}, 0.25));
  for (PlacedItem& item : scene.items) item.model.material = "";
  scene.floor_material = "";
  scene.joints = {joint(Kind::kSlider, 0, 1, {0, 0, 0.7}, Vector3::UnitX())};
  scene.joints[0].latch = 15;
  scene.items[2].on = Support{Support::Kind::kItem, 0, 0.8};
  const Response r = simulate(scene, {}, blocks::run_for(5, 0.004, 0.02));
  EXPECT_EQ(r.outcome, Outcome::kStopped) << r.cause;
  EXPECT_LT(r.quality.energy_closure, 1e-6);
}

// A table that is held carries as the floor does: slip on it ends in the same places. An end of slip that is not
// located makes the velocity wrong by up to 2 mu g h, 16 mm/s here.
TEST(Parts, ContentsSlideOnATableAsOnTheFloor) {
  ContactConstants constants;
  constants.friction = 0.2;
  Scene on_floor = blocks::block(10, Vector3::Constant(0.3), constants), on_table = held_block();
  on_table.pairs.back().constants = constants;
  on_table.items.push_back(body("box", 10, {0, 0, 0.15}, 0.3));
  on_table.items[1].on = Support{Support::Kind::kItem, 0, 1};
  const auto box_of = [](const Scene& scene) {
    const Response r = simulate(scene, sine_floor(4, 1, 3), blocks::run_for(3, 0.004, 0.1));
    return r.items.back().demands;
  };
  const Demands floor = box_of(on_floor), table = box_of(on_table);
  EXPECT_GT(floor.peak_displacement, 0.05);
  EXPECT_NEAR(table.peak_displacement, floor.peak_displacement, 1e-5);
  EXPECT_NEAR(table.residual_displacement, floor.residual_displacement, 1e-5);
}

// Likewise of Housner's rocking on its top: a slender content meets the table with the same
// corners. It leaves the table, on which it has ridden, at the start of a step: 0.5 ms.
TEST(Parts, ContentsRockOnATableAsOnTheFloor) {
  ContactConstants constants;
  constants.friction = 0.8;
  Scene on_floor = blocks::block(10, {0.15, 0.3, 0.6}, constants), on_table = held_block();
  on_table.pairs.back().constants = constants;
  on_table.items.push_back(on_floor.items[0]);
  on_table.items[1].name = "box";
  on_table.items[1].on = Support{Support::Kind::kItem, 0, 1};
  const auto box_of = [](const Scene& scene) {
    const Response r = simulate(scene, sine_floor(3, 1.5, 1.5), blocks::run_for(1.5, 0.0005, 0.1));
    return r.items.back().demands;
  };
  const Demands floor = box_of(on_floor), table = box_of(on_table);
  EXPECT_GT(floor.peak_tilt, 0.01);
  EXPECT_LT(floor.time_of_overturning, 0);
  EXPECT_NEAR(table.peak_tilt, floor.peak_tilt, 1e-3 * floor.peak_tilt);
}

TEST(Parts, RefusesWhatFallsToOneSideOrUnderWhatItCarries) {
  const auto refused = [](const Scene& scene) {
    try {
      simulate(scene, {}, blocks::run_for(0.1, 0.004, 0.1));
    } catch (const Error&) {
      return true;
    }
    return false;
  };
  // A lid upright against its stop, on either side.
  for (const double side : {1.0, -1.0}) {
    Scene lid = held_block();
    lid.items.push_back(body("lid", 2, {0, 0, 1.5}, 0.1));
    lid.joints = {joint(Kind::kHinge, 0, 1, {0, 0, 1}, Vector3::UnitX())};
    (side > 0 ? lid.joints[0].lower : lid.joints[0].upper) = 0;
    (side > 0 ? lid.joints[0].upper : lid.joints[0].lower) = 1.7 * side;
    EXPECT_TRUE(refused(lid)) << side;
  }
  // A mast of 0.2 kg with 4 kg fixed on it: m g h of both is 19.6 N m/rad.
  for (const double stiffness : {0.7 * 19.6, 1.3 * 19.6}) {
    Scene mast = held_block();
    mast.items.push_back(body("mast", 0.2, {0, 0, 1.1}, 0.05));
    mast.items.push_back(body("pump", 4, {0, 0, 1.495}, 0.1));
    mast.joints = {joint(Kind::kFlexible, 0, 1, {0, 0, 1}, Vector3::UnitZ()),
                   joint(Kind::kFixed, 1, 2, {0, 0, 1.2}, Vector3::UnitZ())};
    mast.joints[0].stiffness = stiffness;
    EXPECT_EQ(refused(mast), stiffness < 19.6) << stiffness;
  }
}

// Under a constant acceleration a free drawer meets its stop at L with v = sqrt(2 a L) and comes back by e^2 L. The
// stop yields by v sqrt(m / k) = 8 mm for pi sqrt(m / k) = 20 ms, in which the acceleration changes v by 2 %.
TEST(Parts, DrawerReboundsFromItsStop) {
  Scene scene = drawer();
  Joint& slider = scene.joints[0];
  slider.upper = 0.3;
  slider.restitution = 0.5;
  const double a = 2.5, speed = std::sqrt(2 * a * slider.upper);
  const Response r = simulate(scene, floor_of({-a, -a}, 3), blocks::run_for(0.85, 0.004, 0.004));
  const Demands& d = r.items[1].demands;
  EXPECT_NEAR(d.largest_stop_speed, speed, 1e-3 * speed);
  EXPECT_NEAR(d.peak_travel, slider.upper, speed * std::sqrt(4 / slider.stop_stiffness));
  double least = 1;
  bool met = false;
  for (const Sample& sample : r.items[1].history) {
    met |= sample.displacement.x() > slider.upper;
    if (met) least = std::min(least, sample.displacement.x());
  }
  EXPECT_NEAR(slider.upper - least, 0.25 * slider.upper, 0.03 * slider.upper);
}

// A hard stop, met at other times within the steps: one that ends where the drawer turns back, deep in the stop and
// slow, must not be followed by a long one. 32 steps in a blow leave 0.3 % of the rebound, and the acceleration
// changes v by a pi sqrt(m / k) / v = 0.1 % of it; its height has twice both.
TEST(Parts, DrawerReboundsFromAHardStopAtAnyTimeOfAStep) {
  Scene scene = drawer();
  Joint& slider = scene.joints[0];
  slider.upper = 0.3;
  slider.restitution = 0.6;
  slider.stop_stiffness = 1e8;
  for (int k = 0; k < 15; ++k) {
    const double a = 2.5 * (1 + 0.002 * k);
    const Response r = simulate(scene, floor_of({-a, -a}, 3), blocks::run_for(0.85, 0.004, 0.004));
    double least = 1;
    bool met = false;
    for (const Sample& sample : r.items[1].history) {
      met |= sample.displacement.x() > 0.99 * slider.upper;
      if (met) least = std::min(least, sample.displacement.x());
    }
    const double back = 0.36 * slider.upper;
    EXPECT_NEAR(slider.upper - least, back, 0.008 * back) << a;
    EXPECT_TRUE(r.outcome != Outcome::kUntrusted) << a;
  }
}

// Coulomb friction holds the drawer below m a = F and stops it by work: after a pulse that leaves it with v, F s = m v^2 / 2.
TEST(Parts, FrictionOfADrawer) {
  Scene scene = drawer();
  scene.joints[0].friction = 8;
  const Response stuck = simulate(scene, floor_of({0, -1.9}, 1), blocks::run_for(1, 0.004, 0.1));
  EXPECT_LT(stuck.items[1].demands.peak_travel, 2 * JointLaw::kYield);
  const Response slid = simulate(scene, floor_of({-6, -6}, 0.25), blocks::run_for(1.5, 0.001, 0.1));
  // Pushed with a = 6 m/s2 for 0.25 s against F / m = 2 m/s2, then stopped over v^2 / (2 F / m). Friction grows with
  // the path until it yields, after t = sqrt(2 y / a), so that v is larger by F / m 2 t / 3.
  const double more = 2 * 2.0 / 3 * std::sqrt(2 * JointLaw::kYield / 6);
  const double v = (6 - 2) * 0.25 + more, travel = (v + more) * 0.25 / 2 + v * v / (2 * 2);
  EXPECT_NEAR(slid.items[1].demands.peak_travel, travel, 0.002 * travel);
  EXPECT_NEAR(slid.items[1].demands.residual_travel, travel, 0.002 * travel);
}

// A mast that bends in its foot: I a'' + c a' + (k - m g h) a = 0 after a pulse, an exponential whose rates
// Prony's method reads from samples.
TEST(Parts, MastRingsAtItsFrequency) {
  Scene scene = held_block();
  const double m = 5, h = 0.8, edge = 0.1;
  scene.items.push_back(body("mast", m, {0, 0, 1 + h}, edge));
  scene.joints = {joint(Kind::kFlexible, 0, 1, {0, 0, 1}, Vector3::UnitZ())};
  const double inertia = m * (edge * edge / 6 + h * h), rate = 2 * std::numbers::pi * 2.4,
               zeta = 0.03;
  scene.joints[0].stiffness = inertia * rate * rate + m * kGravity * h;
  scene.joints[0].damping = 2 * zeta * inertia * rate;
  const double step = 0.001;
  const Response r = simulate(scene, floor_of({0, 1, 0}, 0.05), blocks::run_for(2, step, 0.02));
  std::vector<double> angles;
  for (const Sample& sample : r.items[1].history)
    if (sample.time > 0.2) angles.push_back(angle_about_y(sample.orientation));
  angles.pop_back();  // at the end of the run, off the spacing
  const Eigen::VectorXcd found = small::exponents(angles, 0.02, 2);
  const double damped = rate * std::sqrt(1 - zeta * zeta);
  // The method's own: 5 (omega h)^2 / 24 in the frequency or less, 5e-5.
  EXPECT_NEAR(std::abs(found[0].imag()), damped, 2e-4 * damped);
  EXPECT_NEAR(found[0].real(), -zeta * rate, 2e-3 * zeta * rate + 1e-4 * rate);
}

/// A trolley whose part is a block of 20 kg.
Scene trolley_with(bool as_payload, Kind kind) {
  Scene scene = scene_of(small::trolley({10, 100, 200, 300}, small::bare_tread(3e5, 1e5)));
  scene.items[0].name = "trolley";
  const PlacedItem load = body("load", 20, {0.1, 0.05, 0.9}, 0.2);
  if (as_payload) {
    scene.items[0].model.payloads.push_back(
        {"load", 20, load.model.chassis_center_of_mass, load.model.chassis_inertia});
    return scene;
  }
  scene.items.push_back(load);
  scene.items[1].model.material = "";
  scene.joints = {joint(kind, 0, 1, {0.1, 0.05, 0.8}, Vector3::UnitX())};
  scene.joints[0].latch = kind == Kind::kFixed ? 0 : Joint::kFree;
  return scene;
}

// A joint that holds damps a vibration of omega by omega^3 T_c / (2 omega_c^2) of the critical damping, the load being
// a sixth of the mass: at 10 Hz 2e-6, in 60 cycles of 6 s 1e-3 of its amplitude. Treads without damping show it.
TEST(Parts, LockedPartsArePayloads) {
  const FloorMotion floor = small::noise_record(7, 6, {2, 1.5, 0.5});
  const auto settings = blocks::run_for(6, 0.004, 0.1);
  const Demands whole =
      simulate(trolley_with(true, Kind::kFixed), floor, settings).items[0].demands;
  for (const Kind kind : {Kind::kFixed, Kind::kSlider, Kind::kHinge}) {
    const Response r = simulate(trolley_with(false, kind), floor, settings);
    const Demands& d = r.items[0].demands;
    EXPECT_NEAR(d.peak_displacement, whole.peak_displacement, 1e-4 * whole.peak_displacement);
    EXPECT_NEAR(d.peak_velocity, whole.peak_velocity, 1e-3 * whole.peak_velocity);
    EXPECT_NEAR(d.peak_tilt, whole.peak_tilt, 1e-3 * whole.peak_tilt);
    EXPECT_LT(r.quality.energy_closure, 1e-3);
  }
}

// The trolley of four casters with the rear two on a part that holds the load: fixed to the chassis it is the same
// trolley. The joint carries half of it, 2.5 times its part's mass m, and damps heave by the square of that over the
// whole, 6 times as much as above, 4e-4 of critical at 18 Hz: beside the 1 % of damped treads a twenty-fifth of a
// vibration's share of the peaks, which is up to 8 % of them.
TEST(Parts, CastersOfAFixedPartCarryTheItem) {
  const FloorMotion floor = small::noise_record(7, 6, {2, 1.5, 0.5});
  const auto settings = blocks::run_for(6, 0.004, 0.1);
  Scene one = trolley_with(true, Kind::kFixed), scene = trolley_with(false, Kind::kFixed);
  for (Scene* each : {&one, &scene})
    for (Caster& caster : each->items[0].model.casters) {
      caster.tread.normal_damping = 500;
      caster.tread.tangential_damping = 150;
    }
  const Response whole = simulate(one, floor, settings);
  std::vector<Caster>& front = scene.items[0].model.casters;
  std::vector<Caster>& rear = scene.items[1].model.casters;
  for (const Caster& caster : front)
    if (caster.mount.x() < 0) rear.push_back(caster);
  ASSERT_EQ(rear.size(), 2u);
  std::erase_if(front, [](const Caster& caster) { return caster.mount.x() < 0; });
  const Response r = simulate(scene, floor, settings);
  ASSERT_EQ(r.outcome, whole.outcome) << r.cause;
  const Demands &d = r.items[0].demands, &expected = whole.items[0].demands;
  constexpr double kShare = 3e-3;
  EXPECT_NEAR(d.peak_displacement, expected.peak_displacement, kShare * expected.peak_displacement);
  EXPECT_NEAR(d.peak_velocity, expected.peak_velocity, kShare * expected.peak_velocity);
  EXPECT_NEAR(d.peak_tilt, expected.peak_tilt, kShare * expected.peak_tilt);
  EXPECT_NEAR(std::max(d.peak_normal_force, r.items[1].demands.peak_normal_force),
              expected.peak_normal_force, kShare * expected.peak_normal_force);
  EXPECT_LT(r.quality.energy_closure, 1e-3);
}

// A trailer of mass m on a hinge across the trolley at x = -l, its axle a behind the hinge and its mass b: the axle
// carries m g b / a and half of its two forks and wheels' own weight each; the hinge, and so the trolley, the rest.
// It stands though its mass is above the hinge, from which it would fall without its wheels.
TEST(Parts, ATrailerStandsOnItsAxle) {
  Scene scene = trolley_with(false, Kind::kHinge);
  const double m = 20, a = 0.6, b = 0.4;
  const Vector3 hinge(-0.3, 0, 0.3);
  PlacedItem& trailer = scene.items[1];
  trailer.model.chassis_center_of_mass = {hinge.x() - b, 0, 0.9};
  trailer.model.shape[0].center = trailer.model.chassis_center_of_mass;
  scene.joints[0] = joint(Kind::kHinge, 0, 1, hinge, Vector3::UnitY());
  double wheels = 0;
  for (const double side : {-0.2, 0.2}) {
    Caster caster = scene.items[0].model.casters[0];
    caster.trail = 0;
    caster.fork_center_of_mass = Vector3::Zero();
    caster.swivels = false;
    caster.mount = {hinge.x() - a, side, caster.height};
    wheels += (caster.fork_mass + caster.wheel_mass) * kGravity;
    trailer.model.casters.push_back(caster);
  }
  const Response r = simulate(scene, {}, blocks::run_for(0.5, 0.004, 0.1));
  ASSERT_NE(r.outcome, Outcome::kDiverged) << r.cause;
  const auto load = [&](std::size_t item) {
    double sum = 0;
    for (std::size_t i = 0; i < scene.items[item].model.casters.size(); ++i)
      sum += r.items[item].history.front().wheels[i].normal_force;
    return sum;
  };
  // The treads' deflection of under a millimetre turns it by 1e-3 rad, which moves its mass, 0.6 m above the hinge,
  // by as much: 1e-3 of b.
  EXPECT_NEAR(load(1), m * kGravity * b / a + wheels, 3e-3 * m * kGravity);
  const double total = whole_item(scene.items[0].model).mass + whole_item(trailer.model).mass;
  EXPECT_NEAR(load(0) + load(1), total * kGravity, 1e-6 * total * kGravity);
  EXPECT_LT(r.items[1].demands.peak_swing, 2e-3);
}

TEST(Parts, StandStillUnderTheirWeight) {
  Scene scene = blocks::block(100, {1, 1, 1}, {});
  scene.items[0].name = "base";
  scene.items[0].model.material = scene.floor_material = "";
  scene.pairs.clear();
  scene.items.push_back(body("load", 20, {0.1, 0.05, 0.9}, 0.2));
  scene.joints = {joint(Kind::kSlider, 0, 1, {0.1, 0.05, 0.8}, Vector3::UnitX())};
  scene.joints[0].friction = 1;
  // An arm with a bag at its end, and a box on the load that slides.
  scene.items.push_back(body("arm", 2, {0.5, 0, 1.2}, 0.1));
  scene.items.push_back(body("bag", 1, {0.6, 0, 0.9}, 0.1));
  scene.items.push_back(body("box", 3, {0, 0, 0.1}, 0.2));
  for (PlacedItem& item : scene.items) item.model.material = "";
  scene.joints.push_back(joint(Kind::kHinge, 0, 2, {0, 0, 1.2}, Vector3::UnitZ()));
  scene.joints.back().friction = 1;
  scene.joints.push_back(joint(Kind::kBall, 2, 3, {0.6, 0, 1.2}, Vector3::UnitZ()));
  scene.items[4].on = Support{Support::Kind::kItem, 1, 1.0};
  scene.items[4].initial.position = {0.1, 0.05, 0};
  const Response r = simulate(scene, {}, blocks::run_for(2, 0.004, 0.02));
  ASSERT_EQ(r.outcome, Outcome::kStopped) << r.cause;
  // A joint yields by the weight over k, less than a micrometre. What stands on a part has settled as on a floor that
  // does not lean: the load leans by some 1e-6 rad, and so it settles again.
  for (const ItemResponse& item : r.items) {
    EXPECT_LT(item.demands.peak_displacement, 1e-6);
    EXPECT_LT(item.demands.peak_velocity, 1e-4);
  }
  EXPECT_LT(r.items[4].demands.peak_slide, 1e-6);
}

TEST(Parts, RefusesJointsThatCannotBe) {
  const auto refused = [](const std::function<void(Scene&)>& spoil) -> std::string {
    Scene scene = drawer();
    spoil(scene);
    try {
      simulate(scene, {}, blocks::run_for(0.1, 0.004, 0.1));
    } catch (const Error& error) {
      return error.what();
    }
    return "";
  };
  using testing::HasSubstr;
  EXPECT_EQ(refused([](Scene&) {}), "");
  EXPECT_THAT(refused([](Scene& s) { s.joints[0].base = 1; }), HasSubstr("joint.part"));
  EXPECT_THAT(refused([](Scene& s) { s.joints[0].axis *= 2; }), HasSubstr("joint.axis = 2"));
  EXPECT_THAT(refused([](Scene& s) { s.joints[0].lower = 0.1; }),
              HasSubstr("joint.lower = 0.1: must be <= 0"));
  EXPECT_THAT(refused([](Scene& s) { s.joints[0].friction = -1; }),
              HasSubstr("joint.friction = -1"));
  EXPECT_THAT(refused([](Scene& s) {
                s.joints[0].kind = Kind::kBall;
                s.joints[0].upper = 1;
              }),
              HasSubstr("a hinge or a slider"));
  EXPECT_THAT(refused([](Scene& s) { s.joints.push_back(s.joints[0]); }),
              HasSubstr("one joint only"));
  EXPECT_THAT(refused([](Scene& s) { s.items[1].initial.yaw = 1; }), HasSubstr("as its base is"));
}

}  // namespace
}  // namespace gurney
