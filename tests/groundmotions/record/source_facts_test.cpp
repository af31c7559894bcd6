#include "groundmotions/record/source_facts.h"

#include <gtest/gtest.h>

#include <cmath>

namespace gurney::groundmotions {
namespace {

TEST(SourceFacts, PreferTheRupture) {
  const SourceFacts facts = source_facts({{{"magnitude", "6.93"},
                                           {"R_JB [km]", "5.02"},
                                           {"R_rup [km]", "11.5"},
                                           {"Vs30 [m/s]", "349.43"}}});
  EXPECT_DOUBLE_EQ(facts.magnitude, 6.93);
  EXPECT_DOUBLE_EQ(facts.distance, 11500);
  EXPECT_EQ(facts.distance_kind, "Rrup");
  EXPECT_DOUBLE_EQ(facts.vs30, 349.43);
}

TEST(SourceFacts, ReadNumbersInWords) {
  EXPECT_DOUBLE_EQ(source_facts({{{"magnitude", "Moment Mag=      7.1 Ms=  7.0"}}}).magnitude, 7.1);
  EXPECT_DOUBLE_EQ(source_facts({{{"magnitude", "6.0 Mw"}}}).magnitude, 6);
  EXPECT_DOUBLE_EQ(source_facts({{{"magnitude ML", "4.6"}, {"magnitude Mw", "4.4"}}}).magnitude,
                   4.4);
}

TEST(SourceFacts, TheFirstSourceDecides) {
  const SourceFacts facts =
      source_facts({{{"magnitude", "7"}}, {{"magnitude", "6"}, {"epicentral distance [km]", "0"}}});
  EXPECT_EQ(facts.magnitude, 7);
  EXPECT_EQ(facts.distance, 0);
  EXPECT_EQ(facts.distance_kind, "epicentral");
}

TEST(SourceFacts, PlaceholdersAreNone) {
  const SourceFacts facts = source_facts(
      {{{"magnitude", "-999"}, {"R_rup [km]", "-999.0"}, {"vs30 [m/s]", "unknown"}}, {}});
  EXPECT_TRUE(std::isnan(facts.magnitude));
  EXPECT_TRUE(std::isnan(facts.distance));
  EXPECT_TRUE(std::isnan(facts.vs30));
  EXPECT_EQ(facts.distance_kind, "");
}

}  // namespace
}  // namespace gurney::groundmotions
