#include "studies/verification/scenes/rolling_disc.h"

#include <Eigen/LU>
#include <cmath>

#include "engine/base/units.h"
#include "studies/verification/scenes/small_scenes.h"

namespace gurney {
namespace {

double gyration(const Disc& disc) { return 0.1 * disc.radius; }  // of the chassis [m]

Vector3 level(const Vector3& axle) { return Vector3(axle.x(), axle.y(), 0).normalized(); }

}  // namespace

double Disc::A() const { return 0.5 * C() + crumb * mass * std::pow(gyration(*this), 2); }

double Disc::critical_speed() const {
  const double mr2 = m() * radius * radius;
  return std::sqrt(kStandardGravity * radius * mr2 * A() / (C() * (C() + mr2)));
}

double Disc::stiffness(double v) const {
  const double mr2 = m() * radius * radius, n = v / radius;
  return (C() * (C() + mr2) * n * n / A() - m() * kStandardGravity * radius) / (A() + mr2);
}

DiscReference::State DiscReference::sum(const State& y, double h, const State& k) {
  return {y[0] + h * k[0], y[1] + h * k[1], y[2] + h * k[2]};
}

DiscReference::State DiscReference::rates(const State& y, double push) const {
  const Vector3 &a = y[0], &w = y[1];
  const Vector3 da = w.cross(a), upright = Vector3::UnitZ() - a.z() * a;
  const Vector3 u = upright.normalized();
  const Vector3 change = -da.z() * a - a.z() * da;
  const Vector3 du = (change - u.dot(change) * u) / upright.norm();
  const double difference = disc_.C() - disc_.A(), r = disc_.radius, m = disc_.m();
  const Matrix3 inertia = disc_.A() * Matrix3::Identity() + difference * a * a.transpose() +
                          m * r * r * (Matrix3::Identity() - u * u.transpose());
  const Vector3 force =
      m * (r * w.cross(du) + kStandardGravity * Vector3::UnitZ()) - push * level(a);
  const Vector3 rest = -r * u.cross(force) - difference * (w.dot(da) * a + w.dot(a) * da);
  return {da, inertia.inverse() * rest, r * w.cross(u)};
}

double DiscReference::push_for(const State& y, double height_rate2) const {
  // a'' = w' x a + w x a', and w' is linear in the push.
  const auto height = [&](double push) {
    const State k = rates(y, push);
    return (k[1].cross(y[0]) + y[1].cross(k[0])).z();
  };
  const double without = height(0);
  return (height_rate2 - without) / (height(1) - without);
}

template <class Push>
void DiscReference::integrate(double duration, Push push) {
  const auto steps = static_cast<int>(std::ceil(duration / 5e-4));
  const double h = duration / steps;
  for (int i = 0; i < steps; ++i) {
    const auto rate = [&](double t, const State& y) { return rates(y, push(t, y)); };
    const State k1 = rate(time_, state_), k2 = rate(time_ + h / 2, sum(state_, h / 2, k1));
    const State k3 = rate(time_ + h / 2, sum(state_, h / 2, k2));
    const State k4 = rate(time_ + h, sum(state_, h, k3));
    for (std::size_t j = 0; j < 3; ++j)
      state_[j] += h / 6 * (k1[j] + 2 * k2[j] + 2 * k3[j] + k4[j]);
    state_[0].normalize();
    time_ += h;
  }
}

void DiscReference::advance(double duration) {
  integrate(duration, [](double, const State&) { return 0.0; });
}

void DiscReference::advance_led(double duration,
                                const std::function<double(double time)>& height_rate2) {
  integrate(duration, [&](double t, const State& y) { return push_for(y, height_rate2(t)); });
}

Scene rolling_disc(const Disc& d, double speed, double yaw_rate, double stiffness) {
  Scene scene = scene_of({});
  EquipmentModel& item = scene.items[0].model;
  item.name = "disc";
  item.chassis_mass = d.crumb * d.mass;
  item.chassis_center_of_mass = {0, 0, d.radius};
  item.chassis_inertia = item.chassis_mass * std::pow(gyration(d), 2) * Matrix3::Identity();
  item.shape = {{{0, 0, d.radius}, 0.01 * d.radius * Vector3::Ones()}};
  item.marked_points = {{"centre", {0, 0, d.radius}}};
  Tread tread = small::bare_tread(stiffness, stiffness);
  tread.relaxation_length = 1e9;
  tread.static_friction = tread.kinetic_friction = 5;
  Caster wheel = small::caster({0, 0, 1.001 * d.radius}, 0, tread, 0);
  wheel.swivels = false;
  wheel.wheel_radius = d.radius;
  wheel.wheel_width = 1e-7 * d.radius;
  wheel.wheel_mass = d.mass;
  wheel.wheel_axial_inertia = d.C();
  wheel.wheel_transverse_inertia = 0.5 * d.C();
  wheel.fork_mass = d.crumb * d.mass;
  wheel.fork_center_of_mass = {0, 0, -0.001 * d.radius};
  wheel.fork_inertia.setZero();
  item.casters = {wheel};
  scene.items[0].initial.velocity = {speed, 0, 0};
  scene.items[0].initial.yaw_rate = yaw_rate;
  return scene;
}

SimulationSettings disc_settings(double step, double duration, int stride) {
  SimulationSettings settings = small::settings_for(step, duration, stride);
  settings.residual = 1e-12;
  return settings;
}

}  // namespace gurney
