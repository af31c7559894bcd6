#include "studies/explanation/what_if.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "engine/run/simulate.h"
#include "studies/explanation/explain.h"
#include "studies/render/render.h"
#include "studies/report/explanation_report.h"
#include "studies/verification/scenes/blocks.h"

namespace gurney::explanation {
namespace {

/// A block on ice that glides into a wall 0.5 m away with 1 m/s.
study::RunFacts gliding_block() {
  ContactConstants ice;
  ice.friction = 0;
  study::RunFacts facts;
  facts.scene = blocks::block(100, {0.6, 0.6, 0.3}, ice);
  blocks::add_wall(facts.scene, 0.8, ice);
  facts.scene.items[0].initial.velocity = {1, 0, 0};
  facts.settings = RunOptions{blocks::run_for(3, 0.004, 0.004)};
  return facts;
}

Explanation explained(const study::RunFacts& facts) {
  return explain(facts, simulate(facts.scene, facts.floor, facts.settings));
}

const VariantOutcome& named(const WhatIf& what, const std::string& name) {
  return *std::ranges::find(what.variants, name, &VariantOutcome::name);
}

TEST(WhatIf, RunsWhatAppliesAndNamesWhatDoesNot) {
  const study::RunFacts facts = gliding_block();
  const Explanation of = explained(facts);
  const WhatIf what = what_if(facts, of, 1, 2);
  EXPECT_EQ(what.as_it_was.happened, 1u);
  EXPECT_NEAR(what.as_it_was.hardest_impact, 1, 1e-6);
  EXPECT_EQ(named(what, "all brakes on").reason, "it has no casters");
  EXPECT_EQ(named(what, "without its cords").reason, "nothing ties it to the room");
  EXPECT_TRUE(named(what, "without wall").prevented());
  EXPECT_EQ(named(what, "without wall").hardest_impact, 0);
  // Half a metre farther it glides on and hits with the same speed.
  EXPECT_NEAR(named(what, "0.5 m farther from wall").hardest_impact, 1, 1e-6);
  EXPECT_FALSE(named(what, "0.5 m farther from wall").prevented());
  // m v^2 = k x^2 of one strap with its slack: 20 mm + 45 mm; it never reaches the wall.
  const VariantOutcome& strapped = named(what, "with two straps");
  EXPECT_TRUE(strapped.prevented());
  EXPECT_LT(strapped.peak_displacement, 0.02 + 0.0448);
  EXPECT_GT(strapped.peak_displacement, 0.02);
  const std::string words = conclusion(what, of);
  EXPECT_NE(words.find("Taking wall away and holding it with two straps would have prevented the "
                       "impact."),
            std::string::npos)
      << words;
  EXPECT_NE(words.find("standing 0.5 m farther from wall, "), std::string::npos) << words;
}

TEST(WhatIf, HasTheSameBitsWithAnyNumberOfThreads) {
  const study::RunFacts facts = gliding_block();
  const Explanation of = explained(facts);
  const WhatIf one = what_if(facts, of, 3, 1), three = what_if(facts, of, 3, 3);
  EXPECT_EQ(render::json(report::explanation_findings(of, &one)),
            render::json(report::explanation_findings(of, &three)));
  EXPECT_EQ(one.as_it_was.runs, 3u);
  EXPECT_EQ(one.as_it_was.happened, 3u);
  const std::string words = conclusion(one, of);
  // Clopper & Pearson: 0.025^(1/3) = 0.29 with 3 of 3, 1 - 0.29 with none of them.
  EXPECT_NE(words.find("the impact happened in 3 of 3 replicas (0.29 to 1.00)"), std::string::npos)
      << words;
  EXPECT_NE(words.find("0 of 3 replicas (0.00 to 0.71), in: without wall and with two straps."),
            std::string::npos)
      << words;
  EXPECT_NE(words.find("The intervals overlap"), std::string::npos) << words;
}

TEST(Variants, DoNotPutTheItemIntoAWall) {
  study::RunFacts facts = gliding_block();
  facts.scene.items[0].model.shape[0].size.y() = 2.4;  // turned it would reach 1.2 m ahead
  facts.scene.items[0].model.shape[0].size.x() = 0.2;
  const Explanation of = explained(facts);
  for (const Variant& variant : variants_of(facts, of)) {
    if (variant.name == "turned by 90 deg") {
      EXPECT_EQ(variant.reason, "it would stand in wall");
    }
    if (variant.name == "turned by 180 deg") {
      EXPECT_EQ(variant.reason, "");
    }
  }
}

TEST(Variants, LowerTheCentreOfMassOfAll) {
  study::RunFacts facts = gliding_block();
  const Explanation of = explained(facts);
  for (const Variant& variant : variants_of(facts, of)) {
    if (variant.name == "centre of mass 20 % lower") {
      EXPECT_NEAR(whole_item(variant.scene.items[0].model).center_of_mass.z(), 0.8 * 0.15, 1e-12);
    }
  }
}

TEST(Variants, PreventNothingWhereNothingHappened) {
  study::RunFacts facts = gliding_block();
  facts.scene.items[0].initial.velocity = {0, 0, 0};
  const Explanation of = explained(facts);
  EXPECT_EQ(of.item().finding, Finding::kStill);
  EXPECT_NE(conclusion(what_if(facts, of, 1, 1), of).find("there is nothing to prevent"),
            std::string::npos);
}

}  // namespace
}  // namespace gurney::explanation
