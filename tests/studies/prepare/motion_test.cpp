#include <gmock/gmock.h>

#include <cmath>

#include "engine/base/units.h"
#include "engine/config/document.h"
#include "engine/config/table.h"
#include "groundmotions/measures/combination.h"
#include "studies/job/record_reader.h"
#include "studies/prepare/run_job.h"
#include "tests/support/error_text.h"
#include "tests/support/temp_folder.h"

namespace gurney::study {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

/// The request in the table [excitation] of a job `text` in a folder.
RecordRequest request(const TempFolder& folder, const std::string& text) {
  config::Document document("[excitation]\n" + text, folder.path() + "/job.toml");
  config::Table root = document.root();
  auto excitation = root.table("excitation");
  auto record = read_record_request(*excitation);
  document.finish();
  return *record;
}

/// Five seconds of a sine of 2 m/s2 in h1 and of a cosine of 1 m/s2 in h2, 2.5 Hz: samples meet the
/// peaks. The text has six digits.
std::string record_file(const TempFolder& folder) {
  std::string text = "time_s,x_m_per_s2,y_m_per_s2\n";
  for (int i = 0; i <= 500; ++i) {
    const double phase = 5 * std::acos(-1.0) * 0.01 * i;
    text += std::to_string(0.01 * i) + "," + std::to_string(2 * std::sin(phase)) + "," +
            std::to_string(std::cos(phase)) + "\n";
  }
  return folder.write("r.csv", text);
}

TEST(Motion, NeedsAWordAboutAMissingComponent) {
  const TempFolder folder;
  record_file(folder);
  EXPECT_THAT(error_text([&] { motion_of(request(folder, "record = { file = \"r.csv\" }")); }),
              HasSubstr("job.toml:2:10: record 'r' has no z (vertical) component; state with use"));
  const Motion motion = motion_of(request(folder, "record = { file = \"r.csv\", use = \"xy\" }"));
  EXPECT_NEAR(motion.facts.pga.x(), 2, 1e-3);
  EXPECT_EQ(motion.facts.pga.z(), 0);
}

TEST(Motion, StatesAMissingUnitAndAMissingComponentTogether) {
  const TempFolder folder;
  folder.write("a.csv", "0 1 2\n0.01 -1 -2\n0.02 1 2\n0.03 0 0\n");
  const auto errors = [&](const std::string& more) {
    return error_text([&] {
      motion_of(
          request(folder, "record = { file = \"a.csv\", columns = \"time, h1, h2\"" + more + " }"));
    });
  };
  EXPECT_THAT(errors(""), testing::AllOf(HasSubstr("does not state its unit"),
                                         HasSubstr("has no z (vertical) component")));
  EXPECT_THAT(errors(", use = \"xy\""), testing::Not(HasSubstr("component")));
  EXPECT_THAT(errors(", unit = \"gal\""), testing::Not(HasSubstr("its unit")));
}

TEST(Motion, ScalesToAnIntensityAndSaysSo) {
  const TempFolder folder;
  record_file(folder);
  const Motion motion = motion_of(request(folder, R"(record.file = "r.csv"
record.use = "xy"
record.scale_to = { measure = "PGA", component = "geomean", value = 0.5, unit = "g" }
)"));
  EXPECT_NEAR(std::sqrt(motion.facts.pga.x() * motion.facts.pga.y()), 0.5 * kStandardGravity, 1e-9);
  EXPECT_THAT(motion.facts.processing, ElementsAre(HasSubstr("PGA (geomean)")));
  EXPECT_THAT(motion.facts.components,
              ElementsAre("h1: 'x_m_per_s2' of r.csv", "h2: 'y_m_per_s2' of r.csv"));
}

TEST(Motion, IsProcessedAndTakenThroughABuildingInThisOrder) {
  const TempFolder folder;
  record_file(folder);
  const Motion motion = motion_of(request(folder, R"(record.file = "r.csv"
record.use = "xy"
record.processing = [{ step = "resample", time_step_s = 0.005 }]
record.scale = 2
building = { kind = "shear", storeys = 2, period_s = 0.3, damping_ratio = 0.05, floor = "roof" }
)"));
  EXPECT_THAT(motion.facts.processing,
              ElementsAre(HasSubstr("resampl"), HasSubstr("scaled by 2"), HasSubstr("floor 2"),
                          HasSubstr("of vibration after")));
  EXPECT_GT(motion.floor.duration(), 5.0) << "the building vibrates on";
}

TEST(Motion, CanBeSynthetic) {
  const TempFolder folder;
  const Motion motion = motion_of(
      request(folder, "record.synthetic = { kind = \"ricker\", pga_g = 0.3, period_s = 1 }\n"));
  EXPECT_NEAR(motion.facts.pga.x(), 0.3 * kStandardGravity, 1e-6);
  EXPECT_THAT(motion.facts.name, HasSubstr("synthetic"));
  EXPECT_THAT(motion.facts.files, IsEmpty());
  EXPECT_FALSE(motion.seed);
  EXPECT_THAT(motion.facts.processing,
              ElementsAre("made: ricker, period_s = 1, pga_g = 0.3, time_step_s = 0.005"));
  EXPECT_EQ(
      motion_of(request(folder, "record.synthetic = { kind = \"white_noise\", seed = 7 }\n")).seed,
      7u);
}

TEST(Motion, ReportsTheFileOfItsBuilding) {
  const TempFolder folder;
  record_file(folder);
  folder.write("b.toml",
               "schema = \"gurney-building/1\"\nname = \"b\"\nkind = \"shear\"\nstoreys = 1\n"
               "period_s = 0.3\ndamping_ratio = 0.05\n");
  const Motion motion = motion_of(request(folder,
                                          "record = { file = \"r.csv\", use = \"xy\" }\n"
                                          "building = { file = \"b.toml\", floor = \"roof\" }\n"));
  ASSERT_EQ(motion.facts.files.size(), 2u);
  EXPECT_EQ(motion.facts.files[1].name, "b.toml");
}

TEST(Motion, RefusesTheImplausibleOnlyIfAsked) {
  const TempFolder folder;
  folder.write("x.txt", "100\n-100\n100\n-100\n");
  const std::string job =
      "record = { x = \"x.txt\", unit = \"g\", time_step_s = 0.01, plausibility = ";
  EXPECT_THAT(motion_of(request(folder, job + "\"warn\" }")).warnings,
              testing::Contains(HasSubstr("the peak acceleration of h1 is 100 g")));
  EXPECT_THAT(error_text([&] { motion_of(request(folder, job + "\"refuse\" }")); }),
              HasSubstr("the record is not plausible, and plausibility = \"refuse\":"));
}

TEST(Motion, TakesChannels) {
  const TempFolder folder;
  record_file(folder);
  const Motion motion =
      motion_of(request(folder, "record = { file = \"r.csv\", channels = [0, 2, 0] }"));
  EXPECT_EQ(motion.facts.pga.x(), 0);
  EXPECT_NEAR(motion.facts.pga.y(), 1, 1e-3);
}

TEST(Motion, ExplainsErrorsOfTheRequest) {
  const TempFolder folder;
  record_file(folder);
  const auto error = [&](const std::string& text) {
    return error_text([&] { request(folder, text); });
  };
  EXPECT_THAT(error("record.file = \"r.csv\"\nrecord.scale = 2\n"
                    "record.scale_to = { measure = \"PGX\", value = 1, unit = \"g\" }\n"),
              testing::AllOf(HasSubstr("'PGX': unknown measure; did you mean 'PGA'?"),
                             HasSubstr("scale: must not go with scale_to")));
  EXPECT_THAT(error("record.file = \"r.csv\"\n"
                    "record.scale_to = { measure = \"PGV\", value = 1, unit = \"g\" }\n"),
              HasSubstr("unit = \"g\": must be one of m/s, cm/s"));
  EXPECT_THAT(error("record.file = \"r.csv\"\n"
                    "record.scale_to = { measure = \"D5-95\", value = 1, unit = \"s\" }\n"),
              HasSubstr("a record cannot be scaled to a measure in s"));
  EXPECT_THAT(error("record = { x = \"r.csv\", channels = [1, 0, 0] }\n"),
              HasSubstr("channels: must go with one 'file'"));
  EXPECT_THAT(error("record = { file = \"r.csv\", processing = [{ step = \"high_pas\" }] }\n"),
              HasSubstr("did you mean 'high_pass'?"));
  EXPECT_THAT(error("record = { synthetic = { kind = \"rickr\" } }\n"),
              HasSubstr("did you mean 'ricker'?"));
}

TEST(Motion, FloorsOfABuildingRotate) {
  const TempFolder folder;
  record_file(folder);
  const auto floor = [&](const std::string& more) {
    return motion_of(request(folder, R"(record = { file = "r.csv", use = "xy" }
building = { kind = "shear", storeys = 2, period_s = 0.4, damping_ratio = 0.05, floor = "roof")" +
                                         more + " }"))
        .floor;
  };
  const FloorMotion level = floor("");
  const FloorMotion rotating = floor(", floor_rotation = { height_m = 8, bending_share = 0.5 }");
  EXPECT_FALSE(level.rotates());
  ASSERT_TRUE(rotating.rotates());
  EXPECT_EQ(rotating.acceleration(), level.acceleration());
  // Towards x twice as far as towards y, as the record.
  const Vector3 peak = rotating.rotation().angle.cwiseAbs().rowwise().maxCoeff();
  EXPECT_NEAR(peak.y() / peak.x(), 2, 0.1);
}

}  // namespace
}  // namespace gurney::study
