#include "studies/verification/scenes/scenes.h"

#include <limits>

namespace gurney::scenes {
namespace {

EquipmentModel item_on(const std::vector<Vector3>& mounts, const ItemOptions& options) {
  EquipmentModel item;
  item.name = "test item";
  for (std::size_t i = 0; i < mounts.size(); ++i) {
    Caster caster = options.caster;
    caster.mount = mounts[i];
    caster.mount.z() = caster.height;
    caster.heading = i < options.headings.size() ? options.headings[i] : 0;
    item.casters.push_back(caster);
  }
  const double casters = static_cast<double>(mounts.size());
  item.chassis_mass =
      options.total_mass - casters * (options.caster.fork_mass + options.caster.wheel_mass);
  item.chassis_center_of_mass = options.chassis_center;
  item.chassis_inertia = solid_box_inertia(item.chassis_mass, {1.1, 0.55, 1.339});
  item.shape = {{{0, 0, options.caster.height + 0.67}, {1.1, 0.55, 1.339}}};
  item.marked_points = {{"center of mass", whole_item(item).center_of_mass}};
  return item;
}

}  // namespace

Caster rubber_caster() {
  Caster caster;
  caster.fork_center_of_mass = {-0.017, 0, -0.04};
  caster.fork_inertia = solid_box_inertia(caster.fork_mass, {0.08, 0.05, 0.09});
  set_wheel_inertia(caster);
  caster.tread.tangential_damping = 20;  // light: closed forms leave it out
  return caster;
}

void set_wheel_inertia(Caster& caster, double ratio) {
  const double r = caster.wheel_radius, w = caster.wheel_width;
  caster.wheel_axial_inertia = ratio * caster.wheel_mass * r * r / 2;
  caster.wheel_transverse_inertia = ratio * caster.wheel_mass * (r * r / 4 + w * w / 12);
}

void stiffen(Tread& tread) {
  tread.normal_stiffness = 3e8;
  tread.normal_damping = 1.6e4;
  tread.tangential_stiffness = 1e9;
}

EquipmentModel trolley(const ItemOptions& options) {
  const double x = options.half_wheelbase, y = options.half_track;
  return item_on({{x, y, 0}, {x, -y, 0}, {-x, y, 0}, {-x, -y, 0}}, options);
}

EquipmentModel locked_block(ItemOptions options) {
  options.caster.swivels = false;
  options.caster.brake_torque = std::numeric_limits<double>::infinity();
  return trolley(options);
}

EquipmentModel single_caster(double mass, const Caster& caster) {
  return item_on({Vector3::Zero()}, {.total_mass = mass,
                                     .chassis_center = {0, 0, caster.height + 0.1},
                                     .caster = caster,
                                     .headings = {caster.heading}});
}

Fixture hold_rotations(bool roll, bool pitch, bool yaw) {
  Fixture fixture;
  const bool held[] = {roll, pitch, yaw};
  for (int i = 0; i < 3; ++i)
    if (held[i]) fixture.guides[3 + i].kind = Guide::Kind::kHeld;
  return fixture;
}

Fixture tow(double speed) {
  Fixture fixture = hold_rotations();
  fixture.guides[0].kind = Guide::Kind::kVelocity;
  fixture.guides[0].velocity = speed;
  fixture.guides[1].kind = Guide::Kind::kHeld;
  return fixture;
}

FloorMotion floor_motion(double time_step, double duration, const Vector3& direction,
                         const std::function<double(double)>& acceleration) {
  const auto last = std::lround(duration / time_step);
  Eigen::Matrix3Xd samples(3, last + 1);
  for (long i = 0; i <= last; ++i)
    samples.col(i) = acceleration(static_cast<double>(i) * time_step) * direction;
  return {time_step, samples};
}

FloorMotion rectangular_pulse(double acceleration, double duration, const Vector3& direction) {
  return floor_motion(duration, duration, direction, [=](double) { return acceleration; });
}

PointForce constant_force(double force, double duration, const Vector3& point,
                          const Vector3& direction) {
  return {"pull", point, direction, {0, duration}, {force, force}};
}

double total_mass(const EquipmentModel& item) { return whole_item(item).mass; }

double wheel_inertia_mass(const EquipmentModel& item) {
  double sum = 0;
  for (const Caster& caster : item.casters)
    sum += caster.wheel_axial_inertia / (caster.wheel_radius * caster.wheel_radius);
  return sum;
}

SimulationSettings run_for(double duration, double time_step, double history_step) {
  SimulationSettings settings;
  settings.duration = duration;
  settings.time_step = time_step;
  settings.history_step = history_step;
  return settings;
}

}  // namespace gurney::scenes
