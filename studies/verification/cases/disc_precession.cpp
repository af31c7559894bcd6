#include <algorithm>
#include <cmath>
#include <string>

#include "studies/verification/cases.h"
#include "studies/verification/gravity.h"
#include "studies/verification/scenes/rolling_disc.h"

namespace gurney::verification {
namespace {

constexpr double kLed = 0.4, kSample = 1e-3, kStep = 1.25e-4;  // [s]

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
    for (int i = 0; i < std::lround(kLed / kSample); ++i) {
      reference.advance_led(kSample, height_rate2);
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

Response roll(const Precession& c, const Lead& lead, double step, double tread,
              const Runner& runner, Findings& findings) {
  Scene scene = rolling_disc(c.disc(), c.speed, c.yaw_rate, tread);
  scene.items[0].loads = {lead.x, lead.y};
  return runner(findings, scene, {},
                disc_settings(step, kLed + 1, static_cast<int>(std::lround(0.01 / step))));
}

/// Of the axle's height once it is left alone.
double largest(const Response& a, const Response& b) {
  double most = 0;
  const auto &first = a.items[0].history, &second = b.items[0].history;
  for (std::size_t i = 0; i < std::min(first.size(), second.size()); ++i)
    if (first[i].time > kLed - 1e-6)
      most = std::max(most, std::abs(disc_axle(first[i]).z() - disc_axle(second[i]).z()));
  return most;
}

Findings precess(const Precession& c, const Runner& runner) {
  Findings findings;
  const double steady = steady_height(c);
  const Lead lead(c, steady);
  findings.checks.push_back({"height of the axle 1 s later, of the equation integrated", "",
                             lead.height, steady, 1e-6, "it is steady"});
  const auto rolled = [&](double step, double tread) {
    return roll(c, lead, step, tread, runner, findings);
  };
  const Response fine = rolled(kStep, kDiscTread);
  const double nutation = largest(rolled(2 * kStep, kDiscTread), fine) / 2 +
                          2 * largest(rolled(kStep, kDiscTread / 2), fine);
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
  for (const Track* track : {&height, &moment, &middle}) track->report(findings);
  return findings;
}

/// It is steady at a lean of 12 to 30 degrees.
bool is_steady(const Precession& c) {
  if (std::abs(c.yaw_rate) < 1) return false;
  const double steady = steady_height(c);
  return std::abs(steady) > 0.2 && std::abs(steady) < 0.5 &&
         std::abs(Lead(c, steady).height - steady) < 1e-6;
}

}  // namespace

Family disc_precession() {
  return make_family<Precession>(
      {"disc_precession", "rolling disc", "A leaning disc that is left alone rolls on in a circle",
       "(C + m r^2) w3 Om sin th - A Om^2 sin th cos th + m g r cos th = 0",
       "Routh 1905, Advanced Rigid Dynamics"},
      {{{"mass", "kg", 0.5, 10}, &Precession::mass},
       {{"radius", "m", 0.05, 0.3}, &Precession::radius},
       {{"axial", "C over m r^2", 0.45, 1}, &Precession::axial},
       {{"speed", "m/s", 0.5, 2.5}, &Precession::speed},
       {{"yaw_rate", "rad/s", -10, 10}, &Precession::yaw_rate}},
      {{"disc_left", {1, 0.05, 0.5, 0.6, -4}},
       {"disc_right", {1, 0.05, 0.5, 0.8, 10}},
       {"hoop_fast", {1, 0.05, 1, 0.8, 10}},
       {"hoop", {1, 0.05, 1, 0.6, 5}},
       {"wheel_right", {8, 0.3, 0.7, 2, 4}},
       {"wheel_left", {8, 0.3, 0.7, 2, -3}}},
      precess, is_steady);
}

}  // namespace gurney::verification
