#include "tests/support/synthetic_ward.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace gurney {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kFall = 4.5;  // [s]
constexpr std::size_t kPump = 3;

struct Furniture {
  const char* name;
  Vector3 size, position, travel;
  double turn;
  bool casters;
};

const Furniture kFurniture[] = {
    {"bed 1", {2.1, 0.95, 0.9}, {-1.7, 1.55, 0}, {0.12, 0.2, 0}, 0.1, true},
    {"bed 2", {2.1, 0.95, 0.9}, {-1.7, -0.2, 0}, {-0.1, 0.15, 0}, -0.1, true},
    {"ventilator", {0.5, 0.45, 1.3}, {0.1, 1.7, 0}, {0.35, -0.3, 0}, 0.8, true},
    {"infusion pump", {0.4, 0.4, 1.8}, {1.2, -1.5, 0}, {0.05, -0.1, 0}, 0.2, true},
    {"monitor", {0.45, 0.45, 1.4}, {0.9, 1.2, 0}, {-0.1, 0.15, 0}, -0.5, true},
    {"anaesthesia workstation", {0.8, 0.7, 1.4}, {1.8, 1.5, 0}, {0.2, 0.1, 0}, 0.3, true},
    {"crash cart", {0.75, 0.5, 1.0}, {2.3, 0.3, 0}, {0.2, -0.35, 0}, -0.4, true},
    {"ultrasound", {0.7, 0.5, 1.4}, {0.2, 0.0, 0}, {0.45, 0.1, 0}, 1.2, true},
    {"mobile X-ray", {1.2, 0.6, 1.5}, {-0.9, -1.6, 0}, {0.3, 0.1, 0}, 0.15, true},
    {"bookcase", {0.9, 0.3, 1.8}, {-2.4, -2.2, 0}, {0, 0, 0}, 0, false},
};

EquipmentModel model_of(const Furniture& f) {
  EquipmentModel model;
  model.name = f.name;
  model.chassis_mass = 80;
  const double bottom = f.casters ? 0.13 : 0;
  model.shape = {
      {{0, 0, (f.size.z() + bottom) / 2}, {f.size.x(), f.size.y(), f.size.z() - bottom}}};
  model.marked_points = {{"top", {0, 0, f.size.z()}}};
  const char* const names[] = {"front left", "front right", "rear left", "rear right"};
  for (int i = 0; f.casters && i < 4; ++i) {
    Caster caster;
    caster.name = names[i];
    caster.mount = {(i < 2 ? 0.4 : -0.4) * f.size.x(), (i % 2 == 0 ? 0.4 : -0.4) * f.size.y(),
                    0.13};
    model.casters.push_back(caster);
  }
  return model;
}

RoomShape box(const char* name, const Vector3& center, const Vector3& size) {
  return {name, "", center, Quaternion::Identity(), RoomBox{size}};
}

Sample sample_of(const Furniture& f, bool falls, double t) {
  Sample s;
  const double way = 1 - std::exp(-t / 3), sway = way * std::exp(-t / 4);
  s.time = t;
  s.displacement =
      way * f.travel + sway * Vector3(0.15 * std::sin(5 * t), 0.1 * std::sin(4 * t), 0);
  s.yaw = way * f.turn;
  if (!f.casters) s.displacement.setZero();
  const double fallen = falls ? std::clamp((t - kFall + 0.5) / 0.7, 0.0, 1.0) : 0;
  s.tilt = 0.5 * std::numbers::pi * fallen * fallen;
  // Leaning towards -y turns about the floor's x axis.
  s.orientation =
      Eigen::AngleAxisd(s.tilt, Vector3::UnitX()) * Eigen::AngleAxisd(s.yaw, Vector3::UnitZ());
  for (std::size_t i = 0; i < 4; ++i) {
    s.wheels[i].swivel_angle = 0.6 * static_cast<double>(i) + t;
    s.wheels[i].normal_force = 196.2;
  }
  s.points = {{s.displacement, s.velocity, s.acceleration}};
  return s;
}

Demands demands_of(const std::vector<Sample>& history, std::size_t wheels) {
  Demands d;
  for (const Sample& s : history) {
    const double distance = s.displacement.head<2>().norm();
    if (distance > d.peak_displacement) d.time_of_peak_displacement = s.time;
    d.peak_displacement = std::max(d.peak_displacement, distance);
    d.peak_yaw = std::max(d.peak_yaw, std::abs(s.yaw));
    d.peak_tilt = std::max(d.peak_tilt, s.tilt);
  }
  d.residual_displacement = history.back().displacement.head<2>().norm();
  d.residual_yaw = history.back().yaw;
  d.peak_velocity = 4 * d.peak_displacement;
  d.path_length = 3 * d.peak_displacement;
  d.wheels.resize(wheels);
  d.points.resize(1);
  return d;
}

void let_fall(Demands& d) {
  d.time_of_overturning = kFall;
  d.direction_of_overturning = -0.5 * std::numbers::pi;
  d.most_wheels_lifted = 4;
  d.lifted_time = 11;
  d.wheels[0].liftoff_before_overturning = 4.08;
  d.wheels[2].liftoff_before_overturning = 4.1;
  d.wheels[1].liftoff_before_overturning = 4.4;
}

