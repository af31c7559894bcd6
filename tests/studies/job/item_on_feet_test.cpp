#include <gtest/gtest.h>

#include <algorithm>

#include "studies/job/job.h"
#include "tests/studies/job/job_text.h"

namespace gurney::study {
namespace {

TEST(Job, BringsTheContactOfAnItemOnFeetToTheSceneAndItsAssumptions) {
  const Job job = job_of_text(
      "schema = \"gurney-job/1\"\n[item]\nequipment = \"bookcase\"\n"
      "[floor]\ncovering = \"rubber\"\n");
  EXPECT_TRUE(job.scene.items[0].model.casters.empty());
  EXPECT_EQ(job.scene.items[0].model.material, "coated board");
  EXPECT_EQ(job.scene.floor_material, "floor");
  EXPECT_NO_THROW(validate(job.scene));
  // 0.3 of the bookcase times 1.2 of the covering.
  EXPECT_DOUBLE_EQ(contact_constants(job.scene, "coated board", "floor").friction, 0.36);
  for (const char* key :
       {"contact.friction", "contact.restitution", "contact.stiffness_n_per_m", "friction_factor"})
    EXPECT_TRUE(std::any_of(job.assumptions.begin(), job.assumptions.end(),
                            [&](const equipment::Assumption& each) { return each.key == key; }))
        << key;
}

TEST(Job, DrawsTheContactOfAnItemOnFeet) {
  const auto friction = [](int draw) {
    const Job job = job_of_text("schema = \"gurney-job/1\"\n[item]\nequipment = \"bookcase\"\n" +
                                ("[uncertainty]\ndraw = " + std::to_string(draw)) + "\n");
    return job.scene.pairs.at(0).constants.friction;
  };
  EXPECT_NE(friction(1), friction(2));
  EXPECT_GE(friction(1), 0.2);
  EXPECT_LE(friction(1), 0.6);
}

}  // namespace
}  // namespace gurney::study
