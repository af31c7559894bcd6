#include <gtest/gtest.h>
#include <mujoco/mujoco.h>

#include <cmath>
#include <cstring>
#include <memory>
#include <numbers>
#include <utility>

#include "engine/base/units.h"
#include "engine/run/simulate.h"
#include "equipment/catalogue/catalogue.h"
#include "equipment/catalogue/load_item.h"
#include "studies/exports/item_bodies.h"

namespace gurney::peers {
namespace {

struct Deleter {
  void operator()(mjModel* model) const { mj_deleteModel(model); }
  void operator()(mjData* data) const { mj_deleteData(data); }
};
using Model = std::unique_ptr<mjModel, Deleter>;

Model load(const std::string& text) {
  const auto files = std::make_unique<mjVFS>();
  mj_defaultVFS(files.get());
  mj_makeEmptyFileVFS(files.get(), "item.xml", static_cast<int>(text.size()));
  std::memcpy(files->filedata[0], text.data(), text.size());
  char error[1000] = "";
  Model model(mj_loadXML("item.xml", files.get(), error, sizeof error));
  mj_deleteVFS(files.get());
  EXPECT_TRUE(model) << error << "\n" << text;
  return model;
}

/// Of all bodies as MuJoCo places them at the start.
MassProperties mass_of(const mjModel& model) {
  const std::unique_ptr<mjData, Deleter> data(mj_makeData(&model));
  mj_forward(&model, data.get());
  MassProperties sum;
  for (int i = 1; i < model.nbody; ++i) {
    using RowMajor = Eigen::Matrix<double, 3, 3, Eigen::RowMajor>;
    const Matrix3 axes = Eigen::Map<const RowMajor>(data->ximat + 9 * i);
    const Vector3 moments = Eigen::Map<const Vector3>(model.body_inertia + 3 * i);
    sum.add(model.body_mass[i], Eigen::Map<const Vector3>(data->xipos + 3 * i),
            axes * moments.asDiagonal() * axes.transpose());
  }
  return sum;
}

/// An item of the catalogue with its swivels turned, each by another angle.
EquipmentModel item_of(const std::string& name) {
  EquipmentModel item =
      equipment::load_item(equipment::find_data(equipment::DataKind::kItem, name, "")).model;
  double angle = 0.3;
  for (Caster& caster : item.casters) caster.heading += angle *= 1.7;
  return item;
}

class ExportedItem : public testing::TestWithParam<std::string> {};

// Numbers are written so that they read back as the same. MuJoCo turns an inertia to principal axes by
// Jacobi rotations that end with off-diagonals below 1e-12 kg m2 (mju_eig3): that much is lost for each
// of the bodies; all else is the rounding of some 100 sums and products, 100 * 2^-53 = 1e-14 of the
// largest number.
TEST_P(ExportedItem, HasTheMassPropertiesOfOursInMujoco) {
  constexpr double kLost = 1e-12, kRounding = 1e-14;
  const EquipmentModel item = item_of(GetParam());
  const Model model = load(study::mjcf_text(study::item_bodies(item)));
  ASSERT_TRUE(model);
  const MassProperties ours = whole_item(item), theirs = mass_of(*model);
  EXPECT_NEAR(theirs.mass, ours.mass, kRounding * ours.mass);
  const double size = ours.center_of_mass.norm() + 1;
  EXPECT_LE((theirs.center_of_mass - ours.center_of_mass).norm(), kRounding * size);
  const double largest = ours.inertia.diagonal().maxCoeff();
  const double bodies = 1 + 2 * static_cast<double>(item.casters.size());
  EXPECT_LE((theirs.inertia - ours.inertia).cwiseAbs().maxCoeff(),
            bodies * kLost + kRounding * (largest + ours.mass * size * size));
  // Six degrees of freedom of the chassis, and those of the casters that turn.
  int hinges = 0;
  for (const study::CasterBodies& each : study::item_bodies(item).casters)
    hinges += int(each.swivel.turns) + int(each.axle.turns);
  EXPECT_EQ(model->nv, 6 + hinges);
}

// It stands: after a second the chassis has sunk by less than MuJoCo's soft contacts give way, 1 cm.
TEST_P(ExportedItem, StandsInMujoco) {
  const Model model = load(study::mjcf_text(study::item_bodies(item_of(GetParam()))));
  ASSERT_TRUE(model);
  const std::unique_ptr<mjData, Deleter> data(mj_makeData(model.get()));
  while (data->time < 1) mj_step(model.get(), data.get());
  EXPECT_LT(std::abs(data->qpos[2]), 0.01);
  EXPECT_GT(data->qpos[3], std::cos(0.02));  // quaternion: turned by less than 0.04 rad
}

INSTANTIATE_TEST_SUITE_P(Catalogue, ExportedItem,
                         testing::ValuesIn(equipment::catalogue_names(equipment::DataKind::kItem)));

equipment::LoadedItem variant_of(const std::string& name, const std::string& variant) {
  return equipment::load_item(equipment::find_data(equipment::DataKind::kItem, name, ""), {},
                              {variant});
}

std::vector<study::PartBody> parts_of(const equipment::LoadedItem& item) {
  std::vector<study::PartBody> parts;
  for (const equipment::LoadedPart& part : item.parts)
    parts.push_back(
        {part.model.name, part.joint, chassis_with_payloads(part.model), part.model.shape});
  return parts;
}

// Each joint of a part is a joint of MuJoCo: a slider or hinge one degree of freedom, a flexible one
// two, a ball three, a fixed one none; a content has six. The masses are those of the item with its
// parts, to the rounding of the test above for each body.
TEST(ExportedParts, HaveTheMassesAndFreedomsOfOursInMujoco) {
  const auto expect = [](const std::string& name, const std::string& variant, int freedoms) {
    const equipment::LoadedItem loaded = variant_of(name, variant);
    std::vector<study::PartBody> parts = parts_of(loaded);
    for (const equipment::LoadedContent& content : loaded.contents)
      parts.push_back({content.model.name,
                       {},
                       chassis_with_payloads(content.model),
                       content.model.shape,
                       content.pairs.front().constants.friction,
                       content.pairs.front().constants.rolling_resistance,
                       content.yaw,
                       content.position});
    const Model alone = load(study::mjcf_text(study::item_bodies(loaded.model)));
    const Model model = load(study::mjcf_text(study::item_bodies(loaded.model, parts)));
    ASSERT_TRUE(alone && model);
    EXPECT_EQ(model->nv - alone->nv, freedoms);
    const MassProperties ours = whole_item(as_rigid(loaded)), theirs = mass_of(*model);
    EXPECT_NEAR(theirs.mass, ours.mass, 1e-13 * ours.mass);
    EXPECT_LE((theirs.center_of_mass - ours.center_of_mass).norm(), 1e-12);
    EXPECT_LE((theirs.inertia - ours.inertia).cwiseAbs().maxCoeff(), 1e-10);
  };
  expect("crash_cart", "drawers and defibrillator", 5 + 6);
  expect("infusion_pole", "flexible pole and bags", 2 + 3 + 3);
  expect("icu_ventilator", "arm and circuit", 0 + 1 + 1 + 2);
  expect("patient_monitor_stand", "flexible column and tilting monitor", 2 + 1);
  expect("medication_cart", "drawers and computer", 4 + 3 * 6);
  expect("icu_bed", "patient on mattress", 3 + 2);
  expect("hospital_bed", "patient on mattress", 3);
  expect("neonatal_incubator", "door, tray and shelf", 1 + 1 + 2 + 2 * 6);
  expect("storage_shelving", "boxes on shelves", 5 * 6);
}

/// A floor that sways along both horizontals, each with another frequency [m/s2].
Vector3 sway(double t) {
  const double w = 2 * std::numbers::pi * t;
  return {1.0 * std::sin(0.7 * w), 0.8 * std::sin(1.1 * w), 0};
}

constexpr double kSway = 4, kEvery = 0.1;  // [s]

/// Ways of the centres of mass of all parts from their rest, at each multiple of kEvery.
using Paths = std::vector<std::vector<Vector3>>;

/// The item on a chassis that its fixture holds.
Paths our_paths(const equipment::LoadedItem& item, double time_step) {
  Scene scene;
  scene.pairs = {{item.model.material, "", {}}, {item.model.material, item.model.material, {}}};
  const auto add = [&](EquipmentModel model) {
    model.material = item.model.material;
    scene.items.emplace_back().name = model.name;
    scene.items.back().model = std::move(model);
  };
  add(item.model);
  for (Guide& guide : scene.items[0].fixture.guides) guide.kind = Guide::Kind::kHeld;
  for (const equipment::LoadedPart& part : item.parts) {
    scene.joints.push_back(part.joint);
    scene.joints.back().part = scene.items.size();
    add(part.model);
  }
  constexpr double kSample = 0.001;
  Eigen::Matrix3Xd floor(3, std::lround(kSway / kSample) + 1);
  for (Eigen::Index i = 0; i < floor.cols(); ++i) floor.col(i) = sway(kSample * double(i));
  SimulationSettings settings;
  settings.time_step = time_step;
  settings.duration = kSway;
  settings.history_step = kEvery;
  const Response response = simulate(scene, FloorMotion(kSample, floor), settings);
  EXPECT_EQ(response.outcome, Outcome::kStopped) << response.cause;
  Paths paths;
  for (std::size_t i = 1; i < response.items.size(); ++i) {
    std::vector<Vector3>& path = paths.emplace_back();
    for (const Sample& sample : response.items[i].history)
      path.push_back(sample.displacement - response.items[i].history.front().displacement);
  }
  return paths;
}

/// Paths in MuJoCo, the chassis welded to the world and its floor's acceleration taken from gravity.
Paths mujoco_paths(const equipment::LoadedItem& item) {
  std::string text = study::mjcf_text(study::item_bodies(item.model, parts_of(item)));
  const std::string free = "<freejoint/>";
  text.erase(text.find(free), free.size());
  const Model model = load(text);
  const std::unique_ptr<mjData, Deleter> data(mj_makeData(model.get()));
  const int first = model->nbody - static_cast<int>(item.parts.size());
  model->opt.integrator = mjINT_RK4;
  model->opt.timestep = 5e-4;
  model->opt.disableflags |= mjDSBL_CONTACT;
  const auto run_to = [&](double time, const auto& acceleration) {
    for (int left = static_cast<int>(std::lround((time - data->time) / model->opt.timestep));
         left > 0; --left) {
      const Vector3 a = acceleration(data->time + model->opt.timestep / 2);
      Eigen::Map<Vector3>(model->opt.gravity) = Vector3(0, 0, -kStandardGravity) - a;
      mj_step(model.get(), data.get());
    }
    mj_forward(model.get(), data.get());
  };
  // It comes to rest sooner with thirty times the damping, which is near the critical one.
  Eigen::Map<Eigen::VectorXd> damping(model->dof_damping, model->nv);
  damping *= 30;
  run_to(20, [](double) -> Vector3 { return Vector3::Zero(); });
  damping /= 30;
  mju_zero(data->qvel, model->nv);
  data->time = 0;
  Eigen::Map<const Eigen::Matrix3Xd> centers(data->xipos + 3 * first, 3, model->nbody - first);
  const Eigen::Matrix3Xd rest = centers;
  Paths paths(item.parts.size());
  for (int k = 0; k <= std::lround(kSway / kEvery); ++k) {
    run_to(k * kEvery, sway);
    for (std::size_t i = 0; i < paths.size(); ++i)
      paths[i].push_back((centers - rest).col(static_cast<Eigen::Index>(i)));
  }
  return paths;
}

// A pole that bends under bags that swing, on a foot that shakes, and a patient on a mattress: MuJoCo's
// reduced coordinates and Runge-Kutta steps beside ours. Ours is of second order, so its error is a third
// of the difference to twice the step; a joint yields by 1e-5 of its lever of up to 2 m
// (docs/theory/parts.md). MuJoCo holds the acceleration for a step h: (2 pi 1.1 h)^2 / 24 = 5e-7 of
// the ways. Latches are not exported, and dry friction has MuJoCo's own law: these items have none.
TEST(ExportedParts, SwingAsOursInMujoco) {
  constexpr double kYield = 2e-5;
  for (const auto& [name, variant] : {std::pair("infusion_pole", "flexible pole and bags"),
                                      {"hospital_bed", "patient on mattress"}}) {
    const equipment::LoadedItem item = variant_of(name, variant);
    const Paths theirs = mujoco_paths(item), ours = our_paths(item, 0.001),
                coarse = our_paths(item, 0.002);
    ASSERT_EQ(ours.size(), 3u);
    for (std::size_t part = 0; part < ours.size(); ++part) {
      ASSERT_EQ(ours[part].size(), theirs[part].size());
      double largest = 0, error = 0, difference = 0;
      for (std::size_t i = 0; i < ours[part].size(); ++i) {
        largest = std::max(largest, theirs[part][i].norm());
        error = std::max(error, (coarse[part][i] - ours[part][i]).norm() / 3);
        difference = std::max(difference, (ours[part][i] - theirs[part][i]).norm());
      }
      EXPECT_GT(largest, 0.005) << name;
      EXPECT_LE(difference, error + kYield) << name << ": " << item.parts[part].model.name;
    }
  }
}

}  // namespace
}  // namespace gurney::peers
