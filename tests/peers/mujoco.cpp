#include <fmt/core.h>
#include <mujoco/mujoco.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <memory>
#include <numbers>
#include <optional>
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

/// Planes that only the chassis touches, as stiff and damped as a linear spring with our numerical
/// stiffness under the whole mass that rebounds with our restitution e: damping ratio
/// -ln e / sqrt(pi^2 + ln^2 e).
std::string walls_text(const CrossCheck& check) {
  const ContactConstants pair = contact_constants(check.scene, "", "");
  const double stiffness = pair.stiffness / whole_item(check.scene.items[0].model).mass;
  const double decay = -std::log(pair.restitution);
  const double ratio = decay / std::hypot(std::numbers::pi, decay);
  std::string text;
  for (const Wall& wall : check.walls) {
    const Vector3 at = wall.offset * wall.normal;
    text += fmt::format(
        "<geom type='plane' size='0 0 1' pos='{:.17g} {:.17g} {:.17g}' zaxis='{:.17g} {:.17g} "
        "{:.17g}' condim='3' contype='2' conaffinity='0' priority='1' friction='{:.17g} 0 0' "
        "solref='{:.17g} {:.17g}'/>",
        at.x(), at.y(), at.z(), wall.normal.x(), wall.normal.y(), wall.normal.z(), pair.friction,
        -stiffness, -2 * ratio * std::sqrt(stiffness));
  }
  return text;
}

std::string boxes_text(const EquipmentModel& item) {
  std::string text;
  for (const BodyShape& box : item.shape)
    text += fmt::format(
        "<geom type='box' size='{:.17g} {:.17g} {:.17g}' pos='{:.17g} {:.17g} {:.17g}' "
        "contype='0' conaffinity='2'/>",
        0.5 * box.size.x(), 0.5 * box.size.y(), 0.5 * box.size.z(), box.center.x(), box.center.y(),
        box.center.z());
  return text;
}

std::string model_text(const CrossCheck& check, double time_step, Setup setup) {
  const EquipmentModel& item = check.scene.items[0].model;
  const bool best = setup == Setup::kBest;
  // As stiff as a step allows: the reference spring's time constant is two steps.
  const bool soft = setup == Setup::kDefaults;
  const std::string stiff = !soft ? fmt::format("{:.17g} 1", 2 * time_step) : "0.02 1";
  const char* const hard = !soft ? "0.9999 0.9999 0.001" : "0.9 0.95 0.001";
  const MassProperties chassis = chassis_with_payloads(item);
  std::string text = fmt::format(
      "<mujoco><compiler angle='radian' boundmass='0' boundinertia='0' balanceinertia='false'/>"
      "<option timestep='{:.17g}' solver='Newton' {}/>"
      "<worldbody><geom type='plane' size='0 0 1' condim='3' contype='1' conaffinity='1' "
      "friction='{:.17g} 0 0' solref='{}' solimp='{}'/>"
      "{}<body><freejoint/>{}{}",
      time_step, best ? "cone='elliptic' iterations='200' tolerance='1e-14'" : "",
      item.casters[0].tread.kinetic_friction, stiff, hard, walls_text(check),
      check.walls.empty() ? "" : boxes_text(item),
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

Snapshot pose(const mjData& data) {
  const double *p = data.qpos, *q = data.qpos + 3;
  return snapshot({p[0], p[1], p[2]}, Quaternion(q[0], q[1], q[2], q[3]).toRotationMatrix());
}

/// Wheel of a contact with the floor, by its body: world, chassis, then fork and wheel of each
/// caster; none: of the chassis with a wall.
std::optional<std::size_t> wheel_of(const mjModel& model, const mjContact& contact) {
  const int body = std::max(model.geom_bodyid[contact.geom1], model.geom_bodyid[contact.geom2]);
  if (body < 3) return {};
  return static_cast<std::size_t>((body - 3) / 2);
}

}  // namespace

Path mujoco_path(const CrossCheck& check, double time_step, Setup setup) {
  const EquipmentModel& item = check.scene.items[0].model;
  const auto model = load(model_text(check, time_step, setup));
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
      if (const auto wheel = wheel_of(*model, data->contact[c])) load[*wheel] = force[0];
    }
    if ((k + 1) % stride != 0) continue;
    path.push_back(pose(*data));
    if (path.back().tilt > kOverturned) break;
  }
  return path;
}

}  // namespace gurney::peers
