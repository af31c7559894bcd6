#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "engine/run/simulate.h"
#include "studies/verification/scenes/blocks.h"
#include "studies/verification/scenes/small_scenes.h"

// A half-locked bed with a patient on a mattress against an independent integration.
namespace gurney {
namespace {

constexpr double kGravity = 9.80665, kHalfBase = 0.4, kTangential = 1e6, kFriction = 0.4;
constexpr double kPart = 40, kAhead = 0.1, kFrequency = 2.4, kDamping = 0.2;
constexpr double kDuration = 4, kPeak = 5, kRate = 2 * std::numbers::pi * 1.2;

/// All masses at the height of the floor, where friction acts: no load moves from axle to axle but by the
/// way of the part.
Scene bed() {
  Tread tread = small::bare_tread(3e5, kTangential);
  tread.static_friction = tread.kinetic_friction = kFriction;
  Scene scene = scene_of(small::trolley({0, 0, 0, 0}, tread));
  scene.items[0].name = "bed";
  scene.items[0].model.chassis_center_of_mass = Vector3::Zero();
  for (Caster& caster : scene.items[0].model.casters) {
    caster.swivels = false;
    caster.trail = 0;
    caster.fork_center_of_mass = {0, 0, -0.08};
    caster.axle = {};
    if (caster.mount.x() > 0) caster.brake_torque = std::numeric_limits<double>::infinity();
  }
  PlacedItem& patient = scene.items.emplace_back();
  patient.name = "patient";
  patient.model.chassis_mass = kPart;
  patient.model.chassis_center_of_mass = {kAhead, 0, 0};
  patient.model.chassis_inertia = solid_box_inertia(kPart, {1, 0.4, 0.2});
  patient.model.shape = {{{kAhead, 0, 0.8}, {1, 0.4, 0.2}}};
  Joint mattress;
  mattress.kind = Joint::Kind::kSlider;
  mattress.name = "mattress";
  mattress.part = 1;
  mattress.point = {kAhead, 0, 0};
  mattress.axis = Vector3::UnitX();
  const double rate = 2 * std::numbers::pi * kFrequency;
  mattress.stiffness = kPart * rate * rate;
  mattress.damping = 2 * kDamping * kPart * rate;
  scene.joints = {mattress};
  return scene;
}

double floor_at(double t) {
  return kPeak * std::sin(kRate * t) * std::pow(std::sin(std::numbers::pi * t / kDuration), 2);
}

FloorMotion floor_motion() {
  const auto count = static_cast<Eigen::Index>(std::lround(kDuration / 0.001)) + 1;
  Eigen::Matrix3Xd a = Eigen::Matrix3Xd::Zero(3, count);
  for (Eigen::Index i = 0; i < count; ++i) a(0, i) = floor_at(0.001 * static_cast<double>(i));
  return {0.001, a};
}

struct Path {
  std::vector<double> bed, patient;  ///< displacement of the bed, travel of the patient [m]
};

/// x of the bed, q of the patient on it and the deflection s of the locked treads, at steps of 5 us:
///   M x'' + m (x'' + q'' + a) = -k_t s - M a,   m (x'' + q'' + a) = -k q - c q',
///   s' = x' where |k_t s| < mu N_f,   N_f = g (M / 2 + m (1 / 2 + (d + q) / L))
/// with the spin of the free wheels in the mass that x'' feels.
Path integrated(const Scene& scene, double every) {
  constexpr double kStep = 5e-6;
  const EquipmentModel& model = scene.items[0].model;
  const double M = whole_item(model).mass, m = kPart;
  double spinning = 0, locked = 0;
  for (const Caster& caster : model.casters) {
    if (caster.brake_torque > 0)
      locked += kTangential * 10 / 11;  // the brake is a spring of ten times the tread
    else
      spinning += caster.wheel_axial_inertia / std::pow(caster.wheel_radius, 2);
  }
  const double k = scene.joints[0].stiffness, c = scene.joints[0].damping;
  double x = 0, v = 0, q = 0, u = 0, s = 0;
  Path path;
  const long stride = std::lround(every / kStep), count = std::lround(kDuration / kStep);
  for (long i = 0; i <= count; ++i) {
    if (i % stride == 0) {
      path.bed.push_back(x);
      path.patient.push_back(q);
    }
    const double a = floor_at(kStep * static_cast<double>(i)), mattress = -k * q - c * u;
    const double limit =
        kFriction * kGravity * (M / 2 + m * (0.5 + (kAhead + q) / (2 * kHalfBase)));
    const double x2 = (-locked * s - M * a - mattress) / (M + spinning);
    v += kStep * x2;
    u += kStep * (mattress / m - x2 - a);
    x += kStep * v;
    q += kStep * u;
    s = std::clamp(s + kStep * v, -limit / locked, limit / locked);
  }
  return path;
}

// The bed slides by some centimetres on its locked axle while the mattress swings. Casters of 0.5 kg are 0.08 m high:
// at 5 m/s2 their 1 N m moves 1 N, 2e-3 of the load of an axle, and their share of slip with it. At 1 ms slip that
// reverses is located; the elastic treads are soft for the step.
TEST(HalfLockedBed, SlidesUnderAPatientOnAMattress) {
  const Scene scene = bed();
  const double every = 0.02;
  const Response r = simulate(scene, floor_motion(), blocks::run_for(kDuration, 0.001, every));
  ASSERT_EQ(r.outcome, Outcome::kStopped) << r.cause;
  const Path path = integrated(scene, every);
  double bed = 0, patient = 0, farthest = 0, swing = 0;
  const auto& of_bed = r.items[0].history;
  const auto& of_patient = r.items[1].history;
  for (std::size_t i = 0; i < std::min(path.bed.size(), of_bed.size()); ++i) {
    const double x = of_bed[i].displacement.x();
    bed = std::max(bed, std::abs(x - path.bed[i]));
    patient = std::max(patient, std::abs(of_patient[i].displacement.x() - x - path.patient[i]));
    farthest = std::max(farthest, std::abs(path.bed[i]));
    swing = std::max(swing, std::abs(path.patient[i]));
  }
  EXPECT_GT(farthest, 0.03) << "it slides";
  EXPECT_GT(swing, 0.01) << "and the mattress swings";
  EXPECT_LT(bed, 0.01 * farthest);
  EXPECT_LT(patient, 0.01 * swing);
  EXPECT_LT(r.quality.energy_closure, 1e-3);
}

}  // namespace
}  // namespace gurney
