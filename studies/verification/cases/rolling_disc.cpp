#include "studies/verification/scenes/rolling_disc.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "engine/base/units.h"
#include "studies/verification/family.h"

// A disc that rolls on its edge without slip, in 3D: scenes/rolling_disc.h has its equations, and
// how the engine carries it.
namespace gurney::verification {
namespace {

constexpr double kStepAngle = 0.01;  // that the disc turns by in a step, h n [rad]

// --- straight

struct Straight {
  double mass, radius, axial, ratio;  // [kg], [m], C / (m r^2), speed over the critical one
  Disc disc() const { return {mass, radius, axial}; }
};

void roll_straight(const Straight& c, Runner& runner) {
  // The lean x of a disc that rolls upright at n = v / r and is given a breath of yaw rate:
  //   x = X (1 - cos(sqrt(L) t)),   X = (C + m r^2) n yaw_rate / ((A + m r^2) L);
  //   L < 0: cosh(sqrt(-L) t). It leans by 1e-4 at most: the rest of the sine is 1e-9 of it.
  constexpr double kPhase = 7, kLean = 1e-4;  // a cycle, or a growth by e^7
  const Disc disc = c.disc();
  const double v = c.ratio * disc.critical_speed(), n = v / disc.radius;
  const double stiffness = disc.stiffness(v), lambda = std::sqrt(std::abs(stiffness));
  const double amplitude = stiffness > 0 ? kLean / 2 : -kLean / std::cosh(kPhase);
  const double mr2 = disc.m() * disc.radius * disc.radius;
  const double yaw_rate = amplitude * (disc.A() + mr2) * stiffness / ((disc.C() + mr2) * n);
  const double step = kStepAngle / std::max(n, lambda);
  const int count = static_cast<int>(kPhase / lambda / step);
  const Response response =
      runner(rolling_disc(disc, v, yaw_rate), {}, disc_settings(step, count * step, 1));
  Track lean("lean", "rad",
             "(h n)^2 = 1e-4 of the largest lean for each radian of lambda t, 7: a method of "
             "second order whose rates miss by less");
  for (const Sample& sample : response.items[0].history) {
    const double phase = lambda * sample.time;
    lean.add(sample.time, disc_axle(sample).z(),
             amplitude * (1 - (stiffness > 0 ? std::cos(phase) : std::cosh(phase))),
             kPhase * kStepAngle * kStepAngle * kLean);
  }
  runner.report(lean);
  runner.check("stable", "", stiffness > 0 ? 1. : 0.,
               exactly(c.ratio > 1 ? 1. : 0., "above the critical speed, not below"));
}

bool off_critical(const Straight& c) { return std::abs(c.ratio - 1) > 0.015; }

// --- upright, with a weight at its axle

struct Weighted {
  double mass, radius, axial;                  // [kg], [m], C / (m r^2)
  double force = 0.3, lever = 0.4, ratio = 2;  // over m g, r, critical speed
  Disc disc() const { return {mass, radius, axial}; }
};

void carry_weight(const Weighted& c, Runner& runner) {
  const Disc disc = c.disc();
  const double force = c.force * disc.m() * kG, lever = c.lever * disc.radius;
  const double v = c.ratio * disc.critical_speed();
  const double rate = force * lever / (v * (disc.C() / disc.radius + disc.m() * disc.radius));
  const double turn = 2 * std::numbers::pi / rate, step = kStepAngle * disc.radius / v;
  Scene scene = rolling_disc(disc, v, rate);
  scene.items[0].loads = {
      PointForce{"weight", {0, lever, disc.radius}, -Vector3::UnitZ(), {0, turn}, {force, force}}};
  const Response response = runner(scene, {}, disc_settings(step, turn, 20));
  const double sink = (disc.m() * kG + force) / (kDiscTread * disc.radius);
  const double radius = v / rate;
  Track off("distance from the circle", "m",
            "2.2 pi (h n)^2 of its radius: a second-order method misses less than (h n)^2 of the "
            "angle, 2 pi");
  Track lean("lean", "rad", "twice what the tread sinks in, (m g + F) / k, over r");
  for (const Sample& sample : response.items[0].history) {
    const double angle = rate * sample.time;
    const Vector3 circle = radius * Vector3(std::sin(angle), 1 - std::cos(angle), 0);
    off.add(sample.time, (sample.points[0].displacement - circle).norm(), 0,
            2.2 * std::numbers::pi * kStepAngle * kStepAngle * radius);
    lean.add(sample.time, disc_axle(sample).z(), 0, 2 * sink);
  }
  runner.report(off, lean);
}

bool stays_upright(const Weighted& c) { return c.force * c.lever > 0.02; }

// --- turning

struct Turning {
  double mass, radius, axial, speed, yaw_rate;  // [kg], [m], C / (m r^2), [m/s], [rad/s]
  Disc disc() const { return {mass, radius, axial}; }
  DiscReference reference() const {
    return {disc(), Vector3::UnitY(), {0, speed / radius, yaw_rate}};
  }
};

/// Each 0.01 s: the axle's direction and the path of the centre over r.
struct Path {
  std::vector<Vector3> axle, center;
  double closure = 0;  ///< of the energy balance
};

Path run(const Turning& c, double step, double tread, Runner& runner) {
  const int stride = static_cast<int>(std::lround(0.01 / step));
  const Response response = runner(rolling_disc(c.disc(), c.speed, c.yaw_rate, tread), {},
                                   disc_settings(step, 1, stride));
  Path path;
  path.closure = response.quality.energy_closure;
  for (const Sample& sample : response.items[0].history) {
    path.axle.push_back(disc_axle(sample));
    path.center.push_back(sample.points[0].displacement / c.radius);
  }
  return path;
}

Path integrated(const Turning& c, std::size_t samples) {
  DiscReference reference = c.reference();
  Path path;
  for (std::size_t i = 0; i < samples; ++i) {
    if (i > 0) reference.advance(0.01);
    path.axle.push_back(reference.axle());
    path.center.push_back(reference.moved() / c.radius);
  }
  return path;
}

double largest(const std::vector<Vector3>& a, const std::vector<Vector3>& b) {
  double most = 0;
  for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i)
    most = std::max(most, (a[i] - b[i]).norm());
  return most;
}

void turn(const Turning& c, Runner& runner) {
  constexpr double kStep = 5e-4;
  const Path coarse = run(c, 2 * kStep, kDiscTread, runner),
             fine = run(c, kStep, kDiscTread, runner), soft = run(c, kStep, kDiscTread / 2, runner),
             exact = integrated(c, fine.axle.size());
  const auto check = [&](const char* quantity, const char* unit, std::vector<Vector3> Path::*of) {
    runner.check(quantity, unit, largest(fine.*of, exact.*of),
                 near_to(0, largest(coarse.*of, fine.*of) / 2 + 2 * largest(soft.*of, fine.*of),
                         kDiscTolerance));
  };
  check("axle's direction", "rad", &Path::axle);
  check("path of the centre, over r", "", &Path::center);
  runner.check(
      "energy balance error", "", fine.closure,
      near_to(
          0, coarse.closure / 3 + 1e-9,
          "a third of that with the double step, for a method of second order; rounding, 1e-9"));
}

/// It leans by 9 to 57 degrees (from 60 on a wheel lies on its side), and turns by at most 1/20 in
/// a step of 1 ms.
bool leans(const Turning& c) {
  DiscReference reference = c.reference();
  double lean = 0, rate = 0;
  for (int i = 0; i < 100; ++i) {
    reference.advance(0.01);
    lean = std::max(lean, std::abs(std::asin(reference.axle().z())));
    rate = std::max(rate, reference.angular_velocity().norm());
    if (!(lean < 57 * kRadiansPerDegree)) return false;
  }
  return lean > 9 * kRadiansPerDegree && rate < 50;
}

template <class Set, class... Others>
std::vector<Field<Set>> disc_fields(Others... others) {
  return fields(FIELD(Set, mass, "kg", 0.5, 10), FIELD(Set, radius, "m", 0.05, 0.3),
                FIELD(Set, axial, "C over m r^2", 0.45, 1), others...);
}

// --- precession

constexpr double kLed = 0.4, kLeadSample = 1e-3, kRollStep = 1.25e-4;  // [s]

struct Precession {
  double mass, radius, axial, speed, yaw_rate;  // [kg], [m], C / (m r^2), [m/s], [rad/s]
  Disc disc() const { return {mass, radius, axial}; }
};

/// A disc that starts upright is led to a_z = `height` in kLed, by a polynomial of fifth order.
struct Lead {
  PointForce x, y;    ///< from the start on
  double push = 0;    ///< that is left to hold it there [N]
  double height = 0;  ///< 1 s later, left alone

