
#include <gmock/gmock.h>

#include <cmath>

#include "engine/base/units.h"
#include "studies/plan/assessment_files.h"
#include "tests/support/expect_error.h"
#include "tests/support/temp_folder.h"

namespace gurney::study {
namespace {

using testing::ElementsAre;

/// A curve in the form of OpenQuake 3: a comment, titles, a row for each site.
std::string curves(const std::string& facts, const std::string& rows) {
  return "#,,,,,\"generated_by='OpenQuake engine 3.25.0', checksum=1, kind='mean', " + facts +
         "\"\nlon,lat,depth,poe-0.0500000,poe-0.1000000,poe-0.2000000,poe-0.4000000,poe-0."
         "8000000\n" +
         rows;
}

constexpr const char* kPga = "investigation_time=50.0, imt='PGA'";
constexpr const char* kSite = "10.5,45.2,0.0,1.000000E+00,9.0E-01,2.0E-01,2.0E-01,0.000000E+00\n";

class OpenQuakeHazardTest : public testing::Test {
 protected:
  std::string write(const std::string& text) { return folder_.write("hazard.csv", text); }

  TempFolder folder_;
};

// Certain and impossible levels have no rate; of two that are exceeded equally often the larger stays.
TEST_F(OpenQuakeHazardTest, RatesAreThoseOfAPoissonProcess) {
  const OpenQuakeHazard hazard = read_openquake_hazard(write(curves(kPga, kSite)), {});
  EXPECT_EQ(hazard.measure, "PGA");
  EXPECT_THAT(hazard.im, ElementsAre(0.1 * kStandardGravity, 0.4 * kStandardGravity));
  EXPECT_THAT(hazard.rate, ElementsAre(-std::log1p(-0.9) / 50, -std::log1p(-0.2) / 50));
}

TEST_F(OpenQuakeHazardTest, UnitsAreThoseOfOpenQuake) {
  const char* const row = "1,2,0,0.5,0.4,0.3,0.2,0.1\n";
  const auto first = [&](const std::string& imt) {
    return read_openquake_hazard(write(curves("investigation_time=1, imt='" + imt + "'", row)), {});
  };
  EXPECT_EQ(first("SA(0.2)").measure, "Sa(0.2)");
  EXPECT_DOUBLE_EQ(first("SA(0.2)").im[0], 0.05 * kStandardGravity);
  EXPECT_DOUBLE_EQ(first("PGV").im[0], 0.05 * 0.01);
}

TEST_F(OpenQuakeHazardTest, OfSeveralSitesOneIsNamed) {
  const std::string path = write(curves(kPga, "1,2,0,.5,.4,.3,.2,.1\n3,4,0,.9,.8,.7,.6,.5\n"));
  EXPECT_DOUBLE_EQ(read_openquake_hazard(path, 2).rate[0], -std::log1p(-0.9) / 50);
  EXPECT_ERROR(read_openquake_hazard(path, {}), "has 2 sites: site must be given, 1 to 2");
  EXPECT_ERROR(read_openquake_hazard(path, 3), "site = 3: must be 1 to 2");
}

TEST_F(OpenQuakeHazardTest, WhatIsWrongHasItsPlace) {
  const auto read = [&](const std::string& text) { read_openquake_hazard(write(text), {}); };
  EXPECT_ERROR(read("im,rate\n0.1,0.2\n0.2,0.1\n"), "is no hazard curve of OpenQuake");
  EXPECT_ERROR(read(curves("investigation_time=50.0, imt='IA'", kSite)),
               "hazard.csv:1:1: imt = 'IA': must be PGA, PGV or SA(period)");
  EXPECT_ERROR(read(curves("imt='PGA'", kSite)), "hazard.csv:1:1: investigation_time: must be");
  EXPECT_ERROR(read(curves(kPga, "1,2,0,.5,.4,.3,.2\n")), "hazard.csv:3:1: has 7 values for 8");
  EXPECT_ERROR(read(curves(kPga, "1,2,0,.5,.6,.3,.2,.1\n")),
               "hazard.csv:3:10: '.6': must be a probability, and not above the one before it");
  EXPECT_ERROR(read(curves(kPga, "1,2,0,.5,x,.3,.2,.1\n")), "hazard.csv:3:10: 'x'");
  EXPECT_ERROR(read(curves(kPga, "1,2,0,1,1,1,1,.1\n")), "fewer than two levels");
}

// The file of a site names it and states the component, which OpenQuake does not.
TEST_F(OpenQuakeHazardTest, IsNamedByAFileWithItsComponent) {
  write(curves(kPga, kSite));
  const auto read = [&](const std::string& keys) {
    return read_hazard_file(folder_.write(
        "site.toml", "schema = \"gurney-hazard/1\"\nopenquake = \"hazard.csv\"\n" + keys));
  };
  const SiteHazard site = read("component = \"RotD50\"\n");
  EXPECT_EQ(site.measure, "PGA RotD50");
  EXPECT_DOUBLE_EQ(*site.curve.rate(0.4 * kStandardGravity), -std::log1p(-0.2) / 50);
  EXPECT_ERROR(read("unit = \"g\"\n"), "site.toml:3:8: unit: the file of OpenQuake states it");
  EXPECT_ERROR(read("site = 2\n"), "hazard.csv: site = 2: must be 1 to 1");
  EXPECT_ERROR(read_hazard_file(folder_.write("x.csv", "")), "openquake = \"FILE.csv\"");
}

}  // namespace
}  // namespace gurney::study
