#include <fmt/core.h>
#include <mujoco/mujoco.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <memory>
#include <stdexcept>
#include <string>

#include "tests/peers/cross_check.h"

namespace gurney::peers {
namespace {

std::string inertial(double mass, const Vector3& center, const Matrix3& inertia) {
  return fmt::format(
      "<inertial mass='{:.17g}' pos='{:.17g} {:.17g} {:.17g}' "
      "fullinertia='{:.17g} {:.17g} {:.17g} {:.17g} {:.17g} {:.17g}'/>",
      mass, center.x(), center.y(), center.z(), inertia(0, 0), inertia(1, 1), inertia(2, 2),
      inertia(0, 1), inertia(0, 2), inertia(1, 2));
}

std::string model_text(const EquipmentModel& item, double time_step) {
  // As stiff as a step allows: the reference spring's time constant is two steps.
  const std::string stiff = fmt::format("{:.17g} 1", 2 * time_step);
  const char* const hard = "0.9999 0.9999 0.001";
  const MassProperties chassis = chassis_with_payloads(item);
  std::string text = fmt::format(
      "<mujoco><compiler angle='radian' boundmass='0' boundinertia='0' balanceinertia='false'/>"
      "<option timestep='{:.17g}' solver='Newton' cone='elliptic' iterations='200' "
      "tolerance='1e-14'/>"
      "<worldbody><geom type='plane' size='0 0 1' condim='3' contype='1' conaffinity='1' "
      "friction='{:.17g} 0 0' solref='{}' solimp='{}'/>"
      "<body><freejoint/>{}",
      time_step, item.casters[0].tread.kinetic_friction, stiff, hard,
      inertial(chassis.mass, chassis.center_of_mass, chassis.inertia));
  for (const Caster& c : item.casters) {
    const Matrix3 wheel =
        Vector3(c.wheel_transverse_inertia, c.wheel_axial_inertia, c.wheel_transverse_inertia)
            .asDiagonal();
    text += fmt::format(
        "<body pos='{:.17g} {:.17g} {:.17g}' euler='0 0 {:.17g}'><joint type='hinge' axis='0 0 1' "
        "frictionloss='{:.17g}' solreffriction='{}' solimpfriction='{}'/>{}<body pos='{:.17g} 0 "
        "{:.17g}'><joint type='hinge' axis='0 1 0' frictionloss='1e-9' "
        "solreffriction='{}' solimpfriction='{}'/>{}"
        "<geom type='sphere' size='{:.17g}' condim='3' contype='0' conaffinity='1' "
        "friction='{:.17g} 0 0' solref='{}' solimp='{}'/></body></body>",
        c.mount.x(), c.mount.y(), c.mount.z(), c.heading, swivel_friction(c), stiff, hard,
        inertial(c.fork_mass, c.fork_center_of_mass, c.fork_inertia), -c.trail,
        c.wheel_radius - c.height, stiff, hard, inertial(c.wheel_mass, Vector3::Zero(), wheel),
        c.wheel_radius, c.tread.kinetic_friction, stiff, hard);
  }
  return text + "</body></worldbody></mujoco>";
}

struct Deleter {
  void operator()(mjModel* model) const { mj_deleteModel(model); }
  void operator()(mjData* data) const { mj_deleteData(data); }
};

std::unique_ptr<mjModel, Deleter> load(const std::string& text) {
  const auto files = std::make_unique<mjVFS>();
  mj_defaultVFS(files.get());
  mj_makeEmptyFileVFS(files.get(), "trolley.xml", static_cast<int>(text.size()));
  std::memcpy(files->filedata[0], text.data(), text.size());
  char error[1000] = "";
  std::unique_ptr<mjModel, Deleter> model(
      mj_loadXML("trolley.xml", files.get(), error, sizeof error));
  mj_deleteVFS(files.get());
  if (!model) throw std::runtime_error(fmt::format("MuJoCo: {}", error));
  return model;
}

Vector3 pose(const mjData& data) {
  const double *p = data.qpos, *q = data.qpos + 3;
  return {p[0], p[1],
          std::atan2(2 * (q[0] * q[3] + q[1] * q[2]), 1 - 2 * (q[2] * q[2] + q[3] * q[3]))};
}

}  // namespace

Path mujoco_path(const CrossCheck& check, double time_step) {
  const EquipmentModel& item = check.scene.items[0].model;
  const auto model = load(model_text(item, time_step));
  const std::unique_ptr<mjData, Deleter> data(mj_makeData(model.get()));
  const double weight = whole_item(item).mass * check.scene.gravity;
  std::vector<double> load(item.casters.size(), weight / static_cast<double>(item.casters.size()));
  const long stride = std::lround(check.sampling / time_step);
  const long steps = std::lround(check.duration / time_step);
  Path path{pose(*data)};
  for (long k = 0; k < steps; ++k) {
    const double t = static_cast<double>(k) * time_step;
    const Vector3 floor =
        (check.floor.velocity_at(t + time_step) - check.floor.velocity_at(t)) / time_step;
    const Vector3 gravity = -check.scene.gravity * Vector3::UnitZ() - floor;
    for (int i = 0; i < 3; ++i) model->opt.gravity[i] = gravity[i];
    // Degrees of freedom: six of the chassis, then swivel and axle of each caster.
    for (std::size_t i = 0; i < load.size(); ++i)
      model->dof_frictionloss[6 + 2 * i + 1] = axle_friction(item.casters[i], load[i]);
    mj_step(model.get(), data.get());
    std::fill(load.begin(), load.end(), 0.0);
    for (int c = 0; c < data->ncon; ++c) {
      double force[6];
      mj_contactForce(model.get(), data.get(), c, force);
      const int wheel = std::max(data->contact[c].geom1, data->contact[c].geom2) - 1;
      load[static_cast<std::size_t>(wheel)] = force[0];
    }
    if ((k + 1) % stride == 0) path.push_back(pose(*data));
  }
  return path;
}

}  // namespace gurney::peers
