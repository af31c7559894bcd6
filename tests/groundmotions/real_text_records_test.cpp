#include <gmock/gmock.h>

#include <map>

#include "engine/base/units.h"
#include "tests/groundmotions/real_records.h"
#include "tests/support/error_text.h"

namespace gurney {
namespace {

using testing::Contains;
using testing::HasSubstr;

using RealTextRecords = RealRecords;

TEST_F(RealTextRecords, ReadsEveryAt2FileAndRefusesVelocities) {
  std::size_t count = 0;
  for (const char* folder : {"peer_nga_at2", "at2_variants"})
    for (const std::string& file : files(folder)) {
      const auto rows = references(file + ",");
      if (file.ends_with("AT2") || file.ends_with("at2")) {
        ASSERT_EQ(rows.size(), 1u) << file;
        expect_reference(rows[0]);
        ++count;
      } else {
        EXPECT_THAT(error_text([&] { read_components(folder_ / file); }),
                    HasSubstr("a record must be acceleration, but this is a "))
            << file;
      }
    }
  EXPECT_GT(count, 30u);
}

TEST_F(RealTextRecords, ReadsEveryKnetAndKiknetFile) {
  std::size_t count = 0;
  for (const char* folder : {"knet/", "kiknet/"})
    for (const Reference& row : references(folder)) {
      expect_reference(row);
      const Component component = read_components(folder_ / row.file)[0];
      EXPECT_TRUE(component.warnings.empty()) << row.file << ": " << component.warnings[0];
      EXPECT_TRUE(row.file.ends_with(component.name)) << component.name;
      EXPECT_EQ(component.direction == Direction::kVertical, component.name.starts_with("UD"));
      EXPECT_EQ(component.azimuth.value_or(-1), component.name.starts_with("NS") ? 0
                                                : component.name.starts_with("EW")
                                                    ? 90 * kRadiansPerDegree
                                                    : -1);
      ++count;
    }
  EXPECT_EQ(count, files("knet").size() + files("kiknet").size());
}

TEST_F(RealTextRecords, ReadsEsmAndItaca) {
  for (const char* folder : {"esm_asc", "itaca_cor_acc"})
    for (const std::string& file : files(folder)) {
      const auto rows = references(file + ",");
      if (file.ends_with(".rs")) {
        EXPECT_THAT(error_text([&] { read_components(folder_ / file); }),
                    HasSubstr("a record must be an acceleration history, but the header speaks of "
                              "'psa'"));
      } else if (file.ends_with(".metadata")) {
        EXPECT_THAT(error_text([&] { read_components(folder_ / file); }),
                    HasSubstr("not a record in a known format"));
      } else {
        ASSERT_EQ(rows.size(), 1u) << file;
        expect_reference(rows[0]);
        const Component component = read_components(folder_ / file)[0];
        EXPECT_TRUE(component.warnings.empty()) << file << ": " << component.warnings[0];
        EXPECT_TRUE(component.azimuth || component.direction == Direction::kVertical) << file;
      }
    }
}

TEST_F(RealTextRecords, ReadsEmod3dInTheUnitOfTheUser) {
  for (const std::string& file : files("ucgmsim_emod3d_text")) {
    if (file.ends_with(".csv")) {
      EXPECT_THAT(error_text([&] { read_components(folder_ / file, {.unit = "g"}); }),
                  HasSubstr("the header speaks of 'psa'"));
      continue;
    }
    const auto rows = references(file + ",");
    ASSERT_EQ(rows.size(), 1u) << file;
    expect_reference(rows[0], {.unit = "g"});
    EXPECT_THAT(error_text([&] { read_components(folder_ / file); }),
                HasSubstr("the file does not state its unit"));
  }
}

TEST_F(RealTextRecords, ReadsBbpAndSeesACopiedComponent) {
  for (const char* file : {"bbp/2002-SYL.bbp", "bbp/ce22170.bbp"}) {
    const auto components = read_components(folder_ / file);
    ASSERT_EQ(components.size(), 3u);
    const auto rows = references(file);
    ASSERT_EQ(rows.size(), 3u);
    for (std::size_t k = 0; k < 3; ++k) {
      EXPECT_EQ(components[k].name, rows[k].component);
      expect_values(rows[k], components[k]);
    }
  }
  EXPECT_THAT(read_components(folder_ / "bbp/2002-SYL.bbp")[2].warnings,
              Contains(HasSubstr("component U-D has exactly the samples of N-S")));
  EXPECT_THAT(error_text([&] { read_components(folder_ / "bbp/2002-SYL.rd50"); }),
              HasSubstr("the header speaks of 'psa'"));
}

/// What the user has to state for the files of plain_text that have reference values.
const std::map<std::string, ReadOptions> kPlain = {
    {"IELC180.acc", {.unit = "g", .time_step = 0.01}},
    {"ARL360_5col_crlf.g3", {.unit = "g", .time_step = 0.02, .columns = "samples"}},
    {"ARL360_misnamed_is_elcentro.g3", {.unit = "g", .time_step = 0.02, .columns = "samples"}},
    {"elCentro.dat", {.unit = "g", .time_step = 0.02, .columns = "samples"}},
    {"BM68elc.acc", {.unit = "g", .time_step = 0.01, .columns = "samples"}},
    {"Northridge.dat", {}},
    {"Sample GM - ElCentro.txt", {.unit = "g"}},
    {"ChiChi.dat", {.unit = "m/s2"}},
    {"Christchurch2011HVPS_UP.dat", {.unit = "m/s2"}},
    {"Northridge_Sylmar_County.dat", {.unit = "m/s2"}},
    {"elcentro_NS_full.dat", {.unit = "g"}},
    {"SanSalvador1986GIC090.txt", {.unit = "m/s2"}},
    {"eqsig_test_motion_dt0p01.txt", {.unit = "m/s2"}},
};

TEST_F(RealTextRecords, ReadsPlainText) {
  for (const auto& [name, options] : kPlain) {
    const auto rows = references("plain_text/" + name + ",");
    ASSERT_EQ(rows.size(), 1u) << name;
    expect_reference(rows[0], options);
  }
}

// A body of K-NET without its header. The reference takes the mean off.
TEST_F(RealTextRecords, ReadsBareCounts) {
  const auto row = references("plain_text/sample-MYG0041103111446.NS.csv").at(0);
  Component component = read_components(
      folder_ / row.file,
      {.time_step = 0.01, .si_per_count = 39.20 / 6182761, .columns = "samples"})[0];
  component.acceleration.array() -= component.acceleration.mean();
  expect_values(row, component);
  EXPECT_EQ(component.unit, "counts");
}

// Velocities that do not say so, and samples of an unknown unit: all that can be checked is that
// the reader takes the rows.
TEST_F(RealTextRecords, ReadsUnlabelledPlainText) {
  for (const char* name : {"ImperialValleyElCentroArray4.txt", "RSN1063_NORTHR_RRS228.txt"}) {
    const auto components = read_components(folder_ / "plain_text" / name, {.unit = "m/s2"});
    ASSERT_EQ(components.size(), 1u);
    EXPECT_GT(components[0].acceleration.size(), 1900);
  }
  for (const char* name : {"record01.txt", "rrsmv1_1.txt"})
    EXPECT_GT(read_components(folder_ / "plain_text" / name, {.unit = "g", .time_step = 0.01})[0]
                  .acceleration.size(),
              2000);
}

TEST_F(RealTextRecords, AsksForWhatPlainTextDoesNotState) {
  EXPECT_THAT(error_text([&] { read_components(folder_ / "plain_text/BM68elc.acc"); }),
              testing::AllOf(HasSubstr("BM68elc.acc:1:1: 5 numbers in a row, and the first is no "
                                       "time that grows from row to row; state columns"),
                             HasSubstr("the file does not state its unit"),
                             HasSubstr("the file does not state its time step")));
  EXPECT_EQ(kPlain.size() + 5, files("plain_text").size());
}

TEST_F(RealTextRecords, ReadsTheSetsOfFemaP695) {
  std::size_t count = 0;
  for (const Reference& row : references("fema_p695_text/")) {
    const bool table = row.file.ends_with(".txt");
    expect_reference(
        row, {.unit = "g", .time_step = table ? std::nullopt : std::optional(row.time_step)});
    ++count;
  }
  EXPECT_EQ(count + 2, files("fema_p695_text").size());
  for (const char* name : {"GM Data.txt", "MetaData.txt"})
    EXPECT_THAT(error_text([&] { read_components(folder_ / "fema_p695_text" / name); }),
                HasSubstr("not a record in a known format"));
}

// Whatever the user states, the text readers leave the files of other layouts alone. Those of CWB
// are plain tables with times indeed.
TEST_F(RealTextRecords, TakesNoOtherLayoutForOneOfOurs) {
  const std::vector<std::string> ours = {"K-NET", "ESM",    "SIMBAD",      "PEER AT2",
                                         "BBP",   "EMOD3D", "columns CSV", "plain text"};
  std::size_t count = 0;
  for (const char* folder :
       {"cosmos", "csmip_v1_v2_v3", "geonet_v1a_v2a", "miniseed", "other_networks", "sac",
        "usc_volume", "usgs_smc", "published_reference"})
    for (const std::string& file : files(folder))
      for (const char* columns : {"", "samples", "time,h1"}) {
        ++count;
        if (file == "other_networks/1-EAS.dat") continue;
        try {
          const auto components =
              read_components(folder_ / file, {.unit = "g", .time_step = 0.01, .columns = columns});
          EXPECT_THAT(ours, testing::Not(Contains(components[0].format))) << file;
        } catch (const Error&) {
        }
      }
  EXPECT_GT(count, 80u);
}

}  // namespace
}  // namespace gurney