  Lead(const Precession& c, double to) {
    const Disc disc = c.disc();
    DiscReference reference(disc, Vector3::UnitY(), {0, c.speed / disc.radius, c.yaw_rate});
    const auto height_rate2 = [&](double t) {
      const double s = t / kLed;
      return to / (kLed * kLed) * (60 * s - 180 * s * s + 120 * s * s * s);
    };
    x = {"x", {0, 0, disc.radius}, Vector3::UnitX(), {}, {}};
    y = {"y", {0, 0, disc.radius}, Vector3::UnitY(), {}, {}};
    const auto note = [&] {
      const Vector3& axle = reference.axle();
      const Vector2 along =
          reference.push_for(height_rate2(reference.time())) * axle.head<2>().normalized();
      for (auto* force : {&x, &y}) force->time.push_back(reference.time());
      x.force.push_back(along.x());
      y.force.push_back(along.y());
      push = along.dot(axle.head<2>());
    };
    note();
    for (int i = 0; i < std::lround(kLed / kLeadSample); ++i) {
      reference.advance_led(kLeadSample, height_rate2);
      note();
    }
    reference.advance(1);
    height = reference.axle().z();
  }
};

/// a_z of the steady precession: upright it takes a push against the yaw rate; where no push is
/// left it is steady.
double steady_height(const Precession& c) {
  const double upright = Lead(c, 0).push;
  double steady = 0, beyond = std::copysign(0.9, c.yaw_rate);
  for (int i = 0; i < 24; ++i) {
    const double height = 0.5 * (steady + beyond);
    (Lead(c, height).push * upright > 0 ? steady : beyond) = height;
  }
  return steady;
}

Response roll(const Precession& c, const Lead& lead, double step, double tread, Runner& runner) {
  Scene scene = rolling_disc(c.disc(), c.speed, c.yaw_rate, tread);
  scene.items[0].loads = {lead.x, lead.y};
  return runner(scene, {},
                disc_settings(step, kLed + 1, static_cast<int>(std::lround(0.01 / step))));
}

/// Largest difference of the axle's heights once it is left alone.
double largest(const Response& a, const Response& b) {
  double most = 0;
  const auto &first = a.items[0].history, &second = b.items[0].history;
  for (std::size_t i = 0; i < std::min(first.size(), second.size()); ++i)
    if (first[i].time > kLed - 1e-6)
      most = std::max(most, std::abs(disc_axle(first[i]).z() - disc_axle(second[i]).z()));
  return most;
}

void precess(const Precession& c, Runner& runner) {
  const double steady = steady_height(c);
  const Lead lead(c, steady);
  runner.check("height of the axle 1 s later, of the equation integrated", "", lead.height,
               near_to(steady, 1e-6, "it is steady"));
  const auto rolled = [&](double step, double tread) { return roll(c, lead, step, tread, runner); };
  const Response fine = rolled(kRollStep, kDiscTread);
  const double nutation = largest(rolled(2 * kRollStep, kDiscTread), fine) / 2 +
                          2 * largest(rolled(kRollStep, kDiscTread / 2), fine);
  const Disc disc = c.disc();
  const double C = disc.C(), A = disc.A(), r = disc.radius, mgr = disc.m() * kG * r;
  const double mr2 = disc.m() * r * r;
  Track height("height of the axle", "", std::string("a nutation of ") + kDiscTolerance);
  Track moment("moment that is left", "N m",
               "a nutation of the height's tolerance changes the yaw rate by C w3 / A = 2 w3 times "
               "its size: that share of m g r cos(theta)");
  Track middle("path of the circle's middle", "m",
               "that share of its radius, at both ends of the path");
  const auto& history = fine.items[0].history;
  Vector2 first = Vector2::Zero();
  bool begun = false;
  for (std::size_t i = 1; i < history.size(); ++i) {
    if (history[i - 1].time < kLed - 1e-6) continue;
    const Vector3 before = disc_axle(history[i - 1]), a = disc_axle(history[i]);
    const double turn =
        std::atan2(before.x() * a.y() - before.y() * a.x(), before.head<2>().dot(a.head<2>()));
    const double rate = turn / (history[i].time - history[i - 1].time);
    const double spin = history[i].wheels[0].wheel_rate;
    const double cosine = a.z(), sine = std::sqrt(1 - cosine * cosine);
    const double left =
        (C + mr2) * spin * rate * sine - A * rate * rate * sine * cosine + mgr * cosine;
    const double yaw = 2 * std::abs(spin / rate) * nutation;
    const double t = history[i].time, radius = spin * r / rate;
    const Vector2 now =
        history[i].points[0].displacement.head<2>() + radius * a.head<2>().normalized();
    if (!begun) first = now;
    begun = true;
    height.add(t, cosine, steady, nutation);
    moment.add(t, left, 0, yaw * mgr * std::abs(cosine));
    middle.add(t, (now - first).norm(), 0, 2 * yaw * std::abs(radius));
  }
  runner.report(height, moment, middle);
}

/// It is steady at a lean of 12 to 30 degrees.
bool is_steady(const Precession& c) {
  if (std::abs(c.yaw_rate) < 1) return false;
  const double steady = steady_height(c);
  return std::abs(steady) > 0.2 && std::abs(steady) < 0.5 &&
         std::abs(Lead(c, steady).height - steady) < 1e-6;
}

}  // namespace

