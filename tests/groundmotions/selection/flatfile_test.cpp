#include "groundmotions/selection/flatfile.h"

#include <gmock/gmock.h>

#include <cmath>

#include "engine/base/units.h"
#include "groundmotions/scaling/target_spectrum.h"
#include "tests/support/error_text.h"
#include "tests/support/expect_error.h"

namespace gurney::groundmotions {
namespace {

const std::string kHeader =
    "Record Sequence Number,Earthquake Name,Station Name,File Name (Horizontal 1),File Name "
    "(Horizontal 2),File Name (Vertical),Lowest Usable Freq - Ave. Component (Hz),PGA "
    "(g),T0.100S,T0.400S,T1.600S\n";
const Eigen::VectorXd kPeriods{{0.1, 0.2, 1.6}};

TEST(Flatfile, IsRecognisedByItsHeader) {
  EXPECT_TRUE(recognises_flatfile(SourceFile("f.csv", kHeader)));
  EXPECT_FALSE(recognises_flatfile(SourceFile("f.csv", "Record Sequence Number,PGA (g)\n")));
  EXPECT_FALSE(recognises_flatfile(SourceFile("f.csv", "name,file\n")));
}

TEST(Flatfile, HasRecordsAndTheirSpectra) {
  const SourceFile file("data/f.csv", kHeader +
                                          "1063,Northridge-01,\"Rinaldi, Sta\",NORTHR\\RRS228.AT2,"
                                          "NORTHR\\RRS318.AT2,-999,0.1,0.9,2,8,0.25\n"
                                          "2,A,B,x.AT2,y.AT2,z.AT2,0.1,0.1,-999,-999,-999\n");
  const Flatfile f = read_flatfile(file, kPeriods);
  ASSERT_EQ(f.suite.records.size(), 1u);
  const SuiteRecord& record = f.suite.records[0];
  EXPECT_EQ(record.name, "RSN1063");
  ASSERT_EQ(record.files.size(), 2u);  // no vertical
  EXPECT_EQ(record.files[0].path, "data/RSN1063_NORTHR_RRS228.AT2");
  EXPECT_THAT(record.facts,
              testing::ElementsAre(testing::Pair("event", "Northridge-01"),
                                   testing::Pair("station", "Rinaldi, Sta"),
                                   testing::Pair("lowest usable frequency [Hz]", "0.1")));
  const double ln_g = std::log(kStandardGravity);
  EXPECT_NEAR(f.ln_spectra(0, 0), ln_g + std::log(2.), 1e-12);
  EXPECT_NEAR(f.ln_spectra(0, 1), ln_g + std::log(4.), 1e-12);  // half way in ln T
  EXPECT_NEAR(f.ln_spectra(0, 2), ln_g + std::log(0.25), 1e-12);
  EXPECT_THAT(f.suite.notes, testing::ElementsAre(testing::HasSubstr(
                                 "1 records without a spectrum at the periods are excluded")));
}

TEST(Flatfile, ReportsAllErrors) {
  const std::string bad = kHeader + "1,A,B,x,y,z,0.1,0.1,1,4,one\n2,A\n";
  EXPECT_ERROR(read_flatfile(SourceFile("f.csv", bad), kPeriods),
               "f.csv:2:25: Sa 'one': must be a number [g]");
  // Three periods need that cell.
  EXPECT_EQ(error_text([&] {
              read_flatfile(SourceFile("f.csv", bad), Eigen::VectorXd{{0.9, 1.1, 1.3}});
            }),
            "f.csv:2:25: Sa 'one': must be a number [g]\n"
            "f.csv:3:1: 2 cells, the header has 11 columns");
  EXPECT_ERROR(read_flatfile(SourceFile("f.csv", bad), kPeriods),
               "f.csv:3:1: 2 cells, the header has 11 columns");
  EXPECT_ERROR(read_flatfile(SourceFile("f.csv", "Record Sequence Number,T0.1S\n"), kPeriods),
               "f.csv:1:1: no column 'File Name (Horizontal 1)'");
  EXPECT_ERROR(read_flatfile(SourceFile("f.csv", kHeader), Eigen::VectorXd{{0.1, 2}}),
               "f.csv: spectra from 0.1 to 1.6 s, needed from 0.1 to 2 s");
  EXPECT_ERROR(read_flatfile(SourceFile("f.csv", kHeader), kPeriods),
               "f.csv: no record has a spectrum at the periods");
}

}  // namespace
}  // namespace gurney::groundmotions
