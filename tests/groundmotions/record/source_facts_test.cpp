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

TEST(SourceFacts, NameEventAndStation) {
  const SourceFacts report = source_facts({{{"event", "Northridge-01"},
                                            {"station", "Rinaldi Receiving Sta"},
                                            {"lowest usable frequency [Hz]", "0.1125"}},
                                           {{"event", "of the file"}}});
  EXPECT_EQ(report.event, "Northridge-01");
  EXPECT_EQ(report.station, "Rinaldi Receiving Sta");
  EXPECT_DOUBLE_EQ(report.lowest_frequency, 0.1125);
  const SourceFacts peer =
      source_facts({{{"event", "Northridge-01, 1/17/1994, Newhall, Fire Sta, 360"}}});
  EXPECT_EQ(peer.event, "Northridge-01, 1/17/1994");
  EXPECT_EQ(peer.station, "Newhall, Fire Sta");
  const SourceFacts older =
      source_facts({{{"event", "IMPERIAL VALLEY 5/19/40 0439, EL CENTRO ARRAY #9, 180"}}});
  EXPECT_EQ(older.event, "IMPERIAL VALLEY 5/19/40 0439");
  EXPECT_EQ(older.station, "EL CENTRO ARRAY #9");
  const SourceFacts japan =
      source_facts({{{"origin time (Japan)", "2008/06/14 08:43:00"}, {"station", "IWTH25"}}});
  EXPECT_EQ(japan.event, "2008/06/14 08:43:00");
  EXPECT_EQ(japan.station, "IWTH25");
  const SourceFacts geonet =
      source_facts({{{"event", "Epicentre 42 41 33S  Bearing S18W  Dist 9km"},
                     {"station", "Site WTMC  42 37 10S  Cusp file:  2016"}}});
  EXPECT_EQ(geonet.event, "Epicentre 42 41 33S");
  EXPECT_EQ(geonet.station, "Site WTMC  42 37 10S");
  EXPECT_EQ(source_facts({{}}).event, "");
  EXPECT_TRUE(std::isnan(source_facts({{}}).lowest_frequency));
}

}  // namespace
}  // namespace gurney::groundmotions