Family disc_straight() {
  return make_family<Straight>(
      {"disc_straight", "rolling disc", "A disc that rolls straight wobbles or falls over",
       "x = X (1 - cos(sqrt(L) t)), L = [C (C + m r^2) n^2 / A - m g r] / (A + m r^2)",
       "Routh 1905, Advanced Rigid Dynamics; O'Reilly 1996, Nonlinear Dynamics 10"},
      disc_fields<Straight>(FIELD(Straight, ratio, "v over v_crit", 0.5, 2)),
      cases(at("disc_12", 1, 0.05, 0.5, 1.2), at("disc_15", 1, 0.05, 0.5, 1.5),
            at("disc_20", 1, 0.05, 0.5, 2), at("disc_08", 1, 0.05, 0.5, 0.8),
            at("disc_above", 1, 0.05, 0.5, 1.02), at("disc_below", 1, 0.05, 0.5, 0.98),
            at("hoop_12", 1, 0.05, 1, 1.2), at("hoop_15", 1, 0.05, 1, 1.5),
            at("hoop_20", 1, 0.05, 1, 2), at("hoop_08", 1, 0.05, 1, 0.8),
            at("hoop_above", 1, 0.05, 1, 1.02), at("hoop_below", 1, 0.05, 1, 0.98),
            at("wheel_above", 8, 0.3, 0.7, 1.3), at("wheel_below", 8, 0.3, 0.7, 0.6)),
      roll_straight, off_critical);
}