std::vector<Impact> impacts() {
  return {
      {2.5,
       2,
       -1,
       "chassis",
       4,
       "monitor",
       "chassis",
       {0.6, 1.4, 0.9},
       {-1, 0, 0},
       0.4,
       20,
       kNaN,
       0.012},
      {2.9,
       2,
       1,
       "front right",
       4,
       "monitor",
       "rear left",
       {0.62, 1.4, 0.05},
       {-1, 0, 0},
       0.9,
       42,
       kNaN,
       0.011},
      {3.5,
       2,
       -1,
       "chassis",
       4,
       "monitor",
       "chassis",
       {0.65, 1.4, 0.9},
       {-1, 0, 0},
       0.2,
       11,
       kNaN,
       0.013},
      {3.75,
       0,
       -1,
       "chassis",
       -1,
       "north wall",
       "",
       {-1.7, 2.4, 0.7},
       {0, -1, 0},
       0.65,
       210,
       5200,
       0.03},
      {4.75,
       kPump,
       -1,
       "chassis",
       -1,
       "floor",
       "",
       {1.25, -3.2, 0},
       {0, 0, 1},
       3.1,
       90,
       kNaN,
       0.02},
      {5.25,
       6,
       0,
       "front left",
       -1,
       "column",
       "",
       {2.6, -0.4, 0.05},
       {-1, 0, 0},
       0.125,
       6,
       900,
       0.01},
  };
}

}  // namespace

study::RunFacts synthetic_ward() {
  study::RunFacts facts;
  facts.job_name = "ward";
  facts.job_sha256 = std::string(64, 'd');
  facts.title = "Ten items in a ward under a made-up motion";
  Scene& scene = facts.scene;
  for (const Furniture& f : kFurniture)
    scene.items.push_back({f.name, model_of(f), {.position = f.position}});
  scene.room = {box("north wall", {0, 2.5, 1.25}, {6.2, 0.2, 2.5}),
                box("west wall", {-3, 0, 1.25}, {0.2, 5.2, 2.5}),
                box("east wall", {3, 0, 1.25}, {0.2, 5.2, 2.5}),
                box("south wall, west", {-1.2, -2.5, 1.25}, {3.8, 0.2, 2.5}),
                box("south wall, east", {2.45, -2.5, 1.25}, {1.3, 0.2, 2.5}),
                box("threshold", {1.25, -2.5, 0.005}, {1.1, 0.06, 0.01}),
                {"column", "", {2.75, -0.4, 1.25}, Quaternion::Identity(), RoomColumn{0.15, 2.5}}};
  scene.zones = {{"doorway", {1.25, -2.5}, 1.0, 1.1, std::numbers::pi / 2},
                 {"egress lane", {0.6, -0.9}, 4.2, 0.9, 0}};
  scene.tethers = {{"power cord", 2, {0, 0.2, 0.4}, {0.2, 2.4, 0.3}, 0.6, 2e4, 0, 300},
                   {"gas hose", 5, {0, 0.3, 1.0}, {1.8, 2.4, 1.4}, 0.7, 2e3},
                   {"network cable", 4, {0, 0, 1.0}, {0.9, 2.4, 0.3}, 2.5, 2e3}};
  // Half a sine of 2 m/s2 from 3.5 to 4.5 s towards +y: 4 / pi m/s; a ripple of no account.
  constexpr double kStep = 0.005;
  Eigen::Matrix3Xd motion = Eigen::Matrix3Xd::Zero(3, 2401);
  for (int i = 0; i < motion.cols(); ++i) {
    const double t = kStep * i;
    motion(0, i) = 0.5 * std::sin(20 * t);
    if (t > 3.5 && t < 4.5) motion(1, i) = 2 * std::sin(std::numbers::pi * (t - 3.5));
  }
  facts.floor = FloorMotion(kStep, motion, "made-up");
  facts.record = study::RecordFacts{};
  facts.record->name = "made-up";
  return facts;
}

Response synthetic_ward_response() {
  Response response;
  response.outcome = Outcome::kOverturned;
  response.end_time = 15;
  response.quality = {1e-7, 2e-6, 3e-10, 3750, 4, 5, 6, 12000, 7};
  for (std::size_t i = 0; i < std::size(kFurniture); ++i) {
    ItemResponse& item = response.items.emplace_back();
    for (int s = 0; s <= 750; ++s)
      item.history.push_back(sample_of(kFurniture[i], i == kPump, 0.02 * s));
    item.demands = demands_of(item.history, kFurniture[i].casters ? 4 : 0);
  }
  let_fall(response.items[kPump].demands);
  response.impacts = impacts();
  for (const Impact& impact : response.impacts) {
    const auto count = [&](std::size_t item) {
      Demands& d = response.items[item].demands;
      ++d.impacts;
      d.largest_approach_speed = std::max(d.largest_approach_speed, impact.approach_speed);
    };
    count(impact.item);
    if (impact.other_item >= 0) count(static_cast<std::size_t>(impact.other_item));
  }
  response.zones = {{4.25, 10.5, true, 0.25, 0.35}, {1.5, 0.75, false, 0.5, 0.9}};
  response.tethers = {{3.25, 3.5, 300}, {5.75, -1, 120}, {-1, -1, 0}};
  return response;
}

}  // namespace gurney
