#include "groundmotions/scaling/target_spectrum.h"

#include <gmock/gmock.h>

#include <cmath>

#include "engine/base/units.h"
#include "tests/support/expect_error.h"

namespace gurney::groundmotions {
namespace {

constexpr double kG = kStandardGravity;

TEST(Asce7Spectrum, HasItsFourBranches) {
  const TargetSpectrum s = asce7_spectrum(1.0 * kG, 0.6 * kG, 8);
  EXPECT_NEAR(s.at(0), 0.4 * kG, 1e-12);
  EXPECT_NEAR(s.at(0.06), 0.7 * kG, 1e-12);  // half of T_0 = 0.12 s
  for (const double t : {0.12, 0.3, 0.6}) EXPECT_NEAR(s.at(t), kG, 1e-12);
  EXPECT_NEAR(s.at(1), 0.6 * kG, 1e-12);
  EXPECT_NEAR(s.at(8), 0.075 * kG, 1e-12);
  EXPECT_NEAR(s.at(16), 0.6 * 8 / 256 * kG, 1e-12);
  EXPECT_EQ(s.name, "ASCE 7, S_DS 1 g, S_D1 0.6 g, T_L 8 s");
  EXPECT_DOUBLE_EQ(asce7_spectrum(kG, 8 * kG, 8).at(8), kG) << "T_S is T_L";
  EXPECT_ERROR(asce7_spectrum(kG, 0, 8), "both must be > 0 and T_L at least S_D1 / S_DS");
  EXPECT_ERROR(s.at(-1), "is not defined at -1 s, only from 0 to inf s");
}

TEST(Eurocode8Spectrum, HasItsFourBranches) {
  const TargetSpectrum s = eurocode8_spectrum({.ground = 'B', .ground_acceleration = 2.5});
  EXPECT_NEAR(s.at(0), 1.2 * 2.5, 1e-12);  // a_g S
  EXPECT_NEAR(s.at(0.075), 1.2 * 2.5 * 1.75, 1e-12);
  for (const double t : {0.15, 0.3, 0.5}) EXPECT_NEAR(s.at(t), 1.2 * 2.5 * 2.5, 1e-12);
  EXPECT_NEAR(s.at(1), 1.2 * 2.5 * 2.5 * 0.5, 1e-12);
  EXPECT_NEAR(s.at(4), 1.2 * 2.5 * 2.5 * 0.5 * 2 / 16, 1e-12);
  EXPECT_ERROR(s.at(4.1),
               "Eurocode 8 type 1, ground B, a_g 0.2549 g: is not "
               "defined at 4.1 s, only from 0 to 4 s");
}

// Plateau S * 2.5, half of the way to it, and its end, as tables 3.2 and 3.3 have them; beyond T_D as 1 / T^2.
TEST(Eurocode8Spectrum, HasTheValuesOfItsTables) {
  const double soil[2][5] = {{1.0, 1.2, 1.15, 1.35, 1.4}, {1.0, 1.35, 1.5, 1.8, 1.6}};
  const double tb[2][5] = {{0.15, 0.15, 0.2, 0.2, 0.15}, {0.05, 0.05, 0.1, 0.1, 0.05}};
  const double tc[2][5] = {{0.4, 0.5, 0.6, 0.8, 0.5}, {0.25, 0.25, 0.25, 0.3, 0.25}};
  const double td[2] = {2, 1.2};
  for (int type = 1; type <= 2; ++type)
    for (int k = 0; k < 5; ++k) {
      const TargetSpectrum s = eurocode8_spectrum(
          {.type = type, .ground = static_cast<char>('A' + k), .ground_acceleration = 1});
      EXPECT_NEAR(s.at(tb[type - 1][k] / 2), 1.75 * soil[type - 1][k], 1e-12);
      EXPECT_NEAR(s.at(tb[type - 1][k]), 2.5 * soil[type - 1][k], 1e-12);
      EXPECT_NEAR(s.at(tc[type - 1][k]), 2.5 * soil[type - 1][k], 1e-12);
      EXPECT_NEAR(s.at(1), 2.5 * soil[type - 1][k] * tc[type - 1][k], 1e-12);
      EXPECT_NEAR(s.at(3), 2.5 * soil[type - 1][k] * tc[type - 1][k] * td[type - 1] / 9, 1e-12);
    }
}

TEST(Eurocode8Spectrum, CorrectsForDampingAndDirection) {
  const TargetSpectrum damped = eurocode8_spectrum({.ground_acceleration = 1, .damping = 0.1});
  EXPECT_NEAR(damped.at(0.3), 2.5 * std::sqrt(10 / 15.), 1e-12);
  EXPECT_NEAR(damped.at(0), 1, 1e-12);
  EXPECT_EQ(damped.damping, 0.1);  // for the spectra of the records
  EXPECT_EQ(asce7_spectrum(kG, kG, 8).damping, 0.05);
  const TargetSpectrum limited = eurocode8_spectrum({.ground_acceleration = 1, .damping = 0.5});
  EXPECT_NEAR(limited.at(0.3), 2.5 * 0.55, 1e-12);
  const TargetSpectrum up =
      eurocode8_spectrum({.type = 2, .ground = 'D', .ground_acceleration = 1, .vertical = true});
  EXPECT_NEAR(up.at(0.1), 0.45 * 3, 1e-12);
  EXPECT_NEAR(up.at(0.3), 0.45 * 3 * 0.5, 1e-12);
  EXPECT_ERROR(eurocode8_spectrum({.ground = 'F', .ground_acceleration = 1}),
               "ground type 'F': must be A, B, C, D or E");
  EXPECT_ERROR(eurocode8_spectrum({.type = 3, .ground_acceleration = 1}), "type 3: must be 1 or 2");
  EXPECT_ERROR(eurocode8_spectrum({.ground_acceleration = 1, .damping = 1}),
               "damping 1: a_g must be > 0, damping > 0 and < 1");
}

// Table 3.1 of NZS 1170.5:2004 has two decimals: half a unit of the last.
TEST(Nzs1170Spectrum, HasTheValuesOfTable3_1) {
  const double periods[] = {0,   0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8,
                            0.9, 1.0, 1.5, 2.0, 2.5, 3.0, 3.5, 4.0, 4.5};
  const double rock[] = {1.00, 2.35, 2.35, 2.35, 1.89, 1.60, 1.40, 1.24, 1.12,
                         1.03, 0.95, 0.70, 0.53, 0.42, 0.35, 0.26, 0.20, 0.16};
  const double shallow[] = {1.33, 2.93, 2.93, 2.93, 2.36, 2.00, 1.74, 1.55, 1.41,
                            1.29, 1.19, 0.88, 0.66, 0.53, 0.44, 0.32, 0.25, 0.20};
  const double deep[] = {1.12, 3.00, 3.00, 3.00, 3.00, 3.00, 2.84, 2.53, 2.29,
                         2.09, 1.93, 1.43, 1.07, 0.86, 0.71, 0.52, 0.40, 0.32};
  const double soft[] = {1.12, 3.00, 3.00, 3.00, 3.00, 3.00, 3.00, 3.00, 3.00,
                         3.00, 3.00, 2.21, 1.66, 1.33, 1.11, 0.81, 0.62, 0.49};
  const double* const tables[] = {rock, rock, shallow, deep, soft};
  for (int k = 0; k < 5; ++k) {
    const TargetSpectrum s =
        nzs1170_spectrum({.site_class = static_cast<char>('A' + k), .hazard = 0.4});
    for (int i = 0; i < 18; ++i)
      EXPECT_NEAR(s.at(periods[i]) / (0.4 * kG), tables[k][i], 0.005 + 1e-9)
          << s.name << " " << periods[i];
  }
}

TEST(Nzs1170Spectrum, GrowsNearFaultsAndIsLimited) {
  const auto at = [](double period, double distance, double return_period) {
    const Nzs1170 here{.site_class = 'C',
                       .hazard = 0.4,
                       .return_period = return_period,
                       .fault_distance = distance};
    Nzs1170 away = here;
    away.fault_distance = 50;
    return nzs1170_spectrum(here).at(period) / nzs1170_spectrum(away).at(period);
  };
  // Table 3.7: 1, 1.12, 1.36, 1.60, 1.72 at 1.5, 2, 3, 4, 5 s.
  EXPECT_NEAR(at(1.5, 2, 1), 1, 1e-12);
  EXPECT_NEAR(at(2, 2, 1), 1.12, 1e-12);
  EXPECT_NEAR(at(3, 1, 1), 1.36, 1e-12);
  EXPECT_NEAR(at(4, 2, 1), 1.60, 1e-12);
  EXPECT_NEAR(at(5, 2, 1), 1.72, 1e-12);
  EXPECT_NEAR(at(8, 2, 1), 1.72, 1e-12);
  EXPECT_NEAR(at(3, 11, 1), 1.18, 1e-12);
  EXPECT_NEAR(at(3, 11, 0.75), 1, 1e-12);
  const TargetSpectrum strong =
      nzs1170_spectrum({.site_class = 'C', .hazard = 0.6, .return_period = 1.8});
  EXPECT_NEAR(strong.at(0.2), 2.93 * 0.7 * kG, 1e-9);
  EXPECT_ERROR(nzs1170_spectrum({.site_class = 'F', .hazard = 0.4}),
               "site subsoil class 'F': must be A, B, C, D or E");
  for (const Nzs1170& wrong : {Nzs1170{.site_class = 'C', .hazard = 0},
                               {.site_class = 'C', .hazard = 0.4, .return_period = 0},
                               {.site_class = 'C', .hazard = 0.4, .fault_distance = -1}})
    EXPECT_ERROR(nzs1170_spectrum(wrong), "Z and R must be > 0, D >= 0");
}

TEST(Ac156Spectrum, IsThatOfItsFrequencies) {
  const TargetSpectrum s = ac156_spectrum(kG, 0.5, false);
  EXPECT_NEAR(s.at(0), 0.8 * kG, 1e-12);
  EXPECT_NEAR(s.at(1 / 5.), 1.6 * kG, 1e-12);
  EXPECT_NEAR(ac156_spectrum(kG, 0.5, true).at(0.2), 0.67 * kG, 1e-12);
  EXPECT_ERROR(ac156_spectrum(kG, 1.5, false), "z/h in 0..1");
}

TEST(TableSpectrum, IsStraightInLogarithms) {
  const SourceFile file("target.csv",
                        "# invented\nperiod_s, sa_g\n0, 0.4\n0.1, 1.0\n0.4, 1.0\n1.6, 0.25\n");
  const TargetSpectrum s = table_spectrum(file);
  EXPECT_NEAR(s.at(0.05), 0.7 * kG, 1e-12);
  EXPECT_NEAR(s.at(0.2), 1.0 * kG, 1e-12);
  EXPECT_NEAR(s.at(0.8), 0.5 * kG, 1e-12);
  EXPECT_NEAR(s.at(1.6), 0.25 * kG, 1e-12);
  EXPECT_ERROR(s.at(2), "table target.csv: is not defined at 2 s, only from 0 to 1.6 s");
  const SourceFile si("target.csv", "period_s,sa_m_per_s2\n0.1,3\n1,2\n");
  EXPECT_NEAR(table_spectrum(si).at(0.1), 3, 1e-12);
}

TEST(TableSpectrum, ReportsAllErrors) {
  EXPECT_ERROR(table_spectrum(SourceFile("t.csv", "period_s, sa\n0.1, 1\n")),
               "t.csv:1:1: header 'period_s, sa': must be 'period_s, sa_g' or");
  const SourceFile bad("t.csv", "period_s, sa_g\n0.2, 1\n0.1, 1\n0.3, x\n0.4, 0\n0.5\n");
  EXPECT_ERROR(table_spectrum(bad), "t.csv:3:1: period 0.1 s: must be >= 0 and grow");
  EXPECT_ERROR(table_spectrum(bad), "t.csv:4:6: sa_g 'x': must be a number");
  EXPECT_ERROR(table_spectrum(bad), "t.csv:5:1: spectral acceleration 0: must be > 0");
  EXPECT_ERROR(table_spectrum(bad), "t.csv:6:1: 1 cells, the header has 2 columns");
  EXPECT_ERROR(table_spectrum(SourceFile("t.csv", "period_s, sa_g\n0.2, 1\n")),
               "needs a header 'period_s, sa_g' and at least two rows");
}

TEST(TableSpectrum, MayHaveSigma) {
  const SourceFile file("t.csv", "period_s, sa_g, sigma_ln\n0.1, 1, 0.4\n1.6, 0.25, 0.8\n");
  const TargetSpectrum s = table_spectrum(file);
  EXPECT_NEAR(s.at(0.4), 0.5 * kG, 1e-12);
  EXPECT_NEAR(s.sigma(0.4), 0.6, 1e-12);  // half way in ln T
  EXPECT_NEAR(s.sigma(1.6), 0.8, 1e-12);
  EXPECT_FALSE(table_spectrum(SourceFile("t.csv", "period_s, sa_g\n0.1, 1\n1, 1\n")).sigma);
  EXPECT_ERROR(table_spectrum(SourceFile("t.csv", "period_s, sa_g, sigma\n0.1, 1, 1\n")),
               "t.csv:1:1: header 'period_s, sa_g, sigma': must be");
  const SourceFile bad("t.csv", "period_s, sa_g, sigma_ln\n0.1, 1, -1\n0.2, 1, 1\n");
  EXPECT_ERROR(table_spectrum(bad), "t.csv:2:1: sigma -1: must be >= 0");
}

TEST(OpenQuakeSpectrum, IsThatOfOneProbability) {
  const std::string text =
      "#,,,,\"generated_by='OpenQuake engine 3.17.0'\"\npoe,stat,period,mea,std\n"
      "1.00000E-01,mean,1.00000E-01,4.00000E-01,3.00000E-01\n"
      "1.00000E-01,mean,1.00000E+00,1.00000E-01,0.00000E+00\n"
      "2.00000E-02,mean,1.00000E-01,8.00000E-01,3.00000E-01\n"
      "2.00000E-02,quantile-0.5,1.00000E-01,7.00000E-01,3.00000E-01\n"
      "2.00000E-02,mean,1.00000E+00,2.00000E-01,1.00000E-01\n";
  const SourceFile file("cs.csv", text);
  const TargetSpectrum s = openquake_spectrum(file, 0.02);
  EXPECT_NEAR(s.at(0.1), 0.8 * kG, 1e-12);
  EXPECT_NEAR(s.at(std::sqrt(0.1)), 0.4 * kG, 1e-12);
  EXPECT_NEAR(s.sigma(std::sqrt(0.1)), 0.2, 1e-12);
  EXPECT_EQ(s.name, "OpenQuake cs.csv, poe 0.02");
  EXPECT_ERROR(openquake_spectrum(file), "cs.csv: poe is not stated: must be one of 0.02, 0.1");
  EXPECT_ERROR(openquake_spectrum(file, 0.5), "cs.csv: poe 0.5: must be one of 0.02, 0.1");
  const SourceFile one("cs.csv", text.substr(0, text.find("2.00000E-02")));
  EXPECT_NEAR(openquake_spectrum(one).at(1), 0.1 * kG, 1e-12);
  EXPECT_ERROR(openquake_spectrum(SourceFile("cs.csv", "period_s, sa_g\n0.1, 1\n")),
               "cs.csv:1:1: header: must be 'poe,stat,period,mea,std'");
}

}  // namespace
}  // namespace gurney::groundmotions