Family disc_weight() {
  return make_family<Weighted>(
      {"disc_weight", "rolling disc",
       "A weight at the axle of an upright disc turns it on a circle",
       "F d = Om (C n + m v r), n = v / r", "moment of momentum"},
      disc_fields<Weighted>(FIELD(Weighted, force, "m g", 0.1, 0.6),
                            FIELD(Weighted, lever, "r", 0.1, 0.6),
                            FIELD(Weighted, ratio, "v over v_crit", 1.5, 3)),
      cases(at("disc", 1, 0.05, 0.5), at("hoop", 2, 0.1, 1), at("wheel", 8, 0.3, 0.7)),
      carry_weight, stays_upright);
}

Family disc_turning() {
  return make_family<Turning>(
      {"disc_turning", "rolling disc", "A disc with a yaw rate leans out, turns and rises again",
       "d/dt [A w + (C - A) (w . a) a] = -r u x m (dv/dt + g z)",
       "Routh 1905, Advanced Rigid Dynamics; O'Reilly 1996, Nonlinear Dynamics 10"},
      disc_fields<Turning>(FIELD(Turning, speed, "m/s", 0.3, 2),
                           FIELD(Turning, yaw_rate, "rad/s", -5, 5)),
      cases(at("disc_slow_turn", 1, 0.05, 0.5, 0.8, 2), at("disc", 1, 0.05, 0.5, 0.8, 5),
            at("disc_slow", 1, 0.05, 0.5, 0.5, 2), at("hoop", 1, 0.05, 1, 0.6, 2),
            at("wheel", 8, 0.3, 0.7, 1.5, 2), at("wheel_fast_turn", 8, 0.3, 0.7, 1.5, 3),
            at("wheel_slow", 8, 0.3, 0.7, 1.3, 2.5)),
      turn, leans);
}

Family disc_precession() {
  return make_family<Precession>(
      {"disc_precession", "rolling disc", "A leaning disc that is left alone rolls on in a circle",
       "(C + m r^2) w3 Om sin th - A Om^2 sin th cos th + m g r cos th = 0",
       "Routh 1905, Advanced Rigid Dynamics"},
      fields(FIELD(Precession, mass, "kg", 0.5, 10), FIELD(Precession, radius, "m", 0.05, 0.3),
             FIELD(Precession, axial, "C over m r^2", 0.45, 1),
             FIELD(Precession, speed, "m/s", 0.5, 2.5),
             FIELD(Precession, yaw_rate, "rad/s", -10, 10)),
      cases(at("disc_left", 1, 0.05, 0.5, 0.6, -4), at("disc_right", 1, 0.05, 0.5, 0.8, 10),
            at("hoop_fast", 1, 0.05, 1, 0.8, 10), at("hoop", 1, 0.05, 1, 0.6, 5),
            at("wheel_right", 8, 0.3, 0.7, 2, 4), at("wheel_left", 8, 0.3, 0.7, 2, -3)),
      precess, is_steady);
}

}  // namespace gurney::verification
