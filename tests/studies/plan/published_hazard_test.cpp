
#include <gmock/gmock.h>

#include <cmath>

#include "engine/base/units.h"
#include "groundmotions/hazard/hazard_curve_file.h"
#include "studies/plan/assessment_files.h"
#include "tests/support/expect_error.h"
#include "tests/support/spreadsheet_text.h"
#include "tests/support/temp_folder.h"

namespace gurney::study {
namespace {

using groundmotions::PublishedHazard;
using groundmotions::read_openquake_hazard;
using groundmotions::read_usgs_hazard;
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

// OpenQuake ends its lines with CR LF; a spreadsheet puts a byte order mark in front.
TEST_F(OpenQuakeHazardTest, LineEndsAndByteOrderMarksAreNoPartOfTheNumbers) {
  const PublishedHazard hazard =
      read_openquake_hazard(write(spreadsheet_text(curves(kPga, kSite))), {});
  EXPECT_THAT(hazard.im, ElementsAre(0.1 * kStandardGravity, 0.4 * kStandardGravity));
  EXPECT_ERROR(read_openquake_hazard(write("\r\n" + curves(kPga, "1,2,0,.5,x,.3,.2,.1\r\n")), {}),
               "hazard.csv:4:10: 'x'");
}

// Certain and impossible levels have no rate; of two that are exceeded equally often the larger stays.
TEST_F(OpenQuakeHazardTest, RatesAreThoseOfAPoissonProcess) {
  const PublishedHazard hazard = read_openquake_hazard(write(curves(kPga, kSite)), {});
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
  EXPECT_ERROR(read("unit = \"g\"\n"),
               "site.toml:3:8: unit: the file named by openquake states it");
  EXPECT_ERROR(read("site = 2\n"), "hazard.csv: site = 2: must be 1 to 1");
  EXPECT_ERROR(read_hazard_file(folder_.write("x.csv", "")), "openquake = \"x.csv\"");
}

// Synthetic answers in the form of the services of the USGS, today's and the one before it.
std::string usgs(const std::string& curves) {
  return R"({"name": "Hazard Service", "status": "success", "request": {"vs30": 760},
 "response": {"metadata": {"ylabel": "Annual Frequency of Exceedance"}, "hazardCurves": [)" +
         curves + "]}}";
}

std::string curve(const std::string& imt, const std::string& xs, const std::string& ys) {
  return R"({"imt": {"value": ")" + imt + R"(", "display": "x"}, "data": [
    {"component": "Grid", "values": {"xs": [1, 2, 3], "ys": [9, 9, 9]}},
    {"component": "Total", "values": {"xs": [)" +
         xs + R"(], "ys": [)" + ys + "]}}]}";
}

constexpr const char* kBefore = R"j({"status": "success", "response": [{
  "metadata": {"imt": {"value": "SA0P2", "display": "0.2 s"}, "xlabel": "Ground Motion (g)",
               "xvalues": [0.01, 0.1, 1, 2]},
  "data": [{"component": "Total", "yvalues": [0.4, 0.03, 5e-4, 0]},
           {"component": "Grid", "yvalues": [0.2, 0.02, 4e-4, 0]}]}]})j";

class UsgsHazardTest : public testing::Test {
 protected:
  PublishedHazard read(const std::string& text, const std::string& measure = "") {
    return read_usgs_hazard(folder_.write("curve.json", text), measure);
  }

