#include "groundmotions/formats/header_text.h"

#include <gtest/gtest.h>

namespace gurney::groundmotions {
namespace {

TEST(HeaderText, KnowsTheQuantity) {
  for (const char* line : {"velocity time history in cm/s", "VELOCITY (CM/S)", "VELOCITY HISTORY",
                           "Ground velocity, NS", "# Vel [m/s]"})
    EXPECT_EQ(quantity_in(line), "velocity") << line;
  EXPECT_EQ(quantity_in("DISPLACEMENT TRACE (CM)"), "displacement");
  for (const char* line : {"Accelerogram", "ACC (G)", "acceleration from velocity",
                           "ACCELERATION TIME SERIES IN UNITS OF G"})
    EXPECT_EQ(quantity_in(line), "acceleration") << line;
  for (const char* line : {"shear wave velocity 300 m/s", "Peak velocity: 3 cm/s", "Velma Station",
                           "fault displacement 1 m", "Sampling velocity 200", ""})
    EXPECT_FALSE(quantity_in(line)) << line;
}

TEST(HeaderText, FindsTheUnitOfTheSamples) {
  const std::pair<const char*, const char*> lines[] = {{"Units: cm/s2", "cm/s2"},
                                                       {"# unit = G", "G"},
                                                       {"IN UNITS OF G. FILTER POINTS", "G"},
                                                       {"The units are (g)", "g"},
                                                       {"units: cm / s2, corrected", "cm / s2"},
                                                       {"units: in / s2", "in / s2"},
                                                       {"units are in ft / s2", "ft / s2"},
                                                       {"UNITS=SEC AND G", "G"},
                                                       {"Units: furlongs", "furlongs"},
                                                       {"velocity time history in cm/s", "cm/s"},
                                                       {"Accelerations in g", "g"},
                                                       {"ACCELERATION (CM/SEC**2)", "CM/SEC**2"},
                                                       {"all in gals", "gals"}};
  for (const auto& [line, unit] : lines) EXPECT_EQ(unit_text_in(line), unit) << line;
  for (const char* line : {"PGA = 0.3 g", "Peak 341.7 cm/s2", "Time units: sec",
                           "Roof (g wing of the house)", "depth in m", "Station (m)",
                           "vs30 300 m/s", "Vs30 (m/s): 379", "military unit 5", "G. Rossi", ""})
    EXPECT_FALSE(unit_text_in(line)) << line << unit_text_in(line).value_or("");
}

TEST(HeaderText, FindsTheTimeStep) {
  const std::pair<const char*, double> lines[] = {
      {"dt = 0.02", 0.02},
      {"DT=20 MSEC", 0.02},
      {"DT (sec): .005", 0.005},
      {"Time step [ms] 5", 0.005},
      {"time interval is 0.01 s", 0.01},
      {"Sampling rate: 200 Hz", 0.005},
      {"sampling rate 200", 0.005},
      {"Sampling rate (s): 0.005", 0.005},
      {"Sampling frequency (Hz) = 50", 0.02},
      {"at 200 samples per second", 0.005},
      {"100 sps", 0.01},
      {"NPTS=2000DT=.02", 0.02},
      {"1559 points at equal spacing of 0.02 sec", 0.02}};
  for (const auto& [line, step] : lines) {
    ASSERT_TRUE(time_step_in(line)) << line;
    EXPECT_DOUBLE_EQ(*time_step_in(line), step) << line;
  }
  for (const char* line : {"PDT = 3", "3 May 2001, 12:30", "dt unknown", "time 0.02", ""})
    EXPECT_FALSE(time_step_in(line)) << line;
}

TEST(HeaderText, FindsTheUnitOfTimes) {
  EXPECT_EQ(time_unit_in("Time (ms) Ground Acc (g)"), 1e-3);
  EXPECT_EQ(time_unit_in("time in min, acceleration in g"), 60);
  for (const char* line : {"Origin time (UTC): 3", "Time", "Time in", "Times (ms)"})
    EXPECT_FALSE(time_unit_in(line)) << line;
}

}  // namespace
}  // namespace gurney::groundmotions
