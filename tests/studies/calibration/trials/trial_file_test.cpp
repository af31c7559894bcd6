#include "studies/calibration/trials/trial_file.h"

#include <gmock/gmock.h>

#include <algorithm>

#include "tests/studies/calibration/trials/synthetic_trial.h"
#include "tests/support/error_text.h"
#include "tests/support/temp_folder.h"

namespace gurney::calibration {
namespace {

using testing::HasSubstr;
using testing::Not;

const char* const kFacts =
    "# schema = gurney-trial/1\n# kind = pull\n# use = validation\n# origin = measured\n"
    "# caster = R100\n# floor = lab floor\n# wheel_diameter_mm = 100\n# mass_kg = 96.5\n"
    "# wheel_inertia_kg_m2 = 0.0003125\n";

TEST(TrialFile, ReadsBackWhatItWrites) {
  const TempFolder folder;
  Trial made = make_pull({});
  made.kind = TrialKind::kCrosswisePull;
  made.setup.tread = "rubber";
  made.setup.payload = 13.6;
  made.setup.drop_mass = 5;
  made.setup.headings = {kRadiansPerDegree * 90};
  made.setup.item = "xu_trolley";
  made.setup.payload_name = "paver";
  made.setup.payload_count = 1;
  made.setup.pull_point = {0.55, 0, 0.14};
  made.signals.yaw.assign(made.signals.time.size(), 0.01);
  const std::string file = folder.write("one.csv", trial_file_text(made, "made by a test"));
  const TrialSet set = read_trials(folder.path());
  ASSERT_EQ(set.trials.size(), 1u);
  const Trial& read = set.trials[0];
  EXPECT_EQ(read.name, "one");
  EXPECT_EQ(read.kind, TrialKind::kCrosswisePull);
  EXPECT_EQ(read.setup.origin, TrialOrigin::kSimulated);
  EXPECT_EQ(read.setup.tread, "rubber");
  EXPECT_EQ(read.setup.drop_mass, 5);
  EXPECT_EQ(read.setup.payload_name, "paver");
  EXPECT_DOUBLE_EQ(read.setup.added_mass, 0.5);
  EXPECT_DOUBLE_EQ(read.setup.headings.at(0), made.setup.headings[0]);
  EXPECT_EQ(read.setup.pull_point, made.setup.pull_point);
  ASSERT_EQ(read.signals.time.size(), made.signals.time.size());
  for (std::size_t i = 0; i < read.signals.time.size(); ++i) {  // half of the last digit written
    EXPECT_NEAR(read.signals.time[i], made.signals.time[i], 0.51e-6);
    EXPECT_NEAR(read.signals.force[i], made.signals.force[i], 0.51e-3);
    EXPECT_NEAR(read.signals.displacement[i], made.signals.displacement[i], 0.51e-7);
    EXPECT_NEAR(read.signals.yaw[i], 0.01, 1e-6);
  }
  EXPECT_THAT(error_text([&] { read_trial_file(file + "x"); }), HasSubstr("no such file"));
}

TEST(TrialFile, ConvertsUnitsAndSkipsWhatASpreadsheetAdds) {
  const TempFolder folder;
  std::string text = std::string("\xEF\xBB\xBF") + kFacts;
  text +=
      "# note = exported,,\r\n\r\ntime_ms,force_kn,acceleration_g,displacement_cm\r\n"
      "0,0.05,0.1,1\r\n10,0.04,,2,\r\n";
  const TrialSet set = read_trial_file(folder.write("a.csv", text));
  const Trial& trial = set.trials.at(0);
  EXPECT_DOUBLE_EQ(trial.setup.added_mass, 4 * 0.0003125 / 0.0025);
  EXPECT_EQ(trial.setup.wheels, 4);
  EXPECT_DOUBLE_EQ(trial.signals.time[1], 0.01);
  EXPECT_DOUBLE_EQ(trial.signals.force[0], 50);
  EXPECT_DOUBLE_EQ(trial.signals.acceleration[0], 0.1 * kStandardGravity);
  EXPECT_TRUE(std::isnan(trial.signals.acceleration[1]));  // a gap, named by the checks
  EXPECT_DOUBLE_EQ(trial.signals.displacement[1], 0.02);
  EXPECT_EQ(trial.lines, (std::vector<int>{13, 14}));
}

TEST(TrialFile, ReportsEveryErrorWithItsPlace) {
  const TempFolder folder;
  const std::string file = folder.write(
      "bad.csv",
      "# schema = gurney-trial/1\n# kind = pul\n# use = calibration\n# origin = measured\n"
      "# caster = R100\n# caster = R125\n# flor = vinyl\n# wheel_diameter_mm = -100\n# mass = "
      "96.5\n"
      "# added_mass_kg = 0.5\nfree text\n");
  const std::string text = error_text([&] { read_trial_file(file); });
  EXPECT_THAT(text, HasSubstr("bad.csv:2:10: kind = \"pul\": unknown; did you mean 'pull'?"));
  EXPECT_THAT(text, HasSubstr("bad.csv:6:3: caster: stands here twice"));
  EXPECT_THAT(text, HasSubstr("bad.csv:7:3: flor: unknown key; did you mean 'floor'?"));
  EXPECT_THAT(text, HasSubstr("bad.csv:1:1: floor: missing"));
  EXPECT_THAT(text, HasSubstr("wheel_diameter_mm = -100: must be a finite number > 0"));
  EXPECT_THAT(text, HasSubstr("bad.csv:9:3: mass: unknown key; did you mean 'mass_kg'?"));
  EXPECT_THAT(text, HasSubstr("bad.csv:11:1: no samples below"));
}

TEST(TrialFile, ComplainsOnceOfAMassThatIsNone) {
  const TempFolder folder;
  const std::string text = error_text([&] {
    read_trial_file(
        folder.write("bad.csv",
                     "# schema = gurney-trial/1\n# kind = start_pull\n# use = calibration\n"
                     "# origin = measured\n# caster = R100\n# floor = vinyl\n# mass_kg = -96.5\n"
                     "# wheels = 3.5\ntime_s,force_n,displacement_mm\n0,1,2\n"));
  });
  EXPECT_THAT(text, HasSubstr("mass_kg = -96.5: must be"));
  EXPECT_THAT(text, Not(HasSubstr("payload_kg")));
  EXPECT_THAT(text, HasSubstr("wheels = 3.5: must be a whole number"));
}

TEST(TrialFile, StopsAtAFileThatIsNoText) {
  const TempFolder folder;
  std::string bytes;
  for (int i = 0; i < 1000; ++i) bytes += std::string("a\x01,b\x02\n");
  const std::string text = error_text([&] { read_trial_file(folder.write("a.csv", bytes)); });
  EXPECT_EQ(std::ranges::count(text, '\n'), 2) << text;
  EXPECT_THAT(text, HasSubstr("a.csv:3:2: a control character; must be text"));
}

TEST(TrialFile, RefusesTwoRowsOfOneName) {
  const TempFolder folder;
  const std::string row = "t01,R100,100,96.5,47.1,0.291,0.195\n";
  const std::string text = error_text([&] {
    read_trial_file(folder.write(
        "t.csv",
        "# schema = gurney-trial-averages/1\n# use = calibration\n# origin = measured\n"
        "# floor = vinyl\n# wheel_inertia_kg_m2 = 0.0003\n"
        "trial,caster,wheel_diameter_mm,mass_kg,pull_force_n,a2_mps2,a3_mps2\n" +
            row + row));
  });
  EXPECT_THAT(text, HasSubstr("t.csv:8:1: trial = \"t01\": line 7 has it already; each row must be "
                              "a trial of its own"));
}

TEST(TrialFile, KnowsWhichWheelsAreLocked) {
  const TempFolder folder;
  Trial made = make_pull({});
  made.kind = TrialKind::kLockedPull;
  made.setup.locked = LockedWheels::kFront;
  made.setup.pull_height = 0.14;
  made.setup.wheelbase = 0.98;
  made.setup.front_share = 0.53;
  made.setup.rolling_ratio = 0.02;
  made.setup.center_height = 0.61;
  const TrialSetup read =
      read_trial_file(folder.write("one.csv", trial_file_text(made, ""))).trials.at(0).setup;
  EXPECT_EQ(read.locked, LockedWheels::kFront);
  EXPECT_DOUBLE_EQ(read.pull_height, 0.14);
  EXPECT_DOUBLE_EQ(read.wheelbase, 0.98);
  EXPECT_EQ(read.front_share, 0.53);
  EXPECT_EQ(read.rolling_ratio, 0.02);
  EXPECT_DOUBLE_EQ(read.center_height.value_or(0), 0.61);
  const std::string facts =
      "# schema = gurney-trial/1\n# kind = locked_pull\n# use = calibration\n"
      "# origin = measured\n# caster = R100\n# floor = vinyl\n# mass_kg = 96.5\n";
  const std::string table = "time_s,force_n,displacement_mm\n0,1,2\n";
  EXPECT_EQ(read_trial_file(folder.write("all.csv", facts + table)).trials.at(0).setup.locked,
            LockedWheels::kAll);
  const std::string bad =
      folder.write("bad.csv", facts + "# locked = reer\n# front_share = 1.5\n" + table);
  const std::string text = error_text([&] { read_trial_file(bad); });
  EXPECT_THAT(text, HasSubstr("bad.csv:8:12: locked = \"reer\": unknown; did you mean 'rear'?"));
  EXPECT_THAT(text, HasSubstr("bad.csv:9:17: front_share = 1.5: must be"));
  const std::string few = folder.write("few.csv", facts + "# locked = rear\n" + table);
  const std::string missing = error_text([&] { read_trial_file(few); });
  for (const char* key : {"pull_height_mm", "wheelbase_mm", "rolling_ratio"})
    EXPECT_THAT(missing, HasSubstr(std::string(key) + ": missing"));
  EXPECT_THAT(error_text([&] {
                read_trial_file(
                    folder.write("pull.csv", std::string(kFacts) + "# locked = rear\n" + table));
              }),
              HasSubstr("pull.csv:10:3: locked: unknown key"));
}

TEST(TrialFile, ReportsErrorsOfTheTable) {
  const TempFolder folder;
  const std::string file = folder.write(
      "bad.csv",
      std::string(kFacts) + "time_s,time_ms,force,speed\n0,0,1,2\n0.1,100,x,2\n0.2,200\n# more\n");
  const std::string text = error_text([&] { read_trial_file(file); });
  EXPECT_THAT(text, HasSubstr("bad.csv:10:8: time_ms: time_s has it already"));
  EXPECT_THAT(text, HasSubstr("bad.csv:10:16: force: unknown column; did you mean 'force_n'?"));
  EXPECT_THAT(text, HasSubstr("speed: unknown column; known: time_s, time_ms, force_n"));
  EXPECT_THAT(text, HasSubstr("bad.csv:10:1: force_n or force_kn: column missing"));
  EXPECT_THAT(text, HasSubstr("displacement_mm (_cm, _m) or acceleration_mps2 (_g): column"));
  EXPECT_THAT(text, HasSubstr("bad.csv:13:1: 2 cells, but 4 columns"));
  EXPECT_THAT(text, HasSubstr("bad.csv:14:1: lines with # stand above"));
  const std::string comma =
      folder.write("comma.csv", std::string(kFacts) + "time_s,force_n,displacement_mm\n0;1,2,3\n");
  EXPECT_THAT(error_text([&] { read_trial_file(comma); }),
              HasSubstr("comma.csv:11:1: time_s = \"0;1\": must be a number; cells are apart by"));
}

TEST(TrialFile, ReadsATableOfAverages) {
  const TempFolder folder;
  const std::string head =
      "# schema = gurney-trial-averages/1\n# use = calibration\n# origin = measured\n"
      "# floor = vinyl\n# added_mass_kg = 0.5\n";
  const std::string columns =
      "trial,caster,wheel_diameter_mm,mass_kg,pull_force_n,a2_mps2,a3_mps2\n";
  const TrialSet set =
      read_trial_file(folder.write("a.csv", head + columns + "t1,R100,100,96.5,47,0.29,0.19\n"));
  const TrialAverages& a = set.averages.at(0);
  EXPECT_EQ(a.name, "t1");
  EXPECT_EQ(a.line, 7);
  EXPECT_EQ(a.setup.caster, "R100");
  EXPECT_EQ(a.setup.floor, "vinyl");
  EXPECT_DOUBLE_EQ(a.setup.wheel_radius, 0.05);
  EXPECT_EQ(a.coast_deceleration, 0.19);
  folder.write("b.csv", head + "tral,a2_mps2\nt2,-1\n");
  folder.write("c.csv", "# schema = gurney-trial-average/1\nx\n1\n");
  const std::string text = error_text([&] { read_trials(folder.path()); });
  EXPECT_THAT(text, HasSubstr("b.csv:6:1: tral: unknown column; did you mean 'trial'?"));
  EXPECT_THAT(text, HasSubstr("b.csv:7:4: a2_mps2 = -1: must be a finite number > 0"));
  EXPECT_THAT(text, HasSubstr("c.csv:1:12: schema = \"gurney-trial-average/1\": unknown; did you"));
}

}  // namespace
}  // namespace gurney::calibration
