#include "groundmotions/measures/measure.h"

#include <gmock/gmock.h>

#include <cmath>

#include "engine/base/units.h"
#include "groundmotions/measures/fiv3.h"
#include "groundmotions/measures/response_spectrum.h"
#include "tests/support/error_text.h"

namespace gurney::groundmotions {
namespace {

using Eigen::VectorXd;
using testing::AllOf;
using testing::HasSubstr;

VectorXd motion() {
  VectorXd a(1000);
  for (int i = 0; i < a.size(); ++i)
    a[i] = std::sin(0.11 * i) * std::exp(-0.002 * i) + std::cos(0.0007 * i * i);
  return a;
}

TEST(Measure, IsWrittenAsItIsRead) {
  for (const char* text :
       {"PGA", "PGV", "PGD", "PFA", "PFV", "Arias", "CAV", "D5-75", "D5-95", "Tm", "Tp", "SI",
        "Sa(1)", "Sa(0)", "Sa(0.25, 2%)", "SaAvg(1.5)", "SaAvg(0.2:3)", "SaAvg(1, 10%)", "FIV3(1)"})
    EXPECT_EQ(name_of(parse_measure(text)), text);
}

TEST(Measure, MindsNeitherCaseNorBlanks) {
  EXPECT_EQ(name_of(parse_measure(" sa ( 1.0 , 0.02 ) ")), "Sa(1, 2%)");
  EXPECT_EQ(name_of(parse_measure("pga")), "PGA");
}

std::string error(const char* text) {
  return error_text([&] { parse_measure(text); });
}

TEST(Measure, ReportsWhatIsWrong) {
  EXPECT_EQ(error("Sa1.0"), "measure 'Sa1.0': the period stands in brackets: Sa(1.0)");
  EXPECT_EQ(error("Aria"), "measure 'Aria': unknown measure; did you mean 'Arias'?");
  EXPECT_THAT(error("magnitude"), AllOf(HasSubstr("'magnitude': unknown measure; known: PGA, PGV"),
                                        HasSubstr("SaAvg")));
  EXPECT_EQ(error("Sa"), "measure 'Sa': a period in seconds is needed, as in Sa(1.0)");
  EXPECT_EQ(error("Sa(1"), "measure 'Sa(1': a period in seconds is needed, as in Sa(1.0)");
  EXPECT_EQ(error("PGA(1)"), "measure 'PGA(1)': PGA takes nothing in brackets");
  EXPECT_EQ(error("Sa(-1)"),
            "measure 'Sa(-1)': the period '-1' must be a number above 0 in seconds");
  EXPECT_THAT(error("SaAvg(0)"), HasSubstr("the period '0' must be a number above 0"));
  EXPECT_THAT(error("Sa(1s)"), HasSubstr("the period '1s' must be a number above 0"));
  EXPECT_THAT(error("Sa()"), HasSubstr("the period '' must be a number above 0"));
  EXPECT_THAT(error("Sa(1:2)"), HasSubstr("only SaAvg takes a range of periods"));
  EXPECT_THAT(error("SaAvg(2:1)"), HasSubstr("the last period '1' must be a number above the"));
  EXPECT_THAT(error("FIV3(1, 5%)"), HasSubstr("FIV3 takes no damping"));
  EXPECT_THAT(error("Sa(1, 5)"), HasSubstr("the damping '5' must be at least 0% and below 100%"));
  EXPECT_THAT(error("Sa(1, x%)"), HasSubstr("the damping 'x%' must be at least"));
}

// Twice the motion has 2^power times the measure, each measure in its turn.
TEST(Measure, ScalesAsItSays) {
  const VectorXd a = motion();
  for (const std::string& name : known_measures()) {
    const Measure measure = parse_measure(name);
    const double once = value_of(measure, 0.01, a), twice = value_of(measure, 0.01, 2 * a);
    EXPECT_GT(once, 0) << name;
    EXPECT_NEAR(twice, std::pow(2, scaling_power(measure)) * once, 1e-12 * twice) << name;
  }
}

// A constant of 1.5 m/s2 for 1001 samples: the Arias intensity grows along a line but for half a step
// at each end, which the trapezoid adds, for 10 s and one step.
TEST(Measure, TakesSharesOfTheAriasIntensityByName) {
  VectorXd a = VectorXd::Zero(2001);
  a.segment(200, 1001).setConstant(-1.5);
  EXPECT_NEAR(value_of(parse_measure("D5-95"), 0.01, a), 0.9 * 10.01, 1e-9);
  EXPECT_NEAR(value_of(parse_measure("D5-75"), 0.01, a), 0.7 * 10.01, 1e-9);
}

TEST(Measure, TakesPeriodAndDampingToTheSpectrum) {
  const VectorXd a = motion();
  const auto s = response_spectrum(0.01, a, VectorXd::Constant(1, 0.7), 0.02);
  EXPECT_NEAR(value_of(parse_measure("Sa(0.7, 2%)"), 0.01, a), s.pseudo_acceleration[0], 1e-14);
  EXPECT_EQ(value_of(parse_measure("FIV3(0.7)"), 0.01, a), fiv3(0.01, a, 0.7));
  const VectorXd periods = spectral_periods(parse_measure("SaAvg(0.5:1.5)"));
  EXPECT_EQ(periods[0], 0.5);
  EXPECT_EQ(periods[periods.size() - 1], 1.5);
  const auto many = response_spectrum(0.01, a, periods);
  EXPECT_NEAR(value_of(parse_measure("SaAvg(0.5:1.5)"), 0.01, a),
              std::exp(many.pseudo_acceleration.array().log().mean()), 1e-14);
}

TEST(Measure, HasUnitsAndADefinition) {
  EXPECT_STREQ(si_unit_of(parse_measure("Sa(1)")), "m/s2");
  EXPECT_STREQ(display_unit_of(parse_measure("Sa(1)")).name, "g");
  EXPECT_EQ(display_unit_of(parse_measure("PGA")).in_si, kStandardGravity);
  EXPECT_EQ(display_unit_of(parse_measure("PGV")).in_si, 1);
  EXPECT_EQ(definition_of(parse_measure("SaAvg(2, 3%)")),
            "geometric mean of Sa over periods from 0.2 to 3 times 2 s, 3 % damping");
  EXPECT_EQ(definition_of(parse_measure("SaAvg(0.1:2)")),
            "geometric mean of Sa over periods from 0.1 to 2 s, 5 % damping");
}

}  // namespace
}  // namespace gurney::groundmotions