  TempFolder folder_;
};

// Levels are in g, PGV in cm/s; frequencies are rates as they are. The last level is never exceeded.
TEST_F(UsgsHazardTest, FrequenciesAreRatesAndLevelsAreInG) {
  const PublishedHazard hazard = read(kBefore);
  EXPECT_EQ(hazard.measure, "Sa(0.2)");
  EXPECT_THAT(hazard.im,
              ElementsAre(0.01 * kStandardGravity, 0.1 * kStandardGravity, 1 * kStandardGravity));
  EXPECT_THAT(hazard.rate, ElementsAre(0.4, 0.03, 5e-4));
  const PublishedHazard today = read(usgs(curve("PGA", "0.1, 0.2, 0.4", "0.02, 0.02, 1e-3")));
  EXPECT_EQ(today.measure, "PGA");
  EXPECT_THAT(today.im, ElementsAre(0.2 * kStandardGravity, 0.4 * kStandardGravity));
  EXPECT_THAT(today.rate, ElementsAre(0.02, 1e-3));
  EXPECT_DOUBLE_EQ(read(usgs(curve("PGV", "1, 2", "0.1, 0.01"))).im[0], 0.01);
}

TEST_F(UsgsHazardTest, OfSeveralMeasuresOneIsNamed) {
  const std::string both =
      usgs(curve("PGA", "1, 2", "0.1, 0.01") + "," + curve("SA1P5", "3, 4", "0.3, 0.02"));
  EXPECT_DOUBLE_EQ(read(both, "Sa(1.5)").im[0], 3 * kStandardGravity);
  EXPECT_ERROR(read(both), "curve.json: has PGA, Sa(1.5): measure must be given");
  EXPECT_ERROR(read(both, "PGV"), "measure = PGV: the file has PGA, Sa(1.5)");
}

TEST_F(UsgsHazardTest, WhatIsWrongHasItsPlace) {
  EXPECT_ERROR(read("{}"), "is no answer of the hazard service of the USGS: it has no 'response'");
  EXPECT_ERROR(read(R"({"status": "error", "message": "no such site"})"), "but: no such site");
  EXPECT_ERROR(read(usgs(curve("AI", "1, 2", "0.1, 0.01"))),
               "curve.json:/response/hazardCurves/0/imt/value: 'AI': must be PGA, PGV or SA");
  EXPECT_ERROR(read(usgs(curve("PGA", "1, 1", "0.1, 0.01"))),
               "/hazardCurves/0/data/1/values/xs/1: 1: levels must be > 0 and increase");
  EXPECT_ERROR(read(usgs(curve("PGA", "1, 2", "0.1, 0.2"))),
               "/hazardCurves/0/data/1/values/ys/1: 0.2: must be a rate >= 0, and not above");
  EXPECT_ERROR(read(usgs(curve("PGA", "1, 2", "0.1"))), "values/ys: has 1 values for 2 levels");
  EXPECT_ERROR(read(usgs(curve("PGA", "1, 2", "0.1, 0"))), "fewer than two levels");
  EXPECT_ERROR(read(R"({"response": {"hazardCurves": [{"imt": 3, "data": []}]}})"),
               "/response/hazardCurves/0/data: no component is 'Total'");
  EXPECT_ERROR(read(R"({"response": {"disaggs": []}})"), "is a disaggregation");
  EXPECT_ERROR(read(R"({"response": [{"metadata": {}, "data": [{"component": "Total",
      "summary": []}]}]})"),
               "--target \"disaggregation file=FILE\"");
}

TEST_F(UsgsHazardTest, IsNamedByAFileWithItsComponent) {
  folder_.write("curve.json", kBefore);
  const auto site = [&](const std::string& keys) {
    return read_hazard_file(
        folder_.write("site.toml", "schema = \"gurney-hazard/1\"\nusgs = \"curve.json\"\n" + keys));
  };
  EXPECT_EQ(site("component = \"RotD50\"\n").measure, "Sa(0.2) RotD50");
  EXPECT_DOUBLE_EQ(*site("measure = \"Sa(0.2)\"").curve.rate(0.1 * kStandardGravity), 0.03);
  EXPECT_ERROR(site("measure = \"PGA\""), "curve.json: measure = PGA: the file has Sa(0.2)");
  EXPECT_ERROR(site("unit = \"g\""), "site.toml:3:8: unit: the file named by usgs states it");
  EXPECT_ERROR(read_hazard_file(folder_.write("curve.json", kBefore)), "usgs = \"curve.json\"");
}

}  // namespace
}  // namespace gurney::study
