#include <gtest/gtest.h>
#include <mujoco/mujoco.h>

#include <cmath>
#include <cstring>
#include <memory>

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

// Each joint of a part is a joint of MuJoCo: a slider or hinge one degree of freedom, a flexible one
// two, a ball three, a fixed one none; a content has six. The masses are those of the item with its
// parts, to the rounding of the test above for each body.
TEST(ExportedParts, HaveTheMassesAndFreedomsOfOursInMujoco) {
  const auto expect = [](const std::string& name, const std::string& variant, int freedoms) {
    const equipment::LoadedItem loaded = equipment::load_item(
        equipment::find_data(equipment::DataKind::kItem, name, ""), {}, {variant});
    std::vector<study::PartBody> parts;
    for (const equipment::LoadedPart& part : loaded.parts)
      parts.push_back(
          {part.model.name, part.joint, chassis_with_payloads(part.model), part.model.shape});
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

}  // namespace
}  // namespace gurney::peers
